#pragma once
#include <vector>

#include "cleave/topology/unglue.hpp"
#include "corner_marks.hpp"

namespace cleave::topology::detail {

/// The memory that verify_touched works in, kept from one time to the next. It holds nothing that a
/// later verification reads.
struct VerifyScratch {
  /// A corner of a star, and where the walk came in; the corner itself, where it began.
  struct Reached {
    CornerId corner;
    HalfFacetId through;
  };

  CornerMarks reached;
  std::vector<Index> star_cells;
  std::vector<Reached> star;
};

template <int D>
void verify_touched(const Complex<D>& k, const FacetSet& cut, const Relabelling& change,
                    VerifyScratch& scratch);

}  // namespace cleave::topology::detail
