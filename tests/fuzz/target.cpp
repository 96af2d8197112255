#include "target.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace cleave::fuzz {
namespace {

constexpr std::string_view kOpens = "==> ";
constexpr std::string_view kCloses = " <==";

bool is_suffix(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  return text.size() >= 2 && text.size() <= 20 && text.front() == '.' &&
         std::all_of(text.begin() + 1, text.end(), [](char c) {
           return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '.';
         });
}

/// The suffix that a line opens a file with; empty: it is a line of a file.
std::string_view suffix_in(std::string_view line) {
  if (line.size() <= kOpens.size() + kCloses.size()) return {};
  if (line.substr(0, kOpens.size()) != kOpens) return {};
  if (line.substr(line.size() - kCloses.size()) != kCloses) return {};
  line.remove_prefix(kOpens.size());
  line.remove_suffix(kCloses.size());
  return is_suffix(line) ? line : std::string_view();
}

}  // namespace

void violated(const char* what, const char* file, int line, const std::string& detail) {
  std::fprintf(stderr, "%s:%d: does not hold: %s %s\n", file, line, what, detail.c_str());
  std::abort();
}

Folder::Folder() {
  std::string name = (std::filesystem::temp_directory_path() / "cleave-fuzz-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = name;
}

Folder::~Folder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path Folder::put(const std::string& name, std::string_view bytes) const {
  std::ofstream file(path(name), std::ios::binary | std::ios::trunc);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) throw std::runtime_error("cannot write " + path(name).string());
  return path(name);
}

void Folder::clear() const {
  for (const auto& entry : std::filesystem::directory_iterator(path_))
    std::filesystem::remove_all(entry.path());
}

std::filesystem::path Folder::put_all(const std::string& name, std::string_view input) const {
  std::string current = name;
  std::size_t begins = 0;
  for (std::size_t at = 0; at < input.size();) {
    const std::size_t newline = std::min(input.find('\n', at), input.size());
    const std::string_view suffix = suffix_in(input.substr(at, newline - at));
    const std::size_t next = std::min(newline + 1, input.size());
    if (!suffix.empty()) {
      put(current, input.substr(begins, at - begins));
      current = suffix.front() == '+'
                    ? name + std::string(suffix.substr(1))
                    : std::filesystem::path(name).stem().string() + std::string(suffix);
      begins = next;
    }
    at = next;
  }
  put(current, input.substr(begins));
  return path(name);
}

}  // namespace cleave::fuzz
