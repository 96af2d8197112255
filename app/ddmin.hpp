#pragma once
#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace cleave::app {

namespace detail {

/// `items` from part `part` of `parts` nearly equal ones on: where it begins. begin(parts) is the
/// end.
inline std::size_t part_begin(std::size_t items, std::size_t parts, std::size_t part) {
  return items / parts * part + std::min(part, items % parts);
}

template <class Item, class Fails>
std::optional<std::vector<Item>> failing_part(const std::vector<Item>& items, std::size_t parts,
                                              const Fails& fails) {
  for (std::size_t p = 0; p < parts; ++p) {
    const auto at = [&](std::size_t part) {
      return items.begin() + static_cast<std::ptrdiff_t>(part_begin(items.size(), parts, part));
    };
    std::vector<Item> some(at(p), at(p + 1));
    if (fails(some)) return some;
  }
  return std::nullopt;
}

template <class Item, class Fails>
std::optional<std::vector<Item>> failing_rest(const std::vector<Item>& items, std::size_t parts,
                                              const Fails& fails) {
  for (std::size_t p = 0; p < parts; ++p) {
    std::vector<Item> rest = items;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(part_begin(items.size(), parts, p)),
               rest.begin() + static_cast<std::ptrdiff_t>(part_begin(items.size(), parts, p + 1)));
    if (fails(rest)) return rest;
  }
  return std::nullopt;
}

}  // namespace detail

/// Delta debugging (the algorithm ddmin of Zeller and Hildebrandt, "Simplifying and isolating
/// failure-inducing input", 2002): some of `items`, in their order, for which `fails` is true, and
/// is false when any single one of them is left out. `fails(items)` must be true and is not asked
/// again; the same question must always get the same answer. Calls of `fails`: few and small when
/// few items matter, quadratic at worst.
template <class Item, class Fails>
std::vector<Item> ddmin(std::vector<Item> items, const Fails& fails) {
  if (items.empty() || fails(std::vector<Item>())) return {};
  std::size_t parts = 2;
  while (items.size() >= 2) {
    parts = std::min(parts, items.size());
    if (auto part = detail::failing_part(items, parts, fails)) {
      items = std::move(*part);
      parts = 2;
      continue;
    }
    // Of two parts each is the rest of the other.
    auto rest = parts > 2 ? detail::failing_rest(items, parts, fails) : std::nullopt;
    if (rest) {
      items = std::move(*rest);
      parts = std::max<std::size_t>(parts - 1, 2);
    } else if (parts < items.size()) {
      parts *= 2;
    } else {
      break;
    }
  }
  return items;
}

}  // namespace cleave::app
