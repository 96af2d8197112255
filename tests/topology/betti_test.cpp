#include "cleave/topology/betti.hpp"

#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <optional>

#include "cleave/support/random_meshes.hpp"
#include "cleave/topology/summary.hpp"
#include "view_laws.hpp"

namespace cleave::views {
namespace {

template <int D>
using Betti = std::array<std::size_t, static_cast<std::size_t>(D) + 1>;

template <int D>
Betti<D> betti(const support::Mesh<D>& mesh) {
  return betti_numbers<D>({mesh.cells, mesh.vertex_count, {}}).value();
}

/// The rank of a matrix over Z/2 given by its rows, by Gaussian elimination on dense rows.
std::size_t dense_rank(std::vector<std::vector<bool>> rows) {
  std::size_t rank = 0;
  for (std::size_t column = 0; !rows.empty() && column < rows[0].size(); ++column) {
    std::size_t pivot = rank;
    while (pivot < rows.size() && !rows[pivot][column]) ++pivot;
    if (pivot == rows.size()) continue;
    std::swap(rows[rank], rows[pivot]);
    for (std::size_t r = rank + 1; r < rows.size(); ++r)
      if (rows[r][column])
        for (std::size_t c = column; c < rows[r].size(); ++c)
          rows[r][c] = rows[r][c] ^ rows[rank][c];
    ++rank;
  }
  return rank;
}

/// Betti numbers by their definition: simplices as sets, whole boundary matrices, dense ranks.
template <int D>
Betti<D> betti_by_definition(const std::vector<Cell<D>>& cells) {
  std::array<std::map<Vertices, std::size_t>, static_cast<std::size_t>(D) + 1> simplices;
  for (const Cell<D>& cell : cells)
    for (std::uint32_t subset = 1; subset < 1u << (D + 1); ++subset) {
      std::set<VertexId> simplex;
      for (std::size_t i = 0; i <= D; ++i)
        if ((subset >> i & 1u) != 0) simplex.insert(cell[i]);
      simplices[simplex.size() - 1].try_emplace(Vertices(simplex.begin(), simplex.end()), 0);
    }
  for (auto& level : simplices) {
    std::size_t next = 0;
    for (auto& entry : level) entry.second = next++;
  }
  std::array<std::size_t, static_cast<std::size_t>(D) + 2> rank{};
  for (std::size_t k = 1; k <= D; ++k) {
    std::vector<std::vector<bool>> rows;
    for (const auto& [simplex, place] : simplices[k]) {
      rows.emplace_back(simplices[k - 1].size(), false);
      for (std::size_t out = 0; out <= k; ++out) {
        Vertices face = simplex;
        face.erase(face.begin() + static_cast<std::ptrdiff_t>(out));
        rows.back()[simplices[k - 1].at(face)] = true;
      }
    }
    rank[k] = dense_rank(std::move(rows));
  }
  Betti<D> numbers{};
  for (std::size_t k = 0; k <= D; ++k) numbers[k] = simplices[k].size() - rank[k] - rank[k + 1];
  return numbers;
}

std::size_t choose(std::size_t n, std::size_t k) {
  std::size_t result = 1;
  for (std::size_t i = 0; i < k; ++i) result = result * (n - i) / (i + 1);
  return result;
}

template <class Dimension>
class BettiOf : public ::testing::Test {};
TYPED_TEST_SUITE(BettiOf, Dimensions);

TYPED_TEST(BettiOf, BallsSpheresAndTori) {
  constexpr int D = TypeParam::value;
  Betti<D> ball{1}, sphere{1}, torus{};
  sphere[D] = 1;
  for (std::size_t k = 0; k <= D; ++k) torus[k] = choose(D, k);
  EXPECT_EQ(betti<D>(kuhn_cube<D>(3)), ball);
  EXPECT_EQ(betti(support::simplex_boundary<D>()), sphere);
  EXPECT_EQ(betti(support::torus<D>(3)), torus);
  EXPECT_EQ(betti<D>({}), Betti<D>{});
}

TYPED_TEST(BettiOf, SphereBundleOverItself) {
  // The suspension of a sphere is a sphere; that of two spheres has a loop more.
  constexpr int D = TypeParam::value;
  if constexpr (D > 1) {
    const auto sphere = support::simplex_boundary<D - 1>();
    Betti<D> one{1}, two{1};
    one[D] = 1;
    EXPECT_EQ(betti(support::suspension<D>(sphere)), one);
    two[1] += 1;
    two[D] += 2;
    EXPECT_EQ(betti(support::suspension<D>(support::disjoint_union(sphere, sphere))), two);
  }
}

TYPED_TEST(BettiOf, RandomComplexesAreWhatDenseRanksSay) {
  constexpr int D = TypeParam::value;
  support::Rng rng(20001126);
  std::map<std::string, int> met;
  for (int round = 0; round < 30; ++round) {
    const auto mesh_class = support::kMeshClasses[static_cast<std::size_t>(round) % 6];
    auto mesh = support::random_mesh<D>(mesh_class, rng);
    if (mesh.cells.size() > 60) mesh.cells.resize(60);
    const Betti<D> found = betti(mesh);
    EXPECT_EQ(found, betti_by_definition<D>(mesh.cells)) << name(mesh_class) << ' ' << round;
    for (std::size_t k = 1; k <= D; ++k)
      if (found[k] > 0) ++met["b" + std::to_string(k)];
  }
  EXPECT_GE(met["b" + std::to_string(D == 1 ? 1 : D - 1)], 3);
}

TYPED_TEST(BettiOf, AnythingAFileMayHold) {
  // Few vertices, so that cells repeat, name vertices twice, and crowd around facets.
  constexpr int D = TypeParam::value;
  support::Rng rng(7);
  int crowded = 0, loops = 0;
  for (int round = 0; round < 60; ++round) {
    support::Mesh<D> mesh;
    mesh.vertex_count = static_cast<std::size_t>(D) + 2 + static_cast<std::size_t>(round) % 5;
    for (int c = 0; c < 4 + round % 20; ++c) {
      Cell<D> cell;
      for (VertexId& v : cell)
        v.value = static_cast<Index>(rng.below(static_cast<Index>(mesh.vertex_count)));
      mesh.cells.push_back(cell);
    }
    const Betti<D> found = betti(mesh);
    EXPECT_EQ(found, betti_by_definition<D>(mesh.cells)) << round;
    std::int64_t alternating = 0;
    for (std::size_t k = 0; k <= D; ++k)
      alternating += (k % 2 == 0 ? 1 : -1) * static_cast<std::int64_t>(found[k]);
    EXPECT_EQ(alternating, summarize<D>({mesh.cells, mesh.vertex_count, {}}).euler_characteristic);
    crowded += mesh.cells.size() > mesh.vertex_count ? 1 : 0;
    loops += found[1] > 0 ? 1 : 0;
  }
  EXPECT_GE(crowded, 30);
  EXPECT_GE(loops, D <= 2 ? 10 : 0);
}

/// An n x n torus of squares cut in two, the last column joined to the first upside down if
/// `flipped`.
support::Mesh<2> squares(Index n, bool flipped) {
  support::Mesh<2> mesh{{}, n * n};
  const auto at = [&](Index column, Index row) {
    row %= n;
    return VertexId{column < n ? column * n + row : flipped ? (n - row) % n : row};
  };
  for (Index c = 0; c < n; ++c)
    for (Index r = 0; r < n; ++r) {
      mesh.cells.push_back({at(c, r), at(c + 1, r), at(c + 1, r + 1)});
      mesh.cells.push_back({at(c, r), at(c, r + 1), at(c + 1, r + 1)});
    }
  return mesh;
}

TEST(Betti, OfSurfaces) {
  EXPECT_EQ(betti(support::band(6)), (Betti<2>{1, 1, 0}));
  EXPECT_EQ(betti(support::band(5)), (Betti<2>{1, 1, 0}));
  EXPECT_EQ(betti(support::projective_plane()), (Betti<2>{1, 1, 1}));  // over Z/2, not over Q
  EXPECT_EQ(betti(squares(5, false)), (Betti<2>{1, 2, 1}));
  EXPECT_EQ(betti(squares(5, true)), (Betti<2>{1, 2, 1}));  // Klein's bottle, over Z/2
}

TEST(Betti, OfTheSuspendedProjectivePlane) {
  EXPECT_EQ(betti(support::suspension<3>(support::projective_plane())), (Betti<3>{1, 0, 1, 1}));
}

TEST(Betti, OfSolidsWithATunnelAndWithACavity) {
  const support::KuhnGrid<3> flat({4, 4, 2}), grid({4, 4, 4});
  std::vector<bool> ring, shell;
  for (std::size_t c = 0; c < flat.cells.size(); ++c)
    ring.push_back(flat.cube(c) != std::array{1, 1, 0});
  for (std::size_t c = 0; c < grid.cells.size(); ++c)
    shell.push_back(grid.cube(c) != std::array{1, 1, 1});
  EXPECT_EQ(betti(support::sub_mesh<3>(flat, ring)), (Betti<3>{1, 1, 0, 0}));
  EXPECT_EQ(betti(support::sub_mesh<3>(grid, shell)), (Betti<3>{1, 0, 1, 0}));
}

TEST(Betti, OfSpheresThatTouchInAVertex) {
  auto mesh =
      support::disjoint_union(support::simplex_boundary<2>(), support::simplex_boundary<2>());
  EXPECT_EQ(betti(mesh), (Betti<2>{2, 0, 2}));
  for (Cell<2>& cell : mesh.cells)
    for (VertexId& v : cell)
      if (v.value == 4) v.value = 0;
  EXPECT_EQ(betti(mesh), (Betti<2>{1, 0, 2}));
}

/// A disc whose rim of nine edges is glued along 0 1 2 0, 0 1 2 0 and backwards 0 2 1 0: nothing of
/// it can be collapsed, and yet it has the homology of a point.
support::Mesh<2> dunce_hat() {
  const std::array<Index, 9> rim = {0, 1, 2, 0, 1, 2, 0, 2, 1};
  support::Mesh<2> mesh{{}, 13};
  for (Index i = 0; i < 9; ++i) {
    const Index j = (i + 1) % 9;
    const VertexId a{rim[i]}, b{rim[j]}, c{3 + i}, d{3 + j};
    mesh.cells.insert(mesh.cells.end(), {Cell<2>{a, b, c}, {b, c, d}, {c, d, VertexId{12}}});
  }
  return mesh;
}

TEST(Betti, OfTheDunceHatThatNothingCollapses) {
  EXPECT_EQ(betti(dunce_hat()), (Betti<2>{1, 0, 0}));
}

TEST(Betti, StopsAtItsLimits) {
  const support::Mesh<2> torus = squares(5, false);  // 25 vertices, 75 edges, 50 triangles
  const CellSoup<2> soup{torus.cells, torus.vertex_count, {}};
  EXPECT_FALSE(betti_numbers(soup, {149, UINT64_MAX}));
  EXPECT_TRUE(betti_numbers(soup, {150, UINT64_MAX}));
  EXPECT_FALSE(betti_numbers(soup, {150, 1}));
}

TEST(Betti, IgnoresOrphansAndTakesVerticesOutOfRange) {
  const CellSoup<2> soup{{{VertexId{0}, VertexId{1}, VertexId{4000000000}}}, 100, {}};
  EXPECT_EQ(betti_numbers(soup), (Betti<2>{1, 0, 0}));
}

}  // namespace
}  // namespace cleave::views
