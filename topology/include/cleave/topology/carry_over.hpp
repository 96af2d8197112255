#pragma once
#include <algorithm>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
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

/// Merges grouped by the vertex that stays: calls visit(vertices) for each, as for a policy.
template <class Visit>
void for_each_merged(std::span<const Merge> merges, Visit visit) {
  std::vector<Merge> by_kept(merges.begin(), merges.end());
  std::sort(by_kept.begin(), by_kept.end(), [](const Merge& a, const Merge& b) {
    return a.into != b.into ? a.into < b.into : a.vertex < b.vertex;
  });
  std::vector<VertexId> vertices;
  for (auto first = by_kept.begin(); first != by_kept.end();) {
    vertices.assign(1, first->into);
    for (; first != by_kept.end() && first->into == vertices[0]; ++first)
      vertices.push_back(first->vertex);
    visit(std::span<const VertexId>(vertices));
  }
}

}  // namespace detail

/// Makes data held per vertex follow a change: each new vertex gets the value of its parent, merged
/// ones become what the policy says. `per_vertex` has change.vertices_before entries and gets
/// change.vertices_after; throws std::invalid_argument if it has another number of them, and what
/// the policy throws; `per_vertex` is unchanged then. Data on cells and half-facets needs nothing,
/// since their numbers never change. Time: linear in the copies (amortised, as the vector grows),
/// and sorting the merges.
template <class T, class Merging = merging::Equal>
void carry_over(std::vector<T>& per_vertex, const Relabelling& change, const Merging& merge = {}) {
  if (per_vertex.size() != change.vertices_before)
    throw std::invalid_argument(std::to_string(per_vertex.size()) + " values are given for " +
                                std::to_string(change.vertices_before) + " vertices");
  std::vector<std::pair<VertexId, T>> merged;
  detail::for_each_merged(change.merges, [&](std::span<const VertexId> vertices) {
    merged.emplace_back(vertices[0], merge(std::as_const(per_vertex), vertices));
  });
  per_vertex.resize(change.vertices_after);
  for (auto& [vertex, value] : merged) per_vertex[vertex.value] = std::move(value);
  for (const Split& split : change.splits)
    per_vertex[split.vertex.value] = per_vertex[split.parent.value];
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
