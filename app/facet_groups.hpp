#pragma once
#include <array>
#include <vector>

#include "cut_output.hpp"
#include "node_images.hpp"

namespace cleave::app {

/// The images of the elements of each dimension below D, and of the nodes of second order.
template <int D>
struct Carried {
  std::array<Images, 3> elements;
  NodeImages<D> nodes;
};

/// Fills `output.mesh` with the elements below the cells, the fields on facets and all groups: see
/// cut_output. Facets asked for that opened or are shut in `incision` become the groups NAME_minus,
/// NAME_plus and NAME_shut. Fills output.sides; adds to output.one_sided and output.warnings.
template <int D>
void carry_elements(const Renaming<D>& renaming, const Carried<D>& images,
                    const topology::Incision<D>& incision, const std::vector<NamedFacets>& asked,
                    CutOutput& output);

}  // namespace cleave::app
