#include "cleave/topology/vertex_index.hpp"

#include "dimensions.hpp"

namespace cleave::topology {

/// A counting sort. The places of vertex v are counted at v + 2, so that its next free place can be
/// kept at v + 1, and when all are filled every entry has become what it is called.
template <int D>
VertexIndex<D>::VertexIndex(const Complex<D>& k)
    : first_(k.vertex_count() + 2, 0), corners_(k.half_facet_count()) {
  for (const Cell<D>& cell : k.cells())
    for (const VertexId v : cell) ++first_[v.value + 2];
  for (std::size_t v = 2; v < first_.size(); ++v) first_[v] += first_[v - 1];
  Index corner = 0;
  for (const Cell<D>& cell : k.cells())
    for (const VertexId v : cell) corners_[first_[v.value + 1]++] = CornerId{corner++};
}

#define CLEAVE_INSTANTIATE(D) template class VertexIndex<D>;
CLEAVE_FOR_EACH_DIMENSION(CLEAVE_INSTANTIATE)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::topology
