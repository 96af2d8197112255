// The JSON files that say where to cut, facets or a sweep, and the cut that they ask for, in a cube
// and in a strip of triangles.
#include "cut_mesh.hpp"
#include "cut_request.hpp"
#include "error.hpp"
#include "kuhn_cube.hpp"
#include "mesh_laws.hpp"
#include "targets.hpp"

namespace cleave::fuzz {
namespace {

app::Mesh strip_of_triangles() {
  app::Mesh mesh;
  mesh.source = "strip.mesh";
  mesh.dimension = 2;
  for (std::uint32_t i = 0; i < 4; ++i) {
    mesh.points.push_back({static_cast<double>(i), 0, 0});
    mesh.points.push_back({static_cast<double>(i), 1, 0});
    mesh.vertex_numbers.push_back(2 * i);
    mesh.vertex_numbers.push_back(i < 3 ? 2 * i + 1 : UINT64_MAX);
  }
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t even = i % 2;
    for (const std::uint32_t v : {i + even, i + 1 - even, i + 2})
      mesh.elements[2].vertices.push_back(v);
    mesh.elements[2].numbers.push_back(i);
  }
  return mesh;
}

void cut(const app::Mesh& mesh, app::CutOptions options) {
  options.quiet = true;
  options.explain = true;
  options.verify = topology::Verify::all;
  app::Progress progress(1, true);
  try {
    require_places(app::cut_mesh({mesh, {}, {}}, options, progress).mesh);
  } catch (const app::InputError&) {
  }
}

}  // namespace

void fuzz_request(Bytes bytes) {
  static const Folder folder;
  static const app::Mesh cube = app::kuhn_cube({{3, 2, 2}, {2, 1, 1}});
  static const app::Mesh strip = strip_of_triangles();
  const std::string path = folder.put("request.json", text_of(bytes)).string();
  for (const app::Mesh* mesh : {&cube, &strip}) {
    app::CutOptions facets;
    facets.facets = {path};
    cut(*mesh, facets);
    app::CutOptions sweep;
    sweep.sweep = path;
    cut(*mesh, sweep);
    sweep.select.rule = cutting::Rule::nearest_vertex;
    cut(*mesh, sweep);
  }
}

}  // namespace cleave::fuzz
