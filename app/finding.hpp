#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cleave/topology/violation.hpp"
#include "mesh.hpp"
#include "severity.hpp"

namespace cleave::app {

/// What a witness is made of: a number of the file, a list of them, a list of lists, a measure, or
/// a word.
using WitnessValue =
    std::variant<std::int64_t, std::uint64_t, double, std::string, std::vector<std::uint64_t>,
                 std::vector<std::vector<std::uint64_t>>>;

/// One thing that is wrong with a mesh: a witness first, a message second.
struct Finding {
  std::string rule;  // a name of check_rules.hpp
  Severity severity = Severity::error;
  std::string message;                                        // one line, the file's own numbers
  std::vector<std::pair<std::string, WitnessValue>> witness;  // by key, the file's own numbers
};

/// A violation of the topology as a finding. It is an error if a complex of level `required` must
/// not have it, or if it is about cells themselves or their orientation; else a warning.
Finding finding_of(const topology::Violation& violation, const Mesh& mesh,
                   topology::Level required);

}  // namespace cleave::app
