#pragma once
#include <string>
#include <string_view>

namespace cleave::app::page {

/// The bytes of a file of this folder or of third_party/three, by its name without folder, as they
/// were when the program was built. Throws std::logic_error for a name that was not embedded.
std::string asset(std::string_view name);

}  // namespace cleave::app::page
