#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

namespace cleave::app {

/// Adds an option whose argument is one of `names`, each of which stands for a value. Any other
/// argument is wrong usage, answered with the names.
template <class Value>
CLI::Option* add_choice(CLI::App& command, const std::string& option, Value& value,
                        std::vector<std::pair<std::string, Value>> names,
                        const std::string& description) {
  const auto choose = [&value, option, names = std::move(names)](const std::string& text) {
    std::string known;
    for (const auto& [name, meaning] : names) {
      if (name == text) {
        value = meaning;
        return;
      }
      known += (known.empty() ? "" : ", ") + name;
    }
    throw CLI::ValidationError(option, "unknown value '" + text + "'; known are " + known);
  };
  return command.add_option_function<std::string>(option, choose, description);
}

}  // namespace cleave::app
