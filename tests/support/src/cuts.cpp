#include "cleave/support/cuts.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "cleave/support/dimensions.hpp"
#include "cleave/support/reference.hpp"

namespace cleave::support {
namespace {

using Ridge = std::vector<VertexId>;
using Facets = std::vector<HalfFacetId>;
constexpr int kUnlabelled = -1;

/// A mesh with its mates: what it takes to grow sheets.
template <int D>
struct Ground {
  const std::vector<Cell<D>>& cells;
  std::vector<std::optional<HalfFacetId>> mates;
  Facets interior;

  explicit Ground(const Mesh<D>& mesh)
      : cells(mesh.cells),
        mates(mates_of<D>(mesh.cells)),
        interior(interior_facets<D>(mesh.cells)) {}

  std::vector<std::size_t> neighbours(std::size_t cell) const {
    std::vector<std::size_t> result;
    for (int i = 0; i <= D; ++i)
      if (const auto mate =
              mates[topology::half_facet<D>({static_cast<topology::Index>(cell)}, i).value])
        result.push_back(topology::cell_of<D>(*mate).value);
    return result;
  }

  std::size_t side(HalfFacetId h) const { return topology::cell_of<D>(h).value; }

  /// The interior facets between cells of different labels.
  Facets between(const std::vector<int>& label) const {
    Facets result;
    for (const HalfFacetId h : interior)
      if (label[side(h)] != label[side(*mates[h.value])]) result.push_back(h);
    return result;
  }

  /// Gives labels to neighbours of labelled cells, in random order, until `limit` cells have one.
  void grow(std::vector<int>& label, std::size_t limit, Rng& rng) const {
    std::vector<std::size_t> front;
    for (std::size_t c = 0; c < label.size(); ++c)
      if (label[c] != kUnlabelled) front.push_back(c);
    std::size_t labelled = front.size();
    while (!front.empty() && labelled < limit) {
      std::swap(front[rng.below(front.size())], front.back());
      const std::size_t cell = front.back();
      front.pop_back();
      for (const std::size_t next : neighbours(cell))
        if (label[next] == kUnlabelled && labelled < limit) {
          label[next] = label[cell];
          ++labelled;
          front.push_back(next);
        }
    }
  }
};

/// The interior facets around a ridge that no boundary facet contains, and its cells, both in the
/// order of a walk around it; facets[i] lies between cells[i] and cells[i+1]. Empty if there is no
/// such walk through all of them.
template <int D>
struct Circle {
  std::vector<std::size_t> cells;
  Facets facets;
};

template <int D>
Circle<D> circle_around(const Ground<D>& ground, HalfFacetId start, const Ridge& ridge) {
  Circle<D> circle;
  HalfFacetId h = start;
  do {
    const std::size_t cell = ground.side(h);
    circle.cells.push_back(cell);
    // The other facet of this cell that contains the ridge is opposite the other vertex outside it.
    int other = -1;
    for (int i = 0; i <= D; ++i)
      if (i != topology::local_index<D>(h) &&
          !std::binary_search(ridge.begin(), ridge.end(), ground.cells[cell][i]))
        other = i;
    const auto out = topology::half_facet<D>({static_cast<topology::Index>(cell)}, other);
    const auto mate = ground.mates[out.value];
    if (!mate) return {};
    circle.facets.push_back(std::min(out, *mate));
    h = *mate;
  } while (h != start);
  return circle;
}

template <int D>
Ridge random_ridge(const Ground<D>& ground, HalfFacetId of, Rng& rng) {
  const Facet<D> facet = sorted_facet<D>(ground.cells, of);
  Ridge ridge(facet.begin(), facet.end());
  ridge.erase(ridge.begin() + static_cast<std::ptrdiff_t>(rng.below(ridge.size())));
  return ridge;
}

/// Sectors of cells that meet in an inner ridge, `pages` of them (or more, up to all, if
/// `or_more`), grown to the whole piece. The cut lies between the sectors.
template <int D>
std::optional<Facets> junction(const Ground<D>& ground, std::size_t pages, bool or_more, Rng& rng) {
  for (int tries = 0; tries < 20; ++tries) {
    const HalfFacetId start = rng.pick(ground.interior);
    const auto circle = circle_around<D>(ground, start, random_ridge<D>(ground, start, rng));
    const std::size_t n = circle.cells.size();
    if (n < pages) continue;
    const std::size_t chosen = or_more ? pages + rng.below(n - pages + 1) : pages;
    std::vector<std::size_t> cut(n);
    for (std::size_t i = 0; i < n; ++i) cut[i] = i;
    rng.shuffle(cut);
    const std::set<std::size_t> pages_at(cut.begin(), cut.begin() + static_cast<int>(chosen));
    std::vector<int> label(ground.cells.size(), kUnlabelled);
    int sector = 0;
    for (std::size_t i = 0; i < n; ++i) {
      label[circle.cells[i]] = sector;
      if (pages_at.count(i) != 0) sector = (sector + 1) % static_cast<int>(chosen);
    }
    ground.grow(label, label.size(), rng);
    return ground.between(label);
  }
  return std::nullopt;
}

/// The vertices that no boundary facet contains.
template <int D>
std::set<VertexId> inner_vertices(const Ground<D>& ground) {
  std::set<VertexId> inner;
  for (const Cell<D>& cell : ground.cells) inner.insert(cell.begin(), cell.end());
  for (topology::Index h = 0; h < ground.mates.size(); ++h)
    if (!ground.mates[h])
      for (const VertexId v : sorted_facet<D>(ground.cells, {h})) inner.erase(v);
  return inner;
}

template <int D>
std::optional<Facets> isolated(const Ground<D>& ground, Rng& rng) {
  const std::set<VertexId> inner = inner_vertices<D>(ground);
  Facets left(ground.interior);
  rng.shuffle(left);
  const auto is_inner = [&](HalfFacetId h) {
    const Facet<D> facet = sorted_facet<D>(ground.cells, h);
    return std::all_of(facet.begin(), facet.end(), [&](VertexId v) { return inner.count(v) != 0; });
  };
  const auto others = std::stable_partition(left.begin(), left.end(), is_inner);
  if (others == left.begin()) return std::nullopt;
  std::set<VertexId> taken;
  Facets result;
  const std::size_t size = 1 + rng.below(6);
  for (const HalfFacetId h : left) {
    const Facet<D> facet = sorted_facet<D>(ground.cells, h);
    if (result.size() == size) break;
    if (std::any_of(facet.begin(), facet.end(), [&](VertexId v) { return taken.count(v) != 0; }))
      continue;
    taken.insert(facet.begin(), facet.end());
    result.push_back(h);
  }
  return result;
}

/// A set of cells and the rest.
template <int D>
std::optional<Facets> sheet(const Ground<D>& ground, Rng& rng) {
  std::vector<int> label(ground.cells.size(), kUnlabelled);
  label[ground.side(rng.pick(ground.interior))] = 0;
  ground.grow(label, 1 + rng.below(label.size()), rng);
  const Facets facets = ground.between(label);
  if (facets.empty()) return std::nullopt;
  return facets;
}

/// The facets of a sheet near one of them, if that leaves a rim inside the body.
template <int D>
std::optional<Facets> rim(const Ground<D>& ground, Rng& rng) {
  const auto whole = sheet<D>(ground, rng);
  if (!whole || whole->size() < 2) return std::nullopt;
  std::set<VertexId> reached;
  Facets part;
  std::vector<HalfFacetId> left(*whole);
  rng.shuffle(left);
  const std::size_t size = 1 + rng.below(whole->size() - 1);
  while (part.size() < size) {
    auto next = std::find_if(left.begin(), left.end(), [&](HalfFacetId h) {
      const Facet<D> facet = sorted_facet<D>(ground.cells, h);
      return std::count_if(facet.begin(), facet.end(),
                           [&](VertexId v) { return reached.count(v) != 0; }) >= D - 1;
    });
    if (next == left.end()) next = left.begin();
    part.push_back(*next);
    const Facet<D> facet = sorted_facet<D>(ground.cells, *next);
    reached.insert(facet.begin(), facet.end());
    left.erase(next);
  }
  const auto degrees = ridge_degrees<D>(ground.cells, part);
  for (const HalfFacetId h : part) {
    const Facet<D> facet = sorted_facet<D>(ground.cells, h);
    for (std::size_t i = 0; i < facet.size(); ++i) {
      Ridge ridge(facet.begin(), facet.end());
      ridge.erase(ridge.begin() + static_cast<std::ptrdiff_t>(i));
      if (degrees.at(ridge) == 1 && !circle_around<D>(ground, h, ridge).cells.empty()) return part;
    }
  }
  return std::nullopt;
}

template <int D>
std::optional<Facets> book(const Ground<D>& ground, Rng& rng) {
  for (int tries = 0; tries < 20; ++tries) {
    const Ridge ridge = random_ridge<D>(ground, rng.pick(ground.interior), rng);
    Facets pages;
    for (const HalfFacetId h : ground.interior) {
      const Facet<D> facet = sorted_facet<D>(ground.cells, h);
      if (std::includes(facet.begin(), facet.end(), ridge.begin(), ridge.end())) pages.push_back(h);
    }
    if (pages.size() < 3) continue;
    rng.shuffle(pages);
    pages.resize(3 + rng.below(pages.size() - 2));
    return pages;
  }
  return std::nullopt;
}

template <int D>
std::optional<Facets> shell(const Ground<D>& ground, Rng& rng) {
  std::vector<std::size_t> inner;
  for (std::size_t c = 0; c < ground.cells.size(); ++c)
    if (ground.neighbours(c).size() == static_cast<std::size_t>(D) + 1) inner.push_back(c);
  if (inner.empty()) return std::nullopt;
  std::vector<int> label(ground.cells.size(), kUnlabelled);
  label[rng.pick(inner)] = 0;
  std::size_t size = 1;
  const std::size_t limit = 1 + rng.below(inner.size());
  for (int tries = 0; tries < 30 && size < limit; ++tries) {
    const std::size_t cell = rng.pick(inner);
    const auto around = ground.neighbours(cell);
    if (label[cell] == kUnlabelled &&
        std::any_of(around.begin(), around.end(), [&](std::size_t n) { return label[n] == 0; })) {
      label[cell] = 0;
      ++size;
    }
  }
  const Facets facets = ground.between(label);
  if (facets.empty()) return std::nullopt;
  return facets;
}

Facets sample(const Facets& from, double density, Rng& rng) {
  Facets result;
  for (const HalfFacetId h : from)
    if (rng.chance(density)) result.push_back(h);
  return result;
}

/// All interior facets but one to four, where there are more than one.
template <int D>
std::optional<Facets> nearly_all(const Ground<D>& ground, Rng& rng) {
  const std::size_t n = ground.interior.size();
  if (n < 2) return std::nullopt;
  Facets facets = ground.interior;
  rng.shuffle(facets);
  facets.resize(n - 1 - rng.below(std::min<std::size_t>(n - 1, 4)));
  return facets;
}

template <int D>
std::optional<Facets> facets_of_class(const Ground<D>& ground, CutClass cut_class, Rng& rng) {
  switch (cut_class) {
    case CutClass::single:
      return Facets{rng.pick(ground.interior)};
    case CutClass::isolated:
      return isolated<D>(ground, rng);
    case CutClass::sheet:
      return sheet<D>(ground, rng);
    case CutClass::rim:
      return rim<D>(ground, rng);
    case CutClass::tee:
      return junction<D>(ground, 3, false, rng);
    case CutClass::cross:
      return junction<D>(ground, 4, false, rng);
    case CutClass::star:
      return junction<D>(ground, 5, true, rng);
    case CutClass::book:
      return book<D>(ground, rng);
    case CutClass::shell:
      return shell<D>(ground, rng);
    case CutClass::everything:
      return ground.interior;
    case CutClass::nearly:
      return nearly_all<D>(ground, rng);
    case CutClass::random:
      return sample(ground.interior, 0.02 + 0.9 * rng.unit(), rng);
  }
  return std::nullopt;
}

}  // namespace

std::string_view name(CutClass cut_class) {
  constexpr std::array<std::string_view, kCutClasses.size()> kNames{
      "single", "isolated", "sheet", "rim",        "tee",    "cross",
      "star",   "book",     "shell", "everything", "nearly", "random"};
  return kNames[static_cast<std::size_t>(cut_class)];
}

bool can_occur(CutClass cut_class, int dimension) {
  const bool has_ridge = cut_class == CutClass::isolated || cut_class == CutClass::rim ||
                         cut_class == CutClass::tee || cut_class == CutClass::cross ||
                         cut_class == CutClass::star || cut_class == CutClass::book;
  return dimension >= 2 || !has_ridge;
}

template <int D>
std::optional<std::vector<HalfFacetId>> random_cut(const Mesh<D>& mesh, CutClass cut_class,
                                                   Rng& rng) {
  if (!can_occur(cut_class, D)) return std::nullopt;
  const Ground<D> ground(mesh);
  if (ground.interior.empty()) return std::nullopt;
  auto facets = facets_of_class<D>(ground, cut_class, rng);
  if (!facets) return std::nullopt;
  const Facets twice = sample(*facets, 0.1, rng);
  facets->insert(facets->end(), twice.begin(), twice.end());
  for (HalfFacetId& h : *facets)
    if (rng.chance(0.5)) h = *ground.mates[h.value];
  rng.shuffle(*facets);
  return facets;
}

#define CLEAVE_INSTANTIATE(D) \
  template std::optional<std::vector<HalfFacetId>> random_cut<D>(const Mesh<D>&, CutClass, Rng&);
CLEAVE_FOR_EACH_DIMENSION(CLEAVE_INSTANTIATE)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::support
