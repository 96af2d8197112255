#pragma once
#include <filesystem>

#include "files/vtk_files.hpp"

namespace cleave::app {

/// Throws InputError for what VTK would believe without a look, and allocate for, or read outside
/// of its memory by: a file that is missing, empty or not of the format; more points, cells or
/// compressed blocks than a file of its size can hold; cells of a legacy file whose lengths do not
/// fit their list. VTK checks the rest itself.
void precheck_vtk(const std::filesystem::path& path, VtkFormat format);

}  // namespace cleave::app
