#pragma once
#include <vector>

#include "cut_output.hpp"
#include "element_images.hpp"

namespace cleave::app {

/// Fills `output.mesh` with the elements below the cells and with all groups: see cut_output.
/// Facets asked for that opened or are shut in `incision` become the groups NAME_minus, NAME_plus
/// and NAME_shut. Adds to output.one_sided and output.warnings.
template <int D>
void carry_elements(const Renaming<D>& renaming, const topology::Incision<D>& incision,
                    const std::vector<NamedFacets>& asked, CutOutput& output);

}  // namespace cleave::app
