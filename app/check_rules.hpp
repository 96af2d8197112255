#pragma once
#include <span>
#include <string>
#include <string_view>

#include "severity.hpp"

namespace cleave::app {

/// One thing that `cleave check` looks for, and all that is said of it: the pages in docs/checks,
/// the help in SARIF and `cleave check --explain` have their text from here.
struct Rule {
  std::string_view name;
  std::string_view title;     // what a finding says, in a few words
  std::string_view subject;   // "Cells", "Facets", ..: what it is about
  std::string_view severity;  // of a finding unless a configuration says otherwise, in words
  Severity usual;             // the same at the usual required level
  std::string_view meaning, matters, mend, by_hand;
};

/// All rules, in the order in which they are reported.
std::span<const Rule> rules();

/// The rule of this name, or null.
const Rule* find_rule(std::string_view name);

/// The place of a rule in `rules()`. Throws std::logic_error if there is no such rule.
std::size_t place_of_rule(std::string_view name);

/// The names of all rules, for a message: "degenerate-cell, duplicate-cell, ..".
std::string rule_names();

/// Everything that is said of a rule, as plain text in lines of at most 80 characters.
std::string explanation(const Rule& rule);

/// The same as Markdown, without a heading.
std::string explanation_markdown(const Rule& rule);

/// One line per rule: name, severity, title.
std::string list_of_rules();

}  // namespace cleave::app
