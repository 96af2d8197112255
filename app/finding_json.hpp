#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "finding.hpp"

namespace cleave::app {

/// The witness as an object, its keys in the order of the finding.
nlohmann::ordered_json json_of_witness(const Finding& finding);

/// The document as text with a line end; bytes that are not UTF-8 become U+FFFD.
std::string text_of_json(const nlohmann::ordered_json& document);

}  // namespace cleave::app
