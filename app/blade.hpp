#pragma once
#include <array>
#include <vector>

#include "cleave/cutting/sweep.hpp"
#include "json_value.hpp"

namespace cleave::app {

/// The successive positions of a blade's two ends: [[p, q], ..], at least two of them, as sweep
/// files and scenes write it. Throws InputError with the place in the file.
std::vector<std::array<cutting::Point<3>, 2>> read_blade(const JsonValue& blade);

}  // namespace cleave::app
