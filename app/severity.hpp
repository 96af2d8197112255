#pragma once
#include <string_view>

namespace cleave::app {

/// How much a finding weighs: only an error makes `cleave check` exit with 1; what is off is not
/// reported at all.
enum class Severity { off, note, warning, error };

constexpr std::string_view name(Severity severity) {
  switch (severity) {
    case Severity::off:
      return "off";
    case Severity::note:
      return "note";
    case Severity::warning:
      return "warning";
    case Severity::error:
      return "error";
  }
  return "";
}

}  // namespace cleave::app
