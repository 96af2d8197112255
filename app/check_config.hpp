#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "check_settings.hpp"

namespace cleave::app {

/// The configuration of `cleave check`, as docs/checks.md describes the file.
struct CheckConfig {
  SettingsChange settings;
  std::optional<std::size_t> max_findings;  // shown per rule and file in text and JUnit
  std::vector<std::string> exclude;         // patterns, see glob.hpp
  struct Override {
    std::vector<std::string> files;  // patterns
    SettingsChange settings;
  };
  std::vector<Override> overrides;  // later ones win
  std::filesystem::path folder;     // what patterns are relative to: where the file lies

  /// Whether a pattern of `exclude` matches.
  bool excludes(const std::filesystem::path& file) const;

  /// The usual settings, changed by the configuration, by the overrides that match `file`, and by
  /// `command_line`, in this order. A level that `command_line` requires takes back what the
  /// configuration says of the severity of rules that keep a mesh from it.
  CheckSettings settings_for(const std::filesystem::path& file,
                             const SettingsChange& command_line) const;
};

/// Reads a configuration. Throws InputError that names the file and the place in it for everything
/// that is not as docs/schemas/cleave-check-config-1.schema.json has it, unknown keys and rules
/// too.
CheckConfig read_check_config(const std::filesystem::path& path);

/// The file `.cleave-check.json` of `folder` or of the nearest folder above it that has one.
std::optional<std::filesystem::path> find_check_config(const std::filesystem::path& folder);

}  // namespace cleave::app
