#include "cleave/support/reference.hpp"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/connected_components.hpp>
#include <utility>

#include "cleave/support/dimensions.hpp"

namespace cleave::support {
namespace {

using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;
using CellPair = std::pair<std::size_t, std::size_t>;

std::vector<std::size_t> components_of(const Graph& graph) {
  std::vector<std::size_t> component(boost::num_vertices(graph));
  boost::connected_components(graph, component.data());
  return component;
}

template <int D>
bool contains(const Cell<D>& cell, VertexId v) {
  return std::find(cell.begin(), cell.end(), v) != cell.end();
}

template <int D>
int count_common_vertices(const Cell<D>& a, const Cell<D>& b) {
  return static_cast<int>(
      std::count_if(a.begin(), a.end(), [&](VertexId v) { return contains<D>(b, v); }));
}

/// The facets of the cut as pairs of cells, which are the same facets whatever becomes of vertices.
template <int D>
std::set<CellPair> cell_pairs(std::span<const Cell<D>> cells, std::span<const HalfFacetId> cut) {
  std::set<CellPair> pairs;
  const auto facets = facets_of<D>(cells);
  for (const HalfFacetId h : cut) {
    const auto& sides = facets.at(sorted_facet<D>(cells, h));
    if (sides.size() == 2)
      pairs.emplace(topology::cell_of<D>(sides[0]).value, topology::cell_of<D>(sides[1]).value);
  }
  return pairs;
}

/// The facet-connected components of the cells in `star`, one number per cell in ascending order.
template <int D>
std::vector<std::size_t> divide(std::span<const Cell<D>> cells, const std::set<std::size_t>& star,
                                const std::set<CellPair>& cut) {
  const std::vector<std::size_t> members(star.begin(), star.end());
  Graph graph(members.size());
  for (std::size_t i = 0; i < members.size(); ++i)
    for (std::size_t j = i + 1; j < members.size(); ++j)
      if (count_common_vertices<D>(cells[members[i]], cells[members[j]]) == D &&
          cut.count({members[i], members[j]}) == 0)
        boost::add_edge(i, j, graph);
  return components_of(graph);
}

}  // namespace

int parity(std::span<const VertexId> tuple) {
  int sign = 1;
  for (std::size_t i = 0; i < tuple.size(); ++i)
    for (std::size_t j = i + 1; j < tuple.size(); ++j)
      if (tuple[j] < tuple[i]) sign = -sign;
  return sign;
}

template <int D>
static Facet<D> facet_tuple(std::span<const Cell<D>> cells, HalfFacetId h) {
  const Cell<D>& cell = cells[topology::cell_of<D>(h).value];
  Facet<D> facet{};
  for (std::size_t from = 0, to = 0; from < cell.size(); ++from)
    if (static_cast<int>(from) != topology::local_index<D>(h)) facet[to++] = cell[from];
  return facet;
}

template <int D>
Facet<D> sorted_facet(std::span<const Cell<D>> cells, HalfFacetId h) {
  Facet<D> facet = facet_tuple<D>(cells, h);
  std::sort(facet.begin(), facet.end());
  return facet;
}

template <int D>
std::map<Facet<D>, std::vector<HalfFacetId>> facets_of(std::span<const Cell<D>> cells) {
  std::map<Facet<D>, std::vector<HalfFacetId>> facets;
  for (topology::Index h = 0; h < cells.size() * (static_cast<std::size_t>(D) + 1); ++h)
    facets[sorted_facet<D>(cells, {h})].push_back({h});
  return facets;
}

template <int D>
bool is_pseudo_manifold(std::span<const Cell<D>> cells) {
  const auto facets = facets_of<D>(cells);
  return std::all_of(facets.begin(), facets.end(),
                     [](const auto& facet) { return facet.second.size() <= 2; });
}

template <int D>
std::vector<std::optional<HalfFacetId>> mates_of(std::span<const Cell<D>> cells) {
  std::vector<std::optional<HalfFacetId>> mates(cells.size() * (static_cast<std::size_t>(D) + 1));
  for (const auto& [facet, sides] : facets_of<D>(cells))
    if (sides.size() == 2) {
      mates[sides[0].value] = sides[1];
      mates[sides[1].value] = sides[0];
    }
  return mates;
}

template <int D>
std::vector<HalfFacetId> interior_facets(std::span<const Cell<D>> cells) {
  std::vector<HalfFacetId> result;
  for (const auto& [facet, sides] : facets_of<D>(cells))
    if (sides.size() == 2) result.push_back(sides[0]);
  std::sort(result.begin(), result.end());
  return result;
}

template <int D>
std::map<VertexId, std::set<std::size_t>> stars_of(std::span<const Cell<D>> cells) {
  std::map<VertexId, std::set<std::size_t>> stars;
  for (std::size_t t = 0; t < cells.size(); ++t)
    for (const VertexId v : cells[t]) stars[v].insert(t);
  return stars;
}

template <int D>
std::map<VertexId, std::size_t> parts_of_stars(std::span<const Cell<D>> cells,
                                               std::span<const HalfFacetId> cut) {
  const auto pairs = cell_pairs<D>(cells, cut);
  std::map<VertexId, std::size_t> parts;
  for (const auto& [vertex, star] : stars_of<D>(cells)) {
    const auto component = divide<D>(cells, star, pairs);
    parts[vertex] = *std::max_element(component.begin(), component.end()) + 1;
  }
  return parts;
}

template <int D>
std::vector<Cell<D>> algorithm_3(std::span<const Cell<D>> cells, std::span<const HalfFacetId> cut,
                                 std::span<const VertexId> order) {
  std::vector<Cell<D>> mesh(cells.begin(), cells.end());
  const std::set<CellPair> surface = cell_pairs<D>(cells, cut);
  topology::Index fresh = 0;
  for (const Cell<D>& cell : mesh)
    for (const VertexId v : cell) fresh = std::max(fresh, v.value + 1);
  std::map<VertexId, std::set<VertexId>> copies;
  for (const VertexId original : order) {
    if (copies[original].empty()) copies[original] = {original};
    for (const VertexId node : std::set<VertexId>(copies[original])) {
      std::set<std::size_t> incident;
      for (std::size_t t = 0; t < mesh.size(); ++t)
        if (contains<D>(mesh[t], node)) incident.insert(t);
      const auto component = divide<D>(std::span<const Cell<D>>(mesh), incident, surface);
      std::map<std::size_t, VertexId> copy_for;
      std::size_t i = 0;
      for (const std::size_t t : incident) {
        const auto [copy, is_new] = copy_for.try_emplace(component[i++], VertexId{fresh});
        if (is_new) ++fresh;
        std::replace(mesh[t].begin(), mesh[t].end(), node, copy->second);
        copies[original].insert(copy->second);
      }
      if (!incident.empty()) copies[original].erase(node);
    }
  }
  return mesh;
}

template <int D>
std::vector<Cell<D>> algorithm_3(std::span<const Cell<D>> cells, std::span<const HalfFacetId> cut) {
  std::vector<VertexId> order;
  for (const auto& [vertex, star] : stars_of<D>(cells)) order.push_back(vertex);
  return algorithm_3<D>(cells, cut, order);
}

template <int D>
int induced_sign(std::span<const Cell<D>> cells, std::span<const std::int8_t> signs,
                 HalfFacetId h) {
  const int position = topology::local_index<D>(h) % 2 == 0 ? 1 : -1;
  return signs[topology::cell_of<D>(h).value] * position * parity(facet_tuple<D>(cells, h));
}

template <int D>
bool is_coherent(std::span<const Cell<D>> cells, std::span<const std::int8_t> signs) {
  for (const auto& [facet, sides] : facets_of<D>(cells))
    if (sides.size() == 2 &&
        induced_sign<D>(cells, signs, sides[0]) == induced_sign<D>(cells, signs, sides[1]))
      return false;
  return true;
}

template <int D>
std::optional<std::vector<std::int8_t>> coherent_signs(std::span<const Cell<D>> cells) {
  const auto mates = mates_of<D>(cells);
  std::vector<std::int8_t> as_written(cells.size(), 1);
  std::vector<std::int8_t> signs(cells.size(), 0);
  for (std::size_t first = 0; first < cells.size(); ++first) {
    if (signs[first] != 0) continue;
    signs[first] = 1;
    std::vector<std::size_t> todo{first};
    while (!todo.empty()) {
      const std::size_t t = todo.back();
      todo.pop_back();
      for (int i = 0; i <= D; ++i) {
        const auto h = topology::half_facet<D>({static_cast<topology::Index>(t)}, i);
        if (!mates[h.value]) continue;
        const std::size_t u = topology::cell_of<D>(*mates[h.value]).value;
        if (signs[u] != 0) continue;
        const bool same = induced_sign<D>(cells, as_written, h) ==
                          induced_sign<D>(cells, as_written, *mates[h.value]);
        signs[u] = static_cast<std::int8_t>(same ? -signs[t] : signs[t]);
        todo.push_back(u);
      }
    }
  }
  if (!is_coherent<D>(cells, signs)) return std::nullopt;
  return signs;
}

template <int D>
std::set<std::size_t> flood(std::span<const Cell<D>> cells, std::span<const std::int8_t> signs,
                            VertexId node, std::size_t start) {
  // The lookup table of the paper: oriented triangle (ascending vertices and a sign) -> its cell.
  std::map<std::pair<Facet<D>, int>, std::size_t> backlink;
  for (const auto& [facet, sides] : facets_of<D>(cells))
    for (const HalfFacetId h : sides)
      backlink[{facet, induced_sign<D>(cells, signs, h)}] = topology::cell_of<D>(h).value;
  std::set<std::size_t> reached{start};
  std::vector<std::size_t> todo{start};
  while (!todo.empty()) {
    const auto t = static_cast<topology::Index>(todo.back());
    todo.pop_back();
    for (int j = 0; j <= D; ++j) {
      const auto s_j = topology::half_facet<D>({t}, j);
      const auto u =
          backlink.find({sorted_facet<D>(cells, s_j), -induced_sign<D>(cells, signs, s_j)});
      if (u == backlink.end() || !contains<D>(cells[u->second], node)) continue;
      if (reached.insert(u->second).second) todo.push_back(u->second);
    }
  }
  return reached;
}

template <int D>
std::vector<std::size_t> components(std::span<const Cell<D>> cells,
                                    std::span<const HalfFacetId> cut) {
  const auto pairs = cell_pairs<D>(cells, cut);
  Graph graph(cells.size());
  for (const auto& [facet, sides] : facets_of<D>(cells))
    if (sides.size() == 2) {
      const std::size_t t = topology::cell_of<D>(sides[0]).value;
      const std::size_t u = topology::cell_of<D>(sides[1]).value;
      if (pairs.count({t, u}) == 0) boost::add_edge(t, u, graph);
    }
  return components_of(graph);
}

template <int D>
bool refines(std::span<const Cell<D>> fine, std::span<const Cell<D>> coarse) {
  if (fine.size() != coarse.size()) return false;
  std::map<VertexId, VertexId> image;
  for (std::size_t t = 0; t < fine.size(); ++t)
    for (std::size_t i = 0; i < fine[t].size(); ++i)
      if (image.try_emplace(fine[t][i], coarse[t][i]).first->second != coarse[t][i]) return false;
  return true;
}

template <int D>
bool same_partition(std::span<const Cell<D>> a, std::span<const Cell<D>> b) {
  return refines<D>(a, b) && refines<D>(b, a);
}

template <int D>
std::vector<HalfFacetId> opened_facets(std::span<const Cell<D>> before,
                                       std::span<const Cell<D>> after) {
  std::vector<HalfFacetId> opened;
  const auto now = mates_of<D>(after);
  for (const HalfFacetId h : interior_facets<D>(before))
    if (!now[h.value]) opened.push_back(h);
  return opened;
}

template <int D>
std::size_t used_vertices(std::span<const Cell<D>> cells) {
  return stars_of<D>(cells).size();
}

template <int D>
std::map<std::vector<VertexId>, std::size_t> ridge_degrees(std::span<const Cell<D>> cells,
                                                           std::span<const HalfFacetId> cut) {
  std::set<Facet<D>> facets;
  for (const HalfFacetId h : cut) facets.insert(sorted_facet<D>(cells, h));
  std::map<std::vector<VertexId>, std::size_t> degrees;
  if (D == 1) return degrees;  // a ridge would be the empty set
  for (const Facet<D>& facet : facets)
    for (std::size_t without = 0; without < facet.size(); ++without) {
      std::vector<VertexId> ridge(facet.begin(), facet.end());
      ridge.erase(ridge.begin() + static_cast<std::ptrdiff_t>(without));
      ++degrees[ridge];
    }
  return degrees;
}

#define CLEAVE_INSTANTIATE(D)                                                                     \
  template Facet<D> sorted_facet<D>(std::span<const Cell<D>>, HalfFacetId);                       \
  template std::map<Facet<D>, std::vector<HalfFacetId>> facets_of<D>(std::span<const Cell<D>>);   \
  template bool is_pseudo_manifold<D>(std::span<const Cell<D>>);                                  \
  template std::vector<std::optional<HalfFacetId>> mates_of<D>(std::span<const Cell<D>>);         \
  template std::vector<HalfFacetId> interior_facets<D>(std::span<const Cell<D>>);                 \
  template std::map<VertexId, std::set<std::size_t>> stars_of<D>(std::span<const Cell<D>>);       \
  template std::map<VertexId, std::size_t> parts_of_stars<D>(std::span<const Cell<D>>,            \
                                                             std::span<const HalfFacetId>);       \
  template std::vector<Cell<D>> algorithm_3<D>(                                                   \
      std::span<const Cell<D>>, std::span<const HalfFacetId>, std::span<const VertexId>);         \
  template std::vector<Cell<D>> algorithm_3<D>(std::span<const Cell<D>>,                          \
                                               std::span<const HalfFacetId>);                     \
  template int induced_sign<D>(std::span<const Cell<D>>, std::span<const std::int8_t>,            \
                               HalfFacetId);                                                      \
  template bool is_coherent<D>(std::span<const Cell<D>>, std::span<const std::int8_t>);           \
  template std::optional<std::vector<std::int8_t>> coherent_signs<D>(std::span<const Cell<D>>);   \
  template std::set<std::size_t> flood<D>(std::span<const Cell<D>>, std::span<const std::int8_t>, \
                                          VertexId, std::size_t);                                 \
  template std::vector<std::size_t> components<D>(std::span<const Cell<D>>,                       \
                                                  std::span<const HalfFacetId>);                  \
  template bool refines<D>(std::span<const Cell<D>>, std::span<const Cell<D>>);                   \
  template bool same_partition<D>(std::span<const Cell<D>>, std::span<const Cell<D>>);            \
  template std::vector<HalfFacetId> opened_facets<D>(std::span<const Cell<D>>,                    \
                                                     std::span<const Cell<D>>);                   \
  template std::size_t used_vertices<D>(std::span<const Cell<D>>);                                \
  template std::map<std::vector<VertexId>, std::size_t> ridge_degrees<D>(                         \
      std::span<const Cell<D>>, std::span<const HalfFacetId>);
CLEAVE_FOR_EACH_DIMENSION(CLEAVE_INSTANTIATE)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::support
