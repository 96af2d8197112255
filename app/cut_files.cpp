#include "cut_files.hpp"

#include <fmt/format.h>

#include <CLI/Error.hpp>
#include <filesystem>
#include <optional>
#include <utility>

#include "commands.hpp"
#include "error.hpp"
#include "mesh_file.hpp"

namespace cleave::app {
namespace {

bool is_special(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error);
}

void add_reports(OutputFiles& files, const CutAnswer& answer) {
  if (!answer.json_file.empty()) files.add(answer.json_file).write(answer.json);
  if (!answer.fix_it_file.empty()) files.add(answer.fix_it_file).write(answer.fix_it);
  if (!answer.certificate || answer.certificate_file == "-") return;
  OutputFile& file = files.add(answer.certificate_file);
  write_certificate(*answer.certificate, [&](std::string_view text) { file.write(text); });
}

void print_answer(const CutAnswer& answer) {
  if (answer.certificate && answer.certificate_file == "-")
    write_certificate(*answer.certificate, [](std::string_view text) { print(std::string(text)); });
  else
    print(answer.text);
}

}  // namespace

void remove_record(OutputFiles& files, const std::string& out) {
  if (!is_special(out)) files.remove(record_path(out));
}

void require_format(const std::string& out, bool cohesive) {
  const MeshFormat format = output_format_of(out);
  if (cohesive && (format == MeshFormat::kMedit || format == MeshFormat::kTetgen))
    throw InputError(
        fmt::format("'{}': {} files hold no cohesive elements; write .msh, .vtu, .vtk or .inp", out,
                    name_of(format)));
}

CutAnswer answer(const std::string& json_option, std::string json, std::string text, bool quiet) {
  if (json_option == "-") return {"", "", std::move(json)};
  return {json_option, std::move(json), quiet ? "" : std::move(text)};
}

void add_certificate(CutAnswer& answer, const std::string& file,
                     std::optional<Certificate> certificate) {
  answer.certificate_file = file;
  answer.certificate = std::move(certificate);
}

void refuse_certificate(const std::string& certificate, const std::vector<std::string>& files,
                        const std::string& json) {
  if (certificate == "-" && json == "-")
    throw CLI::ValidationError("--certificate", "--json has standard output already");
  refuse_report_onto(certificate, files, "--certificate", "certificate");
}

void write_answer(const CutAnswer& answer) {
  OutputFiles files;
  add_reports(files, answer);
  print_answer(answer);
  files.commit();
}

void write_cut(const std::string& out, const Mesh& mesh, IncisionRecord* record,
               const CutAnswer& answer) {
  OutputFiles files(record != nullptr);
  write_mesh(files, out, mesh);
  std::optional<std::string> text;
  if (record != nullptr && !is_special(out)) {
    for (const auto& [file, hash] : files.sha256()) record->sha256[hashed_suffix(out, file)] = hash;
    text = json_of(*record);
    if (!text)
      warn(
          fmt::format("{}: a group has a name that is not UTF-8, so no record is kept: facets of "
                      "this cut cannot be taken back; rename the group",
                      out));
  }
  if (text)
    files.add(record_path(out)).write(*text);
  else
    remove_record(files, out);
  add_reports(files, answer);
  print_answer(answer);
  files.commit();
}

}  // namespace cleave::app
