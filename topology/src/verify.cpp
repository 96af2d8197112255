#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <vector>

#include "cleave/topology/check.hpp"
#include "cleave/topology/unglue.hpp"
#include "cleave/topology/violation.hpp"
#include "corner_set.hpp"
#include "dimensions.hpp"

namespace cleave::topology {
namespace {

void require(bool holds, const char* what, Index id) {
  if (!holds) throw InvariantBroken(std::string(what) + " (" + std::to_string(id) + ")");
}

template <int D>
Facet<D> sorted_facet(const Complex<D>& k, HalfFacetId h) {
  Facet<D> facet = k.facet(h);
  std::sort(facet.begin(), facet.end());
  return facet;
}

/// Mates h and m name each other, have the same vertices, and opposite orientations are induced on
/// them.
template <int D>
void verify_mates(const Complex<D>& k, HalfFacetId h, HalfFacetId m) {
  require(k.mate(m) == h, "mates do not name each other at half-facet", h.value);
  const Facet<D> one = k.facet(h), other = k.facet(m);
  std::array<std::ptrdiff_t, static_cast<std::size_t>(D)> place{};  // in `other`, of one's vertices
  int parity = 1;
  for (std::size_t i = 0; i < one.size(); ++i) {
    place[i] = std::find(other.begin(), other.end(), one[i]) - other.begin();
    require(place[i] < D, "mates differ in vertices at half-facet", h.value);
    for (std::size_t before = 0; before < i; ++before)
      if (place[i] < place[before]) parity = -parity;
  }
  require(k.facet_sign(h) * parity == -k.facet_sign(m),
          "mates have the same orientation at half-facet", h.value);
}

/// New vertices are told of once each, and every number beyond the old ones is among them.
void verify_splits(const Relabelling& change) {
  std::size_t beyond = 0;
  for (std::size_t n = 0; n < change.splits.size(); ++n) {
    const Split& split = change.splits[n];
    require(split.vertex.value < change.vertices_after &&
                (n == 0 || change.splits[n - 1].vertex < split.vertex),
            "a copy is misnumbered", split.vertex.value);
    require(
        split.parent.value < change.vertices_before && change.parent(split.parent) == split.parent,
        "a copy's parent is new", split.vertex.value);
    if (split.vertex.value >= change.vertices_before) ++beyond;
  }
  require(change.vertices_after == change.vertices_before + beyond,
          "vertices are not counted right, splits", static_cast<Index>(change.splits.size()));
}

/// Vertices that ceased to exist are told of once each, and no cell uses them.
template <int D>
void verify_merges(const Complex<D>& k, const Relabelling& change) {
  require(change.vertices_after <= change.vertices_before, "vertices are not counted right, merges",
          static_cast<Index>(change.merges.size()));
  for (std::size_t n = 0; n < change.merges.size(); ++n) {
    const Merge& merge = change.merges[n];
    require(merge.vertex.value < change.vertices_before &&
                (n == 0 || change.merges[n - 1].vertex < merge.vertex),
            "a merged copy is misnumbered", merge.vertex.value);
    require(merge.vertex.value >= change.vertices_after || !k.a_corner(merge.vertex),
            "a merged copy has a corner", merge.vertex.value);
    require(merge.into.value < change.vertices_after && change.merged(merge.into) == merge.into,
            "a copy is merged into one that ceased to exist", merge.vertex.value);
  }
}

template <int D>
void verify_names(const Complex<D>& k, const Relabelling& change) {
  require(k.vertex_count() == change.vertices_after, "vertices are not counted right",
          static_cast<Index>(change.vertices_after));
  require(change.splits.empty() || change.merges.empty(), "a change both splits and merges, copies",
          static_cast<Index>(change.splits.size()));
  if (change.merges.empty())
    verify_splits(change);
  else
    verify_merges(k, change);
  for (const RenamedCorner& renamed : change.corners) {
    require(renamed.from != renamed.to, "a corner is renamed to its own vertex",
            renamed.corner.value);
    require(change.merges.empty() ? change.parent(renamed.to) == renamed.from
                                  : change.merged(renamed.from) == renamed.to,
            "a corner got a vertex that is neither copy nor parent", renamed.corner.value);
    require(k.vertex(renamed.corner) == renamed.to, "a corner does not have its new vertex",
            renamed.corner.value);
  }
}

/// The facets of `cut` are the opened and the shut ones, and what is said of them, and of closed
/// ones, is so. The names of `change` are verified.
template <int D>
void verify_facets(const Complex<D>& k, const FacetSet& cut, const Relabelling& change) {
  std::vector<HalfFacetId> named = change.shut;
  for (const OpenedFacet& facet : change.opened) named.push_back(facet.half_facet);
  std::inplace_merge(named.begin(), named.begin() + std::ssize(change.shut), named.end());
  const auto asked = cut.half_facets();
  require(std::equal(named.begin(), named.end(), asked.begin(), asked.end()),
          "opened and shut facets are not those of the cut", static_cast<Index>(cut.size()));
  for (const HalfFacetId h : change.shut)
    require(k.is_interior(h), "a shut facet lost its mate", h.value);
  for (const OpenedFacet& facet : change.closed)
    require(k.mate(facet.half_facet) == facet.former_mate, "a closed facet has not its mate",
            facet.half_facet.value);
  const auto parents = [&](HalfFacetId h) {
    Facet<D> facet = k.facet(h);
    for (VertexId& v : facet) v = change.parent(v);
    std::sort(facet.begin(), facet.end());
    return facet;
  };
  for (const OpenedFacet& facet : change.opened) {
    require(!k.is_interior(facet.half_facet) && !k.is_interior(facet.former_mate),
            "an opened facet has a mate", facet.half_facet.value);
    require(sorted_facet(k, facet.half_facet) != sorted_facet(k, facet.former_mate),
            "an opened facet has the same vertices on both sides", facet.half_facet.value);
    require(parents(facet.half_facet) == parents(facet.former_mate),
            "an opened facet's sides do not come from one facet", facet.half_facet.value);
  }
}

/// Walks around vertices from given corners. Shares no code with unglue.
template <int D>
class StarWalks {
 public:
  explicit StarWalks(const Complex<D>& k) : k_(k) {}

  /// Walks around the vertex of `start`, unless an earlier walk came past this corner, and verifies
  /// the mates it crosses.
  void walk(CornerId start) {
    if (!reached_.insert(start)) return;
    const VertexId vertex = k_.vertex(start);
    vertices_.push_back(vertex);
    corners_.assign(1, start);
    for (std::size_t next = 0; next < corners_.size(); ++next) {
      const CornerId corner = corners_[next];
      for (int i = 0; i <= D; ++i) {
        const HalfFacetId h = half_facet<D>(cell_of<D>(corner), i);
        if (h == corner) continue;
        require(k_.vertex(h) != vertex, "a cell has a vertex twice", cell_of<D>(h).value);
        const auto mate = k_.mate(h);
        if (!mate) continue;
        const auto& across = k_.vertices(cell_of<D>(*mate));
        const auto place = std::find(across.begin(), across.end(), vertex) - across.begin();
        require(place <= D && place != local_index<D>(*mate),
                "mates differ in vertices at half-facet", h.value);
        if (h < *mate)
          verify_mates(k_, h, *mate);
        else  // verified when the walk comes back through it
          require(k_.mate(*mate) == h, "mates do not name each other at half-facet", h.value);
        const CornerId neighbour = half_facet<D>(cell_of<D>(*mate), static_cast<int>(place));
        if (reached_.insert(neighbour)) corners_.push_back(neighbour);
      }
    }
  }

  /// Every star was walked from several corners as a rule; one walk must have reached them all.
  void verify_one_walk_each() {
    std::sort(vertices_.begin(), vertices_.end());
    const auto twice = std::adjacent_find(vertices_.begin(), vertices_.end());
    require(twice == vertices_.end(), "the star of a vertex is not one part",
            twice == vertices_.end() ? 0 : twice->value);
    for (const VertexId vertex : vertices_) {
      const auto corner = k_.a_corner(vertex);
      require(corner && k_.vertex(*corner) == vertex && reached_.contains(*corner),
              "a vertex names a corner that is not in its star", vertex.value);
    }
  }

 private:
  const Complex<D>& k_;
  detail::CornerSet reached_;
  std::vector<VertexId> vertices_;  // walked around
  std::vector<CornerId> corners_;   // of the walk under way
};

}  // namespace

template <int D>
void verify_touched(const Complex<D>& k, const FacetSet& cut, const Relabelling& change) {
  verify_names(k, change);
  verify_facets(k, cut, change);
  StarWalks<D> walks(k);
  for (const RenamedCorner& renamed : change.corners) walks.walk(renamed.corner);
  // Each class of corners at a vertex of the cut has a corner on a side of one of its facets.
  const auto walk_around = [&](HalfFacetId side) {
    for (int i = 0; i <= D; ++i)
      if (i != local_index<D>(side)) walks.walk(half_facet<D>(cell_of<D>(side), i));
  };
  for (const auto* facets : {&change.opened, &change.closed})
    for (const OpenedFacet& facet : *facets) {
      walk_around(facet.half_facet);
      walk_around(facet.former_mate);
    }
  for (const HalfFacetId h : change.shut) {
    walk_around(h);
    walk_around(*k.mate(h));
  }
  walks.verify_one_walk_each();
}

template <int D>
void verify_all(const Complex<D>& k) {
  CellSoup<D> soup;
  soup.cells.assign(k.cells().begin(), k.cells().end());
  soup.vertex_count = k.vertex_count();
  soup.signs.reserve(k.cell_count());
  for (Index c = 0; c < k.cell_count(); ++c)
    soup.signs.push_back(static_cast<std::int8_t>(k.sign(CellId{c})));
  for (const Violation& violation : check(soup, Level::cut_regular))
    if (!std::holds_alternative<OrphanVertex>(violation))
      throw InvariantBroken(describe(violation));
  for (Index h = 0; h < k.half_facet_count(); ++h)
    if (const auto mate = k.mate(HalfFacetId{h})) verify_mates(k, HalfFacetId{h}, *mate);
}

#define CLEAVE_INSTANTIATE(D)                                                              \
  template void verify_touched<D>(const Complex<D>&, const FacetSet&, const Relabelling&); \
  template void verify_all<D>(const Complex<D>&);
CLEAVE_FOR_EACH_DIMENSION(CLEAVE_INSTANTIATE)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::topology
