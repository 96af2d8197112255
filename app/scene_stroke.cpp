#include "scene_stroke.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <unordered_map>

#include "cleave/cutting/stroke.hpp"
#include "cleave/topology/carry_over.hpp"
#include "error.hpp"
#include "where.hpp"

namespace cleave::app {
namespace {

using topology::Relabelling;
using topology::VertexId;

SceneStroke along_blade(const BladePath& path, const StrokeSpec& spec, const std::string& source,
                        topology::Incision<3>& incision, std::vector<std::array<double, 3>>& points,
                        Parts& parts) {
  const auto sweep = cutting::sweep_of_blade(path.positions);
  SceneStroke stroke;
  stroke.steps = sweep.step_count();
  const std::size_t vertices_before = incision.complex().vertex_count();
  try {
    const auto result = parts.build(
        "selector", [&] { return cutting::cut_along(incision, points, sweep, spec.select); });
    stroke.requested = result.scored;
    stroke.change = composed(result.changes, vertices_before);
  } catch (const std::invalid_argument& e) {
    throw InputError(source + ": at " + spec.at + "/blade: " + e.what());
  }
  return stroke;
}

// Places in mesh.points of facets given by the file's vertex numbers.
std::vector<Index> places_of(const FacetList& list, const StrokeSpec& spec,
                             const std::string& source, const Mesh& mesh) {
  std::unordered_map<std::uint64_t, Index> place_of;
  for (Index i = 0; i < mesh.points.size(); ++i) place_of.emplace(mesh.vertex_numbers[i], i);
  std::vector<Index> places;
  for (std::size_t f = 0; f < list.facets.size(); ++f)
    for (const std::uint64_t number : list.facets[f]) {
      const auto found = place_of.find(number);
      if (found == place_of.end())
        throw InputError(source + ": at " + spec.at + "/facets/" + std::to_string(f) +
                         ": the mesh has no vertex " + std::to_string(number));
      places.push_back(found->second);
    }
  return places;
}

std::vector<topology::HalfFacetId> named_facets(const StrokeSpec& spec, const std::string& source,
                                                const Body<3>& body) {
  if (const auto* list = std::get_if<FacetList>(&spec.path))
    return locate(body, places_of(*list, spec, source, *body.mesh),
                  source + ": at " + spec.at + "/facets");
  std::vector<topology::HalfFacetId> facets;
  for (const std::string& name : std::get<GroupNames>(spec.path).names) {
    const Group& group = named_group(*body.mesh, name, 2, source, spec.at + "/group");
    const auto found = locate(body, vertices_of(*body.mesh, group), "group \"" + name + "\"");
    facets.insert(facets.end(), found.begin(), found.end());
  }
  return facets;
}

}  // namespace

SceneStroke make_stroke(const StrokeSpec& spec, const std::string& source, const Body<3>& body,
                        topology::Incision<3>& incision, std::vector<std::array<double, 3>>& points,
                        Parts& parts) {
  if (const auto* path = std::get_if<BladePath>(&spec.path))
    return along_blade(*path, spec, source, incision, points, parts);
  return parts.build("cut", [&] {
    const SortedOut asked = sort_out(body.complex, named_facets(spec, source, body));
    SceneStroke stroke;
    stroke.requested = asked.interior;
    stroke.not_interior = asked.boundary.size();
    stroke.change = incision.cut(asked.interior);
    topology::carry_over(points, stroke.change);
    return stroke;
  });
}

Relabelling composed(const std::vector<Relabelling>& changes, std::size_t vertices_before) {
  Relabelling all;
  all.vertices_before = all.vertices_after = vertices_before;
  std::map<topology::CornerId, topology::RenamedCorner> renamed;
  std::map<VertexId, VertexId> parent;  // of copies made by any of the changes
  for (const Relabelling& change : changes) {
    all.vertices_after = change.vertices_after;
    all.shut = change.shut;
    for (const auto& corner : change.corners)
      renamed.emplace(corner.corner, corner).first->second.to = corner.to;
    for (const auto& split : change.splits) {
      const auto copy = parent.find(split.parent);
      parent[split.vertex] = copy == parent.end() ? split.parent : copy->second;
    }
    all.opened.insert(all.opened.end(), change.opened.begin(), change.opened.end());
  }
  for (const auto& [corner, rename] : renamed) all.corners.push_back(rename);
  for (const auto& [vertex, of] : parent) all.splits.push_back({vertex, of});
  for (auto& facet : all.opened) {
    const auto copy = parent.find(facet.by);
    if (copy != parent.end()) facet.by = copy->second;
  }
  std::sort(all.opened.begin(), all.opened.end(),
            [](const auto& a, const auto& b) { return a.half_facet < b.half_facet; });
  return all;
}

}  // namespace cleave::app
