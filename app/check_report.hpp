#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "check_settings.hpp"
#include "cleave/topology/summary.hpp"
#include "finding.hpp"
#include "progress.hpp"

namespace cleave::app {

/// All that `cleave check` has to say about one mesh.
struct CheckReport {
  std::string source;
  std::string unreadable;  // why there is no mesh; empty: there is, and the rest holds
  int dimension = 0;
  std::size_t cells = 0, vertices = 0;
  std::size_t edge_nodes = 0, cohesive = 0;  // nodes of second order, which are no vertices;
                                             // cohesive elements, which are no cells
  topology::Level level{};                   // the highest one reached
  std::vector<Finding> findings;             // topology by kind, then geometry; none off
  topology::Summary topology;
  std::optional<std::vector<std::size_t>> betti;  // b_0 .. b_D; none: not counted
  std::vector<std::string> undecided;             // rules without meaning while others are broken

  std::size_t count(Severity severity) const;
};

/// Applies every rule to `mesh`, in kCheckStages stages of `progress`.
inline constexpr std::size_t kCheckStages = 3;
CheckReport check_mesh(const Mesh& mesh, const CheckSettings& settings,
                       Progress* progress = nullptr);

/// One line per finding ("SOURCE: error: rule: message"), of a long list of one rule and severity
/// the first `at_most` and a line that counts the others; at the end, with `summary`, a line on the
/// whole.
std::string text_of(const CheckReport& report, std::size_t at_most, bool summary);

/// After the texts of several reports: which rules to look up, and, for more than one report or if
/// some files were excluded, a line that counts everything. Empty: there is nothing to say.
std::string closing_text(const std::vector<CheckReport>& reports, std::size_t excluded);

/// The reports as JSON (docs/schemas/cleave-check-1.schema.json): of one mesh an object, of another
/// number a list of objects in the order of the files.
std::string json_of(const std::vector<CheckReport>& reports);

/// The reports in the Static Analysis Results Interchange Format, SARIF 2.1.0: rules with their
/// help, results with the witness, and fingerprints that stay as long as rule and witness do. Files
/// below the working folder are named relative to it. Of one rule, severity and file
/// at most `at_most` results are given; the message of the last one counts the others.
std::string sarif_of(const std::vector<CheckReport>& reports, std::size_t at_most);

/// The reports as JUnit XML: a suite per file and a case per rule, which fails if a finding of it
/// is an error and is skipped if the rule is undecided; a file that cannot be read is an error of
/// the case `readable`. Of long lists the first `at_most` messages are given.
std::string junit_of(const std::vector<CheckReport>& reports, std::size_t at_most);

}  // namespace cleave::app
