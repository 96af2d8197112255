#pragma once
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace cleave::app {

/// From a file's number of a vertex or element to its place. Numbers may be anything up to 64 bits:
/// a run of consecutive ones costs nothing, a dense range a table, others a sorted list.
class MshNodes {
 public:
  /// Makes the map ready; returns a number that two vertices share if there is one.
  std::optional<std::uint64_t> index(const std::vector<std::uint64_t>& numbers);

  /// The place of the vertex with this number, or kNone.
  std::uint32_t find(std::uint64_t number) const;

  static constexpr std::uint32_t kNone = UINT32_MAX;

 private:
  std::uint64_t first_ = 0;
  std::uint64_t run_ = 0;             // so many consecutive numbers from first_ on, if not 0
  std::vector<std::uint32_t> table_;  // by number - first_
  std::vector<std::pair<std::uint64_t, std::uint32_t>> sorted_;
};

}  // namespace cleave::app
