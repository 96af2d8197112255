#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "cleave/topology/complex.hpp"
#include "cleave/topology/ranges.hpp"

namespace cleave::topology {

/// Walks the stars of a complex, one after the other, in memory of its own that it uses again: once
/// it has met the largest star it allocates nothing. That memory is a few kilobytes, whatever the
/// size of the complex. It follows every change of the complex, which must outlive it and stay
/// where it is. Several threads need a walker each.
///
///     StarWalker walker(k);
///     for (const VertexId v : vertices(k))
///       for (const CornerId corner : walker.around(v)) ..
template <int D>
class StarWalker {
 public:
  explicit StarWalker(const Complex<D>& k) : k_(&k) { make_room(kLeastBits, 0); }
  explicit StarWalker(Complex<D>&&) = delete;  // a walker of a temporary

  /// What star(k, vertex) lists, in its order: the corners at `vertex`, one per cell. Valid until
  /// the next call. Time: linear in the star. Throws std::bad_alloc; the walker can be used again.
  std::span<const CornerId> around(VertexId vertex);

 private:
  static constexpr int kLeastBits = 7;  // 128 slots hold stars of up to 64 cells

  /// A cell that walk number `walk` has reached. What other walks left is as good as free.
  struct Slot {
    Index cell = 0;
    std::uint32_t walk = 0;
  };

  /// For a vertex and the facet through which its cell was entered, by local indices: the other
  /// facets that contain the vertex. Branches on them would be guessed wrong half of the time.
  using Exits = std::array<std::uint8_t, D == 1 ? 1 : static_cast<std::size_t>(D) - 1>;
  static constexpr auto kExits = [] {
    std::array<std::array<Exits, D + 1>, D + 1> exits{};
    for (std::size_t vertex = 0; vertex <= D; ++vertex)
      for (std::size_t entered = 0; entered <= D; ++entered)
        for (std::size_t facet = 0, n = 0; facet <= D && n + 1 < D; ++facet)
          if (facet != vertex && facet != entered)
            exits[vertex][entered][n++] = static_cast<std::uint8_t>(facet);
    return exits;
  }();

  void make_room(int bits, std::size_t reached);

  const Complex<D>* k_;
  std::vector<Slot> slots_;  // open addressing, at most half full
  int bits_ = 0;             // the logarithm of their number
  std::uint32_t walk_ = 0;
  std::vector<CornerId> corners_;      // what the walk has reached, in order
  std::vector<std::uint8_t> entered_;  // and through which facet
};

namespace detail {

/// Whether `cell` was not in the table of the walk; it is afterwards.
template <class Slot>
bool enter(Slot* slots, int bits, std::uint32_t walk, CellId cell) {
  const std::size_t last = (std::size_t{1} << bits) - 1;
  std::size_t at = (cell.value * std::uint64_t{0x9E3779B97F4A7C15}) >> (64 - bits);
  for (; slots[at].walk == walk; at = (at + 1) & last)
    if (slots[at].cell == cell.value) return false;
  slots[at] = {cell.value, walk};
  return true;
}

}  // namespace detail

template <int D>
std::span<const CornerId> StarWalker<D>::around(VertexId vertex) {
  const auto start = k_->a_corner(vertex);
  if (!start) return {};
  if (++walk_ == 0) {  // the numbers of walks begin again
    slots_.assign(slots_.size(), Slot{});
    walk_ = 1;
  }
  // In variables of their own, which stores into the arrays cannot change.
  const Cell<D>* const cells = k_->cells().data();
  const HalfFacetId* const mates = k_->mates().data();
  const std::uint32_t walk = walk_;
  Slot* slots = slots_.data();
  CornerId* corners = corners_.data();
  std::uint8_t* entered = entered_.data();
  int bits = bits_;
  std::size_t reached = 0;

  const auto cross = [&](HalfFacetId mate) {
    if (!detail::is_mate(mate)) return;
    const CellId cell = cell_of<D>(mate);
    if (!detail::enter(slots, bits, walk, cell)) return;
    __builtin_prefetch(&mates[half_facet<D>(cell, 0).value]);  // both are needed, and far apart
    int at = 0;  // the vertex is one of the cell's, so this finds which without a branch
    for (int i = 1; i <= D; ++i)
      at += cells[cell.value][static_cast<std::size_t>(i)] == vertex ? i : 0;
    entered[reached] = static_cast<std::uint8_t>(local_index<D>(mate));
    corners[reached++] = half_facet<D>(cell, at);
  };

  detail::enter(slots, bits, walk, cell_of<D>(*start));
  corners[reached++] = *start;
  for (int i = 0; i <= D; ++i) {
    const HalfFacetId h = half_facet<D>(cell_of<D>(*start), i);
    if (h != *start) cross(mates[h.value]);
  }
  for (std::size_t next = 1; next < reached; ++next) {
    if (reached + D > std::size_t{1} << (bits - 1)) {
      make_room(bits + 1, reached);
      slots = slots_.data();
      corners = corners_.data();
      entered = entered_.data();
      bits = bits_;
    }
    const CornerId corner = corners[next];
    const HalfFacetId first = half_facet<D>(cell_of<D>(corner), 0);
    const auto& exits = kExits[static_cast<std::size_t>(local_index<D>(corner))][entered[next]];
    for (std::size_t n = 0; n + 1 < D; ++n) cross(mates[first.value + exits[n]]);
  }
  return std::span(corners_).first(reached);
}

/// Makes 2^bits slots, in which the first `reached` corners are.
template <int D>
void StarWalker<D>::make_room(int bits, std::size_t reached) {
  const std::size_t count = std::size_t{1} << bits;
  corners_.resize(count / 2);
  entered_.resize(count / 2);
  std::vector<Slot> slots(count);
  for (std::size_t n = 0; n < reached; ++n)
    detail::enter(slots.data(), bits, walk_, cell_of<D>(corners_[n]));
  slots_ = std::move(slots);
  bits_ = bits;
}

}  // namespace cleave::topology
