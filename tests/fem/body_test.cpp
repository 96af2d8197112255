// What is wrong with a body is said with the ids that show it.
#include <gtest/gtest.h>

#include <limits>

#include "bodies.hpp"

namespace cleave::fem {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

template <class Flaw>
std::vector<Flaw> of_kind(const std::vector<BodyFlaw>& flaws) {
  std::vector<Flaw> found;
  for (const BodyFlaw& flaw : flaws)
    if (const auto* one = std::get_if<Flaw>(&flaw)) found.push_back(*one);
  return found;
}

TEST(CheckBody, FindsNothingInASoundBody) {
  const Body body = distorted_cube(4, 0.2);
  EXPECT_TRUE(check_body(body.k, body.points).empty());
}

TEST(CheckBody, NamesAVertexThatIsNotFiniteOnce) {
  Body body = cube(3);
  body.points[13][1] = kNaN;  // the inner vertex, of many cells
  const auto flaws = check_body(body.k, body.points);
  ASSERT_EQ(flaws.size(), 1u);
  const auto found = of_kind<PointNotFinite>(flaws);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].vertex.value, 13u);
  EXPECT_NE(describe(flaws[0]).find("vertex 13"), std::string::npos);
}

TEST(CheckBody, NamesFlatCells) {
  Body body = cube(3);
  body.points[13] = body.points[12];  // collapses the cells on that edge
  const auto found = of_kind<FlatCell>(check_body(body.k, body.points));
  ASSERT_FALSE(found.empty());
  for (const FlatCell& flat : found) {
    const auto& cell = body.k.vertices(flat.cell);
    EXPECT_NE(std::find(cell.begin(), cell.end(), VertexId{12}), cell.end());
    EXPECT_NE(std::find(cell.begin(), cell.end(), VertexId{13}), cell.end());
  }
}

TEST(CheckBody, NamesCellsThatAreInvertedAgainstTheirPiece) {
  Body body = cube(4);
  const VertexId inner = vertices_where(body, [](const Point& p) {
                           return std::abs(p[0] - 1.0 / 3.0) + std::abs(p[1] - 1.0 / 3.0) +
                                      std::abs(p[2] - 1.0 / 3.0) <
                                  1e-9;
                         }).at(0);
  body.points[inner.value] = {0.75, 0.33, 0.35};  // beyond its neighbour: some cells fold over
  const auto found = of_kind<InvertedCell>(check_body(body.k, body.points));
  ASSERT_FALSE(found.empty());
  EXPECT_LT(found.size(), topology::star(body.k, inner).size());
  EXPECT_THROW(uniform_operator(body, {1.0, 1.0}), InvalidBody);
}

// Orientation is a matter of each piece: one of two pieces seen in a mirror is sound.
TEST(CheckBody, AWholePieceMayBeMirrored) {
  Body body = cube(3);
  const auto upper = [](const Point& p) { return p[2] > 0.5; };
  cut(body, facets_between(body, upper));
  std::vector<bool> is_upper(body.points.size(), false);
  for (topology::Index c = 0; c < body.k.cell_count(); ++c)
    for (const VertexId v : body.k.vertices({c}))
      if (upper(centroid(body, {c}))) is_upper[v.value] = true;
  for (std::size_t v = 0; v < body.points.size(); ++v)
    if (is_upper[v]) body.points[v][0] = -body.points[v][0];
  EXPECT_TRUE(check_body(body.k, body.points).empty());
}

TEST(CheckBody, WantsOnePointPerVertex) {
  Body body = cube(2);
  body.points.pop_back();
  EXPECT_THROW(static_cast<void>(check_body(body.k, body.points)), std::invalid_argument);
}

TEST(CheckMaterials, NamesBadEntriesAndUnknownOnes) {
  const Body body = cube(2);
  Materials materials = Materials::uniform(body.k.cell_count(), {1.0, 1.0});
  EXPECT_TRUE(check_materials(body.k, materials).empty());
  materials.table.push_back({1.0, 0.0});
  materials.table.push_back({-0.7, 1.0});
  materials.table.push_back({kNaN, 1.0});
  materials.of_cell[4] = 7;
  const auto flaws = check_materials(body.k, materials);
  const auto bad = of_kind<BadMaterial>(flaws);
  ASSERT_EQ(bad.size(), 3u);
  EXPECT_EQ(bad[0].material, 1u);
  EXPECT_EQ(bad[1].material, 2u);
  EXPECT_EQ(bad[2].material, 3u);
  const auto unknown = of_kind<UnknownMaterial>(flaws);
  ASSERT_EQ(unknown.size(), 1u);
  EXPECT_EQ(unknown[0].cell.value, 4u);
  EXPECT_EQ(unknown[0].material, 7u);
  try {
    const ElasticOperator k_operator(body.k, body.points, materials);
    FAIL() << "a bad material was taken";
  } catch (const InvalidBody& error) {
    EXPECT_EQ(error.flaws.size(), 4u);
    EXPECT_NE(std::string(error.what()).find("cell 4 names material 7"), std::string::npos);
  }
  materials.of_cell.pop_back();
  EXPECT_THROW(static_cast<void>(check_materials(body.k, materials)), std::invalid_argument);
}

TEST(Volumes, OfTheCubeAddUp) {
  const Body body = distorted_cube(5, 0.2);
  double total = 0.0;
  for (topology::Index c = 0; c < body.k.cell_count(); ++c)
    total += cell_volume(body.k, body.points, {c});
  EXPECT_NEAR(total, 1.0, 1e-13);
  double stars = 0.0;
  for (const double volume : star_volumes(body.k, body.points)) stars += volume;
  EXPECT_NEAR(stars, 4.0, 1e-13);
}

TEST(LameParameters, FromYoungAndPoisson) {
  const Lame lame = lame_of(2.5, 0.25);
  EXPECT_DOUBLE_EQ(lame.lambda, 1.0);
  EXPECT_DOUBLE_EQ(lame.mu, 1.0);
  EXPECT_THROW(lame_of(-1.0, 0.3), std::invalid_argument);
  EXPECT_THROW(lame_of(1.0, 0.5), std::invalid_argument);
  EXPECT_THROW(lame_of(1.0, -1.0), std::invalid_argument);
  EXPECT_THROW(lame_of(kNaN, 0.3), std::invalid_argument);
  EXPECT_THROW(require_positive({-1.0, 1.0}), std::invalid_argument);
  EXPECT_NO_THROW(require_positive({-0.6, 1.0}));
}

}  // namespace
}  // namespace cleave::fem
