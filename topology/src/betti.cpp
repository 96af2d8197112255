#include "cleave/topology/betti.hpp"

#include <algorithm>
#include <iterator>
#include <queue>
#include <unordered_map>
#include <vector>

#include "dimensions.hpp"
#include "disjoint_sets.hpp"
#include "incidence.hpp"
#include "morse.hpp"

namespace cleave::topology {
namespace {

/// Counts work down to nothing.
class Budget {
 public:
  explicit Budget(std::uint64_t steps) : left_(steps) {}
  bool spend(std::uint64_t steps) {
    if (steps > left_) return false;
    left_ -= steps;
    return true;
  }

 private:
  std::uint64_t left_;
};

using Column = std::vector<Index>;  // the rows that are 1, ascending

/// Follows the boundaries of critical k-simplices down the gradient of dimension k, to the
/// (k-1)-simplices that are critical in their own dimension.
class Flow {
 public:
  Flow(const std::vector<Index>& faces, std::size_t per_simplex, const detail::Gradient& gradient,
       const std::vector<Index>& critical_below)
      : faces_(faces),
        per_simplex_(per_simplex),
        gradient_(gradient),
        row_(gradient.when.size(), detail::kNone),
        odd_(gradient.when.size(), false) {
    for (Index i = 0; i < critical_below.size(); ++i) row_[critical_below[i]] = i;
  }

  /// The boundary of critical simplex `s` in the complex of critical simplices; nothing if the
  /// budget does not suffice.
  std::optional<Column> boundary(Index s, Budget& budget) {
    Column column;
    add_faces(s, column);
    while (!waiting_.empty()) {
      const detail::Collapse& collapse = gradient_.collapses[waiting_.top()];
      waiting_.pop();
      if (!odd_[collapse.face]) continue;  // came an even number of times
      if (!budget.spend(1)) return std::nullopt;
      add_faces(collapse.simplex, column);  // this face itself among them: it goes
    }
    std::sort(column.begin(), column.end());
    Column odd;
    for (std::size_t i = 0; i < column.size(); ++i) {
      if (!odd.empty() && odd.back() == column[i])
        odd.pop_back();
      else
        odd.push_back(column[i]);
    }
    return odd;
  }

 private:
  void add_faces(Index s, Column& column) {
    for (std::size_t i = 0; i < per_simplex_; ++i) {
      const Index face = faces_[s * per_simplex_ + i];
      const Index when = gradient_.when[face];
      if (when != detail::kNone) {
        odd_[face] = !odd_[face];
        if (odd_[face]) waiting_.push(when);
      } else if (row_[face] != detail::kNone) {
        column.push_back(row_[face]);
      }
    }
  }

  const std::vector<Index>& faces_;
  std::size_t per_simplex_;
  const detail::Gradient& gradient_;
  std::vector<Index> row_;  // per (k-1)-simplex: its place among the critical ones, or kNone
  std::vector<bool> odd_;   // per (k-1)-simplex: met an odd number of times
  // Places in the order of collapses: a collapse only leads to later ones.
  std::priority_queue<Index, std::vector<Index>, std::greater<>> waiting_;
};

/// The columns of a matrix over Z/2, reduced as they come. rank() columns are independent.
class Reduction {
 public:
  /// False if the budget does not suffice.
  bool add(Column column, Budget& budget) {
    Column sum;
    while (!column.empty()) {
      const auto entry = by_last_row_.try_emplace(column.back(), Column{});
      if (entry.second) {
        entry.first->second = std::move(column);
        return true;
      }
      const Column& other = entry.first->second;
      if (!budget.spend(column.size() + other.size())) return false;
      sum.clear();
      std::set_symmetric_difference(column.begin(), column.end(), other.begin(), other.end(),
                                    std::back_inserter(sum));
      column.swap(sum);
    }
    return true;
  }
  std::size_t rank() const { return by_last_row_.size(); }

 private:
  std::unordered_map<Index, Column> by_last_row_;
};

/// The rank of the boundary from critical k-simplices to critical (k-1)-simplices.
std::optional<std::size_t> rank_of(const std::vector<Index>& faces, std::size_t per_simplex,
                                   const detail::Gradient& gradient,
                                   const std::vector<Index>& critical_below, Budget& budget) {
  Flow flow(faces, per_simplex, gradient, critical_below);
  Reduction reduction;
  for (const Index s : gradient.critical) {
    if (reduction.rank() == critical_below.size()) break;  // it cannot grow
    const auto column = flow.boundary(s, budget);
    if (!column || !reduction.add(*column, budget)) return std::nullopt;
  }
  return reduction.rank();
}

std::size_t connected_parts(const detail::Incidence& all) {
  detail::DisjointSets sets(all.counts[0]);
  for (std::size_t e = 0; e < all.counts[1]; ++e)
    sets.join(all.faces[1][2 * e], all.faces[1][2 * e + 1]);
  return sets.count();
}

}  // namespace

template <int D>
std::optional<std::array<std::size_t, static_cast<std::size_t>(D) + 1>> betti_numbers(
    const CellSoup<D>& soup, BettiLimits limits) {
  constexpr auto kTop = static_cast<std::size_t>(D);
  require_ids_suffice(D, soup.cells.size(), soup.vertex_count);
  const auto all = detail::incidence<D>(soup, limits.simplices);
  if (!all) return std::nullopt;

  // From the top down: what a dimension collapses through is no simplex of the next.
  std::array<detail::Gradient, kTop + 1> gradients;
  std::vector<bool> gone(all->counts[kTop], false);
  for (std::size_t k = kTop; k > 0; --k) {
    gradients[k] = detail::collapse_all(all->faces[k], k + 1, all->counts[k - 1], gone);
    gone.assign(all->counts[k - 1], false);
    for (const detail::Collapse& collapse : gradients[k].collapses) gone[collapse.face] = true;
  }
  for (Index v = 0; v < gone.size(); ++v)
    if (!gone[v]) gradients[0].critical.push_back(v);

  Budget budget(limits.steps);
  std::array<std::size_t, kTop + 2> rank{};  // of the boundary of dimension k; 0 at both ends
  if (!gradients[0].critical.empty())
    rank[1] = gradients[0].critical.size() - connected_parts(*all);
  for (std::size_t k = 2; k <= kTop; ++k) {
    const auto found =
        rank_of(all->faces[k], k + 1, gradients[k], gradients[k - 1].critical, budget);
    if (!found) return std::nullopt;
    rank[k] = *found;
  }
  std::array<std::size_t, kTop + 1> betti{};
  for (std::size_t k = 0; k <= kTop; ++k)
    betti[k] = gradients[k].critical.size() - rank[k] - rank[k + 1];
  return betti;
}

#define CLEAVE_INSTANTIATE(D)                                                              \
  template std::optional<std::array<std::size_t, D + 1>> betti_numbers(const CellSoup<D>&, \
                                                                       BettiLimits);
CLEAVE_FOR_EACH_DIMENSION(CLEAVE_INSTANTIATE)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::topology
