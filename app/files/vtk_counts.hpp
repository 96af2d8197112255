#pragma once
#include <filesystem>

#include "files/vtk_files.hpp"

namespace cleave::app {

/// Throws InputError if a VTK file is missing, empty, not of the format, or claims more points or
/// cells than a file of its size can hold: VTK believes counts and allocates.
void check_vtk_counts(const std::filesystem::path& path, VtkFormat format);

}  // namespace cleave::app
