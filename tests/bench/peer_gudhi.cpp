#include <gudhi/Simplex_tree.h>

#include <numeric>
#include <stdexcept>

#include "peers.hpp"

/// GUDHI's Simplex_tree without filtration and keys: a tree of the vertices of all simplices,
/// ascending. It has no neighbours; they are found as cofaces of facets, for which this version
/// searches all of the tree, so that visiting them is quadratic.
namespace cleave::bench {
namespace {

struct Options {
  using Indexing_tag = Gudhi::linear_indexing_tag;
  using Vertex_handle = int;
  using Filtration_value = double;
  using Simplex_key = std::uint32_t;
  static const bool store_key = false;
  static const bool store_filtration = false;
  static const bool contiguous_vertices = true;
};

template <int D>
class GudhiMesh : public PeerMesh {
 public:
  explicit GudhiMesh(const topology::CellSoup<D>& soup) {
    std::vector<int> vertices(soup.vertex_count);
    std::iota(vertices.begin(), vertices.end(), 0);
    tree_.insert_batch_vertices(vertices);
    std::array<int, D + 1> tuple;
    for (const auto& cell : soup.cells) {
      for (std::size_t i = 0; i < cell.size(); ++i) tuple[i] = static_cast<int>(cell[i].value);
      tree_.insert_simplex_and_subfaces(tuple);
    }
  }

  std::uint64_t visit_neighbours() override {
    std::uint64_t steps = 0;
    for (const auto simplex : tree_.complex_simplex_range()) {
      if (tree_.dimension(simplex) != D) continue;
      for (const auto facet : tree_.boundary_simplex_range(simplex))
        steps += tree_.cofaces_simplex_range(facet, 1).size() - 1;
    }
    return steps;
  }

  std::uint64_t visit_stars() override {
    std::uint64_t visits = 0;
    for (const int v : tree_.complex_vertex_range())
      for (const auto simplex : tree_.star_simplex_range(tree_.find({v})))
        visits += tree_.dimension(simplex) == D ? 1 : 0;
    return visits;
  }

 private:
  Gudhi::Simplex_tree<Options> tree_;
};

template <int D>
Assembler<D> gudhi() {
  return {"GUDHI_Simplex_tree",
          [](const topology::CellSoup<D>& soup) -> std::unique_ptr<PeerMesh> {
            return std::make_unique<GudhiMesh<D>>(soup);
          },
          1'000'000, 1'000};
}

const Registration kTetrahedra(gudhi<3>());
const Registration kTriangles(gudhi<2>());

}  // namespace
}  // namespace cleave::bench
