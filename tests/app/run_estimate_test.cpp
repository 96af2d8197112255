// The estimate of the energy error, which every solve of a run reports, against the true error on
// both demo scenes: at rest and after the last stroke.
#include <gtest/gtest.h>

#include <string>

#include "body.hpp"
#include "cleave/fem/elastic_operator.hpp"
#include "cleave/fem/estimate_study.hpp"
#include "kuhn_cube.hpp"
#include "mesh_file.hpp"
#include "run_solve.hpp"
#include "scene.hpp"
#include "scene_physics.hpp"
#include "scene_stroke.hpp"

namespace cleave::app {
namespace {

// As the rounding errors of a solve grow towards its end, only errors above this are compared.
constexpr double kFloor = 1e-10;
constexpr std::size_t kFirst = 5;

Mesh mesh_of(const Scene& scene) {
  if (const auto* cube = std::get_if<CubeSpec>(&scene.mesh)) return kuhn_cube(*cube);
  return read_mesh(std::get<std::filesystem::path>(scene.mesh));
}

void expect_good_estimates(const std::string& file) {
  const Scene scene = read_scene(std::string(CLEAVE_DATA) + "/" + file);
  const Mesh mesh = mesh_of(scene);
  const Body<3> body = make_body<3>(mesh);
  auto points = points_of(body);
  const SceneMaterials materials = materials_of(scene, mesh);
  fem::ElasticOperator k(body.complex, points, materials.lame);
  fem::Dirichlet supports = supports_of(scene, body);
  auto loads = loads_of(scene, body, points, materials);
  topology::Incision<3> incision(body.complex);
  const auto study = [&] {
    const auto found = fem::study_estimate(incision.complex(), points, k, supports,
                                           force_of(loads, incision.complex(), points),
                                           solve_options(*scene.solve));
    EXPECT_NE(found.reference_outcome, fem::Outcome::iteration_limit);
    EXPECT_GT(found.iterates.size(), 100u);
    testing::Test::RecordProperty("worst_factor",
                                  std::to_string(found.worst_factor(kFirst, kFloor)));
    EXPECT_LT(found.worst_factor(kFirst, kFloor), 3.0) << file;
  };
  study();
  Parts parts;
  for (const StrokeSpec& stroke : scene.strokes) {
    const auto change = make_stroke(stroke, scene.source, body, incision, points, parts).change;
    k.update(incision.complex(), change);
    supports.carry_over(change);
    for (auto& part : loads) fem::carry_over(part, incision.complex(), points, change);
  }
  study();
}

TEST(EnergyErrorEstimate, IsWithinThreeTimesTheTruthOnTheLiver) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "minutes under a sanitizer; the cube takes the same paths";
#endif
  expect_good_estimates("liver.scene.json");
}

TEST(EnergyErrorEstimate, IsWithinThreeTimesTheTruthOnTheCube) {
  expect_good_estimates("cube.scene.json");
}

}  // namespace
}  // namespace cleave::app
