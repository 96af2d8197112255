#include "output_files.hpp"

namespace cleave::app {

OutputFile& OutputFiles::add(const std::filesystem::path& target) {
  return files_.emplace_back(target);
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
