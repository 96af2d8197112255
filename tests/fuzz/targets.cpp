#include "targets.hpp"

#include <algorithm>
#include <array>

namespace cleave::fuzz {
namespace {

constexpr std::array kTargets{
    Target{"medit", [](Bytes bytes) { fuzz_mesh(".mesh", Keeps::everything, bytes); }},
    Target{"msh", [](Bytes bytes) { fuzz_mesh(".msh", Keeps::everything, bytes); }},
    Target{"vtk", [](Bytes bytes) { fuzz_mesh(".vtk", Keeps::everything, bytes); }},
    Target{"vtu", [](Bytes bytes) { fuzz_mesh(".vtu", Keeps::everything, bytes); }},
    Target{"tetgen", [](Bytes bytes) { fuzz_mesh(".ele", Keeps::cells, bytes); }},
    Target{"abaqus", [](Bytes bytes) { fuzz_mesh(".inp", Keeps::cells, bytes); }},
    Target{"request", fuzz_request},
    Target{"record", fuzz_record},
    Target{"certificate", fuzz_certificate},
    Target{"config", fuzz_config},
    Target{"scene", fuzz_scene},
    Target{"topology", fuzz_topology},
};

}  // namespace

std::span<const Target> targets() { return kTargets; }

const Target* find_target(std::string_view name) {
  const auto found = std::find_if(kTargets.begin(), kTargets.end(),
                                  [&](const Target& target) { return target.name == name; });
  return found == kTargets.end() ? nullptr : &*found;
}

}  // namespace cleave::fuzz
