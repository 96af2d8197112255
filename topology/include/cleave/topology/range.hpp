#pragma once
#include <cstddef>
#include <iterator>
#include <ranges>

namespace cleave::topology {

/// What lies between two iterators: a view of two words, made and passed by value. It models the
/// std::ranges concept that its iterators allow, for const ranges too, and iterators outlive it.
template <class Iterator>
class Range {
 public:
  Range() = default;
  Range(Iterator first, Iterator last) : first_(first), last_(last) {}

  Iterator begin() const { return first_; }
  Iterator end() const { return last_; }
  bool empty() const { return first_ == last_; }
  auto front() const { return *first_; }  // requires !empty()

  std::size_t size() const requires std::random_access_iterator<Iterator> {
    return static_cast<std::size_t>(last_ - first_);
  }
  auto operator[](std::size_t i) const requires std::random_access_iterator<Iterator> {
    return first_[static_cast<std::ptrdiff_t>(i)];
  }

 private:
  Iterator first_, last_;
};

}  // namespace cleave::topology

template <class Iterator>
inline constexpr bool std::ranges::enable_view<cleave::topology::Range<Iterator>> = true;
template <class Iterator>
inline constexpr bool std::ranges::enable_borrowed_range<cleave::topology::Range<Iterator>> = true;
