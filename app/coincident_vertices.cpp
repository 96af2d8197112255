#include "coincident_vertices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "body.hpp"
#include "error.hpp"
#include "file_words.hpp"
#include "point_sets.hpp"
#include "record.hpp"

namespace cleave::app {
namespace {

using Places = std::vector<Index>;

// Places that cells use and that have finite coordinates, ascending.
Places used_places(const Mesh& mesh) {
  std::vector<bool> used(mesh.points.size(), false);
  for (const Index place : mesh.cells().vertices) used[place] = true;
  for (const Index place : mesh.cells().midside)
    if (place < used.size()) used[place] = true;  // else: a node that is missing
  Places places;
  for (Index place = 0; place < used.size(); ++place) {
    const auto& p = mesh.points[place];
    if (used[place] && std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]))
      places.push_back(place);
  }
  return places;
}

/// What a file says of how its vertices came to lie in one place.
class Intent {
 public:
  explicit Intent(const Mesh& mesh) {
    for (const Field& field : mesh.point_fields)
      if (field.name == "parent" && field.components == 1) origin_ = field.values;
    if (origin_.empty()) read_record_of(mesh);
    mark_sides(mesh);
    in_cohesive_.assign(mesh.points.size(), false);
    for (const Index place : mesh.cohesive.vertices) in_cohesive_[place] = true;
  }

  /// Why these vertices are meant to be separate; empty: nothing says so.
  std::string reason(const Places& places) const {
    const auto all = [&](const auto& holds) {
      return std::all_of(places.begin(), places.end(), holds);
    };
    if (!origin_.empty() && all([&](Index p) { return origin_[p] == origin_[places.front()]; }))
      return "copies of one vertex that a cut made";
    if (all([&](Index p) { return in_cohesive_[p]; })) return "joined by cohesive elements";
    if (all([&](Index p) { return side_[p] != nullptr; }))
      return "on the sides of the cut " + *side_[places.front()];
    return {};
  }

 private:
  void read_record_of(const Mesh& mesh) {
    std::error_code error;
    const std::filesystem::path path = mesh.source + ".cleave.json";
    if (!std::filesystem::is_regular_file(path, error)) return;
    try {
      const IncisionRecord record = read_record(path);
      for (const Run& run : record.original.origins)
        for (std::uint64_t i = 0; i < run.count && origin_.size() <= mesh.points.size(); ++i)
          origin_.push_back(static_cast<double>(run.first + i));
    } catch (const InputError&) {
      origin_.clear();  // whoever goes on cutting is told; here it says nothing
    }
    if (origin_.size() != mesh.points.size()) origin_.clear();
  }

  void mark_sides(const Mesh& mesh) {
    side_.assign(mesh.points.size(), nullptr);
    std::map<std::string, std::vector<const Group*>> pairs;  // by NAME
    for (const Group& group : mesh.groups)
      for (const std::string ending : {"_minus", "_plus"})
        if (group.dimension == mesh.dimension - 1 && group.name.size() > ending.size() &&
            group.name.ends_with(ending))
          pairs[group.name.substr(0, group.name.size() - ending.size())].push_back(&group);
    for (const auto& [name, groups] : pairs) {
      if (groups.size() != 2) continue;
      names_.push_back(std::make_unique<std::string>(name));
      for (const Group* group : groups)
        for (const Index place : vertices_of(mesh, *group)) side_[place] = names_.back().get();
    }
  }

  std::vector<double> origin_;  // per place; empty: unknown
  std::vector<bool> in_cohesive_;
  std::vector<const std::string*> side_;  // per place: the name of a cut that has it on a side
  std::vector<std::unique_ptr<std::string>> names_;
};

Finding finding_of(const Mesh& mesh, const Places& places, const std::string& reason) {
  std::vector<std::uint64_t> vertices;
  double distance = 0;
  for (const Index place : places) {
    vertices.push_back(mesh.vertex_numbers[place]);
    const auto &a = mesh.points[places.front()], &b = mesh.points[place];
    distance = std::max(distance, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
  }
  const std::string where =
      distance == 0 ? "in the same place" : fmt::format("within {:.3g} of each other", distance);
  return {"coincident-vertices",
          reason.empty() ? Severity::warning : Severity::note,
          reason.empty()
              ? fmt::format("vertices {} are {}, and the cells around one are not joined to those "
                            "around another",
                            listed(vertices), where)
              : fmt::format("vertices {} are {}: {}", listed(vertices), where, reason),
          {{"vertices", vertices}, {"distance", distance}}};
}

}  // namespace

std::vector<Finding> check_coincident(const Mesh& mesh, double distance) {
  std::vector<Finding> findings;
  const std::vector<Places> sets = close_points(mesh.points, used_places(mesh), distance);
  if (sets.empty()) return findings;
  const Intent intent(mesh);
  for (const Places& places : sets)
    findings.push_back(finding_of(mesh, places, intent.reason(places)));
  return findings;
}

}  // namespace cleave::app
