#include "cleave/topology/simplices.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "view_laws.hpp"

namespace cleave::views {
namespace {

template <class Dimension>
class SimplicesOf : public ::testing::Test {};
TYPED_TEST_SUITE(SimplicesOf, Dimensions);

TYPED_TEST(SimplicesOf, AreAllSubsetsOfCellsInOrderWithTheirStars) {
  constexpr int D = TypeParam::value;
  for (const auto& k : sample_complexes<D>())
    for (int dimension = 0; dimension <= D; ++dimension) {
      const Simplices<D> simplices(k, dimension);
      const auto expected = simplices_by_definition(k, static_cast<std::size_t>(dimension) + 1);
      EXPECT_EQ(simplices.dimension(), dimension);
      ASSERT_EQ(simplices.count(), expected.size());
      std::size_t i = 0;
      for (const auto& [vertices, star] : expected) {  // a map: in lexicographic order
        EXPECT_EQ(Vertices(simplices[i].begin(), simplices[i].end()), vertices);
        const auto cells = simplices.star(i);
        EXPECT_EQ(std::vector<CellId>(cells.begin(), cells.end()), star);
        ++i;
      }
    }
}

TYPED_TEST(SimplicesOf, AreFoundInAnyOrderWithTheParityOfTheTuple) {
  constexpr int D = TypeParam::value;
  for (const auto& k : sample_complexes<D>())
    for (int dimension = 0; dimension <= D; ++dimension) {
      const Simplices<D> simplices(k, dimension);
      for (std::size_t i = 0; i < simplices.count(); i += 7) {
        Vertices tuple(simplices[i].begin(), simplices[i].end());
        do {
          const auto found = simplices.find(tuple);
          ASSERT_TRUE(found);
          EXPECT_EQ(found->index, i);
          EXPECT_EQ(found->sign, support::parity(tuple));
          const Vertices cell = ascending(k.vertices(found->cell));
          EXPECT_TRUE(
              std::includes(cell.begin(), cell.end(), simplices[i].begin(), simplices[i].end()));
        } while (std::next_permutation(tuple.begin(), tuple.end()));
      }
    }
}

TYPED_TEST(SimplicesOf, DoNotHoldWhatIsNoSimplex) {
  constexpr int D = TypeParam::value;
  const auto k = complex_of<D>(kuhn_cube<D>(3));
  const VertexId least{0}, greatest{static_cast<Index>(k.vertex_count() - 1)};
  const Simplices<D> edges(k, 1);
  EXPECT_TRUE(edges.contains(Vertices{least, {1}}));
  EXPECT_FALSE(edges.contains(Vertices{least, greatest})) << "opposite corners of the grid";
  EXPECT_FALSE(edges.contains(Vertices{least, least})) << "a vertex twice";
  EXPECT_FALSE(edges.contains(Vertices{least})) << "too short";
  EXPECT_FALSE(edges.contains(Vertices{least, {1}, {2}})) << "too long";
  EXPECT_FALSE(edges.contains(Vertices{{greatest.value + 1}, {greatest.value + 2}}));
  EXPECT_FALSE(edges.contains(Vertices{}));
}

TYPED_TEST(SimplicesOf, HaveADimensionFromZeroToThatOfTheComplex) {
  constexpr int D = TypeParam::value;
  EXPECT_THROW(Simplices<D>(Complex<D>(), -1), std::invalid_argument);
  EXPECT_THROW(Simplices<D>(Complex<D>(), D + 1), std::invalid_argument);
  EXPECT_EQ(Simplices<D>(Complex<D>(), D).count(), 0u);
}

TYPED_TEST(SimplicesOf, HalfFacetsAreFoundByOrientedTuple) {
  constexpr int D = TypeParam::value;
  for (const auto& k : sample_complexes<D>()) {
    std::vector<std::int8_t> signs;
    for (Index c = 0; c < k.cell_count(); ++c)
      signs.push_back(static_cast<std::int8_t>(k.sign({c})));
    const auto step = static_cast<Index>(1 + k.half_facet_count() / 500);
    for (Index h = 0; h < k.half_facet_count(); h += step) {
      Facet<D> tuple = support::sorted_facet<D>(k.cells(), {h});
      const int induced = support::induced_sign<D>(k.cells(), signs, {h});
      do {
        for (const int sign : {1, -1}) {
          const auto found = find_half_facet(k, tuple, sign);
          ASSERT_TRUE(found);
          const bool asked_for_h = sign * support::parity(tuple) == induced;
          const auto mate = k.mate({h});
          EXPECT_EQ(found->half_facet, asked_for_h || !mate ? HalfFacetId{h} : *mate);
          EXPECT_EQ(found->sign, asked_for_h || mate ? 1 : -1);
        }
      } while (std::next_permutation(tuple.begin(), tuple.end()));
    }
  }
}

TEST(HalfFacets, AreNotFoundWhereThereIsNoFacet) {
  const auto k = complex_of<3>(kuhn_cube<3>(3));
  EXPECT_FALSE(find_half_facet(k, {VertexId{0}, VertexId{1}, VertexId{26}}));
  EXPECT_FALSE(find_half_facet(k, {VertexId{0}, VertexId{0}, VertexId{1}})) << "a vertex twice";
  EXPECT_FALSE(find_half_facet(k, {VertexId{27}, VertexId{0}, VertexId{1}})) << "no such vertex";
  EXPECT_FALSE(find_half_facet(k, {VertexId{0}, VertexId{1}, VertexId{27}}));
  EXPECT_THROW(find_half_facet(k, {VertexId{0}, VertexId{1}, VertexId{4}}, 0),
               std::invalid_argument);
}

TYPED_TEST(SimplicesOf, LinkIsWhatIsOppositeInTheStar) {
  constexpr int D = TypeParam::value;
  for (const auto& k : sample_complexes<D>())
    for (int dimension = 0; dimension <= D; ++dimension)
      for (const auto& [simplex, star] :
           simplices_by_definition(k, static_cast<std::size_t>(dimension) + 1)) {
        std::vector<Vertices> expected;
        for (const CellId cell : star) {
          const Vertices all = ascending(k.vertices(cell));
          Vertices& rest = expected.emplace_back();
          std::set_difference(all.begin(), all.end(), simplex.begin(), simplex.end(),
                              std::back_inserter(rest));
        }
        std::sort(expected.begin(), expected.end());
        if (dimension == D) expected.clear();  // nothing is opposite a cell
        EXPECT_EQ(link<D>(k, simplex), expected);
      }
}

TEST(Link, OfNoSimplexIsEmpty) {
  const auto k = complex_of<3>(kuhn_cube<3>(3));
  EXPECT_TRUE(link<3>(k, Vertices{}).empty());
  EXPECT_TRUE(link<3>(k, Vertices{{0}, {26}}).empty());
  EXPECT_TRUE(link<3>(k, Vertices{{0}, {0}}).empty());
  EXPECT_TRUE(link<3>(k, Vertices{{27}}).empty());
  EXPECT_TRUE(link<3>(k, Vertices{{0}, {1}, {2}, {3}, {4}}).empty());
}

TEST(Link, OfAnInnerVertexOfTheKuhnGridIsASphere) {
  const auto k = complex_of<3>(kuhn_cube<3>(3));
  EXPECT_EQ(link<3>(k, Vertices{{13}}).size(), 24u);  // the centre: 24 triangles
}

}  // namespace
}  // namespace cleave::views
