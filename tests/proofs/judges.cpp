#include "judges.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string_view>

#include "certify_certificate.hpp"
#include "error.hpp"

namespace cleave::proofs {
namespace {

int status_of(const Verdict& verdict) {
  return verdict == "accepted"    ? app::kFine
         : verdict == "malformed" ? app::kBadInput
                                  : app::kFindings;
}

/// "rejected: parent: cells .." -> "rejected: parent"
Verdict verdict_in(std::string_view line) {
  if (line == "accepted") return Verdict(line);
  if (line.substr(0, 10) == "malformed:") return "malformed";
  const auto clause = line.find(':', line.find(':') + 1);
  if (line.substr(0, 10) == "rejected: " && clause != std::string_view::npos)
    return Verdict(line.substr(0, clause));
  throw std::runtime_error("the checker says: " + std::string(line));
}

std::string_view take_line(std::string_view& text) {
  const auto end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

std::uint32_t take_number(std::string_view& text) {
  std::uint32_t number = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{})
    throw std::runtime_error("the checker prints no number where one is due");
  text.remove_prefix(static_cast<std::size_t>(rest - text.data()));
  if (!text.empty() && text[0] == ' ') text.remove_prefix(1);
  return number;
}

std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += text;
  return all;
}

}  // namespace

Verdict judged_by_cpp(const std::string& text) {
  try {
    const app::CertificateFile file(app::InputText("certificate", text));
    const auto rejection = app::certify(file);
    if (!rejection) return "accepted";
    return "rejected: " + std::string(topology::name(rejection->clause));
  } catch (const app::InputError&) {
    return "malformed";
  }
}

Folder::Folder() {
  std::string name = (std::filesystem::temp_directory_path() / "cleave-proofs-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = name;
}

Folder::~Folder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path Folder::put(const std::string& name, const std::string& text) const {
  std::ofstream file(path_ / name, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw std::runtime_error("cannot write into " + path_.string());
  return path_ / name;
}

std::pair<std::string, int> Checker::run(const std::string& options,
                                         const std::filesystem::path& file) const {
  const std::string command =
      "'" + program_ + "' " + options + " '" + file.string() + "' 2>/dev/null";
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + program_);
  std::string out;
  std::array<char, 1 << 16> block{};
  for (std::size_t n = 0; (n = std::fread(block.data(), 1, block.size(), pipe)) > 0;)
    out.append(block.data(), n);
  const int status = pclose(pipe);
  return {out, WIFEXITED(status) ? WEXITSTATUS(status) : -1};
}

std::vector<Verdict> Checker::judged(const std::vector<std::string>& texts) const {
  const auto [out, status] = run("--batch", folder_.put("batch", joined(texts)));
  std::vector<Verdict> verdicts;
  int worst = 0;
  for (std::string_view rest = out; !rest.empty();) {
    verdicts.push_back(verdict_in(take_line(rest)));
    worst = std::max(worst, status_of(verdicts.back()));
  }
  if (verdicts.size() != texts.size() || status != worst)
    throw std::runtime_error("the checker speaks of " + std::to_string(verdicts.size()) +
                             " certificates, not " + std::to_string(texts.size()) +
                             ", and exits with " + std::to_string(status));
  return verdicts;
}

Verdict Checker::judged(const std::string& text) const {
  const auto [out, status] = run("", folder_.put("one", text));
  std::string_view rest = out;
  Verdict verdict =
      out.empty() && status == app::kBadInput ? "malformed" : verdict_in(take_line(rest));
  if (status != status_of(verdict) || !rest.empty())
    throw std::runtime_error("the checker exits with " + std::to_string(status) +
                             " and says: " + out);
  return verdict;
}

std::vector<std::vector<std::uint32_t>> Checker::unglued(const std::filesystem::path& file) const {
  const auto [out, status] = run("--unglue --batch", file);
  if (status != 0) throw std::runtime_error("the checker does not unglue a certificate");
  std::vector<std::vector<std::uint32_t>> all;
  for (std::string_view rest = out; !rest.empty();) {
    if (rest.substr(0, 8) != "classes ") throw std::runtime_error("the checker prints no classes");
    rest.remove_prefix(8);
    auto& classes = all.emplace_back();
    const std::uint32_t cells = take_number(rest);
    take_line(rest);
    for (std::uint32_t c = 0; c < cells; ++c)
      for (std::string_view row = take_line(rest); !row.empty();)
        classes.push_back(take_number(row));
  }
  return all;
}

std::vector<std::vector<std::uint32_t>> Checker::unglued(
    const std::vector<std::string>& texts) const {
  return unglued(folder_.put("batch", joined(texts)));
}

}  // namespace cleave::proofs
