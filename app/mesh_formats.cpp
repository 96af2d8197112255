#include "mesh_formats.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "error.hpp"
#include "files/input_text.hpp"
#include "files/tetgen.hpp"

namespace cleave::app {
namespace {

struct Extension {
  const char* text;
  MeshFormat format;
};
constexpr std::array<Extension, 7> kExtensions{{{".mesh", MeshFormat::kMedit},
                                                {".msh", MeshFormat::kGmsh},
                                                {".node", MeshFormat::kTetgen},
                                                {".ele", MeshFormat::kTetgen},
                                                {".inp", MeshFormat::kAbaqus},
                                                {".vtu", MeshFormat::kVtu},
                                                {".vtk", MeshFormat::kVtk}}};

/// The path without an extension .gz.
std::filesystem::path unpacked(const std::filesystem::path& path) {
  return is_gzip_name(path) ? path.parent_path() / path.stem() : path;
}

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = unpacked(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

}  // namespace

MeshFormat format_of(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  for (const Extension& known : kExtensions)
    if (extension == known.text) return known.format;
  throw InputError("'" + path.string() + "': " +
                   (extension.empty() ? "no extension" : "unknown extension '" + extension + "'") +
                   "; mesh files are " + mesh_extensions());
}

MeshFormat output_format_of(const std::filesystem::path& path) {
  if (is_gzip_name(path))
    throw InputError("'" + path.string() + "': compressed files are read, not written; write '" +
                     unpacked(path).string() + "' and compress it with gzip");
  return format_of(path);
}

const char* name_of(MeshFormat format) {
  switch (format) {
    case MeshFormat::kMedit:
      return "Medit";
    case MeshFormat::kGmsh:
      return "gmsh";
    case MeshFormat::kTetgen:
      return "TetGen";
    case MeshFormat::kAbaqus:
      return "Abaqus";
    case MeshFormat::kVtu:
      return "VTK XML";
    case MeshFormat::kVtk:
      break;
  }
  return "VTK legacy";
}

std::string mesh_extensions() {
  std::string text;
  for (const Extension& known : kExtensions)
    text +=
        (text.empty() ? "" : ", ") + std::string(known.text) + " (" + name_of(known.format) + ")";
  return text;
}

bool has_group_names(MeshFormat format) {
  return format == MeshFormat::kGmsh || format == MeshFormat::kAbaqus;
}

std::filesystem::path groups_path(const std::filesystem::path& mesh_path) {
  const std::string extension = lower_extension(mesh_path);
  std::filesystem::path path = extension == ".ele" || extension == ".node"
                                   ? tetgen_paths(mesh_path).node
                                   : unpacked(mesh_path);
  path += ".groups.json";
  return path;
}

std::vector<std::string> mesh_files(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  std::vector<std::string> files{path.string(), groups_path(path).string()};
  if (extension != ".node" && extension != ".ele") return files;
  const TetgenPaths paths = tetgen_paths(path);
  for (const auto& file : {paths.node, paths.ele, paths.face, paths.edge})
    files.push_back(file.string());
  return files;
}

}  // namespace cleave::app
