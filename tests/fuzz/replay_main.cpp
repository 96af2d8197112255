// replay TARGET FILE..: runs files, and the files of folders, through a fuzz target without
// libFuzzer. What was once found must never come back, whatever the compiler.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "target.hpp"

namespace {

void replay(const cleave::fuzz::Target& target, const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  std::printf("%s\n", path.string().c_str());
  std::fflush(stdout);
  target.run({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

}  // namespace

int main(int argc, char** argv) {
  const auto* target = argc < 2 ? nullptr : cleave::fuzz::find_target(argv[1]);
  if (target == nullptr) return std::fputs("usage: replay TARGET FILE..\n", stderr), 2;
  std::vector<std::filesystem::path> inputs;
  for (int i = 2; i < argc; ++i) {
    if (!std::filesystem::is_directory(argv[i])) {
      inputs.emplace_back(argv[i]);
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(argv[i]))
      inputs.push_back(entry.path());
  }
  if (inputs.empty()) return std::fputs("there is no input to replay\n", stderr), 1;
  std::sort(inputs.begin(), inputs.end());
  for (const auto& input : inputs) replay(*target, input);
  std::printf("%zu inputs\n", inputs.size());
  return 0;
}
