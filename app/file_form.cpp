#include <zlib.h>

#include <array>
#include <memory>
#include <sstream>
#include <string_view>

#include "error.hpp"
#include "files/input_text.hpp"
#include "mesh_formats.hpp"
#include "mesh_info.hpp"

namespace cleave::app {
namespace {

/// The first bytes of a file, or of what it holds compressed.
std::string head_of(const std::filesystem::path& path) {
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
  std::string head(4096, '\0');
  const int size =
      file == nullptr ? -1 : gzread(file.get(), head.data(), static_cast<unsigned>(head.size()));
  if (size < 0) throw InputError("cannot read '" + path.string() + "'");
  head.resize(static_cast<std::size_t>(size));
  return head;
}

/// The text between `before` and the next of `ends`; empty if there is no `before`.
std::string after(std::string_view text, std::string_view before, std::string_view ends) {
  const auto at = text.find(before);
  if (at == text.npos) return {};
  text.remove_prefix(at + before.size());
  return std::string(text.substr(0, text.find_first_of(ends)));
}

std::string vtu_encoding(const std::string& head) {
  if (head.find("compressor=\"") != std::string::npos) return "compressed";
  const std::string format = after(head, " format=\"", "\"");
  if (format == "ascii") return "text";
  return format == "binary" ? "base64" : format;
}

}  // namespace

FileForm form_of(const std::filesystem::path& path) {
  const MeshFormat format = format_of(path);
  const std::string head = head_of(path);
  FileForm form{name_of(format), {}, "text"};
  switch (format) {
    case MeshFormat::kMedit:
      std::istringstream(after(head, "MeshVersionFormatted", "#")) >> form.version;
      break;
    case MeshFormat::kGmsh: {
      std::string type;
      std::istringstream(after(head, "$MeshFormat", "$")) >> form.version >> type;
      if (type == "1") form.encoding = "binary";
      break;
    }
    case MeshFormat::kTetgen:
    case MeshFormat::kAbaqus:
      break;
    case MeshFormat::kVtu:
      if (const auto file = head.find("<VTKFile"); file != std::string::npos)
        form.version = after(std::string_view(head).substr(file), " version=\"", "\"");
      form.encoding = vtu_encoding(head);
      break;
    case MeshFormat::kVtk:
      form.version = after(head, "DataFile Version ", " \r\n");
      if (head.find("\nBINARY") != std::string::npos) form.encoding = "binary";
      break;
  }
  if (is_gzip_name(path)) form.encoding += ", gzip";
  return form;
}

}  // namespace cleave::app
