#pragma once
#include <string>
#include <string_view>

namespace cleave::app {

/// `text` as XML 1.0 takes it in an element and in a quoted attribute. What XML has no way to say
/// becomes U+FFFD: control characters, U+FFFE and U+FFFF, and bytes that are not UTF-8.
std::string xml_text(std::string_view text);

}  // namespace cleave::app
