#include "files/msh_content.hpp"

#include <algorithm>
#include <set>

namespace cleave::app {
namespace {

/// What gmsh calls its element types, from number 1 on.
constexpr std::array<const char*, 31> kTypeNames = {"2-node line",
                                                    "3-node triangle",
                                                    "4-node quadrangle",
                                                    "4-node tetrahedron",
                                                    "8-node hexahedron",
                                                    "6-node prism",
                                                    "5-node pyramid",
                                                    "3-node second order line",
                                                    "6-node second order triangle",
                                                    "9-node second order quadrangle",
                                                    "10-node second order tetrahedron",
                                                    "27-node second order hexahedron",
                                                    "18-node second order prism",
                                                    "14-node second order pyramid",
                                                    "1-node point",
                                                    "8-node second order quadrangle",
                                                    "20-node second order hexahedron",
                                                    "15-node second order prism",
                                                    "13-node second order pyramid",
                                                    "9-node third order incomplete triangle",
                                                    "10-node third order triangle",
                                                    "12-node fourth order incomplete triangle",
                                                    "15-node fourth order triangle",
                                                    "15-node fifth order incomplete triangle",
                                                    "21-node fifth order triangle",
                                                    "4-node third order edge",
                                                    "5-node fourth order edge",
                                                    "6-node fifth order edge",
                                                    "20-node third order tetrahedron",
                                                    "35-node fourth order tetrahedron",
                                                    "56-node fifth order tetrahedron"};

std::string name_of(int type) {
  const bool known = type >= 1 && type <= static_cast<int>(kTypeNames.size());
  return known ? kTypeNames[static_cast<std::size_t>(type - 1)] : "element";
}

bool is_simplex(std::string_view name) {
  return name.find("line") != name.npos || name.find("edge") != name.npos ||
         name.find("triangle") != name.npos || name.find("tetrahedron") != name.npos;
}

/// The first element whose two sides are not at the same place; the size if there is none.
std::size_t first_with_thickness(const std::vector<std::array<double, 3>>& points,
                                 const std::vector<Index>& vertices, std::size_t side) {
  for (std::size_t i = 0; i < vertices.size(); i += 2 * side)
    for (std::size_t k = 0; k < side; ++k)
      if (points[vertices[i + k]] != points[vertices[i + side + k]]) return i / (2 * side);
  return vertices.size() / (2 * side);
}

/// The names of the groups of `tags`; groups that hold nothing else are no groups of cells.
std::vector<std::string> take_names(const std::vector<std::int32_t>& tags, int dimension,
                                    std::vector<Group>& groups) {
  std::map<std::int32_t, std::string> name_of_tag;
  for (const std::int32_t tag : tags)
    if (tag != 0) name_of_tag[tag] = std::to_string(tag);
  for (const Group& group : groups) {
    const auto known = name_of_tag.find(group.tag);
    if (group.dimension == dimension && known != name_of_tag.end()) known->second = group.name;
  }
  const auto is_theirs = [&](const Group& group) {
    return group.dimension == dimension && group.elements.empty() &&
           name_of_tag.count(group.tag) > 0;
  };
  groups.erase(std::remove_if(groups.begin(), groups.end(), is_theirs), groups.end());
  std::vector<std::string> names;
  for (const std::int32_t tag : tags) names.push_back(tag != 0 ? name_of_tag[tag] : std::string());
  return names;
}

}  // namespace

std::string msh_refusal(int type, std::optional<std::uint64_t> number) {
  const std::string name = name_of(type);
  const std::string who = number ? "element " + std::to_string(*number) + " is" : "these are";
  const std::string what =
      who + (number ? " a " : " elements of type ") + name + " (type " + std::to_string(type) + ")";
  return what + (is_simplex(name)
                     ? "; Cleave works on simplices of order 1 and 2: write the mesh with "
                       "Mesh.ElementOrder = 1 (`gmsh -order 1`) or 2"
                     : "; Cleave works on simplices of order 1 and 2: mesh without recombining, "
                       "or split the elements into triangles or tetrahedra");
}

std::string msh_mixed_orders(const MshKind& kind, std::uint64_t number) {
  return "element " + std::to_string(number) + " is a " + name_of(kind.type) +
         ", but those of its dimension before it are of the other order; write the mesh with one "
         "order (`gmsh -order 1` or 2)";
}

int MshContent::dimension() const {
  for (int d = 3; d > 0; --d)
    if (mesh.elements[static_cast<std::size_t>(d)].size() > 0) return d;
  return 0;
}

void MshContent::expect(const MshKind& kind, std::size_t count) {
  if (kind.cohesive) return;
  Elements& elements = mesh.elements[static_cast<std::size_t>(kind.dimension)];
  // Twice as much as there was at least, lest a file of many small blocks be copied for each.
  const auto make_room = [](auto& list, std::size_t more) {
    if (list.size() + more > list.capacity())
      list.reserve(std::max(list.size() + more, 2 * list.size()));
  };
  make_room(elements.vertices, kind.corners * count);
  make_room(elements.midside, kind.midside * count);
  make_room(elements.numbers, count);
}

void MshContent::finish_cohesive() {
  for (int d = 2; d <= 3; ++d) {
    MshCohesive& list = cohesive[static_cast<std::size_t>(d - 2)];
    if (list.numbers.empty()) continue;
    const int type = msh_cohesive(d).type;
    if (dimension() != d) text->fail(list.places[0], msh_refusal(type, list.numbers[0]));
    const std::size_t thick =
        first_with_thickness(mesh.points, list.vertices, static_cast<std::size_t>(d));
    if (thick < list.numbers.size())
      text->fail(list.places[thick],
                 msh_refusal(type, list.numbers[thick]) +
                     ". Only cohesive elements, whose two sides are at the same place, may be of "
                     "this type");
    if (cohesive_in_several_groups)
      drop(list.places[0], "cohesive elements that are in several groups keep the first");
    mesh.cohesive.names = take_names(list.tags, d, mesh.groups);
    mesh.cohesive.vertices = std::move(list.vertices);
    mesh.cohesive.numbers = std::move(list.numbers);
  }
}

void MshContent::drop(const char* place, const std::string& message) {
  mesh.dropped.push_back(text->where(place) + ": " + message);
}

}  // namespace cleave::app
