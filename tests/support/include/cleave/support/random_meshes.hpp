#pragma once
#include <array>
#include <string_view>

#include "cleave/support/meshes.hpp"
#include "cleave/support/rng.hpp"

namespace cleave::support {

/// The classes of input that every property meets. All give orientable pseudo-manifolds; `stellar`
/// gives balls, the others may give meshes that are not cut-regular, `pinched` always (D >= 2).
enum class MeshClass {
  scattered,  // random cells of a Kuhn grid: pinched vertices, several pieces
  pinched,  // every second cube of a Kuhn grid, and some more: cubes that touch in vertices, ridges
  hollow,   // a Kuhn grid without the star of an inner vertex, or without an inner cube
  stellar,  // random stellar subdivisions of a small mesh
  irregular,  // random cavities replaced by cones, as Delaunay insertion does, without geometry
  closed      // spheres, tori, suspensions of these; refined at random
};

inline constexpr std::array<MeshClass, 6> kMeshClasses{MeshClass::scattered, MeshClass::pinched,
                                                       MeshClass::hollow,    MeshClass::stellar,
                                                       MeshClass::irregular, MeshClass::closed};

std::string_view name(MeshClass mesh_class);

/// A random mesh of the class, never empty, with some 10 to 350 cells, each with its tuple, the
/// cells and the vertex numbers in random order.
template <int D>
Mesh<D> random_mesh(MeshClass mesh_class, Rng& rng);

/// Stars a random simplex (dimension 1 .. D): every cell around it is replaced by its cone from a
/// new vertex.
template <int D>
void subdivide(Mesh<D>& mesh, Rng& rng);

/// Replaces a random facet-connected set of at most `largest` cells by the cone of its boundary
/// from a new vertex. Leaves the mesh alone if the set's boundary touches itself in a ridge.
template <int D>
void insert_vertex(Mesh<D>& mesh, std::size_t largest, Rng& rng);

/// Random order of cells, of each tuple, and random vertex numbers; unused vertices go.
template <int D>
void scramble(Mesh<D>& mesh, Rng& rng);

}  // namespace cleave::support
