#include "cleave/topology/boundary.hpp"

#include "cleave/topology/assemble.hpp"

namespace cleave::topology {

template <int D>
std::vector<HalfFacetId> boundary(const Complex<D>& k) {
  std::vector<HalfFacetId> free;
  for (Index h = 0; h < k.half_facet_count(); ++h)
    if (!k.is_interior({h})) free.push_back({h});
  return free;
}

namespace {

/// The vertices of `half_facets`, ascending, and the number that each has among them.
struct BoundaryVertices {
  std::vector<VertexId> ascending;
  std::vector<VertexId> number_of;  // meaningful for the vertices of `ascending` alone
};

template <int D>
BoundaryVertices vertices_of(const Complex<D>& k, const std::vector<HalfFacetId>& half_facets) {
  std::vector<bool> used(k.vertex_count());
  for (const HalfFacetId h : half_facets)
    for (const VertexId vertex : k.facet(h)) used[vertex.value] = true;
  BoundaryVertices found{{}, std::vector<VertexId>(k.vertex_count())};
  for (Index vertex = 0; vertex < used.size(); ++vertex) {
    if (!used[vertex]) continue;
    found.number_of[vertex] = {static_cast<Index>(found.ascending.size())};
    found.ascending.push_back({vertex});
  }
  return found;
}

}  // namespace

template <int D>
requires(D >= 2) std::variant<BoundaryComplex<D>, std::vector<Violation>> boundary_complex(
    const Complex<D>& k) {
  std::vector<HalfFacetId> half_facets = boundary(k);
  BoundaryVertices vertices = vertices_of(k, half_facets);
  CellSoup<D - 1> soup;
  soup.vertex_count = vertices.ascending.size();
  soup.cells.reserve(half_facets.size());
  soup.signs.reserve(half_facets.size());
  for (const HalfFacetId h : half_facets) {
    Cell<D - 1> cell = k.facet(h);
    for (VertexId& vertex : cell) vertex = vertices.number_of[vertex.value];
    soup.cells.push_back(cell);
    soup.signs.push_back(static_cast<std::int8_t>(k.facet_sign(h)));
  }
  try {
    return BoundaryComplex<D>{assemble(std::move(soup)), std::move(half_facets),
                              std::move(vertices.ascending)};
  } catch (InvalidComplex& invalid) {
    return std::move(invalid.violations);
  }
}

template std::vector<HalfFacetId> boundary(const Complex<1>&);
template std::vector<HalfFacetId> boundary(const Complex<2>&);
template std::vector<HalfFacetId> boundary(const Complex<3>&);
template std::vector<HalfFacetId> boundary(const Complex<4>&);
template std::variant<BoundaryComplex<2>, std::vector<Violation>> boundary_complex(
    const Complex<2>&);
template std::variant<BoundaryComplex<3>, std::vector<Violation>> boundary_complex(
    const Complex<3>&);
template std::variant<BoundaryComplex<4>, std::vector<Violation>> boundary_complex(
    const Complex<4>&);

}  // namespace cleave::topology
