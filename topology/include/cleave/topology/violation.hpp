#pragma once
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "cleave/topology/ids.hpp"

namespace cleave::topology {

/// How well-behaved a complex is; each level includes the ones before it.
/// edge-regular: the cells around every simplex of dimension 1 .. D-2 form one part (D >= 3; always
/// true below). manifold: every vertex link is a sphere or a ball (decided for D <= 3).
enum class Level { none, pseudo_manifold, cut_regular, edge_regular, manifold };

std::string_view name(Level level);  // "pseudo-manifold", ..

/// A cell names a vertex twice.
struct DegenerateCell {
  CellId cell;
  VertexId repeated;
};
/// A cell names a vertex that does not exist (its number is vertex_count or more).
struct VertexOutOfRange {
  CellId cell;
  VertexId vertex;
};
/// Two cells have the same vertices.
struct DuplicateCell {
  CellId first, second;
};
/// A facet belongs to three cells or more: all its half-facets, ascending.
struct FacetInThreeCells {
  std::vector<HalfFacetId> half_facets;
};
/// Two cells induce the same orientation on their common facet, but other signs would mend it.
struct OrientationConflict {
  HalfFacetId one, other;
};
/// No choice of signs is coherent. Walk the loop to see it: leave the cell of loop[i] through
/// loop[i] into the cell of loop[i+1] (cyclic); an odd number of these steps join tuples that
/// induce the same orientation on the facet between them. The loop is a shortest one of its piece,
/// unless the piece is so large and wound that not all candidates could be tried.
struct NonOrientable {
  std::vector<HalfFacetId> loop;
};
/// The cells around `vertex` fall into several facet-connected parts (Definition 4).
struct NotCutRegular {
  VertexId vertex;
  CellId one_part, other_part;  // any cell of each: enough to re-check by hand
  std::size_t parts;
};
/// The cells around a simplex of dimension 1 .. D-2 (an edge, when D = 3) fall into several parts.
struct PinchedSimplex {
  std::vector<VertexId> simplex;
  CellId one_part, other_part;
  std::size_t parts;
};
/// The link of `vertex` is neither a sphere nor a ball.
struct BadVertexLink {
  VertexId vertex;
  int euler_characteristic;
  int boundary_components;
};
/// No cell uses `vertex`.
struct OrphanVertex {
  VertexId vertex;
};

using Violation = std::variant<DegenerateCell, VertexOutOfRange, DuplicateCell, FacetInThreeCells,
                               OrientationConflict, NonOrientable, NotCutRegular, PinchedSimplex,
                               BadVertexLink, OrphanVertex>;

/// The rule a violation breaks, as the command line and JSON name it: "duplicate-cell", ..
std::string_view rule(const Violation& violation);

/// The first level that a complex with this violation does not reach. Level::none where the
/// violation keeps it from no level: an orphan vertex, and orientation, which the levels do not
/// speak of (but `assemble` asks for).
Level breaks(const Violation& violation);

/// One line of plain words with the 0-based ids of the witness.
std::string describe(const Violation& violation);

/// Thrown by what makes a Complex. `violations` are those that `check` gives for the same input.
class InvalidComplex : public std::invalid_argument {
 public:
  explicit InvalidComplex(std::vector<Violation> all);
  std::vector<Violation> violations;
};

/// An invariant of this library broke: a defect of ours, not of the input.
class InvariantBroken : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

}  // namespace cleave::topology
