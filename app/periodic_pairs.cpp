#include "periodic_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

#include "edge_nodes.hpp"
#include "element_images.hpp"
#include "error.hpp"
#include "file_words.hpp"
#include "star_cut.hpp"

namespace cleave::app {

using topology::CellId;
using topology::HalfFacetId;

namespace {

// Two places of the output that a periodicity identifies.
struct Link {
  Index vertex, master;
  friend bool operator<(const Link& a, const Link& b) {
    return std::pair(a.vertex, a.master) < std::pair(b.vertex, b.master);
  }
  friend bool operator==(const Link& a, const Link& b) {
    return a.vertex == b.vertex && a.master == b.master;
  }
};

// Two boundary facets that a periodicity identifies: of the entity, and of its master.
struct FacetPair {
  HalfFacetId facet, master;
};

template <int D>
using Tuple = std::array<Index, static_cast<std::size_t>(D)>;

// The places of a facet's vertices in the file, and the places they have now in its cell.
template <int D>
struct FacetPlaces {
  Tuple<D> file, now;
};

template <int D>
class PairCarrier {
 public:
  PairCarrier(const Body<D>& body, const topology::FacetSet& scored, CutOutput& output)
      : body_(body),
        mesh_(*body.mesh),
        scored_(scored),
        output_(output),
        component_(output.origin.size()) {
    for (Index h = 0; h < body.complex.half_facet_count(); ++h)
      if (!body.complex.is_interior({h})) boundary_.push_back({h});
    for (Index place = 0; place < output.origin.size(); ++place)
      by_origin_.emplace_back(output.origin[place], place);
    std::sort(by_origin_.begin(), by_origin_.end());
    std::iota(component_.begin(), component_.end(), 0u);
  }

  void run() {
    std::vector<std::vector<Link>> links;
    for (const Periodicity& p : mesh_.periodic) {
      links.push_back(p.dimension == D - 1 ? links_of(p) : std::vector<Link>{});
      for (const Link& link : links.back()) join(link.vertex, link.master);
    }
    for (std::size_t i = 0; i < mesh_.periodic.size(); ++i)
      output_.mesh.periodic.push_back(after(mesh_.periodic[i], links[i]));
    warn_of_unpaired();
  }

 private:
  FacetPlaces<D> places(HalfFacetId h) const {
    const CellId cell = topology::cell_of<D>(h);
    const std::size_t first = static_cast<std::size_t>(D + 1) * cell.value;
    FacetPlaces<D> facet{};
    for (std::size_t i = 0, to = 0; i <= static_cast<std::size_t>(D); ++i) {
      if (static_cast<int>(i) == topology::local_index<D>(h)) continue;
      facet.file[to] = mesh_.cells().vertices[first + i];
      facet.now[to++] = output_.mesh.cells().vertices[first + i];
    }
    return facet;
  }

  // The node that `cell` has now on the edge between two file places.
  Index node(CellId cell, Index a, Index b) const {
    const Index* tuple = &mesh_.cells().vertices[static_cast<std::size_t>(D + 1) * cell.value];
    const auto i = static_cast<std::size_t>(std::find(tuple, tuple + D, a) - tuple);
    const auto j = static_cast<std::size_t>(std::find(tuple, tuple + D, b) - tuple);
    return output_.mesh.cells()
        .midside[edges_of_simplex(D) * cell.value + edge_index(D, std::min(i, j), std::max(i, j))];
  }

  // The copies of a point of the file, ascending.
  std::vector<Index> copies(Index origin) const {
    std::vector<Index> all;
    for (auto at =
             std::lower_bound(by_origin_.begin(), by_origin_.end(), std::pair{origin, Index{0}});
         at != by_origin_.end() && at->first == origin; ++at)
      all.push_back(at->second);
    return all;
  }

  // Facets of the boundary that `p` identifies. `master_of` is per point of the file.
  std::vector<FacetPair> facet_pairs(const Periodicity& p, std::vector<Index>& master_of) const {
    std::vector<bool> is_master(mesh_.points.size());
    master_of.assign(mesh_.points.size(), kNoPlace);
    for (const auto& pair : p.pairs) {
      master_of[pair.vertex] = pair.master;
      is_master[pair.master] = true;
    }
    std::vector<std::pair<Tuple<D>, HalfFacetId>> slaves, masters;
    for (const HalfFacetId h : boundary_) {
      Tuple<D> own = places(h).file, image{};
      std::transform(own.begin(), own.end(), image.begin(), [&](Index v) { return master_of[v]; });
      const auto mastering = [&](Index v) { return is_master[v]; };
      if (std::all_of(own.begin(), own.end(), mastering)) {
        std::sort(own.begin(), own.end());
        masters.emplace_back(own, h);
      }
      if (std::find(image.begin(), image.end(), kNoPlace) == image.end()) {
        std::sort(image.begin(), image.end());
        slaves.emplace_back(image, h);
      }
    }
    std::sort(masters.begin(), masters.end());
    std::vector<FacetPair> pairs;
    for (const auto& [key, h] : slaves) {
      const auto at =
          std::lower_bound(masters.begin(), masters.end(), std::pair{key, HalfFacetId{}});
      if (at != masters.end() && at->first == key) pairs.push_back({h, at->second});
    }
    return pairs;
  }

  // What `p`, between entities of dimension D-1, identifies now. Throws InputError if that is not
  // one to one.
  std::vector<Link> links_of(const Periodicity& p) const {
    std::vector<Index> master_of;
    const auto pairs = facet_pairs(p, master_of);
    std::vector<Link> links;
    for (const FacetPair& pair : pairs) {
      const auto one = places(pair.facet), other = places(pair.master);
      for (std::size_t i = 0; i < one.file.size(); ++i) {
        const Index master = master_of[one.file[i]];
        const auto q = std::find(other.file.begin(), other.file.end(), master);
        links.push_back({one.now[i], other.now[static_cast<std::size_t>(q - other.file.begin())]});
        if (!mesh_.cells().second_order()) continue;
        for (std::size_t j = i + 1; j < one.file.size(); ++j)
          links.push_back(
              {node(topology::cell_of<D>(pair.facet), one.file[i], one.file[j]),
               node(topology::cell_of<D>(pair.master), master, master_of[one.file[j]])});
      }
    }
    std::sort(links.begin(), links.end());
    links.erase(std::unique(links.begin(), links.end()), links.end());
    require_one_to_one(p, links, pairs);
    return links;
  }

  void require_one_to_one(const Periodicity& p, const std::vector<Link>& links,
                          const std::vector<FacetPair>& pairs) const {
    std::vector<Link> inverse;
    for (const Link& link : links) inverse.push_back({link.master, link.vertex});
    std::sort(inverse.begin(), inverse.end());
    for (std::size_t i = 1; i < links.size(); ++i) {
      if (links[i - 1].vertex == links[i].vertex)
        refuse(p, {links[i - 1].master, links[i].master}, links[i].vertex, pairs, true);
      if (inverse[i - 1].vertex == inverse[i].vertex)
        refuse(p, {inverse[i - 1].master, inverse[i].master}, inverse[i].vertex, pairs, false);
    }
  }

  // `apart` are two copies of one point, both identified with the point `joined` of the other side;
  // `masters_apart`: the side that came apart is the master's.
  [[noreturn]] void refuse(const Periodicity& p, std::array<Index, 2> apart, Index joined,
                           const std::vector<FacetPair>& pairs, bool masters_apart) const {
    static constexpr std::array<const char*, 3> kEntity{"point", "curve", "surface"};
    const Index partner = output_.origin[joined];
    const auto facets = facets_to_cut(apart, partner, pairs, masters_apart);
    std::string advice = "cut both sides alike, or leave the facets at this vertex out";
    if (!facets.empty()) {
      advice = fmt::format("cut the {} ", facets.size() == 1 ? "facet" : "facets");
      for (std::size_t i = 0; i < facets.size(); ++i)
        advice +=
            fmt::format("{}({})", i == 0 ? "" : ", ", listed(facet_vertices(mesh_, facets[i])));
      advice += fmt::format(" as well, so that vertex {} splits where its partner does",
                            mesh_.vertex_numbers[partner]);
    }
    throw InputError(fmt::format(
        "{}: the cut splits vertex {} and leaves vertex {} joined, although {} {} and its master "
        "{} are periodic and make the two a pair; {}",
        mesh_.source, mesh_.vertex_numbers[output_.origin[apart[0]]], mesh_.vertex_numbers[partner],
        kEntity[static_cast<std::size_t>(p.dimension)], p.entity, p.master, advice));
  }

  // The fewest facets around `partner`, a place in the file, that separate the facets there whose
  // counterparts came apart. Empty if `partner` is a node of second order or its facets touch.
  std::vector<HalfFacetId> facets_to_cut(std::array<Index, 2> apart, Index partner,
                                         const std::vector<FacetPair>& pairs,
                                         bool masters_apart) const {
    std::array<std::vector<CellId>, 2> around;
    std::optional<topology::VertexId> vertex;
    for (const FacetPair& pair : pairs) {
      const HalfFacetId here = masters_apart ? pair.master : pair.facet;
      const HalfFacetId there = masters_apart ? pair.facet : pair.master;
      const auto now = places(here).now;
      const auto file = places(there).file;
      const auto at =
          static_cast<std::size_t>(std::find(file.begin(), file.end(), partner) - file.begin());
      if (at == file.size()) continue;
      vertex = body_.complex.facet(there)[at];
      for (std::size_t side = 0; side < 2; ++side)
        if (std::find(now.begin(), now.end(), apart[side]) != now.end())
          around[side].push_back(topology::cell_of<D>(there));
    }
    if (!vertex) return {};
    return star_cut(body_.complex, scored_, *vertex, around[0], around[1]);
  }

  Index root(Index place) {
    while (component_[place] != place) place = component_[place] = component_[component_[place]];
    return place;
  }
  void join(Index a, Index b) { component_[root(a)] = root(b); }

  // The pairs of `p` as they are now; `links` are those that its own facets identify.
  Periodicity after(const Periodicity& p, const std::vector<Link>& links) {
    Periodicity now{p.dimension, p.entity, p.master, p.affine, {}};
    for (const auto& pair : p.pairs) {
      const auto ones = copies(pair.vertex), others = copies(pair.master);
      if (ones.empty() || others.empty()) continue;  // dropped with the vertex
      if (ones.size() == 1 && others.size() == 1) {
        now.pairs.push_back({ones.front(), others.front()});
        continue;
      }
      std::vector<Link> found;
      for (const Index one : ones)
        for (const Index other : others)
          if (std::binary_search(links.begin(), links.end(), Link{one, other}))
            found.push_back({one, other});
      if (found.empty()) found = by_way_of_others(p, pair, ones, others);
      for (const Link& link : found) now.pairs.push_back({link.vertex, link.master});
      split_.insert(split_.end(), ones.begin(), ones.end());
      split_.insert(split_.end(), others.begin(), others.end());
    }
    return now;
  }

  // Copies that facets of other periodicities identify, one after the other.
  std::vector<Link> by_way_of_others(const Periodicity& p, const Periodicity::Pair& pair,
                                     const std::vector<Index>& ones,
                                     const std::vector<Index>& others) {
    std::vector<Link> found;
    for (const Index one : ones)
      for (const Index other : others)
        if (root(one) == root(other)) found.push_back({one, other});
    bool one_to_one = !found.empty();
    for (const Link& a : found)
      for (const Link& b : found)
        if (!(a == b) && (a.vertex == b.vertex || a.master == b.master)) one_to_one = false;
    if (one_to_one) return found;
    throw InputError(fmt::format(
        "{}: the cut makes {} of vertex {} and {} of vertex {}, which entity {} of dimension {} "
        "and "
        "its master {} make a periodic pair, and {}; leave the facets at these vertices out, or "
        "remove the periodic condition from the file",
        mesh_.source, counted(ones.size(), "vertex", "vertices"), mesh_.vertex_numbers[pair.vertex],
        ones.size() == others.size() ? "as many" : counted(others.size(), "vertex", "vertices"),
        mesh_.vertex_numbers[pair.master], p.entity, p.dimension, p.master,
        found.empty() ? "no facets that are identified say which belong together"
                      : "they do not correspond one to one"));
  }

  void warn_of_unpaired() {
    std::vector<bool> paired(output_.origin.size());
    for (const Periodicity& p : output_.mesh.periodic)
      for (const auto& pair : p.pairs) paired[pair.vertex] = paired[pair.master] = true;
    std::sort(split_.begin(), split_.end());
    split_.erase(std::unique(split_.begin(), split_.end()), split_.end());
    split_.erase(
        std::remove_if(split_.begin(), split_.end(), [&](Index place) { return paired[place]; }),
        split_.end());
    if (split_.empty()) return;
    output_.warnings.push_back(fmt::format(
        "{} on no facet of the periodic boundary and in no periodic pair, such as {} of vertex {}",
        counted(split_.size(), "copy is", "copies are"),
        output_.mesh.vertex_numbers[split_.front()],
        mesh_.vertex_numbers[output_.origin[split_.front()]]));
  }

  const Body<D>& body_;
  const Mesh& mesh_;
  const topology::FacetSet& scored_;
  CutOutput& output_;
  std::vector<HalfFacetId> boundary_;               // of the file's cells
  std::vector<std::pair<Index, Index>> by_origin_;  // origin, place in the output
  std::vector<Index> component_;                    // union-find over the output's points
  std::vector<Index> split_;  // the copies of points of pairs that have several
};

}  // namespace

template <int D>
void carry_periodic(const Body<D>& body, const topology::Incision<D>& incision, CutOutput& output) {
  if (body.mesh->periodic.empty()) return;
  const topology::FacetSet scored = incision.scored();
  PairCarrier<D>(body, scored, output).run();
}

template void carry_periodic<1>(const Body<1>&, const topology::Incision<1>&, CutOutput&);
template void carry_periodic<2>(const Body<2>&, const topology::Incision<2>&, CutOutput&);
template void carry_periodic<3>(const Body<3>&, const topology::Incision<3>&, CutOutput&);

}  // namespace cleave::app
