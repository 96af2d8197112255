#include "mesh_file.hpp"

#include <optional>
#include <system_error>

#include "error.hpp"
#include "files/abaqus.hpp"
#include "files/group_integers.hpp"
#include "files/input_text.hpp"
#include "files/medit.hpp"
#include "files/msh_format.hpp"
#include "files/tetgen.hpp"
#include "files/text_output.hpp"
#include "files/vtk_files.hpp"
#include "output_files.hpp"

namespace cleave::app {

namespace {

Mesh read_format(const std::filesystem::path& path, MeshFormat format, const HowFar& how_far) {
  const bool is_vtk = format == MeshFormat::kVtu || format == MeshFormat::kVtk;
  if (is_vtk && is_gzip_name(path))
    throw InputError("'" + path.string() +
                     "': VTK files are read as they are, not compressed by gzip; unpack it first");
  switch (format) {
    case MeshFormat::kMedit:
      return read_medit(InputText(path, how_far));
    case MeshFormat::kGmsh:
      return read_msh(InputText(path, how_far));
    case MeshFormat::kTetgen:
      return read_tetgen(path);
    case MeshFormat::kAbaqus:
      return read_abaqus(InputText(path, how_far));
    case MeshFormat::kVtu:
      return read_vtk(path, VtkFormat::kXml);
    case MeshFormat::kVtk:
      break;
  }
  return read_vtk(path, VtkFormat::kLegacy);
}

GroupIntegers write_tetgen_files(OutputFiles& files, const std::filesystem::path& path,
                                 const Mesh& mesh) {
  require_tetgen_can_hold(mesh);
  const TetgenPaths paths = tetgen_paths(path);
  TextOutput node(files.add(paths.node)), ele(files.add(paths.ele));
  std::optional<TextOutput> face, edge;
  const auto open = [&](std::optional<TextOutput>& out, const auto& name, bool is_needed) {
    if (is_needed)
      out.emplace(files.add(name));
    else
      files.remove(name);  // it would be read with the new mesh
    return is_needed ? &*out : nullptr;
  };
  return write_tetgen(
      {node, ele, open(face, paths.face, mesh.elements[2].size() > 0 && mesh.dimension == 3),
       open(edge, paths.edge, mesh.elements[1].size() > 0)},
      mesh);
}

GroupIntegers write_format(OutputFiles& files, const std::filesystem::path& path, const Mesh& mesh,
                           const WriteOptions& options) {
  const MeshFormat format = format_of(path);
  if (format == MeshFormat::kTetgen) return write_tetgen_files(files, path, mesh);
  GroupIntegers integers;
  TextOutput out(files.add(path));
  switch (format) {
    case MeshFormat::kMedit:
      return write_medit(out, mesh);
    case MeshFormat::kGmsh:
      write_msh(out, mesh,
                {options.msh_version.value_or(mesh.msh_version),
                 options.binary.value_or(mesh.msh_binary)});
      break;
    case MeshFormat::kAbaqus:
      write_abaqus(out, mesh);
      break;
    case MeshFormat::kVtu:
      out << write_vtu(mesh, options.encoding.value_or(VtuEncoding::kBase64), integers);
      break;
    case MeshFormat::kVtk:
      out << write_vtk(mesh, options.binary.value_or(true), integers);
      break;
    case MeshFormat::kTetgen:
      break;
  }
  return integers;
}

}  // namespace

Mesh read_mesh(const std::filesystem::path& path, const HowFar& how_far) {
  const MeshFormat format = format_of(path);
  Mesh mesh = read_format(path, format, how_far);
  for (int d = 1; d <= 3; ++d)
    if (mesh.elements[static_cast<std::size_t>(d)].size() > 0) mesh.dimension = d;
  if (mesh.dimension == 0)
    throw InputError(path.string() + ": holds no edges, triangles or tetrahedra");
  std::error_code error;
  if (!has_group_names(format) && std::filesystem::exists(groups_path(path), error))
    apply_group_names(mesh, groups_path(path));
  return mesh;
}

void require_options_fit(const std::filesystem::path& path, const WriteOptions& options) {
  const MeshFormat format = output_format_of(path);
  const auto refuse = [&](const std::string& why) {
    throw InputError("'" + path.string() + "': " + why);
  };
  if (options.msh_version && format != MeshFormat::kGmsh)
    refuse("a version can be chosen for .msh files only");
  if (options.binary && format != MeshFormat::kGmsh && format != MeshFormat::kVtk)
    refuse("binary or text can be chosen for .msh and .vtk files only");
  if (options.encoding && format != MeshFormat::kVtu)
    refuse("an encoding can be chosen for .vtu files only");
}

void write_mesh(OutputFiles& files, const std::filesystem::path& path, const Mesh& mesh,
                const WriteOptions& options) {
  require_options_fit(path, options);
  const GroupIntegers integers = write_format(files, path, mesh, options);
  const std::string names = integers.to_json();
  if (!names.empty())
    files.add(groups_path(path)).write(names);
  else if (!has_group_names(format_of(path)))
    files.remove(groups_path(path));
}

void write_mesh(const std::filesystem::path& path, const Mesh& mesh, const WriteOptions& options) {
  OutputFiles files;
  write_mesh(files, path, mesh, options);
  files.commit();
}

}  // namespace cleave::app
