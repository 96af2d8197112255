// A cut followed locally gives what a new start on the cut body gives.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "bodies.hpp"
#include "cleave/fem/loads.hpp"
#include "cleave/fem/stiffness.hpp"
#include "cleave/topology/pieces.hpp"

namespace cleave::fem {
namespace {

Materials two_materials(const Body& body) {
  Materials materials{{{1.0, 1.0}, {50.0, 4.0}}, {}};
  for (std::uint32_t c = 0; c < body.k.cell_count(); ++c) materials.of_cell.push_back(c % 3 == 0);
  return materials;
}

// "Bit for bit": every comparison below is exact.
RC_GTEST_PROP(ElasticOperatorAfterCutsProperty, EqualsANewOneBitForBit, (std::uint64_t seed)) {
  support::Rng rng(seed);
  Body body = random_body(rng);
  const Materials materials = two_materials(body);
  ElasticOperator followed(body.k, body.points, materials);
  for (int stage = 0; stage < 3; ++stage) {
    const auto change = cut(body, random_cut(body.k, rng));
    followed.update(body.k, change);
    const ElasticOperator fresh(body.k, body.points, materials);
    RC_ASSERT(followed.vertex_count() == fresh.vertex_count());
    for (topology::Index v = 0; v < body.k.vertex_count(); ++v)
      RC_ASSERT(followed.diagonal_block({v}) == fresh.diagonal_block({v}));
    const Eigen::VectorXd u = random_vector(fresh.size(), rng);
    Eigen::VectorXd one, other;
    followed.apply(u, one);
    fresh.apply(u, other);
    RC_ASSERT(one == other);
    RC_CLASSIFY(!change.splits.empty(), "split");
  }
}

// T9: a piece has no hinge to another one, so the matrix has a block per piece and nothing else.
RC_GTEST_PROP(ElasticOperatorAfterCutsProperty, HasABlockPerPiece, (std::uint64_t seed)) {
  support::Rng rng(seed);
  Body body = random_body(rng);
  cut(body, random_cut(body.k, rng));
  const auto pieces = topology::pieces(body.k);
  std::vector<topology::Index> piece_of(body.k.vertex_count());
  for (topology::Index c = 0; c < body.k.cell_count(); ++c)
    for (const VertexId v : body.k.vertices({c})) piece_of[v.value] = pieces.of_cell[c];
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  const Matrix matrix = assemble_stiffness(uniform_operator(body, {1.0, 1.0}));
  for (Eigen::Index row = 0; row < matrix.rows(); ++row)
    for (Matrix::InnerIterator entry(matrix, row); entry; ++entry)
      RC_ASSERT(piece_of[static_cast<std::size_t>(row / 3)] ==
                piece_of[static_cast<std::size_t>(entry.col() / 3)]);
  RC_CLASSIFY(pieces.count > 1, "several pieces");
}

// Taking a cut back: the corners get their old names again, and the operator its old values.
TEST(ElasticOperatorAfterCuts, FollowsMerges) {
  Body body = distorted_cube(4, 0.2);
  const Body before = body;
  const Materials materials = two_materials(body);
  ElasticOperator followed(body.k, body.points, materials);
  const auto change = cut(body, facets_between(body, [](const Point& p) { return p[0] < 0.5; }));
  ASSERT_FALSE(change.splits.empty());
  followed.update(body.k, change);

  followed.update(before.k, topology::inverse(change));

  const ElasticOperator fresh(before.k, before.points, materials);
  support::Rng rng(3);
  const Eigen::VectorXd u = random_vector(fresh.size(), rng);
  Eigen::VectorXd one, other;
  followed.apply(u, one);
  fresh.apply(u, other);
  EXPECT_EQ(one, other);
  for (topology::Index v = 0; v < before.k.vertex_count(); ++v)
    EXPECT_EQ(followed.diagonal_block({v}), fresh.diagonal_block({v}));
}

TEST(ElasticOperatorAfterCuts, RefusesAnotherComplex) {
  const Body body = cube(3);
  auto k_operator = uniform_operator(body, {1.0, 1.0});
  EXPECT_THROW(k_operator.update(cube(2).k, {}), std::invalid_argument);
}

TEST(ElasticOperatorAfterCuts, RefusesAChangeThatIsNotTheNextOne) {
  Body body = cube(3);
  auto k_operator = uniform_operator(body, {1.0, 1.0});
  const auto change = cut(body, facets_between(body, [](const Point& p) { return p[0] < 0.5; }));
  ASSERT_FALSE(change.splits.empty());
  EXPECT_THROW(k_operator.update(body.k, {}), std::invalid_argument);
  EXPECT_EQ(k_operator.vertex_count(), change.vertices_before);
  k_operator.update(body.k, change);
  EXPECT_EQ(k_operator.vertex_count(), change.vertices_after);
  EXPECT_THROW(k_operator.update(body.k, change), std::invalid_argument);
}

Eigen::Vector3d resultant(const Loads& loads) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const NodalForce& load : loads.nodal) sum += load.force;
  return sum;
}

RC_GTEST_PROP(LoadsAfterCutsProperty, KeepTheirTotal, (std::uint64_t seed)) {
  support::Rng rng(seed);
  Body body = random_body(rng);
  Loads loads;
  for (const VertexId v : vertices_where(body, [](const Point&) { return true; }))
    loads.nodal.push_back({v, random_vector(3, rng)});
  const Eigen::Vector3d before = resultant(loads);
  const auto change = cut(body, random_cut(body.k, rng));
  carry_over(loads, body.k, body.points, change);
  RC_ASSERT((resultant(loads) - before).norm() <= 1e-12 * static_cast<double>(loads.nodal.size()));

  // Copies of one vertex are loaded in proportion to their stars.
  const auto volumes = star_volumes(body.k, body.points);
  std::vector<Eigen::Vector3d> density(body.k.vertex_count(), Eigen::Vector3d::Zero());
  for (const NodalForce& load : loads.nodal)
    density[load.vertex.value] += load.force / volumes[load.vertex.value];
  for (const auto& split : change.splits)
    RC_ASSERT((density[split.vertex.value] - density[split.parent.value]).norm() <=
              1e-12 * density[split.parent.value].norm());
}

// Weight belongs to cells: cutting moves it between copies and changes no sum.
TEST(LoadsAfterCuts, GravityAndTractionsNeedNothing) {
  Body body = distorted_cube(5, 0.2);
  Loads loads;
  loads.gravity = {0.0, 0.0, -9.81};
  loads.density.assign(body.k.cell_count(), 1000.0);
  for (topology::Index h = 0; h < body.k.half_facet_count(); ++h)
    if (!body.k.is_interior({h})) loads.tractions.push_back({{h}, {1.0, 2.0, 3.0}});
  const Eigen::VectorXd before = force_vector(body.k, body.points, loads);
  const auto change =
      cut(body, facets_between(body, [](const Point& p) { return p[0] + p[1] < 1.0; }));
  ASSERT_FALSE(change.splits.empty());
  Eigen::VectorXd after = force_vector(body.k, body.points, loads);
  for (const auto& split : change.splits)
    after.segment<3>(3 * split.parent.value) += after.segment<3>(3 * split.vertex.value);
  EXPECT_LT((after.head(before.size()) - before).norm(), 1e-13 * before.norm());
}

TEST(LoadsAfterCuts, FollowMerges) {
  const Body body = cube(2);
  Loads loads;
  loads.nodal = {{VertexId{3}, {1.0, 0.0, 0.0}}, {VertexId{8}, {0.0, 2.0, 0.0}}};
  topology::Relabelling change;
  change.vertices_before = 9;
  change.vertices_after = 8;
  change.merges = {{VertexId{8}, VertexId{3}}};
  carry_over(loads, body.k, body.points, change);
  const Eigen::VectorXd f = force_vector(body.k, body.points, loads);
  EXPECT_EQ(Eigen::Vector3d(f.segment<3>(9)), Eigen::Vector3d(1.0, 2.0, 0.0));
}

}  // namespace
}  // namespace cleave::fem
