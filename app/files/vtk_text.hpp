#pragma once
#include <filesystem>
#include <string>

class vtkUnstructuredGrid;

namespace cleave::app {

/// The grid as a legacy file in text form, version 4.2, with the shortest digits that read back to
/// the same bits; VTK's own writer keeps eleven. Throws OutputError for a value that is not finite,
/// which VTK cannot read from such a file.
std::string legacy_text(vtkUnstructuredGrid& grid);

/// Throws InputError with the first line of a legacy text file that holds a number that is not
/// finite, if there is one: VTK says of it only that something is wrong.
void explain_not_finite(const std::filesystem::path& path);

}  // namespace cleave::app
