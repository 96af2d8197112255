#include "cleave/topology/vertex_graph.hpp"

#include <stdexcept>
#include <string>

#include "cleave/topology/simplices.hpp"

namespace cleave::topology {

template <int D>
VertexGraph::VertexGraph(const Complex<D>& k) {
  const Simplices<D> edges(k, 1);
  if (edges.count() > kNoIndex / 2)
    throw std::length_error("too many 1-simplices for a vertex graph with " +
                            std::to_string(kIdBits) + "-bit numbers");
  offsets_.assign(k.vertex_count() + 1, 0);
  for (std::size_t e = 0; e < edges.count(); ++e)
    for (const VertexId end : edges[e]) ++offsets_[end.value + 1];
  for (std::size_t v = 0; v < k.vertex_count(); ++v) offsets_[v + 1] += offsets_[v];

  // Edges come in lexicographic order, so every vertex first meets its lesser neighbours,
  // ascending, then, once it is the lesser end itself, the greater ones.
  std::vector<Index> next(offsets_.begin(), offsets_.end() - 1);
  neighbours_.resize(2 * edges.count());
  for (std::size_t e = 0; e < edges.count(); ++e) {
    const VertexId lesser = edges[e][0], greater = edges[e][1];
    neighbours_[next[lesser.value]++] = greater;
    neighbours_[next[greater.value]++] = lesser;
  }
}

template VertexGraph::VertexGraph(const Complex<1>&);
template VertexGraph::VertexGraph(const Complex<2>&);
template VertexGraph::VertexGraph(const Complex<3>&);
template VertexGraph::VertexGraph(const Complex<4>&);

}  // namespace cleave::topology
