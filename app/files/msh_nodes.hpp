#pragma once
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "mesh.hpp"

namespace cleave::app {

/// From a file's number of a vertex or element to its place. Numbers may be anything up to 64 bits:
/// a run of consecutive ones costs nothing, a dense range a table, others a sorted list.
class MshNodes {
 public:
  /// Makes the map ready; returns a number that two vertices share if there is one.
  std::optional<std::uint64_t> index(const std::vector<std::uint64_t>& numbers);

  /// The place of the vertex with this number, or kNone.
  Index find(std::uint64_t number) const;

  static constexpr Index kNone = topology::kNoIndex;

 private:
  std::uint64_t first_ = 0;
  std::uint64_t run_ = 0;     // so many consecutive numbers from first_ on, if not 0
  std::vector<Index> table_;  // by number - first_
  std::vector<std::pair<std::uint64_t, Index>> sorted_;
};

}  // namespace cleave::app
