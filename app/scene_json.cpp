#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

#include "blade.hpp"
#include "error.hpp"
#include "json_value.hpp"
#include "scene.hpp"

namespace cleave::app {
namespace {

std::vector<std::uint64_t> numbers(const JsonValue& value) {
  std::vector<std::uint64_t> out;
  for (const auto& item : value.items()) out.push_back(item.count());
  return out;
}

MeshSpec read_mesh(const JsonValue& value, const std::filesystem::path& folder) {
  value.only({"file", "cube", "unit"});
  if (value.one_of({"file", "cube"}) == "file") return folder / value["file"].string();
  const JsonValue cube = value["cube"];
  cube.only({"nodes", "size"});
  CubeSpec spec;
  const auto nodes = cube["nodes"].items();
  if (nodes.size() != 3) cube["nodes"].fail("three counts [nx, ny, nz] are needed");
  for (std::size_t i = 0; i < 3; ++i) {
    spec.nodes[i] = nodes[i].count();
    if (spec.nodes[i] < 2) nodes[i].fail("a cube needs at least 2 nodes along each axis");
  }
  spec.size = cube["size"].vector();
  for (const double length : spec.size)
    if (!(length > 0.0)) cube["size"].fail("the three lengths must be positive");
  return spec;
}

Where read_where(const JsonValue& value) {
  value.only({"group", "dimension", "box", "half_space", "vertices"});
  Where where;
  where.at = value.pointer();
  const auto kind = value.one_of({"group", "box", "half_space", "vertices"});
  const JsonValue place = value[kind];
  if (kind != "group" && value.has("dimension"))
    value["dimension"].fail("only a group has a dimension");
  if (kind == "group") {
    GroupName group{place.string(), std::nullopt};
    if (value.has("dimension")) {
      const std::uint64_t dimension = value["dimension"].count();
      if (dimension > 3) value["dimension"].fail("0, 1, 2 or 3 is needed");
      group.dimension = static_cast<int>(dimension);
    }
    where.place = group;
  } else if (kind == "box") {
    const auto ends = place.items();
    if (ends.size() != 2) place.fail("two opposite ends [[x,y,z],[x,y,z]] are needed");
    const Box box{ends[0].vector(), ends[1].vector()};
    for (std::size_t i = 0; i < 3; ++i)
      if (box.low[i] > box.high[i]) place.fail("the first end must be the lower one on every axis");
    where.place = box;
  } else if (kind == "half_space") {
    place.only({"point", "normal"});
    const HalfSpace half{place["point"].vector(), place["normal"].vector()};
    if (half.normal == Point3{}) place["normal"].fail("the normal must not be zero");
    where.place = half;
  } else {
    where.place = VertexNumbers{numbers(place)};
  }
  return where;
}

MaterialSpec read_material(const JsonValue& value, const std::string& group) {
  value.only({"lambda", "mu", "young", "poisson", "density"});
  MaterialSpec material;
  material.group = group;
  material.at = value.pointer();
  try {
    if (value.has("young") || value.has("poisson")) {
      if (value.has("lambda") || value.has("mu"))
        value.fail("give lambda and mu, or young and poisson, not both");
      material.lame = fem::lame_of(value["young"].number(), value["poisson"].number());
    } else {
      material.lame = {value["lambda"].number(), value["mu"].number()};
    }
    fem::require_positive(material.lame);
  } catch (const std::invalid_argument& e) {
    value.fail(e.what());
  }
  if (value.has("density")) {
    material.density = value["density"].number();
    if (!(*material.density > 0.0)) value["density"].fail("a density must be positive");
  }
  return material;
}

std::vector<MaterialSpec> read_materials(const JsonValue& value) {
  if (!value.has("groups")) return {read_material(value, {})};
  value.only({"groups"});
  std::vector<MaterialSpec> materials;
  for (const auto& [name, entry] : value["groups"].members())
    materials.push_back(read_material(entry, name));
  if (materials.empty()) value["groups"].fail("at least one group is needed");
  return materials;
}

SupportSpec read_support(const JsonValue& value) {
  value.only({"where", "axes", "value"});
  SupportSpec support;
  support.where = read_where(value["where"]);
  support.where.at = value.pointer();
  const auto axes = value.has("axes") ? value["axes"].items() : std::vector<JsonValue>{};
  if (!value.has("axes")) support.axes = {true, true, true};
  for (const auto& axis : axes) support.axes[axis.choice({"x", "y", "z"})] = true;
  if (support.axes == std::array<bool, 3>{}) value["axes"].fail("name at least one of x, y, z");
  if (value.has("value")) support.value = value["value"].number();
  return support;
}

LoadSpec read_load(const JsonValue& value) {
  using Kind = LoadSpec::Kind;
  LoadSpec load;
  load.at = value.pointer();
  const auto kind = value.one_of({"force", "total_force", "traction", "gravity"});
  load.kind = kind == "force"         ? Kind::force
              : kind == "total_force" ? Kind::total_force
              : kind == "traction"    ? Kind::traction
                                      : Kind::gravity;
  load.vector = value[kind].vector();
  if (load.kind == Kind::gravity) {
    value.only({"where", "gravity", "density"});
    if (value.has("density")) {
      load.density = value["density"].number();
      if (!(*load.density > 0.0)) value["density"].fail("a density must be positive");
    }
  } else {
    value.only({"where", kind});
  }
  if (load.kind != Kind::gravity || value.has("where")) {
    load.where = read_where(value["where"]);
    load.where->at = value.pointer();
  }
  return load;
}

FacetList read_facets(const JsonValue& value) {
  FacetList list;
  for (const auto& facet : value.items()) {
    const auto vertices = numbers(facet);
    if (vertices.size() != 3) facet.fail("a facet is named by three vertex numbers");
    list.facets.push_back({vertices[0], vertices[1], vertices[2]});
  }
  return list;
}

GroupNames read_groups(const JsonValue& value) {
  if (value.is_string()) return {{value.string()}};
  GroupNames groups;
  for (const auto& name : value.items()) groups.names.push_back(name.string());
  if (groups.names.empty()) value.fail("at least one group is needed");
  return groups;
}

StrokeSpec read_stroke(const JsonValue& value, std::size_t number) {
  value.only({"name", "blade", "facets", "group", "select", "ties", "snap"});
  StrokeSpec stroke;
  stroke.at = value.pointer();
  stroke.name = value.has("name") ? value["name"].string() : "stroke " + std::to_string(number);
  const auto kind = value.one_of({"blade", "facets", "group"});
  if (kind == "blade") stroke.path = BladePath{read_blade(value[kind])};
  if (kind == "facets") stroke.path = read_facets(value[kind]);
  if (kind == "group") stroke.path = read_groups(value[kind]);
  for (const auto* key : {"select", "ties"})
    if (kind != "blade" && value.has(key)) value[key].fail("only a blade selects facets");
  if (value.has("select"))
    stroke.select.rule = value["select"].choice({"dual-edge", "nearest-vertex"}) == 0
                             ? cutting::Rule::dual_edge
                             : cutting::Rule::nearest_vertex;
  if (value.has("ties"))
    stroke.select.ties =
        value["ties"].choice({"id", "both"}) == 0 ? cutting::Ties::by_id : cutting::Ties::both;
  if (value.has("snap") && value["snap"].boolean())
    value["snap"].fail("unknown value true; known here: false (vertices are not moved)");
  return stroke;
}

SolveSpec read_solve(const JsonValue& value) {
  value.only(
      {"tolerance", "norm", "preconditioner", "formulation", "max_iterations", "on_unsupported"});
  SolveSpec solve;
  if (value.has("tolerance")) solve.tolerance = value["tolerance"].number();
  if (!(solve.tolerance > 0.0 && solve.tolerance < 1.0))
    value["tolerance"].fail("a relative tolerance lies between 0 and 1");
  if (value.has("norm"))
    solve.norm = value["norm"].choice({"residual", "energy"}) == 0 ? SolveSpec::Norm::residual
                                                                   : SolveSpec::Norm::energy;
  if (value.has("preconditioner"))
    solve.preconditioner = value["preconditioner"].choice({"none", "jacobi"}) == 0
                               ? SolveSpec::Preconditioner::none
                               : SolveSpec::Preconditioner::jacobi;
  if (value.has("formulation")) value["formulation"].choice({"p1"});
  if (value.has("max_iterations")) {
    solve.max_iterations = value["max_iterations"].count();
    if (solve.max_iterations == 0) value["max_iterations"].fail("at least one is needed");
  }
  if (value.has("on_unsupported"))
    solve.on_unsupported = value["on_unsupported"].choice({"refuse", "modulo_free_modes"}) == 0
                               ? SolveSpec::Unsupported::refuse
                               : SolveSpec::Unsupported::modulo_free_modes;
  return solve;
}

OutputSpec read_output(const JsonValue& value) {
  value.only({"vtu", "frames", "page"});
  OutputSpec output;
  if (value.has("vtu")) output.vtu = value["vtu"].boolean();
  if (value.has("frames"))
    output.frames = value["frames"].choice({"states", "final"}) == 0
                        ? OutputSpec::Frames::states
                        : OutputSpec::Frames::final_only;
  if (value.has("page")) output.page = value["page"].boolean();
  return output;
}

template <class Entry, class Read>
std::vector<Entry> read_list(const JsonValue& scene, std::string_view key, Read read) {
  std::vector<Entry> entries;
  if (scene.has(key))
    for (const auto& item : scene[key].items()) entries.push_back(read(item));
  return entries;
}

Scene read(const JsonValue& top, const std::string& source, const std::filesystem::path& folder) {
  top.only({"title", "mesh", "material", "supports", "loads", "strokes", "solve", "output"});
  Scene scene;
  scene.source = source;
  scene.title = top.has("title") ? top["title"].string()
                                 : std::filesystem::path(source).stem().stem().string();
  scene.mesh = read_mesh(top["mesh"], folder);
  if (top["mesh"].has("unit")) scene.length_unit = top["mesh"]["unit"].string();
  if (top.has("material")) scene.materials = read_materials(top["material"]);
  scene.supports = read_list<SupportSpec>(top, "supports", read_support);
  scene.loads = read_list<LoadSpec>(top, "loads", read_load);
  std::size_t stroke = 0;
  scene.strokes = read_list<StrokeSpec>(
      top, "strokes", [&](const JsonValue& item) { return read_stroke(item, ++stroke); });
  if (top.has("solve")) scene.solve = read_solve(top["solve"]);
  if (top.has("output")) scene.output = read_output(top["output"]);
  if (scene.solve && scene.materials.empty())
    top["solve"].fail("to solve needs a \"material\"; add one, or take \"solve\" out");
  return scene;
}

}  // namespace

Scene parse_scene(std::string_view text, const std::string& source,
                  const std::filesystem::path& folder) {
  const nlohmann::json document = parse_json(text, source);
  return read(JsonValue(document, source), source, folder);
}

Scene read_scene(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || !std::filesystem::is_regular_file(file))
    throw InputError(file.string() + ": no such scene file, or it cannot be read");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  return parse_scene(text, file.string(), file.parent_path());
}

}  // namespace cleave::app
