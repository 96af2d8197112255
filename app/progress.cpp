#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "temporaries.hpp"

namespace cleave::app {
namespace {

// Both that the first guess is not wild and that short commands show none.
constexpr double kSecondsBeforeGuess = 3;
constexpr double kDoneBeforeGuess = 0.05;

std::string in_words(double seconds) {
  const auto whole = static_cast<long>(seconds) + 1;
  return whole < 60 ? fmt::format("{} s", whole)
                    : fmt::format("{} min {:02} s", whole / 60, whole % 60);
}

}  // namespace

Progress::Progress(std::size_t stages, bool quiet)
    : stages_(std::max<std::size_t>(stages, 1)), shown_(!quiet && isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() { clear(); }

void Progress::stage(const std::string& what) {
  if (!shown_) return;
  ++at_;
  what_ = what;
  if (at_ <= stages_ || !drawn_just_now()) draw(0);
}

void Progress::within(double part) {
  if (shown_ && !what_.empty() && !drawn_just_now()) draw(std::clamp(part, 0.0, 1.0));
}

HowFar Progress::within_stage() {
  if (!shown_) return {};
  return [this](double part) { within(part); };
}

bool Progress::drawn_just_now() const {
  return Clock::now() - drawn_ < std::chrono::milliseconds(100);
}

void Progress::draw(double done) {
  constexpr std::size_t kWidth = 24;
  const auto before = static_cast<double>(std::min(at_, stages_) - 1);
  const double all = (before + done) / static_cast<double>(stages_);
  const auto full = static_cast<std::size_t>(kWidth * all);
  const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
  const bool guess = elapsed > kSecondsBeforeGuess && all > kDoneBeforeGuess;
  watch_line(true);
  fmt::print(stderr, "\r\x1b[K[{}{}] {:3.0f} % {}{}", std::string(full, '#'),
             std::string(kWidth - full, '.'), 100 * all, what_,
             guess ? ", about " + in_words(elapsed * (1 - all) / all) + " left" : "");
  std::fflush(stderr);
  drawn_ = Clock::now();
}

void Progress::clear() {
  if (!shown_) return;
  fmt::print(stderr, "\r\x1b[K");
  watch_line(false);
}

}  // namespace cleave::app
