// What follows a cut follows a stitch: operator, supports, loads, displacements.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/LU>
#include <Eigen/SparseCore>

#include "bodies.hpp"
#include "cleave/fem/displacement.hpp"
#include "cleave/fem/loads.hpp"
#include "cleave/fem/solve.hpp"
#include "cleave/fem/stiffness.hpp"
#include "cleave/topology/carry_over.hpp"
#include "cleave/topology/incision.hpp"

namespace cleave::fem {
namespace {

using topology::FacetSet;
using topology::Incision;

constexpr Lame kMaterial{1.3, 0.7};

/// A body that is cut and stitched; its points follow.
struct Wound {
  explicit Wound(const Body& body) : incision(body.k), points(body.points) {}

  topology::Relabelling cut(const FacetSet& facets) { return follow(incision.cut(facets)); }
  topology::Relabelling stitch(const FacetSet& facets) { return follow(incision.stitch(facets)); }
  topology::Relabelling follow(topology::Relabelling change) {
    topology::carry_over(points, change);
    return change;
  }
  const Complex<3>& k() const { return incision.complex(); }

  Incision<3> incision;
  std::vector<Point> points;
};

FacetSet part_of(const FacetSet& facets, support::Rng& rng) {
  const double density = rng.unit();
  std::vector<HalfFacetId> part;
  for (const HalfFacetId h : facets.half_facets())
    if (rng.chance(density)) part.push_back(h);
  return FacetSet::of_lesser(std::move(part));
}

/// K u with K of linear elasticity assembled from the strain-displacement matrices of the cells, as
/// textbooks have it: volume B^T C B. Shares nothing with the operator.
Eigen::VectorXd textbook_force(const Complex<3>& k, const std::vector<Point>& points,
                               const Eigen::VectorXd& u) {
  Eigen::Matrix<double, 6, 6> c = Eigen::Matrix<double, 6, 6>::Zero();
  c.topLeftCorner<3, 3>().setConstant(kMaterial.lambda);
  c.diagonal() << 2 * kMaterial.mu + kMaterial.lambda, 2 * kMaterial.mu + kMaterial.lambda,
      2 * kMaterial.mu + kMaterial.lambda, kMaterial.mu, kMaterial.mu, kMaterial.mu;
  std::vector<Eigen::Triplet<double>> entries;
  for (topology::Index cell = 0; cell < k.cell_count(); ++cell) {
    Eigen::Matrix4d corners;  // rows (1, x, y, z)
    for (int i = 0; i < 4; ++i) {
      const Point& p = points[k.vertices({cell})[static_cast<std::size_t>(i)].value];
      corners.row(i) << 1.0, p[0], p[1], p[2];
    }
    const Eigen::Matrix4d shape = corners.inverse();  // column i: coefficients of function i
    const double volume = std::abs(corners.determinant()) / 6.0;
    Eigen::Matrix<double, 6, 12> b = Eigen::Matrix<double, 6, 12>::Zero();
    for (int i = 0; i < 4; ++i) {
      const double x = shape(1, i), y = shape(2, i), z = shape(3, i);
      b.block<6, 3>(0, 3 * i) << x, 0, 0, 0, y, 0, 0, 0, z, y, x, 0, 0, z, y, z, 0, x;
    }
    const CellStiffness part = volume * b.transpose() * c * b;
    const auto coordinate = [&](int row) {
      return 3 * static_cast<int>(k.vertices({cell})[static_cast<std::size_t>(row / 3)].value) +
             row % 3;
    };
    for (int row = 0; row < 12; ++row)
      for (int column = 0; column < 12; ++column)
        entries.emplace_back(coordinate(row), coordinate(column), part(row, column));
  }
  Eigen::SparseMatrix<double> assembled(u.size(), u.size());
  assembled.setFromTriplets(entries.begin(), entries.end());
  return assembled * u;
}

// T12, for the operator.
RC_GTEST_PROP(ElasticOperatorAfterStitchesProperty, EqualsANewOneAndTheTextbook,
              (std::uint64_t seed)) {
  support::Rng rng(seed);
  const Body body = random_body(rng);
  Wound wound(body);
  const Materials materials = Materials::uniform(body.k.cell_count(), kMaterial);
  ElasticOperator followed(body.k, body.points, materials);
  followed.update(wound.k(), wound.cut(random_cut(body.k, rng)));
  bool merged = false, shut = false;
  for (int stage = 0; stage < 3; ++stage) {
    const auto change = wound.stitch(part_of(wound.incision.scored(), rng));
    followed.update(wound.k(), change);
    merged = merged || !change.merges.empty();
    shut = shut || !change.shut.empty();
    const ElasticOperator fresh(wound.k(), wound.points, materials);
    RC_ASSERT(followed.vertex_count() == fresh.vertex_count());
    for (topology::Index v = 0; v < wound.k().vertex_count(); ++v)
      RC_ASSERT(followed.diagonal_block({v}) == fresh.diagonal_block({v}));
    const Eigen::VectorXd u = random_vector(fresh.size(), rng);
    Eigen::VectorXd one, other;
    followed.apply(u, one);
    fresh.apply(u, other);
    RC_ASSERT(one == other);
    const Eigen::VectorXd expected = textbook_force(wound.k(), wound.points, u);
    RC_ASSERT((one - expected).norm() <= 1e-12 * expected.norm());
  }
  wound.stitch(wound.incision.scored());
  RC_ASSERT(wound.points == body.points);
  RC_CLASSIFY(merged, "merged");
  RC_CLASSIFY(shut, "others were shut");
}

RC_GTEST_PROP(LoadsAfterStitchesProperty, AddUp, (std::uint64_t seed)) {
  support::Rng rng(seed);
  const Body body = random_body(rng);
  Wound wound(body);
  Loads loads;
  for (const VertexId v : boundary_vertices(body.k))
    loads.nodal.push_back({v, random_vector(3, rng)});
  const Eigen::VectorXd before = force_vector(body.k, body.points, loads);
  for (int cycle = 0; cycle < 3; ++cycle) {
    const auto there = wound.cut(random_cut(body.k, rng) - wound.incision.scored());
    carry_over(loads, wound.k(), wound.points, there);
    const Eigen::VectorXd apart = force_vector(wound.k(), wound.points, loads);
    const auto back = wound.stitch(wound.incision.scored());
    carry_over(loads, wound.k(), wound.points, back);
    const Eigen::VectorXd after = force_vector(wound.k(), wound.points, loads);
    RC_ASSERT((after - before).norm() <= 1e-12 * before.norm());
    // The force on a vertex that stays is the sum of those on what became one.
    Eigen::VectorXd sum = apart.head(after.size());
    for (const auto& merge : back.merges)
      sum.segment<3>(3 * merge.into.value) += apart.segment<3>(3 * merge.vertex.value);
    RC_ASSERT((after - sum).norm() <= 1e-12 * before.norm());
    RC_ASSERT(loads.nodal.size() <= body.k.vertex_count());  // cycles do not pile up entries
    RC_CLASSIFY(!back.merges.empty(), "merged");
  }
}

// The volume-weighted sum of displacements is kept by a stitch, as momentum is.
RC_GTEST_PROP(DisplacementsAfterStitchesProperty, KeepTheirMean, (std::uint64_t seed)) {
  support::Rng rng(seed);
  const Body body = random_body(rng);
  Wound wound(body);
  Eigen::VectorXd u = random_vector(3 * static_cast<Eigen::Index>(body.points.size()), rng);
  const Eigen::VectorXd at_first = u;
  const auto there = wound.cut(random_cut(body.k, rng));
  carry_over(u, wound.k(), wound.points, there);
  for (topology::Index c = 0; c < body.k.half_facet_count(); ++c)
    RC_ASSERT(u.segment<3>(3 * wound.k().vertex({c}).value) ==
              at_first.segment<3>(3 * body.k.vertex({c}).value));

  // Copies that were not moved apart come back where they were.
  Wound back = wound;
  Eigen::VectorXd unmoved = u;
  if (back.incision.can_undo()) {
    const auto undone = back.follow(back.incision.undo());
    carry_over(unmoved, back.k(), back.points, undone);
  }
  RC_ASSERT((unmoved - at_first).norm() <= 1e-14 * at_first.norm());

  u += random_vector(u.size(), rng);
  const auto moment = [&] {
    const auto volumes = star_volumes(wound.k(), wound.points);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (topology::Index v = 0; v < volumes.size(); ++v) sum += volumes[v] * u.segment<3>(3 * v);
    return sum;
  };
  const auto volumes = star_volumes(wound.k(), wound.points);
  const Eigen::VectorXd apart = u;
  const Eigen::Vector3d before = moment();
  const auto change = wound.stitch(part_of(wound.incision.scored(), rng));
  carry_over(u, wound.k(), wound.points, change);
  RC_ASSERT((moment() - before).norm() <= 1e-12 * static_cast<double>(u.size()));
  for (const auto& merge : change.merges) {
    Eigen::Vector3d sum = volumes[merge.into.value] * apart.segment<3>(3 * merge.into.value);
    double volume = volumes[merge.into.value];
    for (const auto& other : change.merges) {
      if (other.into != merge.into) continue;
      sum += volumes[other.vertex.value] * apart.segment<3>(3 * other.vertex.value);
      volume += volumes[other.vertex.value];
    }
    RC_ASSERT((u.segment<3>(3 * merge.into.value) - sum / volume).norm() <= 1e-13);
  }
  RC_CLASSIFY(!change.merges.empty(), "merged");
}

TEST(DisplacementsAfterStitches, RefuseAnotherSize) {
  const Body body = cube(2);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(3);
  EXPECT_THROW(carry_over(u, body.k, body.points, {}), std::invalid_argument);
}

/// A cube cut in two at x = 1/2, where the two sides of the bottom of the wound are held.
class HeldWound : public ::testing::Test {
 protected:
  HeldWound() {
    wound_.cut(wall_);
    for (topology::Index v = 0; v < wound_.k().vertex_count(); ++v)
      if (wound_.points[v][0] == 0.5 && wound_.points[v][2] == 0.0) held_.push_back({v});
  }

  Body body_ = cube(5);
  FacetSet wall_ = facets_between(body_, [](const Point& p) { return p[0] < 0.5; });
  Wound wound_{body_};
  std::vector<VertexId> held_;
};

TEST_F(HeldWound, SupportsThatAgreeFollow) {
  Dirichlet supports;
  for (const VertexId v : held_) supports.prescribe(v, 1, wound_.points[v.value][1]);
  const std::size_t held = supports.size();
  EXPECT_TRUE(supports.conflicts(wound_.incision.planned_merges(wall_)).empty());
  supports.carry_over(wound_.stitch(wall_));
  EXPECT_EQ(2 * supports.size(), held);
  for (const auto& [at, value] : supports.values()) EXPECT_EQ(value, body_.points[at / 3][1]);
}

TEST_F(HeldWound, SupportsThatDisagreeAreFoundBeforeAnythingChanges) {
  Dirichlet supports;
  for (const VertexId v : held_)
    supports.prescribe(v, 0, v.value < body_.points.size() ? 0.0 : 0.1);
  const auto planned = wound_.incision.planned_merges(wall_);
  const auto conflicts = supports.conflicts(planned);
  ASSERT_EQ(conflicts.size(), 5u);
  for (const SupportConflict& conflict : conflicts) {
    EXPECT_EQ(wound_.incision.original(conflict.one), wound_.incision.original(conflict.other));
    EXPECT_EQ(conflict.axis, 0);
    EXPECT_EQ(conflict.value_of_one, 0.0);
    EXPECT_EQ(conflict.value_of_other, 0.1);
  }
  EXPECT_EQ(wound_.incision.opened().size(), wall_.size());
  // A stitch away from them is allowed.
  std::vector<HalfFacetId> above;
  for (const HalfFacetId h : wall_.half_facets()) {
    const auto facet = body_.k.facet(h);
    if (std::all_of(facet.begin(), facet.end(),
                    [&](VertexId v) { return body_.points[v.value][2] > 0.0; }))
      above.push_back(h);
  }
  const FacetSet allowed = FacetSet::of_lesser(above);
  EXPECT_TRUE(supports.conflicts(wound_.incision.planned_merges(allowed)).empty());
  const Dirichlet before = supports;
  supports.carry_over(wound_.stitch(allowed));
  EXPECT_EQ(supports.values(), before.values());
}

// Ids that a stitch leaves unused are no trouble to the solver.
TEST_F(HeldWound, TheSolutionAfterAStitchIsThatOfABodyNeverCutThere) {
  const FacetSet upper = [&] {
    std::vector<HalfFacetId> above;
    for (const HalfFacetId h : wall_.half_facets())
      if (h.value % 2 == 0) above.push_back(h);
    return FacetSet::of_lesser(above);
  }();
  wound_.stitch(upper);
  Wound fresh(body_);
  fresh.cut(wall_ - upper);
  const auto solved = [&](const Wound& wound) {
    const Body body{wound.k(), wound.points, {}};
    const Dirichlet supports =
        clamped(vertices_where(body, [](const Point& p) { return p[2] == 0.0; }));
    Loads loads;
    loads.gravity = {0.3, 0.0, -1.0};
    loads.density.assign(body.k.cell_count(), 1.0);
    const auto result = solve(body.k, body.points, uniform_operator(body, kMaterial), supports,
                              force_vector(body.k, body.points, loads));
    EXPECT_EQ(result.outcome, Outcome::converged);
    return result.displacement;
  };
  const Eigen::VectorXd u = solved(wound_), expected = solved(fresh);
  for (topology::Index c = 0; c < body_.k.half_facet_count(); ++c)
    EXPECT_LT((u.segment<3>(3 * wound_.k().vertex({c}).value) -
               expected.segment<3>(3 * fresh.k().vertex({c}).value))
                  .norm(),
              1e-6 * expected.norm());
}

}  // namespace
}  // namespace cleave::fem
