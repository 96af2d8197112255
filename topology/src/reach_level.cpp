#include <algorithm>
#include <optional>
#include <stdexcept>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "cleave/topology/fix_it.hpp"
#include "cleave/topology/incision.hpp"
#include "dimensions.hpp"
#include "least_cut.hpp"
#include "star_levels.hpp"

namespace cleave::topology {
namespace {

/// One round of further facets for a complex that does not reach its level.
template <int D>
class Round {
 public:
  explicit Round(const Incision<D>& incision)
      : k_(incision.complex()),
        barred_(incision.shut().half_facets().begin(), incision.shut().half_facets().end()) {}

  /// Separates the parts around a simplex at that vertex of it where it takes fewest facets.
  void separate(const std::vector<VertexId>& simplex) {
    const auto parts = parts_around(simplex);
    std::optional<std::vector<HalfFacetId>> best;
    for (const VertexId vertex : simplex) {
      auto cut = cut_between(parts, vertex);
      if (!best || std::pair(cut.size(), cut) < std::pair(best->size(), *best))
        best = std::move(cut);
    }
    add(*best);
  }

  FacetSet found() const { return FacetSet::of_lesser(found_); }

  /// Divides the cells around a vertex (D = 3, edge-regular) so that each part's link is a disk.
  void divide_into_disks(VertexId vertex);

 private:
  using Part = std::vector<CellId>;

  void add(const std::vector<HalfFacetId>& facets) {
    barred_.insert(facets.begin(), facets.end());
    found_.insert(found_.end(), facets.begin(), facets.end());
  }

  /// The facet-connected parts of the star of a simplex, by their least cells.
  std::vector<Part> parts_around(const std::vector<VertexId>& simplex) const {
    const auto has = [&](const auto& vertices, VertexId v) {
      return std::find(vertices.begin(), vertices.end(), v) != vertices.end();
    };
    std::vector<CellId> cells;
    for (const CornerId corner : star(k_, simplex[0])) {
      const CellId cell = cell_of<D>(corner);
      if (std::all_of(simplex.begin(), simplex.end(),
                      [&](VertexId v) { return has(k_.vertices(cell), v); }))
        cells.push_back(cell);
    }
    std::sort(cells.begin(), cells.end());

    std::vector<Part> parts;
    std::unordered_set<CellId> seen;
    for (const CellId first : cells) {
      if (!seen.insert(first).second) continue;
      Part part{first};
      for (std::size_t next = 0; next < part.size(); ++next)
        detail::for_each_step(k_, simplex[0], part[next], [&](HalfFacetId h) {
          if (has(simplex, k_.vertex(h))) return;  // the facet lacks a vertex of the simplex
          const CellId across = cell_of<D>(*k_.mate(h));
          if (seen.insert(across).second) part.push_back(across);
        });
      parts.push_back(std::move(part));
    }
    return parts;
  }

  /// Facets at `vertex` that keep all parts apart: each part from all others, one after the other.
  std::vector<HalfFacetId> cut_between(const std::vector<Part>& parts, VertexId vertex) const {
    std::vector<HalfFacetId> cut;
    for (std::size_t n = 0; n + 1 < parts.size(); ++n) {
      Part others;
      for (std::size_t m = 0; m < parts.size(); ++m)
        if (m != n) others.insert(others.end(), parts[m].begin(), parts[m].end());
      const auto more =
          detail::LeastCut<D>(k_, vertex)
              .between(parts[n], others, k_.half_facet_count(), [&](HalfFacetId h) {
                return barred_.contains(h) || std::binary_search(cut.begin(), cut.end(), h);
              });
      cut.insert(cut.end(), more->begin(), more->end());
      std::sort(cut.begin(), cut.end());
    }
    return cut;
  }

  const Complex<D>& k_;
  std::unordered_set<HalfFacetId> barred_;  // scored and shut, or found
  std::vector<HalfFacetId> found_;
};

template <int D>
void Round<D>::divide_into_disks(VertexId vertex) {
  std::vector<CornerId> corners = star(k_, vertex);
  std::sort(corners.begin(), corners.end());
  std::unordered_map<CellId, std::size_t> disk_of;
  std::size_t disks = 0;
  for (const CornerId first : corners) {
    if (disk_of.contains(cell_of<D>(first))) continue;
    const std::size_t disk = disks++;
    std::unordered_set<VertexId> reached;  // vertices of the disk in the link
    const auto take = [&](CellId cell) {
      disk_of.emplace(cell, disk);
      for (const VertexId v : k_.vertices(cell)) reached.insert(v);
    };
    // A triangle may join a disk that it meets in one edge and no further vertex, or in two edges.
    const auto may_join = [&](CellId cell) {
      std::size_t edges = 0;
      VertexId opposite{};
      detail::for_each_step(k_, vertex, cell, [&](HalfFacetId h) {
        const auto across = disk_of.find(cell_of<D>(*k_.mate(h)));
        if (across == disk_of.end() || across->second != disk) return;
        ++edges;
        opposite = k_.vertex(h);
      });
      return edges == 2 || (edges == 1 && !reached.contains(opposite));
    };
    take(cell_of<D>(first));
    std::vector<CellId> open{cell_of<D>(first)};
    for (std::size_t next = 0; next < open.size(); ++next)
      detail::for_each_step(k_, vertex, open[next], [&](HalfFacetId h) {
        const CellId across = cell_of<D>(*k_.mate(h));
        if (barred_.contains(detail::lesser(k_, h)) || disk_of.contains(across) ||
            !may_join(across))
          return;
        take(across);
        open.push_back(across);
      });
  }
  std::vector<HalfFacetId> between;
  for (const CornerId corner : corners)
    detail::for_each_step(k_, vertex, cell_of<D>(corner), [&](HalfFacetId h) {
      const HalfFacetId mate = *k_.mate(h);
      if (h < mate && !barred_.contains(h) &&
          disk_of.at(cell_of<D>(h)) != disk_of.at(cell_of<D>(mate)))
        between.push_back(h);
    });
  add(between);
}

template <int D>
FacetSet more_facets(const Incision<D>& incision, Level level) {
  using Access = detail::ComplexAccess<D>;
  const Complex<D>& k = incision.complex();
  std::vector<CornerId> a_corner;
  for (Index v = 0; v < k.vertex_count(); ++v)
    a_corner.push_back(k.a_corner(VertexId{v}).value_or(CornerId{detail::kNone}));
  std::vector<Violation> found;
  detail::find_faults_beyond_stars<D>(Access::cells(k), Access::mates(k), a_corner, {}, level,
                                      found);
  Round<D> round(incision);
  bool pinched = false;
  for (const Violation& violation : found)
    if (const auto* fault = std::get_if<PinchedSimplex>(&violation)) {
      round.separate(fault->simplex);
      pinched = true;
    }
  // Where no edge is pinched every link is a surface.
  if constexpr (D == 3)
    if (!pinched)
      for (const Violation& violation : found)
        round.divide_into_disks(std::get<BadVertexLink>(violation).vertex);
  return round.found();
}

}  // namespace

template <int D>
FacetSet facets_to_reach(const Complex<D>& k, const FacetSet& scored, Level level) {
  if (level == Level::manifold && D > 3)
    throw std::invalid_argument("whether a complex of dimension 4 is a manifold is not decided");
  FacetSet found;
  if (level <= Level::cut_regular) return found;
  Incision<D> trial(k);
  trial.cut(scored, Verify::none);
  for (;;) {
    const FacetSet more = more_facets(trial, level);
    if (more.empty()) return found;
    found = found | more;
    trial.cut(more, Verify::none);
  }
}

#define CLEAVE_INSTANTIATE(D) \
  template FacetSet facets_to_reach<D>(const Complex<D>&, const FacetSet&, Level);
CLEAVE_FOR_EACH_DIMENSION(CLEAVE_INSTANTIATE)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::topology
