#include "node_images.hpp"

#include <algorithm>
#include <unordered_set>

#include "edge_nodes.hpp"

namespace cleave::app {

using topology::CellId;

namespace {

// An edge by its ends in ascending order.
using Edge = std::pair<Index, Index>;
Edge edge_of(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

// An edge of the output that an image of an edge of the file has become.
struct EdgeImage {
  Index node;  // place in the file
  Edge edge;
};

// The distinct images of the edges that have a vertex with several copies: those in cells, by
// ascending cell, then those that only elements below the cells have.
template <int D>
class EdgeImages {
 public:
  EdgeImages(const Renaming<D>& renaming, const std::array<Images, 3>& images)
      : copies_(count_copies(renaming)) {
    const Mesh& mesh = *renaming.body->mesh;
    constexpr auto kCorners = static_cast<std::size_t>(D) + 1;
    for (Index c = 0; c < mesh.cells().size(); ++c) {
      std::array<Index, kCorners> now{};
      for (std::size_t i = 0; i < kCorners; ++i)
        now[i] = renaming.place_of[renaming.after->vertices({c})[i].value];
      add(mesh.cells(), c, kCorners, now.data());
    }
    for (std::size_t k = 1; k < static_cast<std::size_t>(D); ++k) {
      const Elements& elements = mesh.elements[k];
      for (Index e = 0; e < elements.size(); ++e)
        for (Index i = images[k].first[e]; i < images[k].first[e + 1]; ++i)
          add(elements, e, k + 1, &images[k].vertices[(k + 1) * i]);
    }
    // Of one node the cells' images stay first, in their order.
    std::stable_sort(found.begin(), found.end(),
                     [](const EdgeImage& a, const EdgeImage& b) { return a.node < b.node; });
  }

  std::vector<EdgeImage> found;

 private:
  void add(const Elements& elements, Index e, std::size_t corners, const Index* now) {
    const Index* was = &elements.vertices[corners * e];
    if (std::none_of(was, was + corners, [&](Index v) { return copies_[v] > 1; })) return;
    const Index* node = &elements.midside[edges_of_simplex(corners - 1) * e];
    for (std::size_t i = 0; i < corners; ++i)
      for (std::size_t j = i + 1; j < corners; ++j, ++node) {
        if (copies_[was[i]] <= 1 && copies_[was[j]] <= 1) continue;
        const Edge edge = edge_of(now[i], now[j]);
        if (seen_.insert(edge).second) found.push_back({*node, edge});
      }
  }

  std::vector<Index> copies_;
  std::unordered_set<Edge, boost::hash<Edge>> seen_;
};

}  // namespace

template <int D>
NodeImages<D>::NodeImages(const Renaming<D>& renaming, const std::array<Images, 3>& images,
                          std::vector<Index> place_of_node, Index first_copy)
    : renaming_(&renaming), first_copy_(first_copy) {
  if (!renaming.body->mesh->cells().second_order()) return;
  place_of_node_ = std::move(place_of_node);
  const auto found = EdgeImages<D>(renaming, images).found;
  for (std::size_t i = 0; i < found.size(); ++i) {
    Index& place = node_on_[found[i].edge];
    if (i == 0 || found[i - 1].node != found[i].node) {
      place = place_of_node_[found[i].node];
      continue;
    }
    place = first_copy_ + static_cast<Index>(parents_.size());
    parents_.push_back(found[i].node);
  }
}

template <int D>
Index NodeImages<D>::on_edge(Index node, Index a, Index b) const {
  const auto touched = node_on_.find(edge_of(a, b));
  return touched != node_on_.end() ? touched->second : place_of_node_[node];
}

template <int D>
std::vector<Index> NodeImages<D>::of_element(std::span<const Index> nodes,
                                             std::span<const Index> vertices) const {
  std::vector<Index> now;
  if (!second_order()) return now;
  const Index* node = nodes.data();
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (std::size_t j = i + 1; j < vertices.size(); ++j)
      now.push_back(on_edge(*node++, vertices[i], vertices[j]));
  return now;
}

template <int D>
Index NodeImages<D>::in_cell(CellId cell, Index a, Index b) const {
  const Elements& cells = renaming_->body->mesh->cells();
  const Index* tuple = &cells.vertices[static_cast<std::size_t>(D + 1) * cell.value];
  auto i = static_cast<std::size_t>(std::find(tuple, tuple + D, a) - tuple);
  auto j = static_cast<std::size_t>(std::find(tuple, tuple + D, b) - tuple);
  if (j < i) std::swap(i, j);
  const std::size_t place = edges_of_simplex(D) * cell.value + edge_index(D, i, j);
  return on_edge(cells.midside[place], renaming_->in_cell(cell, a), renaming_->in_cell(cell, b));
}

template <int D>
std::vector<Index> NodeImages<D>::places(Index node) const {
  if (!second_order() || place_of_node_[node] == kNoPlace) return {};
  std::vector<Index> all{place_of_node_[node]};
  const auto [first, last] = std::equal_range(parents_.begin(), parents_.end(), node);
  for (auto copy = first; copy != last; ++copy)
    all.push_back(first_copy_ + static_cast<Index>(copy - parents_.begin()));
  return all;
}

std::vector<bool> nodes_in_use(const Mesh& mesh, const std::vector<bool>& in_use) {
  std::vector<bool> node(mesh.points.size());
  for (std::size_t k = 1; k < mesh.elements.size(); ++k) {
    const Elements& elements = mesh.elements[k];
    if (!elements.second_order()) continue;
    const std::size_t edges = edges_of_simplex(k);
    for (std::size_t e = 0; e < elements.size(); ++e) {
      const Index* v = &elements.vertices[(k + 1) * e];
      if (!std::all_of(v, v + k + 1, [&](Index place) { return in_use[place]; })) continue;
      for (std::size_t i = 0; i < edges; ++i) node[elements.midside[edges * e + i]] = true;
    }
  }
  return node;
}

template class NodeImages<1>;
template class NodeImages<2>;
template class NodeImages<3>;

}  // namespace cleave::app
