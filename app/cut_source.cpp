#include "cut_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "error.hpp"
#include "file_words.hpp"
#include "mesh_file.hpp"
#include "sha256.hpp"

namespace cleave::app {
namespace {

// Throws unless the files of the mesh are those that the record was written for.
void require_unchanged(const std::string& path, const IncisionRecord& record) {
  const auto refuse = [&](const std::filesystem::path& file, const std::string& why) {
    throw InputError(
        fmt::format("{}: this file is not the one that {} was written for ({}); restore it, or "
                    "give --forget (or "
                    "remove the record) to take the mesh as it is for a new one",
                    file.string(), record_path(path).string(), why));
  };
  std::error_code error;
  for (const auto& [suffix, hash] : record.sha256) {
    const auto file = hashed_path(path, suffix);
    if (!std::filesystem::exists(file, error)) refuse(file, "it is missing");
    if (sha256_of_file(file) != hash) refuse(file, "its SHA-256 has changed");
  }
  for (const auto& file : {std::filesystem::path(path), groups_path(path)})
    if (std::filesystem::exists(file, error) && record.sha256.count(hashed_suffix(path, file)) == 0)
      refuse(file, "there was none");
}

}  // namespace

CutSource read_source(const std::string& path, bool forget, const HowFar& how_far) {
  CutSource source;
  const std::string record = record_path(path).string();
  std::error_code error;
  const bool recorded = !forget && std::filesystem::exists(record, error);
  if (recorded) {
    source.record = read_record(record);
    require_unchanged(path, *source.record);
  }
  source.mesh = read_mesh(path, how_far);
  if (!recorded) return source;
  if (source.record->dimension != source.mesh.dimension)
    throw InputError(
        fmt::format("{}: at /dimension: the mesh {} has dimension {}; restore both "
                    "files, or give --forget to start anew",
                    record, path, source.mesh.dimension));
  source.restored = restore_original(source.record->original, source.mesh, record);
  return source;
}

bool looks_cut(const Mesh& mesh) {
  std::set<std::string> names;
  for (const Group& group : mesh.groups)
    if (group.dimension == mesh.dimension - 1) names.insert(group.name);
  const std::string minus = "_minus";
  return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
    return name.size() > minus.size() && name.ends_with(minus) &&
           names.count(name.substr(0, name.size() - minus.size()) + "_plus") != 0;
  });
}

std::string warning_of_lost_record(const Mesh& mesh) {
  return fmt::format(
      "{} looks cut before, but {} is missing: it is taken as a new mesh; keep the two files "
      "together to go on",
      mesh.source, record_path(mesh.source).string());
}

std::string note_on(const CutSource& source) {
  return fmt::format("{}: cut before; going on from {}, by which {} {} opened and {} shut",
                     source.mesh.source, record_path(source.mesh.source).string(),
                     counted(source.record->opened.size(), "facet"),
                     source.record->opened.size() == 1 ? "is" : "are", source.record->shut.size());
}

}  // namespace cleave::app
