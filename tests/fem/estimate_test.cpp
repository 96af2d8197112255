// The estimate of the energy error against the true one, on a cube and on a real liver.
#include "cleave/fem/estimate_study.hpp"

#include <gtest/gtest.h>

#include "bodies.hpp"
#include "cleave/fem/loads.hpp"

namespace cleave::fem {
namespace {

/// Estimates of iterates whose true error is below this are not judged: the reference is not exact.
constexpr double kFloor = 1e-9;

/// No iterate is off by a factor three.
void expect_good(const EstimateStudy& study, std::size_t least_count) {
  EXPECT_TRUE(study.reference_outcome == Outcome::converged ||
              study.reference_outcome == Outcome::stagnated)
      << name(study.reference_outcome);
  ASSERT_GE(study.iterates.size(), least_count);
  testing::Test::RecordProperty("worst_factor", std::to_string(study.worst_factor(5, kFloor)));
  EXPECT_LT(study.worst_factor(5, kFloor), 3.0);
  EXPECT_LT(study.iterates.back().truth, 1e-5);
}

TEST(EnergyErrorEstimate, IsWithinAFactorThreeOnACubePulledApart) {
  Body body = cube(8);
  const auto left = vertices_where(body, [](const Point& p) { return p[0] == 0.0; });
  const auto sheet = facets_between(body, [](const Point& p) { return p[0] < 3.0 / 7.0; });
  std::vector<HalfFacetId> upper_half;
  for (const HalfFacetId h : sheet.half_facets())
    if (centroid(body, topology::cell_of<3>(h))[2] > 0.5) upper_half.push_back(h);
  ASSERT_FALSE(cut(body, topology::FacetSet::of_lesser(upper_half)).splits.empty());
  Loads loads;
  loads.nodal = share_force(body.k, body.points,
                            vertices_where(body, [](const Point& p) { return p[0] == 1.0; }),
                            {1.0, 0.2, 0.0});
  SolveOptions options;
  const auto study =
      study_estimate(body.k, body.points, uniform_operator(body, {1.0, 1.0}), clamped(left),
                     force_vector(body.k, body.points, loads), options);
  expect_good(study, 30);
}

TEST(EnergyErrorEstimate, IsWithinAFactorThreeOnALiverOfSeveralMaterials) {
  const Body body = medit_body(CLEAVE_DATA_DIR "/liver-16k.mesh");
  Materials materials{{lame_of(2e3, 0.45), lame_of(1e4, 0.45), lame_of(6e4, 0.4)}, {}};
  for (const std::uint32_t label : body.labels)
    materials.of_cell.push_back(std::min<std::uint32_t>(label, 3) - 1);
  double top = 0.0;
  for (const Point& p : body.points) top = std::max(top, p[2]);
  Loads loads;
  loads.gravity = {0.0, 0.0, -9.81};
  loads.density.assign(body.k.cell_count(), 1e-6);
  SolveOptions options;
  options.tolerance = 1e-6;
  const auto study = study_estimate(
      body.k, body.points, ElasticOperator(body.k, body.points, materials),
      clamped(vertices_where(body, [top](const Point& p) { return p[2] > 0.95 * top; })),
      force_vector(body.k, body.points, loads), options);
  expect_good(study, 100);
}

TEST(EnergyErrorEstimate, IsWithinAFactorThreeOnLayersAMillionTimesSofter) {
  const Scene scene = under_its_weight(distorted_cube(7, 0.2));
  const ElasticOperator k_operator(scene.body.k, scene.body.points,
                                   layered(scene.body, 6, lame_of(1.0, 0.3), lame_of(1e6, 0.3)));
  SolveOptions options;
  options.tolerance = 1e-6;
  expect_good(study_estimate(scene.body.k, scene.body.points, k_operator, scene.supports,
                             scene.force, options),
              500);
}

TEST(EnergyErrorEstimate, AStudyJudgesByTheWorstIterate) {
  const EstimateStudy study{Outcome::converged, {{1, 9.0, 1.0}, {6, 1.0, 2.0}, {7, 1e-12, 1e-20}}};
  EXPECT_EQ(study.worst_factor(0, 1e-10), 9.0);
  EXPECT_EQ(study.worst_factor(5, 1e-10), 2.0);
  EXPECT_EQ(study.worst_factor(7, 1e-10), 1.0);
}

}  // namespace
}  // namespace cleave::fem
