#include "cleave/fem/loads.hpp"

#include <gtest/gtest.h>

#include "bodies.hpp"
#include "cleave/topology/boundary.hpp"

namespace cleave::fem {
namespace {

Eigen::Vector3d sum_of(const Eigen::VectorXd& f) {
  return f.reshaped(3, f.size() / 3).rowwise().sum();
}

TEST(Loads, TractionOnAFaceOfTheCubeIsAreaTimesTraction) {
  const Body body = distorted_cube(4, 0.2);
  Loads loads;
  for (const HalfFacetId h : topology::boundary(body.k)) {
    const auto facet = body.k.facet(h);
    const bool on_top = std::all_of(facet.begin(), facet.end(),
                                    [&](VertexId v) { return body.points[v.value][2] == 1.0; });
    if (on_top) loads.tractions.push_back({h, {3.0, -1.0, 7.0}});
  }
  EXPECT_EQ(loads.tractions.size(), 18u);
  const Eigen::VectorXd f = force_vector(body.k, body.points, loads);
  EXPECT_LT((sum_of(f) - Eigen::Vector3d(3.0, -1.0, 7.0)).norm(), 1e-14 * 10);
  for (topology::Index v = 0; v < body.points.size(); ++v) {
    if (body.points[v][2] != 1.0) {
      EXPECT_EQ(Eigen::Vector3d(f.segment<3>(3 * v)), Eigen::Vector3d::Zero().eval());
    }
  }
}

TEST(Loads, OneHalfFacetGivesAThirdToEachVertex) {
  const Body body = body_of({{VertexId{0}, {1}, {2}, {3}}},
                            {{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 3.0, 0.0}, {0.0, 0.0, 1.0}});
  Loads loads;
  loads.tractions = {{HalfFacetId{3}, {0.0, 0.0, 5.0}}};  // opposite vertex 3: area 3
  const Eigen::VectorXd f = force_vector(body.k, body.points, loads);
  for (int v = 0; v < 3; ++v) EXPECT_DOUBLE_EQ(f[3 * v + 2], 5.0);
  EXPECT_EQ(f[11], 0.0);
}

TEST(Loads, GravityIsDensityTimesVolumeTimesAcceleration) {
  const Body body = distorted_cube(4, 0.2);
  Loads loads;
  loads.gravity = {0.0, 1.0, -9.81};
  double mass = 0.0;
  for (topology::Index c = 0; c < body.k.cell_count(); ++c) {
    loads.density.push_back(900.0 + c);
    mass += loads.density.back() * cell_volume(body.k, body.points, {c});
  }
  const Eigen::Vector3d weight = sum_of(force_vector(body.k, body.points, loads));
  EXPECT_LT((weight - mass * loads.gravity).norm(), 1e-13 * weight.norm());
}

TEST(Loads, NodalForcesOnOneVertexAddUp) {
  const Body body = cube(2);
  Loads loads;
  loads.nodal = {{VertexId{5}, {1.0, 0.0, 0.0}}, {VertexId{5}, {0.0, 2.0, 0.0}}};
  const Eigen::VectorXd f = force_vector(body.k, body.points, loads);
  EXPECT_EQ(Eigen::Vector3d(f.segment<3>(15)), Eigen::Vector3d(1.0, 2.0, 0.0));
  EXPECT_DOUBLE_EQ(f.lpNorm<1>(), 3.0);
}

TEST(Loads, ATotalForceIsSharedByStarVolume) {
  const Body body = distorted_cube(4, 0.2);
  const Eigen::Vector3d total(1.0, -2.0, 3.0);
  std::vector<VertexId> set = vertices_where(body, [](const Point& p) { return p[0] == 1.0; });
  const std::size_t distinct = set.size();
  set.push_back(set.front());  // named twice: counts once
  const auto shares = share_force(body.k, body.points, set, total);
  ASSERT_EQ(shares.size(), distinct);
  const auto volumes = star_volumes(body.k, body.points);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const NodalForce& share : shares) {
    sum += share.force;
    EXPECT_NEAR(share.force[2] / volumes[share.vertex.value],
                shares[0].force[2] / volumes[shares[0].vertex.value], 1e-12 * 100);
  }
  EXPECT_LT((sum - total).norm(), 1e-14 * 10);
}

TEST(Loads, NameWhatTheyCannotLoad) {
  Body body = cube(3);
  const auto force_on = [&](const Loads& loads) {
    static_cast<void>(force_vector(body.k, body.points, loads));
  };
  Loads beyond;
  beyond.nodal = {{VertexId{27}, {1.0, 0.0, 0.0}}};
  EXPECT_THROW(force_on(beyond), std::invalid_argument);
  EXPECT_THROW(share_force(body.k, body.points, {}, {1.0, 0.0, 0.0}), std::invalid_argument);

  Loads inside;
  topology::Index interior = 0;
  while (!body.k.is_interior({interior})) ++interior;
  inside.tractions = {{HalfFacetId{interior}, {1.0, 0.0, 0.0}}};
  EXPECT_THROW(force_on(inside), std::invalid_argument);
  inside.tractions = {{HalfFacetId{4 * 48}, {1.0, 0.0, 0.0}}};
  EXPECT_THROW(force_on(inside), std::invalid_argument);

  Loads weight;
  weight.gravity = {0.0, 0.0, -9.81};
  EXPECT_THROW(force_on(weight), std::invalid_argument);  // no density
  weight.density.assign(body.k.cell_count(), 1.0);
  weight.density[17] = -1.0;
  try {
    force_on(weight);
    FAIL() << "a negative density was taken";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("cell 17"), std::string::npos);
  }

  Body with_orphan = body_of({{VertexId{0}, {1}, {2}, {3}}},
                             {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {9, 9, 9}});
  Loads orphan;
  orphan.nodal = {{VertexId{4}, {1.0, 0.0, 0.0}}};
  EXPECT_THROW(static_cast<void>(force_vector(with_orphan.k, with_orphan.points, orphan)),
               std::invalid_argument);
}

}  // namespace
}  // namespace cleave::fem
