#pragma once
#include <array>
#include <concepts>
#include <cstddef>
#include <iterator>
#include <ranges>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "cleave/topology/cell_soup.hpp"
#include "cleave/topology/ids.hpp"

/// Arrays of plain numbers as ids and tuples of ids, and the other way round. Nothing is copied:
/// the spans show the same memory and are valid as long as it. Ids and tuples are laid out as the
/// numbers they hold, which is asserted here (docs/decisions/0016-show-numbers-as-ids.md).
///
///     const std::vector<int> tets = ..;  // four numbers each
///     check(CellView<3>::of(as_cells<3>(tets), points.size()));
namespace cleave::topology {

/// A number that an id can be read from: as wide as Index. If it is signed, a negative one is read
/// as an id above all others, and is reported as out of range.
template <class Number>
concept IndexLike = std::integral<Number> && std::same_as<std::make_unsigned_t<Number>, Index>;

namespace detail {

/// The numbers that a value of an array is made of: itself, or those of a tuple.
template <class Value>
struct NumbersOf {
  using Number = Value;
  static constexpr std::size_t kCount = 1;
};
template <class Value, std::size_t N>
struct NumbersOf<std::array<Value, N>> {
  using Number = typename NumbersOf<Value>::Number;
  static constexpr std::size_t kCount = N * NumbersOf<Value>::kCount;
};
template <class Value, std::size_t N>
struct NumbersOf<Value[N]> : NumbersOf<std::array<Value, N>> {};

template <class T>
inline constexpr bool kLooksLikeNumbers =
    std::is_standard_layout_v<T>&& std::is_trivially_copyable_v<T> && alignof(T) == alignof(Index);

/// `count` numbers from `numbers` on, as ids or tuples of ids.
template <class T>
std::span<const T> as_tuples(const void* numbers, std::size_t count) {
  constexpr std::size_t each = NumbersOf<T>::kCount;
  static_assert(kLooksLikeNumbers<T> && sizeof(T) == each * sizeof(Index));
  if (count % each != 0)
    throw std::invalid_argument(std::to_string(count) + " numbers are no tuples of " +
                                std::to_string(each));
  return {static_cast<const T*>(numbers), count / each};
}

}  // namespace detail

/// What numbers of ids may lie in: std::vector, std::span, std::array, of numbers or of
/// std::array<number, n>; a pointer as std::span(pointer, count); an Eigen matrix as
/// std::span(matrix.data(), matrix.size()), if it holds one tuple after the other.
template <class Array>
concept ArrayOfNumbers = std::ranges::contiguous_range<Array> && std::ranges::sized_range<Array> &&
    std::ranges::borrowed_range<Array> &&  // no temporary that holds its numbers
    IndexLike<typename detail::NumbersOf<std::ranges::range_value_t<Array>>::Number>;

/// The numbers as ids of type AnId: half-facets of a cut, vertices of a set.
template <class AnId, ArrayOfNumbers Array>
std::span<const AnId> as_ids(Array&& array) {
  constexpr std::size_t each = detail::NumbersOf<std::ranges::range_value_t<Array>>::kCount;
  return detail::as_tuples<AnId>(std::ranges::data(array), each * std::ranges::size(array));
}

/// The numbers as cells, D+1 vertices each. Throws std::invalid_argument if they are no multiple of
/// that.
template <int D, ArrayOfNumbers Array>
std::span<const Cell<D>> as_cells(Array&& array) {
  const auto ids = as_ids<VertexId>(array);
  return detail::as_tuples<Cell<D>>(ids.data(), ids.size());
}

/// The numbers as facets, D vertices each. Throws as as_cells.
template <int D, ArrayOfNumbers Array>
std::span<const Facet<D>> as_facets(Array&& array) {
  const auto ids = as_ids<VertexId>(array);
  return detail::as_tuples<Facet<D>>(ids.data(), ids.size());
}

/// Ids as plain numbers: k.mates(), or FacetSet::half_facets().
template <class Tag>
std::span<const Index> as_numbers(std::span<const Id<Tag>> ids) {
  static_assert(detail::kLooksLikeNumbers<Id<Tag>> && sizeof(Id<Tag>) == sizeof(Index));
  return {reinterpret_cast<const Index*>(ids.data()), ids.size()};
}

/// Tuples as plain numbers: k.cells().
template <std::size_t N>
std::span<const Index> as_numbers(std::span<const std::array<VertexId, N>> tuples) {
  using Tuple = std::array<VertexId, N>;
  static_assert(detail::kLooksLikeNumbers<Tuple> && sizeof(Tuple) == N * sizeof(Index));
  return {reinterpret_cast<const Index*>(tuples.data()), N * tuples.size()};
}

/// A soup of its own, for `assemble`, which keeps and changes the cells it is given: the one copy
/// that is needed of arrays that stay somebody else's.
template <int D>
CellSoup<D> copy_of(const CellView<D>& view) {
  return {{view.cells.begin(), view.cells.end()},
          view.vertex_count,
          {view.signs.begin(), view.signs.end()}};
}

}  // namespace cleave::topology
