#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "cleave/topology/summary.hpp"
#include "finding.hpp"

namespace cleave::app {

/// All that `cleave check` has to say about one mesh.
struct CheckReport {
  std::string source;
  int dimension = 0;
  std::size_t cells = 0, vertices = 0;
  std::size_t edge_nodes = 0, cohesive = 0;  // nodes of second order, which are no vertices;
                                             // cohesive elements, which are no cells
  topology::Level level{};                   // the highest one reached
  std::vector<Finding> findings;             // topology by kind, then geometry
  topology::Summary topology;

  /// How many findings are errors.
  std::size_t errors() const;
};

/// Applies every rule to `mesh`. Findings above the level `required` are warnings.
CheckReport check_mesh(const Mesh& mesh, topology::Level required);

/// One line per finding ("SOURCE: error: rule: message"), of a long list of one rule the first
/// `at_most` and a line that counts the others; at the end, with `summary`, a line on the whole.
std::string text_of(const CheckReport& report, std::size_t at_most, bool summary);

/// The report as JSON (docs/schemas/cleave-check-1.schema.json): of one mesh an object, of several
/// a list of objects in the order of the command line.
std::string json_of(const std::vector<CheckReport>& reports);

}  // namespace cleave::app
