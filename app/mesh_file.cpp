#include "mesh_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <system_error>

#include "error.hpp"
#include "files/group_integers.hpp"
#include "files/input_text.hpp"
#include "files/medit.hpp"
#include "files/msh_format.hpp"
#include "files/text_output.hpp"
#include "files/vtk_files.hpp"
#include "output_files.hpp"

namespace cleave::app {

namespace {

/// The path without an extension .gz.
std::filesystem::path unpacked(const std::filesystem::path& path) {
  return is_gzip_name(path) ? path.parent_path() / path.stem() : path;
}

}  // namespace

MeshFormat format_of(const std::filesystem::path& path) {
  std::string extension = unpacked(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension == ".mesh") return MeshFormat::kMedit;
  if (extension == ".msh") return MeshFormat::kGmsh;
  if (extension == ".vtu") return MeshFormat::kVtu;
  if (extension == ".vtk") return MeshFormat::kVtk;
  throw InputError("'" + path.string() + "': " +
                   (extension.empty() ? "no extension" : "unknown extension '" + extension + "'") +
                   "; mesh files are .mesh (Medit), .msh (gmsh), .vtu and .vtk (VTK)");
}

MeshFormat output_format_of(const std::filesystem::path& path) {
  if (is_gzip_name(path))
    throw InputError("'" + path.string() + "': compressed files are read, not written; write '" +
                     unpacked(path).string() + "' and compress it with gzip");
  return format_of(path);
}

namespace {

Mesh read_format(const std::filesystem::path& path, MeshFormat format) {
  const bool is_vtk = format == MeshFormat::kVtu || format == MeshFormat::kVtk;
  if (is_vtk && is_gzip_name(path))
    throw InputError("'" + path.string() +
                     "': VTK files are read as they are, not compressed by gzip; unpack it first");
  switch (format) {
    case MeshFormat::kMedit:
      return read_medit(InputText(path));
    case MeshFormat::kGmsh:
      return read_msh(InputText(path));
    case MeshFormat::kVtu:
      return read_vtk(path, VtkFormat::kXml);
    case MeshFormat::kVtk:
      break;
  }
  return read_vtk(path, VtkFormat::kLegacy);
}

GroupIntegers write_format(OutputFile& file, MeshFormat format, const Mesh& mesh,
                           const WriteOptions& options) {
  GroupIntegers integers;
  TextOutput out(file);
  switch (format) {
    case MeshFormat::kMedit:
      return write_medit(out, mesh);
    case MeshFormat::kGmsh:
      write_msh(out, mesh,
                {options.msh_version.value_or(mesh.msh_version),
                 options.binary.value_or(mesh.msh_binary)});
      break;
    case MeshFormat::kVtu:
      out << write_vtk(mesh, VtkFormat::kXml, integers);
      break;
    case MeshFormat::kVtk:
      out << write_vtk(mesh, VtkFormat::kLegacy, integers);
      break;
  }
  return integers;
}

}  // namespace

std::filesystem::path groups_path(const std::filesystem::path& mesh_path) {
  std::filesystem::path path = unpacked(mesh_path);
  path += ".groups.json";
  return path;
}

Mesh read_mesh(const std::filesystem::path& path) {
  const MeshFormat format = format_of(path);
  Mesh mesh = read_format(path, format);
  for (int d = 1; d <= 3; ++d)
    if (mesh.elements[static_cast<std::size_t>(d)].size() > 0) mesh.dimension = d;
  if (mesh.dimension == 0)
    throw InputError(path.string() + ": holds no edges, triangles or tetrahedra");
  std::error_code error;
  if (format != MeshFormat::kGmsh && std::filesystem::exists(groups_path(path), error))
    apply_group_names(mesh, groups_path(path));
  return mesh;
}

void write_mesh(OutputFiles& files, const std::filesystem::path& path, const Mesh& mesh,
                const WriteOptions& options) {
  const MeshFormat format = output_format_of(path);
  if (format != MeshFormat::kGmsh && (options.msh_version || options.binary))
    throw InputError("'" + path.string() +
                     "': a version or a form, text or binary, can be chosen for .msh files only");
  const GroupIntegers integers = write_format(files.add(path), format, mesh, options);
  const std::string names = integers.to_json();
  if (!names.empty())
    files.add(groups_path(path)).write(names);
  else if (format != MeshFormat::kGmsh)
    files.remove(groups_path(path));
}

void write_mesh(const std::filesystem::path& path, const Mesh& mesh, const WriteOptions& options) {
  OutputFiles files;
  write_mesh(files, path, mesh, options);
  files.commit();
}

}  // namespace cleave::app
