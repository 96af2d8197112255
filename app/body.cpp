#include "body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cleave/topology/arrays.hpp"
#include "cleave/topology/check.hpp"
#include "cleave/topology/locate.hpp"
#include "cleave/topology/pieces.hpp"
#include "edge_nodes.hpp"
#include "error.hpp"
#include "file_words.hpp"

namespace cleave::app {

using topology::CellId;
using topology::CellSoup;
using topology::HalfFacetId;
using topology::VertexId;

template <int D>
CellSoup<D> soup_of(const Mesh& mesh) {
  CellSoup<D> soup;
  soup.vertex_count = mesh.points.size();
  soup.cells.resize(mesh.cells().size());
  const Index* vertex = mesh.cells().vertices.data();
  for (auto& cell : soup.cells)
    for (VertexId& v : cell) v = {*vertex++};
  return soup;
}

template <int D>
topology::CellView<D> cells_of(const Mesh& mesh) {
  return topology::CellView<D>::of(topology::as_cells<D>(mesh.cells().vertices),
                                   mesh.points.size());
}

namespace {

// The first of what is wrong in words; `check` shows all of it.
InputError refusal(const Mesh& mesh, const std::vector<std::string>& wrong) {
  constexpr std::size_t kShown = 3;
  std::string text = mesh.source + ": this mesh cannot be used:";
  for (std::size_t i = 0; i < std::min(kShown, wrong.size()); ++i) text += "\n  " + wrong[i];
  if (wrong.size() > kShown) text += fmt::format("\n  and {} more", wrong.size() - kShown);
  return InputError(text + "\n`cleave check` lists every violation; mend the file and try again");
}

InputError refusal(const Mesh& mesh, const std::vector<topology::Violation>& violations) {
  std::vector<std::string> wrong;
  for (const auto& violation : violations) wrong.push_back(describe_in_file(violation, mesh));
  return refusal(mesh, wrong);
}

void require_sound_nodes(const Mesh& mesh) {
  std::vector<std::string> wrong;
  for (Finding& finding : check_edge_nodes(mesh)) wrong.push_back(std::move(finding.message));
  if (!wrong.empty()) throw refusal(mesh, wrong);
}

void require_no_cohesive(const Mesh& mesh) {
  if (mesh.cohesive.size() == 0) return;
  throw InputError(fmt::format(
      "{}: holds {} (the first is {}), which join the two sides of a cut made before; cut the mesh "
      "it was made from along all facets at once",
      mesh.source, counted(mesh.cohesive.size(), "cohesive element"),
      mesh.cohesive.numbers.front()));
}

void require_finite(const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    for (const double x : mesh.points[i])
      if (!std::isfinite(x))
        throw InputError(
            fmt::format("{}: vertex {} has a coordinate that is not finite ({}); mend "
                        "the file",
                        mesh.source, mesh.vertex_numbers[i], x));
}

// D! times the signed volume of a cell, in double precision: enough for a sum over a piece.
template <int D>
double signed_volume(const Mesh& mesh, Index cell) {
  const Index* vertex = &mesh.cells().vertices[static_cast<std::size_t>(D + 1) * cell];
  const auto& origin = mesh.points[vertex[0]];
  std::array<std::array<double, 3>, 3> e{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(D); ++i)
    for (std::size_t x = 0; x < 3; ++x) e[i][x] = mesh.points[vertex[i + 1]][x] - origin[x];
  if constexpr (D == 2) return e[0][0] * e[1][1] - e[0][1] * e[1][0];
  return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
         e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
         e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
}

// Turns over the signs of the pieces whose oriented volume is negative; false if there are none.
template <int D>
bool turn_over(const Mesh& mesh, const topology::Complex<D>& k, std::vector<std::int8_t>& signs) {
  if (D == 1 || (D == 2 && !is_planar(mesh))) return false;
  const auto pieces = topology::pieces(k);
  std::vector<double> volume(pieces.count);
  for (Index c = 0; c < signs.size(); ++c)
    volume[pieces.of_cell[c]] += signs[c] * signed_volume<D>(mesh, c);
  bool any = false;
  for (Index c = 0; c < signs.size(); ++c) {
    if (!(volume[pieces.of_cell[c]] < 0)) continue;
    signs[c] = static_cast<std::int8_t>(-signs[c]);
    any = true;
  }
  return any;
}

}  // namespace

template <int D>
Body<D> make_body(const Mesh& mesh, const HowFar& how_far) {
  require_finite(mesh);
  require_sound_nodes(mesh);
  require_no_cohesive(mesh);
  try {
    auto oriented = topology::orient(cells_of<D>(mesh));
    if (const auto* witness = std::get_if<topology::NonOrientable>(&oriented))
      throw refusal(mesh, {*witness});
    auto& signs = std::get<std::vector<std::int8_t>>(oriented);
    const auto assembled = [&] {
      CellSoup<D> soup = soup_of<D>(mesh);
      soup.signs = signs;
      return topology::assemble_regularized(std::move(soup), {.progress = how_far});
    };
    auto made = assembled();
    // `orient` gave the first cell of each piece +1; where that cell is inverted, the piece is
    // turned over and assembled again, in the memory of the first try.
    if (turn_over(mesh, made.complex, signs)) {
      made = {};
      made = assembled();
    }
    return {&mesh, std::move(made.complex), std::move(made.splits)};
  } catch (const topology::InvalidComplex& e) {
    throw refusal(mesh, e.violations);
  }
}

bool is_planar(const Mesh& mesh) {
  if (mesh.two_dimensional_points) return true;
  return std::all_of(mesh.points.begin(), mesh.points.end(),
                     [&](const auto& p) { return p[2] == mesh.points.front()[2]; });
}

template <int D>
std::vector<std::array<double, static_cast<std::size_t>(D)>> points_of(const Body<D>& body) {
  const Mesh& mesh = *body.mesh;
  if (D == 2 && !is_planar(mesh))
    throw InputError(mesh.source +
                     ": the triangles do not lie in a plane z = constant, so nothing "
                     "can be swept through them; name facets instead (--facets, --group)");
  std::vector<std::array<double, static_cast<std::size_t>(D)>> points(body.complex.vertex_count());
  for (Index v = 0; v < points.size(); ++v)
    std::copy_n(mesh.points[body.place({v})].begin(), D, points[v].begin());
  return points;
}

template <int D>
std::vector<HalfFacetId> locate(const Mesh& mesh, std::span<const Index> facets,
                                const std::string& asked_by) {
  std::vector<topology::Facet<D>> tuples(facets.size() / D);
  for (std::size_t i = 0; i < facets.size(); ++i) tuples[i / D][i % D] = {facets[i]};
  const auto found = topology::locate_facets<D>(cells_of<D>(mesh).cells, tuples);

  std::vector<HalfFacetId> located;
  for (std::size_t i = 0; i < tuples.size(); ++i) {
    if (!found[i]) {
      std::vector<std::uint64_t> numbers;
      for (const VertexId v : tuples[i]) numbers.push_back(vertex_number(mesh, v));
      throw InputError(
          fmt::format("{}: {} asks for the facet ({}), which no cell has; check the "
                      "vertex numbers",
                      mesh.source, asked_by, listed(numbers)));
    }
    located.push_back(*found[i]);
  }
  return located;
}

template <int D>
SortedOut sort_out(const topology::Complex<D>& k, std::span<const HalfFacetId> facets) {
  std::vector<HalfFacetId> interior;
  SortedOut sorted;
  for (const HalfFacetId h : facets) (k.is_interior(h) ? interior : sorted.boundary).push_back(h);
  sorted.interior = topology::FacetSet::of(k, std::span<const HalfFacetId>(interior));
  std::sort(sorted.boundary.begin(), sorted.boundary.end());
  sorted.boundary.erase(std::unique(sorted.boundary.begin(), sorted.boundary.end()),
                        sorted.boundary.end());
  return sorted;
}

const Group& facet_group(const Mesh& mesh, const std::string& name) {
  std::string names;
  for (const Group& group : mesh.groups) {
    if (group.dimension != mesh.dimension - 1) continue;
    if (group.name == name) return group;
    names += (names.empty() ? "" : ", ") + group.name;
  }
  throw InputError(fmt::format(
      "{}: no facet group is named \"{}\"; {}", mesh.source, name,
      names.empty() ? "the file has no facet groups" : "the facet groups are: " + names));
}

std::vector<Index> vertices_of(const Mesh& mesh, const Group& group) {
  const auto& elements = mesh.elements[static_cast<std::size_t>(group.dimension)];
  const auto corners = static_cast<std::size_t>(group.dimension) + 1;
  std::vector<Index> vertices;
  vertices.reserve(corners * group.elements.size());
  for (const Index e : group.elements)
    for (std::size_t i = 0; i < corners; ++i)
      vertices.push_back(elements.vertices[corners * e + i]);
  return vertices;
}

#define CLEAVE_INSTANTIATE(D)                                                      \
  template CellSoup<D> soup_of<D>(const Mesh&);                                    \
  template topology::CellView<D> cells_of<D>(const Mesh&);                         \
  template Body<D> make_body<D>(const Mesh&, const HowFar&);                       \
  template std::vector<std::array<double, D>> points_of<D>(const Body<D>&);        \
  template std::vector<HalfFacetId> locate<D>(const Mesh&, std::span<const Index>, \
                                              const std::string&);                 \
  template SortedOut sort_out<D>(const topology::Complex<D>&, std::span<const HalfFacetId>);
CLEAVE_INSTANTIATE(1)
CLEAVE_INSTANTIATE(2)
CLEAVE_INSTANTIATE(3)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::app
