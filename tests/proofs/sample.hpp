#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "certificate.hpp"
#include "cleave/support/cuts.hpp"
#include "cleave/support/defects.hpp"
#include "cleave/support/random_meshes.hpp"

/// Random cuts and what C++ makes of them, as certificates.
namespace cleave::proofs {

using support::Rng;

struct Sample {
  app::Certificate certificate;
  std::vector<std::uint32_t> other_after;  // what a cut with a facet more or less makes; may be the
                                           // same up to names
  support::MeshClass mesh_class{};
  std::size_t asked = 0, opened = 0;  // distinct interior facets
  bool cut_regular = true;            // before
  bool pinched = false;               // a simplex below a vertex's level, before
};

/// The sample of this number: dimensions 1 to 4, classes of meshes and classes of cuts go round
/// with it, and every thirteenth cut is empty. Half of the results come from `unglue`, the others
/// from an incision that is cut in two stages with a facet too many, which is stitched. The cut may
/// repeat facets and name facets of the boundary.
Sample sample(std::uint64_t number, Rng& rng);

/// A certificate of a mesh that is none: with a cell that has a vertex twice, a cell twice, a facet
/// in three cells, or a row of the cut that is no facet.
enum class Fault { repeated_vertex, same_vertices, three_cells, no_facet };
app::Certificate faulty(Fault fault, int dimension, Rng& rng);

std::string text_of(const app::Certificate& certificate);

/// For each corner the least corner that has the same vertex: equal for cells that are the same up
/// to the names of vertices.
std::vector<std::uint32_t> classes(const std::vector<std::uint32_t>& vertices);

}  // namespace cleave::proofs
