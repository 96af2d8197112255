#include "output_files.hpp"

namespace cleave::app {

OutputFile& OutputFiles::add(const std::filesystem::path& target) {
  OutputFile& file = files_.emplace_back(target);
  if (hashed_) file.digest_into(digests_.emplace_back(target, Sha256()).second);
  return file;
}

std::vector<std::pair<std::filesystem::path, std::string>> OutputFiles::sha256() {
  std::vector<std::pair<std::filesystem::path, std::string>> hashes;
  for (auto& [target, digest] : digests_) hashes.emplace_back(target, digest.hex());
  return hashes;
}

void OutputFiles::remove(const std::filesystem::path& target) { gone_.push_back(target); }

void OutputFiles::commit() {
  std::vector<Replacement> replacements;
  for (auto file = files_.rbegin(); file != files_.rend(); ++file)
    if (auto replacement = file->finish()) replacements.push_back(std::move(*replacement));
  for (const auto& target : gone_) replacements.push_back({{}, target, target});
  replace_together(replacements);
  for (OutputFile& file : files_) file.forget_temporary();
}

}  // namespace cleave::app
