#include "cohesive.hpp"

#include <algorithm>

#include "error.hpp"

namespace cleave::app {

using topology::HalfFacetId;

namespace {

// The places of a facet's vertices in the file and now, seen from the cell of `h`, in an order that
// makes the element positive: D = 3, the normal points out of the cell; D = 2, the cell is on the
// right, since quadrangles are positive when the plus side is on the left of the first two.
template <int D>
struct Face {
  std::array<Index, static_cast<std::size_t>(D)> file{}, now{};
};

template <int D>
Face<D> face(const Body<D>& body, const Mesh& after, HalfFacetId h) {
  const std::size_t first = static_cast<std::size_t>(D + 1) * topology::cell_of<D>(h).value;
  Face<D> face;
  for (std::size_t i = 0, to = 0; i <= static_cast<std::size_t>(D); ++i) {
    if (static_cast<int>(i) == topology::local_index<D>(h)) continue;
    face.file[to] = body.mesh->cells().vertices[first + i];
    face.now[to++] = after.cells().vertices[first + i];
  }
  const bool outward = body.complex.facet_sign(h) > 0;
  if (outward != (D == 3)) {
    std::swap(face.file[0], face.file[1]);
    std::swap(face.now[0], face.now[1]);
  }
  return face;
}

}  // namespace

template <int D>
void add_cohesive(const Body<D>& body, CutOutput& output) {
  static_assert(D == 2 || D == 3);
  std::uint64_t next_number = 1;
  for (const Elements& elements : output.mesh.elements)
    for (const std::uint64_t number : elements.numbers)
      next_number = std::max(next_number, number + 1);
  CohesiveElements& cohesive = output.mesh.cohesive;
  for (const SidedFacet& side : output.sides) {
    const auto minus = face(body, output.mesh, side.minus);
    const auto plus = face(body, output.mesh, *body.complex.mate(side.minus));
    cohesive.vertices.insert(cohesive.vertices.end(), minus.now.begin(), minus.now.end());
    for (const Index place : minus.file) {
      const auto at = std::find(plus.file.begin(), plus.file.end(), place) - plus.file.begin();
      cohesive.vertices.push_back(plus.now[static_cast<std::size_t>(at)]);
    }
    cohesive.numbers.push_back(next_number++);
    cohesive.names.push_back(side.name + "_cohesive");
  }
}

void require_cohesive(const Mesh& mesh) {
  if (mesh.dimension == 1)
    throw InputError(mesh.source +
                     ": --cohesive puts prisms between tetrahedra and quadrangles between "
                     "triangles; this mesh has edges alone");
  if (mesh.cells().second_order())
    throw InputError(mesh.source +
                     ": --cohesive makes elements of first order, and the cells are of second "
                     "order; cut the mesh in first order (gmsh: Mesh.ElementOrder = 1)");
}

template void add_cohesive<2>(const Body<2>&, CutOutput&);
template void add_cohesive<3>(const Body<3>&, CutOutput&);

}  // namespace cleave::app
