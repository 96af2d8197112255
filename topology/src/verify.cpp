#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "cleave/topology/check.hpp"
#include "cleave/topology/unglue.hpp"
#include "cleave/topology/violation.hpp"
#include "dimensions.hpp"
#include "star_cells.hpp"
#include "verify_scratch.hpp"

namespace cleave::topology {
namespace {

[[noreturn, gnu::cold, gnu::noinline]] void fail(const char* what, Index id) {
  throw InvariantBroken(std::string(what) + " (" + std::to_string(id) + ")");
}

inline void require(bool holds, const char* what, Index id) {
  if (!holds) fail(what, id);
}

/// Puts the entries of one tuple at places of another, one after the other.
class Places {
 public:
  /// False if the place is taken.
  bool take(std::size_t place) {
    odd_ ^= kOdd >> (taken_ >> place);  // earlier entries at later places
    const unsigned bit = 1u << place;
    const bool was_free = (taken_ & bit) == 0;
    taken_ |= bit;
    return was_free;
  }
  /// Of the permutation, when all places are taken.
  bool is_odd() const { return (odd_ & 1u) != 0; }

 private:
  static constexpr unsigned kOdd = 0x96696996u;  // bit n: whether n < 32 has an odd number of bits
  unsigned taken_ = 0, odd_ = 0;
};

template <std::size_t N>
std::size_t place_in(const std::array<VertexId, N>& tuple, VertexId vertex) {
  std::size_t place = 0;
  while (place < N && tuple[place] != vertex) ++place;
  return place;
}

/// Whether the facets opposite two places of two cells are the same, vertex by vertex, as most are
/// where the vertices of cells ascend. Without branches.
template <std::size_t N>
[[gnu::always_inline]] inline bool in_same_order(const std::array<VertexId, N>& one,
                                                 std::size_t opposite,
                                                 const std::array<VertexId, N>& other,
                                                 std::size_t back) {
  bool same = true;
  for (std::size_t i = 0; i + 1 < N; ++i)
    same &= one[i + (i >= opposite ? 1 : 0)] == other[i + (i >= back ? 1 : 0)];
  return same;
}

/// Whether each entry of one facet is found at a place of its own in the other.
template <std::size_t N>
bool same_vertices(const std::array<VertexId, N>& one, const std::array<VertexId, N>& other) {
  Places places;
  for (const VertexId v : one) {
    const std::size_t place = place_in(other, v);
    if (place == N || !places.take(place)) return false;
  }
  return true;
}

/// Mates h and m, which name each other, have the same vertices, and opposite orientations are
/// induced on them: when the vertices opposite the facet count as the same, one cell is an odd
/// permutation of the other if their signs agree, an even one if they differ.
template <int D>
[[gnu::always_inline]] inline void verify_mates(const Complex<D>& k, HalfFacetId h, HalfFacetId m) {
  const Cell<D>& one = k.vertices(cell_of<D>(h));
  const Cell<D>& other = k.vertices(cell_of<D>(m));
  const auto opposite = static_cast<std::size_t>(local_index<D>(h));
  const auto back = static_cast<std::size_t>(local_index<D>(m));
  if (in_same_order(one, opposite, other, back)) {
    require((opposite + back) % 2 == (k.sign(cell_of<D>(h)) == k.sign(cell_of<D>(m)) ? 1 : 0),
            "mates have the same orientation at half-facet", h.value);
    return;
  }
  Places places;
  for (std::size_t i = 0; i <= D; ++i) {
    const std::size_t place = i == opposite ? back : place_in(other, one[i]);
    require(place <= D && places.take(place), "mates differ in vertices at half-facet", h.value);
  }
  require(places.is_odd() == (k.sign(cell_of<D>(h)) == k.sign(cell_of<D>(m))),
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

/// Where `vertex` is told of in `entries`, ascending by vertex, or their end. New ids follow each
/// other as a rule, so that its place can be computed.
template <class Entry>
[[gnu::always_inline]] inline auto told(const std::vector<Entry>& entries, VertexId vertex) {
  if (entries.empty() || vertex < entries.front().vertex) return entries.end();
  const auto at = static_cast<std::size_t>(vertex.value - entries.front().vertex.value);
  if (at < entries.size() && entries[at].vertex == vertex)
    return entries.begin() + static_cast<std::ptrdiff_t>(at);
  const auto from = std::lower_bound(entries.begin(), entries.end(), vertex,
                                     [](const Entry& e, VertexId v) { return e.vertex < v; });
  return from != entries.end() && from->vertex == vertex ? from : entries.end();
}

[[gnu::always_inline]] inline VertexId parent(const Relabelling& change, VertexId vertex) {
  const auto split = told(change.splits, vertex);
  return split == change.splits.end() ? vertex : split->parent;
}

VertexId merged(const Relabelling& change, VertexId vertex) {
  const auto merge = told(change.merges, vertex);
  return merge == change.merges.end() ? vertex : merge->into;
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
    require(change.merges.empty() ? parent(change, renamed.to) == renamed.from
                                  : merged(change, renamed.from) == renamed.to,
            "a corner got a vertex that is neither copy nor parent", renamed.corner.value);
    require(k.vertex(renamed.corner) == renamed.to, "a corner does not have its new vertex",
            renamed.corner.value);
  }
}

/// Whether the opened and the shut facets together are those of `cut`, ascending like these.
bool opened_or_shut(const FacetSet& cut, const Relabelling& change) {
  auto opened = change.opened.begin();
  auto shut = change.shut.begin();
  for (const HalfFacetId h : cut.half_facets())
    if (opened != change.opened.end() && opened->half_facet == h)
      ++opened;
    else if (shut != change.shut.end() && *shut == h)
      ++shut;
    else
      return false;
  return opened == change.opened.end() && shut == change.shut.end();
}

/// The facets of `cut` are the opened and the shut ones, and what is said of them, and of closed
/// ones, is so. The names of `change` are verified.
template <int D>
void verify_facets(const Complex<D>& k, const FacetSet& cut, const Relabelling& change) {
  require(opened_or_shut(cut, change), "opened and shut facets are not those of the cut",
          static_cast<Index>(cut.size()));
  for (const HalfFacetId h : change.shut)
    require(k.is_interior(h), "a shut facet lost its mate", h.value);
  for (const OpenedFacet& facet : change.closed)
    require(k.mate(facet.half_facet) == facet.former_mate, "a closed facet has not its mate",
            facet.half_facet.value);
  for (const OpenedFacet& facet : change.opened) {
    require(!k.is_interior(facet.half_facet) && !k.is_interior(facet.former_mate),
            "an opened facet has a mate", facet.half_facet.value);
    Facet<D> one = k.facet(facet.half_facet), other = k.facet(facet.former_mate);
    require(!same_vertices(one, other), "an opened facet has the same vertices on both sides",
            facet.half_facet.value);
    for (VertexId& v : one) v = parent(change, v);
    for (VertexId& v : other) v = parent(change, v);
    require(same_vertices(one, other), "an opened facet's sides do not come from one facet",
            facet.half_facet.value);
  }
}

/// Walks around vertices from given corners. Shares no code with unglue.
template <int D>
class StarWalks {
  using Reached = detail::VerifyScratch::Reached;

 public:
  StarWalks(const Complex<D>& k, detail::VerifyScratch& scratch)
      : k_(k), reached_(scratch.reached), star_(scratch.star), cells_(scratch.star_cells) {
    reached_.clear();
  }

  /// Walks around the vertex of `start`, unless an earlier walk came past this corner, and verifies
  /// the mates it crosses, each once. The vertex must name the least corner that the walk comes
  /// past; so there is no second walk around it, and its star is one part.
  void walk(CornerId start) {
    if (!reached_.contains(start)) walk_from(start);
  }

 private:
  void walk_from(CornerId start) {
    const VertexId vertex = k_.vertex(start);
    const HalfFacetId* const mates = k_.mates().data();
    const std::size_t half_facets = k_.half_facet_count();
    const Cell<D>* const cells = k_.cells().data();
    CornerId least = start;
    star_.assign(1, {start, start});
    cells_.begin();
    cells_.add(cells_.at(cell_of<D>(start)), start, star_);
    for (std::size_t next = 0; next < star_.size(); ++next) {
      const auto [corner, through] = star_[next];
      least = std::min(least, corner);
      const CellId cell = cell_of<D>(corner);
      int times = 0;
      for (const VertexId v : cells[cell.value]) times += v == vertex ? 1 : 0;
      require(times == 1, "a cell has a vertex twice", cell.value);
      const HalfFacetId first = half_facet<D>(cell, 0);
      for (int i = 0; i <= D; ++i) {
        const HalfFacetId h{first.value + static_cast<Index>(i)};
        if (h == corner || h == through) continue;  // `through` was verified on the way in
        const HalfFacetId mate = mates[h.value];
        if (mate.value >= half_facets) continue;
        require(mates[mate.value] == h, "mates do not name each other at half-facet", h.value);
        if (reach(h, mate, vertex) || h < mate)
          verify_mates(k_, h, mate);  // else seen from the other side
      }
    }
    if (k_.a_corner(vertex) != least)
      fail("the star of a vertex is not one part, or it does not name its least corner",
           vertex.value);
    for (const Reached& there : star_) reached_.insert(there.corner);
  }

  /// Comes to the corner beyond `h`; true for the first time.
  bool reach(HalfFacetId h, HalfFacetId mate, VertexId vertex) {
    Index& known = cells_.at(cell_of<D>(mate));
    if (known != kNoIndex) {
      require(known != mate.value, "mates differ in vertices at half-facet", h.value);
      return false;
    }
    const std::size_t place = place_in(k_.vertices(cell_of<D>(mate)), vertex);
    const CornerId corner = half_facet<D>(cell_of<D>(mate), static_cast<int>(place));
    require(place <= D && corner != mate, "mates differ in vertices at half-facet", h.value);
    star_.push_back({corner, mate});
    cells_.add(known, corner, star_);
    return true;
  }

  const Complex<D>& k_;
  detail::CornerMarks& reached_;  // by all walks
  std::vector<Reached>& star_;    // of the walk under way
  detail::StarCells<D> cells_;    // the same
};

}  // namespace

template <int D>
void verify_touched(const Complex<D>& k, const FacetSet& cut, const Relabelling& change) {
  detail::VerifyScratch scratch;
  detail::verify_touched(k, cut, change, scratch);
}

template <int D>
void detail::verify_touched(const Complex<D>& k, const FacetSet& cut, const Relabelling& change,
                            VerifyScratch& scratch) {
  verify_names(k, change);
  verify_facets(k, cut, change);
  StarWalks<D> walks(k, scratch);
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
    if (const auto mate = k.mate(HalfFacetId{h})) {
      require(k.mate(*mate) == HalfFacetId{h}, "mates do not name each other at half-facet", h);
      verify_mates(k, HalfFacetId{h}, *mate);
    }
}

#define CLEAVE_INSTANTIATE(D)                                                                     \
  template void verify_touched<D>(const Complex<D>&, const FacetSet&, const Relabelling&);        \
  template void detail::verify_touched<D>(const Complex<D>&, const FacetSet&, const Relabelling&, \
                                          VerifyScratch&);                                        \
  template void verify_all<D>(const Complex<D>&);
CLEAVE_FOR_EACH_DIMENSION(CLEAVE_INSTANTIATE)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::topology
