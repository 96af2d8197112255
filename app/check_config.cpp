#include "check_config.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>
#include <variant>

#include "check_rules.hpp"
#include "files/input_text.hpp"
#include "glob.hpp"
#include "json_value.hpp"

namespace cleave::app {
namespace {

using topology::Level;

std::map<std::string, Severity> severities(const JsonValue& value) {
  constexpr std::array kSeverities = {Severity::off, Severity::note, Severity::warning,
                                      Severity::error};
  std::map<std::string, Severity> found;
  for (const auto& [rule, severity] : value.members()) {
    if (find_rule(rule) == nullptr)
      severity.fail("there is no rule \"" + rule + "\"; rules are " + rule_names());
    found[rule] = kSeverities[severity.choice({"off", "note", "warning", "error"})];
  }
  return found;
}

double not_negative(const JsonValue& value) {
  const double number = value.number();
  if (!(number >= 0) || std::isinf(number)) value.fail("a number from 0 on is needed");
  return number;
}

SettingsChange settings_of(const JsonValue& value) {
  constexpr std::array kLevels = {Level::pseudo_manifold, Level::cut_regular, Level::edge_regular,
                                  Level::manifold};
  constexpr std::array kHoles = {CountHoles::automatic, CountHoles::always, CountHoles::never};
  SettingsChange change;
  if (value.has("require"))
    change.required = kLevels[value["require"].choice(
        {"pseudo-manifold", "cut-regular", "edge-regular", "manifold"})];
  if (value.has("severity")) change.severity = severities(value["severity"]);
  if (value.has("flat_ratio")) change.flat_ratio = not_negative(value["flat_ratio"]);
  if (value.has("coincident_distance"))
    change.coincident_distance = not_negative(value["coincident_distance"]);
  if (value.has("betti"))
    change.betti = kHoles[value["betti"].choice({"automatic", "always", "never"})];
  return change;
}

std::vector<std::string> patterns(const JsonValue& value) {
  std::vector<std::string> found;
  for (const JsonValue& item : value.items()) {
    found.push_back(item.string());
    if (found.back().empty()) item.fail("an empty pattern matches nothing");
  }
  return found;
}

// For each rule of the topology by its name the level that a finding of it keeps a mesh from.
template <std::size_t... I>
std::map<std::string, Level> levels_by_rule(std::index_sequence<I...>) {
  std::map<std::string, Level> levels;
  for (const topology::Violation& violation :
       {topology::Violation(std::variant_alternative_t<I, topology::Violation>{})...})
    levels.emplace(topology::rule(violation), topology::breaks(violation));
  return levels;
}

void forget_severities_up_to(Level required, CheckSettings& settings) {
  constexpr std::size_t kKinds = std::variant_size_v<topology::Violation>;
  for (const auto& [rule, level] : levels_by_rule(std::make_index_sequence<kKinds>{}))
    if (level != Level::none && level <= required) settings.severity.erase(rule);
}

bool any_names(const std::vector<std::string>& patterns, const std::filesystem::path& file,
               const std::filesystem::path& folder) {
  return std::any_of(patterns.begin(), patterns.end(),
                     [&](const std::string& pattern) { return glob_names(pattern, file, folder); });
}

}  // namespace

void SettingsChange::apply_to(CheckSettings& settings) const {
  settings.required = required.value_or(settings.required);
  for (const auto& [rule, value] : severity) settings.severity[rule] = value;
  settings.flat_ratio = flat_ratio.value_or(settings.flat_ratio);
  settings.coincident_distance = coincident_distance.value_or(settings.coincident_distance);
  settings.betti = betti.value_or(settings.betti);
}

bool CheckConfig::excludes(const std::filesystem::path& file) const {
  return any_names(exclude, file, folder);
}

CheckSettings CheckConfig::settings_for(const std::filesystem::path& file,
                                        const SettingsChange& command_line) const {
  CheckSettings settings_of_file;
  settings.apply_to(settings_of_file);
  for (const Override& one : overrides)
    if (any_names(one.files, file, folder)) one.settings.apply_to(settings_of_file);
  if (command_line.required) forget_severities_up_to(*command_line.required, settings_of_file);
  command_line.apply_to(settings_of_file);
  return settings_of_file;
}

CheckConfig read_check_config(const std::filesystem::path& path) {
  const InputText text(path);
  const nlohmann::json document = parse_json(text.bytes(), path.string());
  const JsonValue top(document, path.string());
  top.only({"$schema", "require", "severity", "flat_ratio", "coincident_distance", "betti",
            "max_findings", "exclude", "overrides"});
  CheckConfig config;
  config.folder = path.parent_path();
  config.settings = settings_of(top);
  if (top.has("max_findings"))
    config.max_findings = static_cast<std::size_t>(top["max_findings"].count());
  if (top.has("exclude")) config.exclude = patterns(top["exclude"]);
  if (top.has("overrides"))
    for (const JsonValue& one : top["overrides"].items()) {
      one.only({"files", "require", "severity", "flat_ratio", "coincident_distance", "betti"});
      config.overrides.push_back({patterns(one["files"]), settings_of(one)});
    }
  return config;
}

std::optional<std::filesystem::path> find_check_config(const std::filesystem::path& folder) {
  std::error_code ignored;
  std::filesystem::path at = std::filesystem::absolute(folder, ignored);
  while (true) {
    const std::filesystem::path candidate = at / ".cleave-check.json";
    if (std::filesystem::is_regular_file(candidate, ignored)) return candidate;
    if (!at.has_relative_path()) return std::nullopt;
    at = at.parent_path();
  }
}

}  // namespace cleave::app
