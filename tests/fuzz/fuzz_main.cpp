// The entry points that libFuzzer calls. The environment names the target, so that the processes
// which libFuzzer starts by itself have the same one.
#include <cstdio>
#include <cstdlib>

#include "target.hpp"

namespace {

const cleave::fuzz::Target* chosen = nullptr;

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer gives the name
extern "C" int LLVMFuzzerInitialize(int*, char***) {
  const char* name = std::getenv("CLEAVE_FUZZ_TARGET");
  chosen = cleave::fuzz::find_target(name == nullptr ? "" : name);
  if (chosen != nullptr) return 0;
  std::fputs("CLEAVE_FUZZ_TARGET must name one of these:", stderr);
  for (const auto& target : cleave::fuzz::targets())
    std::fprintf(stderr, " %.*s", static_cast<int>(target.name.size()), target.name.data());
  std::fputs("\n", stderr);
  std::exit(1);
}

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer gives the name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  chosen->run({bytes, size});
  return 0;
}
