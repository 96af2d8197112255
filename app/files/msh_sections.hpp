#pragma once
#include <string_view>
#include <vector>

#include "files/msh_content.hpp"

namespace cleave::app {

/// The first section of a file: what the rest is like, and where that starts.
struct MshHead {
  MshVersion version;
  bool binary, swapped;  // the bytes of numbers come in the order that is not the machine's
  const char* end;
};

/// Reads $MeshFormat, which comes first ($Comments may come before it). Throws InputError for what
/// is no gmsh file of a version that is known.
MshHead read_msh_head(const InputText& text);

/// The section that `line`, a line between sections, opens, with an end where a line closes it.
/// Throws InputError if it opens none, or if none closes it.
MshSection msh_section(const InputText& text, const Row& line);

/// The end of the line at `section_end` in `text`, which must close the section `name`. Throws
/// InputError if it does not.
const char* msh_closed(const InputText& text, const char* section_end, std::string_view name);

}  // namespace cleave::app
