#pragma once
#include <boost/iterator/iterator_facade.hpp>
#include <boost/property_map/property_map.hpp>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>

#include "cleave/topology/ids.hpp"

/// Ids as ranges, and as the Boost Graph Library wants them: iterators, and a property map to their
/// numbers.
namespace cleave::topology {

/// Counts through ids; a random-access iterator, for std::ranges too, that makes its values.
template <class AnId>
class IdIterator : public boost::iterator_facade<IdIterator<AnId>, AnId,
                                                 boost::random_access_traversal_tag, AnId> {
 public:
  using iterator_concept = std::random_access_iterator_tag;

  IdIterator() = default;
  explicit IdIterator(AnId id) : id_(id) {}

  AnId operator[](std::ptrdiff_t n) const { return {static_cast<Index>(id_.value + n)}; }

 private:
  friend class boost::iterator_core_access;
  AnId dereference() const { return id_; }
  bool equal(const IdIterator& other) const { return id_ == other.id_; }
  void increment() { ++id_.value; }
  void decrement() { --id_.value; }
  void advance(std::ptrdiff_t n) { id_.value = static_cast<Index>(id_.value + n); }
  std::ptrdiff_t distance_to(const IdIterator& other) const {
    return static_cast<std::ptrdiff_t>(other.id_.value) - static_cast<std::ptrdiff_t>(id_.value);
  }

  AnId id_;
};

/// The ids 0 .. count-1.
template <class AnId>
std::pair<IdIterator<AnId>, IdIterator<AnId>> id_range(std::size_t count) {
  return {IdIterator<AnId>(AnId{0}), IdIterator<AnId>(AnId{static_cast<Index>(count)})};
}

/// The vertex_index of graphs whose vertices are ids: the number of an id is its value.
template <class AnId>
struct IdIndexMap {
  using key_type = AnId;
  using value_type = std::size_t;
  using reference = std::size_t;
  using category = boost::readable_property_map_tag;
  friend std::size_t get(const IdIndexMap&, AnId id) { return id.value; }
};

}  // namespace cleave::topology
