#pragma once
#include <array>
#include <vector>

#include "page.hpp"

namespace cleave::app::page {

/// Throws std::invalid_argument as write_page says.
void require_consistent(const PageData& data);

/// The middle of the bounding box of `points` (3 numbers each); zeros if there are none.
std::array<double, 3> middle(const std::vector<double>& points);

/// Numbers, 3 per place, relative to `origin`, rounded to 32-bit floats.
std::vector<float> as_floats(const std::vector<double>& triples,
                             const std::array<double, 3>& origin = {});

}  // namespace cleave::app::page
