#include "sub_mesh.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace cleave::app {
namespace {

constexpr Index kGone = topology::kNoIndex;
using Places = std::vector<Index>;  // of entities in the whole mesh, ascending
using Face = std::array<Index, 3>;  // ascending vertices, the rest kGone

Face face_of(const Index* tuple, std::size_t n) {
  Face face{kGone, kGone, kGone};
  std::copy(tuple, tuple + n, face.begin());
  std::sort(face.begin(), face.end());
  return face;
}

// The faces with `n` vertices of these cells, ascending.
std::vector<Face> faces_of(const Mesh& mesh, std::span<const Index> cells, std::size_t n) {
  const auto corners = static_cast<std::size_t>(mesh.dimension) + 1;
  std::vector<Face> faces;
  for (const Index c : cells) {
    std::vector<bool> chosen(corners, false);
    std::fill(chosen.begin(), chosen.begin() + static_cast<std::ptrdiff_t>(n), true);
    do {
      std::array<Index, 3> tuple{};
      for (std::size_t i = 0, to = 0; i < corners; ++i)
        if (chosen[i]) tuple[to++] = mesh.cells().vertices[corners * c + i];
      faces.push_back(face_of(tuple.data(), n));
    } while (std::prev_permutation(chosen.begin(), chosen.end()));
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

std::size_t midsides(const Elements& elements) {
  return elements.size() == 0 ? 0 : elements.midside.size() / elements.size();
}

struct Part {
  const Mesh& whole;
  SubMesh result;
  std::vector<Index> new_place;  // of the whole's points

  bool stays(Index vertex) const { return new_place[vertex] != kGone; }
  bool all_stay(const Index* vertices, std::size_t n) const {
    return std::all_of(vertices, vertices + n, [&](Index v) { return stays(v); });
  }

  void number_points(std::span<const Index> cells, std::span<const Index> loose) {
    const Elements& all = whole.cells();
    const auto corners = static_cast<std::size_t>(whole.dimension) + 1;
    const std::size_t between = midsides(all);
    new_place.assign(whole.points.size(), kGone);
    for (const Index c : cells) {
      for (std::size_t i = 0; i < corners; ++i) new_place[all.vertices[corners * c + i]] = 0;
      for (std::size_t i = 0; i < between; ++i) new_place[all.midside[between * c + i]] = 0;
    }
    for (const Index v : loose) new_place[v] = 0;
    for (Index v = 0; v < new_place.size(); ++v) {
      if (!stays(v)) continue;
      new_place[v] = static_cast<Index>(result.place.size());
      result.place.push_back(v);
      result.mesh.points.push_back(whole.points[v]);
      result.mesh.vertex_numbers.push_back(whole.vertex_numbers[v]);
    }
  }

  Places elements_that_stay(std::size_t dimension, std::span<const Index> cells) const {
    const Elements& all = whole.elements[dimension];
    Places stay;
    if (all.size() == 0) return stay;
    const auto faces = dimension == 0 ? std::vector<Face>() : faces_of(whole, cells, dimension + 1);
    for (Index e = 0; e < all.size(); ++e) {
      const Index* tuple = &all.vertices[(dimension + 1) * e];
      if (dimension == 0
              ? stays(*tuple)
              : std::binary_search(faces.begin(), faces.end(), face_of(tuple, dimension + 1)))
        stay.push_back(e);
    }
    return stay;
  }

  void add_elements(std::size_t dimension, const Places& stay) {
    const Elements& all = whole.elements[dimension];
    Elements& some = result.mesh.elements[dimension];
    const std::size_t between = midsides(all);
    for (const Index e : stay) {
      some.numbers.push_back(all.numbers[e]);
      for (std::size_t i = 0; i <= dimension; ++i)
        some.vertices.push_back(new_place[all.vertices[(dimension + 1) * e + i]]);
      for (std::size_t i = 0; i < between; ++i)
        some.midside.push_back(new_place[all.midside[between * e + i]]);
    }
    std::vector<Index> new_element(all.size(), kGone);
    for (Index i = 0; i < stay.size(); ++i) new_element[stay[i]] = i;
    for (const Group& group : whole.groups) {
      if (group.dimension != static_cast<int>(dimension)) continue;
      Group some_of_it{group.name, group.dimension, group.tag, {}};
      for (const Index e : group.elements)
        if (new_element[e] != kGone) some_of_it.elements.push_back(new_element[e]);
      if (!some_of_it.elements.empty()) result.mesh.groups.push_back(std::move(some_of_it));
    }
  }

  static std::vector<Field> fields(const std::vector<Field>& all, const Places& stay) {
    std::vector<Field> some;
    for (const Field& field : all) {
      Field part = field;
      part.values.clear();
      const auto n = static_cast<std::size_t>(field.components);
      for (const Index e : stay)
        for (std::size_t i = 0; i < n; ++i) part.values.push_back(field.values[n * e + i]);
      some.push_back(std::move(part));
    }
    return some;
  }

  void add_cohesive() {
    const auto n = 2 * static_cast<std::size_t>(whole.dimension);
    const CohesiveElements& all = whole.cohesive;
    CohesiveElements& some = result.mesh.cohesive;
    for (std::size_t e = 0; e < all.size(); ++e) {
      if (!all_stay(&all.vertices[n * e], n)) continue;
      for (std::size_t i = 0; i < n; ++i)
        some.vertices.push_back(new_place[all.vertices[n * e + i]]);
      some.numbers.push_back(all.numbers[e]);
      some.names.push_back(all.names[e]);
    }
  }

  void add_periodic() {
    for (const Periodicity& all : whole.periodic) {
      Periodicity some{all.dimension, all.entity, all.master, all.affine, {}};
      for (const auto& pair : all.pairs)
        if (stays(pair.vertex) && stays(pair.master))
          some.pairs.push_back({new_place[pair.vertex], new_place[pair.master]});
      if (!some.pairs.empty()) result.mesh.periodic.push_back(std::move(some));
    }
  }
};

}  // namespace

SubMesh sub_mesh(const Mesh& mesh, std::span<const Index> cells, std::span<const Index> loose) {
  Part part{mesh, {}, {}};
  Mesh& some = part.result.mesh;
  some.source = mesh.source;
  some.dimension = mesh.dimension;
  some.two_dimensional_points = mesh.two_dimensional_points;
  some.msh_version = mesh.msh_version;
  some.msh_binary = mesh.msh_binary;
  part.number_points(cells, loose);
  const auto top = static_cast<std::size_t>(mesh.dimension);
  Places facets;
  for (std::size_t d = 0; d < top; ++d) {
    Places stay = part.elements_that_stay(d, cells);
    part.add_elements(d, stay);
    if (d + 1 == top) facets = std::move(stay);
  }
  const Places stay(cells.begin(), cells.end());
  part.add_elements(top, stay);
  some.point_fields = Part::fields(mesh.point_fields, part.result.place);
  some.cell_fields = Part::fields(mesh.cell_fields, stay);
  some.facet_fields = Part::fields(mesh.facet_fields, facets);
  part.add_cohesive();
  part.add_periodic();
  return std::move(part.result);
}

}  // namespace cleave::app
