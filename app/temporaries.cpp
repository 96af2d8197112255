#include "temporaries.hpp"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <cstring>

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

/// Calls only what POSIX lists as async-signal-safe. The action was reset on entry, so that the
/// signal raised here ends the process as soon as the handler returns.
extern "C" void remove_temporaries(int signal) {
  for (const Slot& slot : slots)
    if (slot.state.load() == kLive) unlink(slot.path.data());
  raise(signal);
}

bool install_handlers() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction current {};
    if (sigaction(signal, nullptr, &current) != 0) continue;
    if ((current.sa_flags & SA_SIGINFO) != 0 || current.sa_handler != SIG_DFL) continue;
    struct sigaction ours {};
    ours.sa_handler = remove_temporaries;
    ours.sa_flags = static_cast<int>(SA_RESETHAND);
    sigemptyset(&ours.sa_mask);
    sigaction(signal, &ours, nullptr);
  }
  return true;
}

}  // namespace

WatchedTemporary::WatchedTemporary(const std::string& path) : slot_(-1) {
  static const bool installed = install_handlers();
  if (!installed || path.size() >= PATH_MAX) return;
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
