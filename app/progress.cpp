#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace cleave::app {

Progress::Progress(std::size_t stages, bool quiet)
    : stages_(std::max<std::size_t>(stages, 1)), shown_(!quiet && isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() { clear(); }

void Progress::stage(const std::string& what) {
  if (!shown_) return;
  constexpr std::size_t kWidth = 24;
  const std::size_t full = kWidth * std::min(at_++, stages_) / stages_;
  fmt::print(stderr, "\r\x1b[K[{}{}] {}", std::string(full, '#'), std::string(kWidth - full, '.'),
             what);
  std::fflush(stderr);
}

void Progress::clear() {
  if (shown_) fmt::print(stderr, "\r\x1b[K");
}

}  // namespace cleave::app
