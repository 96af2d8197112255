#pragma once
#include <malloc.h>
#include <unistd.h>

#include <cstddef>
#include <fstream>
#include <string>

/// Memory as the kernel counts it (Linux), for programs whose allocations cannot be counted
/// otherwise. Whoever asks gets back to it first what was freed.
namespace cleave::bench {

/// Bytes of this process that are in memory now.
inline std::size_t resident_bytes() {
  malloc_trim(0);
  std::size_t pages = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> pages >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

/// The most since the last forget_resident_peak().
inline std::size_t resident_peak() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return 1024 * std::stoull(line.substr(6));
  return 0;
}

inline void forget_resident_peak() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << 5;
}

}  // namespace cleave::bench
