#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace cleave::app {

/// Whether the whole `text` matches `pattern`: `?` is one character, `*` any number of them,
/// neither of them '/'; `**` is any number of any characters. Everything else is itself. Time: at
/// most the product of both lengths for each kind of star.
bool glob_matches(std::string_view pattern, std::string_view text);

/// Whether `pattern` speaks of `file` as seen from `folder`. A pattern without '/' matches the name
/// of the file or of a folder on the way to it; one with '/' matches the path from `folder` on, or
/// the beginning of it that ends with a folder. `./` at its beginning and '/' at its end are
/// ignored.
bool glob_names(std::string_view pattern, const std::filesystem::path& file,
                const std::filesystem::path& folder);

}  // namespace cleave::app
