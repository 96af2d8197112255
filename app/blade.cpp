#include "blade.hpp"

namespace cleave::app {

std::vector<std::array<cutting::Point<3>, 2>> read_blade(const JsonValue& blade) {
  std::vector<std::array<cutting::Point<3>, 2>> positions;
  for (const JsonValue& position : blade.items()) {
    const auto ends = position.items();
    if (ends.size() != 2) position.fail("the blade's two ends [[x,y,z],[x,y,z]] are needed");
    positions.push_back({ends[0].vector(), ends[1].vector()});
  }
  if (positions.size() < 2) blade.fail("a blade needs at least two positions to sweep anything");
  return positions;
}

}  // namespace cleave::app
