#include "where.hpp"

#include <algorithm>
#include <unordered_map>

#include "error.hpp"

namespace cleave::app {
namespace {

using topology::CellId;
using topology::HalfFacetId;
using topology::VertexId;

constexpr const char* kElements[] = {"vertex", "edge", "facet", "cell"};

[[noreturn]] void fail(const std::string& source, const std::string& at, const std::string& what) {
  throw InputError(source + ": at " + at + ": " + what);
}

std::string names_of(const Mesh& mesh, int dimension) {
  std::string names;
  for (const Group& group : mesh.groups)
    if (group.dimension == dimension) names += (names.empty() ? "\"" : ", \"") + group.name + "\"";
  return names.empty() ? "none" : names;
}

// The only group of that name, or the one of the dimension the scene gives. `natural` is the
// dimension of what is asked for, preferred if the scene gives none; -1: none is natural.
const Group& group_of(const GroupName& name, int natural, const Mesh& mesh,
                      const std::string& source, const std::string& at) {
  if (name.dimension) return named_group(mesh, name.name, *name.dimension, source, at);
  std::vector<const Group*> found;
  for (const Group& group : mesh.groups)
    if (group.name == name.name) found.push_back(&group);
  for (const Group* group : found)
    if (group->dimension == natural) return *group;
  if (found.size() == 1) return *found.front();
  if (found.empty()) {
    std::string known;
    for (int d = 3; d >= 0; --d)
      known += std::string(d == 3 ? "" : "; ") + kElements[d] + " groups: " + names_of(mesh, d);
    fail(source, at, "the mesh has no group \"" + name.name + "\". It has " + known);
  }
  std::string dimensions;
  for (const Group* group : found)
    dimensions += (dimensions.empty() ? "" : ", ") + std::to_string(group->dimension);
  fail(source, at,
       "several groups are named \"" + name.name + "\"; add \"dimension\", one of " + dimensions);
}

// One flag per place in mesh.points: lies there, whether a cell uses it or not.
std::vector<bool> flags_of_numbers(const VertexNumbers& list, const Mesh& mesh,
                                   const std::string& source, const std::string& at) {
  std::unordered_map<std::uint64_t, std::size_t> place_of;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) place_of.emplace(mesh.vertex_numbers[i], i);
  std::vector<bool> flags(mesh.points.size(), false);
  for (const std::uint64_t number : list.numbers) {
    const auto found = place_of.find(number);
    if (found == place_of.end())
      fail(source, at, "the mesh has no vertex " + std::to_string(number));
    flags[found->second] = true;
  }
  return flags;
}

std::vector<bool> flags_of_group(const Group& group, const Mesh& mesh) {
  std::vector<bool> flags(mesh.points.size(), false);
  for (const Index place : vertices_of(mesh, group)) flags[place] = true;
  return flags;
}

template <class Inside>
std::vector<bool> flags_of_points(const Mesh& mesh, Inside inside) {
  std::vector<bool> flags(mesh.points.size());
  for (std::size_t i = 0; i < flags.size(); ++i) flags[i] = inside(mesh.points[i]);
  return flags;
}

std::vector<bool> flags_of(const Where& where, int natural, const Mesh& mesh,
                           const std::string& source) {
  if (const auto* name = std::get_if<GroupName>(&where.place))
    return flags_of_group(group_of(*name, natural, mesh, source, where.at), mesh);
  if (const auto* list = std::get_if<VertexNumbers>(&where.place))
    return flags_of_numbers(*list, mesh, source, where.at);
  if (const auto* box = std::get_if<Box>(&where.place))
    return flags_of_points(mesh, [box](const Point3& x) {
      bool inside = true;
      for (std::size_t i = 0; i < 3; ++i)
        inside = inside && box->low[i] <= x[i] && x[i] <= box->high[i];
      return inside;
    });
  const auto& half = std::get<HalfSpace>(where.place);
  return flags_of_points(mesh, [&half](const Point3& x) {
    double height = 0.0;
    for (std::size_t i = 0; i < 3; ++i) height += (x[i] - half.point[i]) * half.normal[i];
    return height >= 0.0;
  });
}

// The group that `where` names, if it names one of that dimension.
const Group* group_of_dimension(const Where& where, int dimension, const Mesh& mesh,
                                const std::string& source) {
  const auto* name = std::get_if<GroupName>(&where.place);
  if (!name) return nullptr;
  const Group& group = group_of(*name, dimension, mesh, source, where.at);
  return group.dimension == dimension ? &group : nullptr;
}

template <class Selected>
void require_some(const Selected& selected, const char* what, const Where& where,
                  const std::string& source) {
  if (selected.empty())
    fail(source, where.at, std::string("\"where\" selects no ") + what + " of the body");
}

}  // namespace

const Group& named_group(const Mesh& mesh, const std::string& name, int dimension,
                         const std::string& source, const std::string& at) {
  for (const Group& group : mesh.groups)
    if (group.dimension == dimension && group.name == name) return group;
  fail(source, at,
       std::string("the mesh has no ") + kElements[dimension] + " group \"" + name +
           "\"; it has: " + names_of(mesh, dimension));
}

std::vector<VertexId> vertices_in(const Where& where, const Body<3>& body,
                                  const std::string& source) {
  const std::vector<bool> flags = flags_of(where, -1, *body.mesh, source);
  std::vector<VertexId> vertices;
  for (Index v = 0; v < body.complex.vertex_count(); ++v)
    if (body.complex.a_corner({v}) && flags[body.place({v})]) vertices.push_back({v});
  require_some(vertices, "vertex", where, source);
  return vertices;
}

std::vector<HalfFacetId> boundary_facets_in(const Where& where, const Body<3>& body,
                                            const std::string& source) {
  const topology::Complex<3>& k = body.complex;
  std::vector<HalfFacetId> facets;
  if (const Group* group = group_of_dimension(where, 2, *body.mesh, source)) {
    const auto places = vertices_of(*body.mesh, *group);
    for (const HalfFacetId h : locate(body, places, "group \"" + group->name + "\""))
      if (!k.is_interior(h)) facets.push_back(h);
    std::sort(facets.begin(), facets.end());
    facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
  } else {
    const std::vector<bool> flags = flags_of(where, 2, *body.mesh, source);
    for (Index h = 0; h < k.half_facet_count(); ++h) {
      if (k.is_interior({h})) continue;
      const auto facet = k.facet({h});
      if (std::all_of(facet.begin(), facet.end(), [&](VertexId v) { return flags[body.place(v)]; }))
        facets.push_back({h});
    }
  }
  require_some(facets, "boundary facet", where, source);
  return facets;
}

std::vector<CellId> cells_in(const Where& where, const Mesh& mesh, const std::string& source) {
  std::vector<CellId> cells;
  if (const Group* group = group_of_dimension(where, 3, mesh, source)) {
    for (const Index cell : group->elements) cells.push_back({cell});
  } else {
    const std::vector<bool> flags = flags_of(where, 3, mesh, source);
    const std::vector<Index>& vertices = mesh.cells().vertices;
    for (Index c = 0; c < mesh.cells().size(); ++c)
      if (std::all_of(&vertices[4 * c], &vertices[4 * c] + 4,
                      [&](Index place) { return flags[place]; }))
        cells.push_back({c});
  }
  require_some(cells, "cell", where, source);
  return cells;
}

}  // namespace cleave::app
