#pragma once
#include <algorithm>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "cleave/topology/relabelling.hpp"

namespace cleave::topology {

/// Vertices that are merged have different values where they must agree.
class UnequalValues : public std::invalid_argument {
 public:
  UnequalValues(VertexId kept, VertexId gone);
  VertexId kept, gone;  // vertices of before
};

/// What becomes of the values of merged vertices. A policy is called for each vertex that others
/// are merged into, as policy(values, vertices): all values from before, and the vertices that
/// become one, first the one that stays, then the others ascending. Weights and originals are the
/// caller's, since topology knows no coordinates.
namespace merging {

/// Points of copies that were never moved, prescribed values: they must be equal, or UnequalValues
/// is thrown.
struct Equal {
  template <class T>
  T operator()(const std::vector<T>& values, std::span<const VertexId> vertices) const {
    for (const VertexId v : vertices.subspan(1))
      if (!(values[v.value] == values[vertices[0].value])) throw UnequalValues(vertices[0], v);
    return values[vertices[0].value];
  }
};

/// Points of copies that may have been moved: equal values stay, others give restore(vertex), the
/// value that the vertex that stays had before it was ever split.
template <class Restore>
struct Restored {
  Restore restore;
  template <class T>
  T operator()(const std::vector<T>& values, std::span<const VertexId> vertices) const {
    const auto differs = [&](VertexId v) {
      return !(values[v.value] == values[vertices[0].value]);
    };
    if (std::any_of(vertices.begin(), vertices.end(), differs)) return restore(vertices[0]);
    return values[vertices[0].value];
  }
};
template <class Restore>
Restored(Restore) -> Restored<Restore>;

/// Displacements: the mean, weighted by weights[v], a number per vertex of before (the volumes of
/// stars); weights that sum to zero count as equal. T needs T * double and T + T.
struct Mean {
  std::span<const double> weights;
  template <class T>
  T operator()(const std::vector<T>& values, std::span<const VertexId> vertices) const {
    double total = 0.0;
    for (const VertexId v : vertices) total += weights[v.value];
    const auto share = [&](VertexId v) {
      return total == 0.0 ? 1.0 / static_cast<double>(vertices.size()) : weights[v.value] / total;
    };
    T mean = values[vertices[0].value] * share(vertices[0]);
    for (const VertexId v : vertices.subspan(1)) mean = mean + values[v.value] * share(v);
    return mean;
  }
};

/// Forces: they add up. T needs T + T.
struct Sum {
  template <class T>
  T operator()(const std::vector<T>& values, std::span<const VertexId> vertices) const {
    T sum = values[vertices[0].value];
    for (const VertexId v : vertices.subspan(1)) sum = sum + values[v.value];
    return sum;
  }
};

}  // namespace merging

namespace detail {

/// Merges grouped by the vertex that stays.
class MergeGroups {
 public:
  /// Keeps its memory from one time to the next.
  void fill(std::span<const Merge> merges);

  /// Calls visit(vertices) for each group as for a policy, the vertices that stay ascending.
  template <class Visit>
  void for_each(Visit visit) const {
    std::size_t first = 0;
    for (const std::size_t end : ends_) {
      visit(std::span(vertices_).subspan(first, end - first));
      first = end;
    }
  }

 private:
  std::vector<Merge> by_kept_;
  std::vector<VertexId> vertices_;  // of all groups, one after the other
  std::vector<std::size_t> ends_;   // of the groups
};

/// The same for merges that are looked at once.
template <class Visit>
void for_each_merged(std::span<const Merge> merges, Visit visit) {
  MergeGroups groups;
  groups.fill(merges);
  groups.for_each(visit);
}

/// Throws std::invalid_argument unless there is a value for each vertex of before.
void require_value_each(std::size_t values, const Relabelling& change);

/// Makes one array follow a change, in two parts: `prepare` throws, and changes nothing that can be
/// seen; `commit` does neither. So several arrays follow, or none. Keeps its memory from one time
/// to the next.
template <class T>
class Carrying {
  static_assert(std::is_nothrow_move_assignable_v<T>, "a failure must leave all values alone");

 public:
  /// `groups` of the merges of `change`.
  template <class Merging>
  void prepare(std::vector<T>& values, const Relabelling& change, const MergeGroups& groups,
               const Merging& merge) {
    require_value_each(values.size(), change);
    merged_.clear();
    groups.for_each([&](std::span<const VertexId> vertices) {
      merged_.push_back({vertices[0], merge(std::as_const(values), vertices)});
    });
    copies_.clear();
    if constexpr (kPrepareCopies) {
      copies_.reserve(change.splits.size());
      for (const Split& split : change.splits) {
        const T* const value = find_merged(split.parent);
        copies_.push_back(value != nullptr ? *value : values[split.parent.value]);
      }
    }
    if (values.capacity() < change.vertices_after)
      values.reserve(std::max(change.vertices_after, 2 * values.capacity()));
  }

  /// Requires that `prepare` has been called with the same.
  void commit(std::vector<T>& values, const Relabelling& change) noexcept {
    values.resize(change.vertices_after);
    for (Merged& merged : merged_) values[merged.vertex.value] = std::move(merged.value);
    for (std::size_t n = 0; n < change.splits.size(); ++n) {
      const Split& split = change.splits[n];
      if constexpr (kPrepareCopies)
        values[split.vertex.value] = std::move(copies_[n]);
      else
        values[split.vertex.value] = values[split.parent.value];
    }
  }

 private:
  struct Merged {
    VertexId vertex;
    T value;
  };

  /// Whether copying a value may throw, so that it is not for `commit`.
  static constexpr bool kPrepareCopies = !std::is_nothrow_copy_assignable_v<T>;

  const T* find_merged(VertexId vertex) const {
    const auto at =
        std::lower_bound(merged_.begin(), merged_.end(), vertex,
                         [](const Merged& merged, VertexId v) { return merged.vertex < v; });
    return at != merged_.end() && at->vertex == vertex ? &at->value : nullptr;
  }

  std::vector<Merged> merged_;  // ascending by vertex
  std::vector<T> copies_;       // of each split, if they are prepared
};

}  // namespace detail

/// Makes data held per vertex follow a change: each new vertex gets the value of its parent, merged
/// ones become what the policy says. `per_vertex` has change.vertices_before entries and gets
/// change.vertices_after; throws std::invalid_argument if it has another number of them, what the
/// policy throws, and std::bad_alloc; `per_vertex` is unchanged then. Data on cells and half-facets
/// needs nothing, since their numbers never change. Several arrays that shall follow together, by
/// name: VertexProperties (properties.hpp). Time: linear in the copies (amortised, as the vector
/// grows), and sorting the merges.
template <class T, class Merging = merging::Equal>
void carry_over(std::vector<T>& per_vertex, const Relabelling& change, const Merging& merge = {}) {
  detail::MergeGroups groups;
  groups.fill(change.merges);
  detail::Carrying<T> carrying;
  carrying.prepare(per_vertex, change, groups, merge);
  carrying.commit(per_vertex, change);
}

/// The merges whose two vertices have different values: nothing if data that must agree allows
/// them. `merges` from a Relabelling, or planned (Incision::planned_merges). Time: linear.
template <class T>
std::vector<Merge> conflicts(const std::vector<T>& per_vertex, std::span<const Merge> merges) {
  std::vector<Merge> found;
  for (const Merge& merge : merges)
    if (!(per_vertex[merge.vertex.value] == per_vertex[merge.into.value])) found.push_back(merge);
  return found;
}

/// Makes a set of vertices, sorted ascending, follow a change: it gets all copies of its members,
/// and a vertex that members are merged into takes their place.
void carry_over_set(std::vector<VertexId>& vertices, const Relabelling& change);

}  // namespace cleave::topology
