#include "temporaries.hpp"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <cstring>
#include <string_view>

#include "error.hpp"

namespace cleave::app {
namespace {

enum SlotState { kFree, kFilling, kLive };

/// Storage a signal handler may read: no allocation, no lock.
struct Slot {
  std::atomic<int> state{kFree};
  std::array<char, PATH_MAX> path{};
};
static_assert(std::atomic<int>::is_always_lock_free);

std::array<Slot, 16> slots;
std::atomic<bool> line_drawn{false};

void wipe_up() {
  for (const Slot& slot : slots)
    if (slot.state.load() == kLive) unlink(slot.path.data());
  constexpr std::array<char, 4> kWipe = {'\r', '\x1b', '[', 'K'};
  if (line_drawn.load() && write(STDERR_FILENO, kWipe.data(), kWipe.size()) < 0) return;
}

/// Calls only what POSIX lists as async-signal-safe. The action was reset on entry, so that the
/// signal raised here ends the process as soon as the handler returns.
extern "C" void wipe_up_and_end(int signal) {
  wipe_up();
  raise(signal);
}

extern "C" void say_that_input_shrank(int /*signal*/) {
  wipe_up();
  constexpr std::string_view kMessage =
      "cleave: error: a file became shorter while it was read; try again when it is complete\n";
  if (write(STDERR_FILENO, kMessage.data(), kMessage.size()) < 0) _exit(kBadInput);
  _exit(kBadInput);
}

bool install_handlers() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction current {};
    if (sigaction(signal, nullptr, &current) != 0) continue;
    if ((current.sa_flags & SA_SIGINFO) != 0 || current.sa_handler != SIG_DFL) continue;
    struct sigaction ours {};
    ours.sa_handler = wipe_up_and_end;
    ours.sa_flags = static_cast<int>(SA_RESETHAND);
    sigemptyset(&ours.sa_mask);
    sigaction(signal, &ours, nullptr);
  }
  return true;
}

bool handlers_are_installed() {
  static const bool installed = install_handlers();
  return installed;
}

}  // namespace

void watch_line(bool drawn) { line_drawn.store(drawn && handlers_are_installed()); }

void watch_mapped_input() {
  struct sigaction current {};
  if (sigaction(SIGBUS, nullptr, &current) != 0 || current.sa_handler != SIG_DFL) return;
  struct sigaction ours {};
  ours.sa_handler = say_that_input_shrank;
  sigemptyset(&ours.sa_mask);
  sigaction(SIGBUS, &ours, nullptr);
}

WatchedTemporary::WatchedTemporary(const std::string& path) : slot_(-1) {
  if (!handlers_are_installed() || path.size() >= PATH_MAX) return;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    int expected = kFree;
    if (!slots[i].state.compare_exchange_strong(expected, kFilling)) continue;
    std::memcpy(slots[i].path.data(), path.c_str(), path.size() + 1);
    slots[i].state.store(kLive);
    slot_ = static_cast<int>(i);
    return;
  }
}

WatchedTemporary::~WatchedTemporary() {
  if (slot_ >= 0) slots[static_cast<std::size_t>(slot_)].state.store(kFree);
}

}  // namespace cleave::app
