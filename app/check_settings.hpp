#pragma once
#include <map>
#include <optional>
#include <string>

#include "cleave/topology/violation.hpp"
#include "geometry_check.hpp"
#include "severity.hpp"

namespace cleave::app {

/// Whether holes are counted (topology::betti_numbers): `automatic` does for meshes of moderate
/// size, which takes about as long as everything else that is checked.
enum class CountHoles { automatic, always, never };

/// How one mesh is checked.
struct CheckSettings {
  topology::Level required = topology::Level::cut_regular;  // what is above is a warning
  std::map<std::string, Severity> severity;                 // of rules that differ from the usual
  double flat_ratio = kFlatRatio;                           // of flat-cell
  double coincident_distance = 0;                           // of coincident-vertices; 0: equal
  CountHoles betti = CountHoles::automatic;
};

/// What a command line, a configuration or a part of one says about settings; the rest stays.
struct SettingsChange {
  std::optional<topology::Level> required;
  std::map<std::string, Severity> severity;
  std::optional<double> flat_ratio, coincident_distance;
  std::optional<CountHoles> betti;

  void apply_to(CheckSettings& settings) const;
};

}  // namespace cleave::app
