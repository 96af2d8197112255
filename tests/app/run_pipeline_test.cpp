// Scenes on small cubes: which parts are built, what each error says, what a solve reports.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "error.hpp"
#include "kuhn_cube.hpp"
#include "run_pipeline.hpp"
#include "scene.hpp"
#include "scene_physics.hpp"
#include "scene_stroke.hpp"

namespace cleave::app {
namespace {

const std::string kCube = R"("mesh": {"cube": {"nodes": [4,4,4], "size": [3,3,3]}})";
const std::string kLame = R"("material": {"lambda": 1, "mu": 1})";
const std::string kFloor = R"("supports": [{"where": {"box": [[0,0,0],[3,3,0]]}}])";
const std::string kPull =
    R"("loads": [{"where": {"box": [[3,0,0],[3,3,3]]}, "traction": [0.01,0,0]}])";
const std::string kHalf = R"("strokes": [{"name": "half",
    "blade": [[[1.1,-1,4],[1.1,-1,0.9]],[[1.1,4,4],[1.1,4,0.9]]]}])";  // plane x = 1 down to z = 1
const std::string kThrough = R"("strokes": [{"name": "through",
    "blade": [[[1.1,-1,4],[1.1,-1,-1]],[[1.1,4,4],[1.1,4,-1]]]}])";

std::string joined(const std::vector<std::string>& parts) {
  std::string text = "{" + kCube;
  for (const auto& part : parts) text += ", " + part;
  return text + "}";
}

RunResult run(const std::vector<std::string>& parts) {
  return run_scene(parse_scene(joined(parts), "s.json", ""), [](const std::string&) {});
}

std::string refusal(const std::vector<std::string>& parts) {
  try {
    run(parts);
  } catch (const InputError& e) {
    return e.what();
  }
  ADD_FAILURE() << "accepted: " << joined(parts);
  return {};
}

std::vector<std::string> built(const RunReport& report) {
  std::vector<std::string> names;
  for (const Part& part : report.parts.all()) names.push_back(part.name);
  return names;
}

using Names = std::vector<std::string>;
const std::string kNoFiles = R"("output": {"vtu": false})";

TEST(RunParts, OfAMeshAloneAreTheMeshAndItsFile) {
  EXPECT_EQ(built(run({}).report), (Names{"mesh", "vtu"}));
  EXPECT_EQ(built(run({kNoFiles}).report), (Names{"mesh"}));
}

TEST(RunParts, WithAMaterialAreNoOperatorAndNoComplex) {
  EXPECT_EQ(built(run({kLame, kNoFiles}).report), (Names{"mesh", "material"}));
}

TEST(RunParts, OfACutHaveNoMaterialAndNoSolver) {
  const auto result = run({kHalf, kNoFiles});
  EXPECT_EQ(built(result.report),
            (Names{"mesh", "complex", "incision", "pinched-edge check", "selector"}));
  EXPECT_TRUE(result.vtu.empty());
  EXPECT_FALSE(result.page.has_value());
}

TEST(RunParts, OfFacetsThatAreNamedHaveNoSelector) {
  EXPECT_EQ(built(run({R"("strokes": [{"facets": [[0,1,21]]}])", kNoFiles}).report),
            (Names{"mesh", "complex", "incision", "pinched-edge check", "cut"}));
}

TEST(RunParts, OfASolveHaveNoSelector) {
  EXPECT_EQ(built(run({kLame, kFloor, kPull, R"("solve": {})", kNoFiles}).report),
            (Names{"mesh", "material", "complex", "incision", "pinched-edge check", "operator",
                   "supports", "loads", "solver"}));
  EXPECT_EQ(built(run({kLame, kFloor, R"("solve": {})", kNoFiles}).report),
            (Names{"mesh", "material", "complex", "incision", "pinched-edge check", "operator",
                   "supports", "solver"}));
}

TEST(RunParts, HaveAPageOnlyIfItIsNamed) {
  const auto result = run({R"("output": {"vtu": false, "page": true})"});
  EXPECT_EQ(built(result.report), (Names{"mesh", "page"}));
  ASSERT_TRUE(result.page.has_value());
  EXPECT_EQ(result.page->states.size(), 1u);
  EXPECT_EQ(result.page->states[0].pieces, 1u);
}

TEST(RunParts, BytesAreWhatTheHeapGrewBy) {
  const auto result = run({kHalf, kNoFiles});
  if (!result.report.parts.bytes_known()) GTEST_SKIP() << "the allocator does not tell";
  const Part& complex = result.report.parts.all()[1];
  ASSERT_EQ(complex.name, "complex");
  EXPECT_GE(complex.bytes, 162 * 32);  // cells and mates alone
  EXPECT_LT(complex.bytes, 162 * 200);
}

TEST(Run, CutsSolvesAndReports) {
  const auto result = run({kLame, kFloor, kPull, kHalf, R"("solve": {"tolerance": 1e-10})",
                           R"("output": {"page": true})"});
  const RunReport& report = result.report;
  EXPECT_EQ(report.cells, 162u);
  EXPECT_EQ(report.vertices_before, 64u);
  ASSERT_EQ(report.strokes.size(), 1u);
  const StrokeReport& stroke = report.strokes[0];
  EXPECT_EQ(stroke.requested, 12u);  // 3 by 2 squares of two facets
  EXPECT_EQ(stroke.opened, 12u);
  EXPECT_EQ(stroke.shut, 0u);
  EXPECT_EQ(stroke.new_vertices, 8u);  // two rows of four above the rim
  EXPECT_EQ(report.vertices_after, 72u);
  EXPECT_EQ(stroke.pieces_after, 1u);
  ASSERT_TRUE(stroke.gap.has_value());
  EXPECT_GT(stroke.gap->mean, 0.0);
  EXPECT_GE(stroke.gap->max, stroke.gap->mean);
  ASSERT_EQ(report.solves.size(), 2u);
  for (const SolveReport& solve : report.solves) {
    EXPECT_EQ(solve.outcome, fem::Outcome::converged);
    EXPECT_LE(solve.residual, 1e-10);
    EXPECT_TRUE(solve.floating.empty());
  }
  EXPECT_FALSE(report.solves[0].warm_start);
  EXPECT_TRUE(report.solves[1].warm_start);
  ASSERT_EQ(result.vtu.size(), 3u);
  EXPECT_EQ(result.vtu.back().name, "final.vtu");
  EXPECT_EQ(result.vtu[1].mesh.points.size(), 72u);
  EXPECT_EQ(result.page->states.size(), 2u);
  EXPECT_EQ(result.page->states[1].opened.size(), 12u);
}

TEST(Run, CuttingInStagesGivesTheSameBodyAndDisplacement) {
  const std::string strict = R"("solve": {"tolerance": 1e-13})";
  const auto once = run({kLame, kFloor, kPull, kHalf, strict});
  const auto in_steps = run({kLame, kFloor, kPull,
                             R"("strokes": [
        {"blade": [[[1.1,-1,4],[1.1,-1,1.9]],[[1.1,4,4],[1.1,4,1.9]]]},
        {"blade": [[[1.1,-1,2.1],[1.1,-1,0.9]],[[1.1,4,2.1],[1.1,4,0.9]]]}])",
                             strict});
  const auto& a = once.vtu.back().mesh;
  const auto& b = in_steps.vtu.back().mesh;
  ASSERT_EQ(a.cells().vertices, b.cells().vertices);  // canonical numbering
  const auto& u = a.point_fields.back();
  const auto& v = b.point_fields.back();
  ASSERT_EQ(u.name, "displacement");
  ASSERT_EQ(u.values.size(), v.values.size());
  for (std::size_t i = 0; i < u.values.size(); ++i)
    EXPECT_NEAR(u.values[i], v.values[i], 1e-9 * once.report.solves[1].largest_displacement);
}

TEST(Run, APieceThatNothingHoldsIsRefusedOrSolvedModuloItsMotions) {
  const auto refused =
      run({kLame, kFloor, kPull,
           R"("strokes": [{"blade": [[[-1,-1,1.1],[-1,4,1.1]],[[4,-1,1.1],[4,4,1.1]]]}])",
           R"("solve": {})"});
  ASSERT_EQ(refused.report.solves.size(), 2u);
  const SolveReport& last = refused.report.solves[1];
  EXPECT_EQ(last.outcome, fem::Outcome::unsupported_piece);
  EXPECT_FALSE(last.has_displacement);
  EXPECT_FALSE(refused.report.every_solve_converged());
  ASSERT_EQ(last.floating.size(), 1u);
  EXPECT_EQ(last.floating[0].free_modes, 6u);
  EXPECT_EQ(last.floating[0].cells, 108u);
  for (const Field& field : refused.vtu.back().mesh.point_fields)
    EXPECT_NE(field.name, "displacement") << "nothing was solved";

  const auto solved =
      run({kLame, kFloor, kPull,
           R"("strokes": [{"blade": [[[-1,-1,1.1],[-1,4,1.1]],[[4,-1,1.1],[4,4,1.1]]]}])",
           R"("solve": {"on_unsupported": "modulo_free_modes"})"});
  const SolveReport& modulo = solved.report.solves[1];
  EXPECT_EQ(modulo.outcome, fem::Outcome::converged);
  ASSERT_EQ(modulo.floating.size(), 1u);
  EXPECT_NEAR(modulo.floating[0].removed_force[0], 0.01 * 6.0, 1e-12);  // traction on 3 x 2
}

TEST(Run, WithoutSupportsTheOutcomeIsTyped) {
  const auto result = run({kLame, kPull, R"("solve": {})"});
  EXPECT_EQ(result.report.solves[0].outcome, fem::Outcome::unsupported_piece);
  EXPECT_EQ(result.report.solves[0].floating[0].free_modes, 6u);
}

TEST(Run, AnIterationLimitIsAnOutcome) {
  const auto result = run({kLame, kFloor, kPull, R"("solve": {"max_iterations": 3})"});
  EXPECT_EQ(result.report.solves[0].outcome, fem::Outcome::iteration_limit);
  EXPECT_EQ(result.report.solves[0].iterations, 3u);
}

TEST(Run, AStrokeThatMissesIsAWarning) {
  const auto result = run({R"("strokes": [{"blade": [[[9,9,9],[9,9,8]],[[9,8,9],[9,8,8]]]}])"});
  EXPECT_EQ(result.report.strokes[0].requested, 0u);
  EXPECT_EQ(result.report.strokes[0].pieces_after, 1u);
  ASSERT_EQ(result.report.warnings.size(), 1u);
  EXPECT_NE(result.report.warnings[0].find("stroke 1 selects no facet"), std::string::npos);
}

TEST(Run, ParentsAreIntegersWithAndWithoutAComplex) {
  for (const auto& result : {run({}), run({R"("strokes": [{"facets": []}])"})}) {
    const auto& fields = result.vtu.back().mesh.point_fields;
    ASSERT_EQ(fields.size(), 1u);
    EXPECT_EQ(fields[0].name, "parent");
    EXPECT_TRUE(fields[0].integer);
  }
}

TEST(Run, SupportsWithoutASolveAreAWarning) {
  const auto result = run({kFloor, R"("strokes": [{"facets": []}])"});
  ASSERT_EQ(result.report.warnings.size(), 2u);
  EXPECT_NE(result.report.warnings[0].find("without \"solve\""), std::string::npos);
}

TEST(Run, GravityGivesTheWeight) {
  // Held at its floor, the block's support takes the weight; a floating one shows it as removed.
  const auto result = run({kLame, R"("loads": [{"gravity": [0,0,-10], "density": 2}])",
                           R"("solve": {"on_unsupported": "modulo_free_modes"})"});
  EXPECT_NEAR(result.report.solves[0].floating.at(0).removed_force[2], -10.0 * 2.0 * 27.0, 1e-9);
  const auto in_part =
      run({R"("material": {"lambda": 1, "mu": 1, "density": 2})",
           R"("loads": [{"where": {"box": [[0,0,0],[3,3,1]]}, "gravity": [0,0,-10]}])",
           R"("solve": {"on_unsupported": "modulo_free_modes"})"});
  EXPECT_NEAR(in_part.report.solves[0].floating.at(0).removed_force[2], -10.0 * 2.0 * 9.0, 1e-9);
}

TEST(Run, TotalForceIsShared) {
  const auto result =
      run({kLame, R"("loads": [{"where": {"half_space": {"point": [0,0,2], "normal": [0,0,1]}},
                            "total_force": [1,2,3]}])",
           R"("solve": {"on_unsupported": "modulo_free_modes"})"});
  const auto& removed = result.report.solves[0].floating.at(0).removed_force;
  EXPECT_NEAR(removed[0], 1.0, 1e-12);
  EXPECT_NEAR(removed[1], 2.0, 1e-12);
  EXPECT_NEAR(removed[2], 3.0, 1e-12);
}

void expect_all(const std::string& message, const std::vector<std::string>& words) {
  for (const auto& word : words)
    EXPECT_NE(message.find(word), std::string::npos) << word << " is missing in: " << message;
}

TEST(RunRefuses, ContradictorySupports) {
  expect_all(refusal({kLame,
                      R"("supports": [{"where": {"box": [[0,0,0],[3,3,0]]}},
          {"where": {"vertices": [5]}, "axes": ["y"], "value": 0.5}])",
                      R"("solve": {})"}),
             {"s.json", "vertex 5", "y", "0.5", "/supports/0", "/supports/1"});
}

TEST(RunRefuses, AnEmptySelection) {
  expect_all(
      refusal({kLame, R"("supports": [{"where": {"box": [[7,7,7],[8,8,8]]}}])", R"("solve": {})"}),
      {"/supports/0", "no vertex"});
  expect_all(refusal({kLame, R"("loads": [{"where": {"box": [[1,1,1],[2,2,2]]},
                                     "traction": [1,0,0]}])",
                      R"("solve": {})"}),
             {"/loads/0", "no boundary facet"});
}

TEST(RunRefuses, WhatTheMeshDoesNotHave) {
  expect_all(refusal({kLame, R"("supports": [{"where": {"group": "skin"}}])", R"("solve": {})"}),
             {"/supports/0", "\"skin\"", "cell groups: none"});
  expect_all(refusal({kLame, R"("supports": [{"where": {"vertices": [64]}}])", R"("solve": {})"}),
             {"/supports/0", "vertex 64"});
  expect_all(refusal({R"("material": {"groups": {"3": {"lambda": 1, "mu": 1}}})"}),
             {"/material/groups/3", "cell group \"3\""});
  expect_all(refusal({R"("strokes": [{"group": "fault"}])"}), {"/strokes/0/group", "\"fault\""});
  expect_all(refusal({R"("strokes": [{"facets": [[0,1,64]]}])"}),
             {"/strokes/0/facets/0", "vertex 64"});
  expect_all(refusal({R"("strokes": [{"facets": [[0,1,63]]}])"}), {"/strokes/0/facets", "0", "63"});
}

TEST(RunRefuses, GravityWithoutDensity) {
  expect_all(refusal({kLame, R"("loads": [{"gravity": [0,0,-10]}])", R"("solve": {})"}),
             {"/loads/0", "density", "cell 0"});
}

TEST(RunRefuses, ACellWithTwoMaterials) {
  const Scene scene = parse_scene("{" + kCube + R"(, "material": {"groups": {
      "bone": {"lambda": 1, "mu": 1}, "cut": {"lambda": 2, "mu": 1}}}})",
                                  "s.json", "");
  Mesh mesh = kuhn_cube(std::get<CubeSpec>(scene.mesh));
  Group bone{"bone", 3, 1, {}}, cut{"cut", 3, 2, {17}};
  for (Index c = 0; c < mesh.cells().size(); ++c) bone.elements.push_back(c);
  mesh.groups = {bone, cut};
  try {
    materials_of(scene, mesh);
    FAIL();
  } catch (const InputError& e) {
    expect_all(e.what(), {"cell 17", "two materials", "/material/groups/bone",
                          "/material/groups/cut", "\"bone\", \"cut\""});
  }
  mesh.groups = {cut, bone};
  mesh.groups[1].elements.erase(mesh.groups[1].elements.begin() + 17);
  const SceneMaterials materials = materials_of(scene, mesh);
  EXPECT_EQ(materials.lame.of_cell[17], 1u);
  EXPECT_EQ(materials.lame.of_cell[16], 0u);
  EXPECT_EQ(materials.lame.table[1].lambda, 2.0);
}

TEST(Composed, ChangesOneAfterTheOtherAreOne) {
  using topology::CornerId;
  using topology::VertexId;
  topology::Relabelling first, second;
  first.vertices_before = 3;
  first.vertices_after = second.vertices_before = 4;
  second.vertices_after = 6;
  first.corners = {{CornerId{1}, VertexId{0}, VertexId{3}},
                   {CornerId{5}, VertexId{0}, VertexId{3}}};
  first.splits = {{VertexId{3}, VertexId{0}}};
  second.corners = {{CornerId{5}, VertexId{3}, VertexId{4}},
                    {CornerId{9}, VertexId{1}, VertexId{5}}};
  second.splits = {{VertexId{4}, VertexId{3}}, {VertexId{5}, VertexId{1}}};
  const auto both = composed({first, second}, 3);
  EXPECT_EQ(both.vertices_before, 3u);
  EXPECT_EQ(both.vertices_after, 6u);
  EXPECT_EQ(both.corners,
            (std::vector<topology::RenamedCorner>{{CornerId{1}, VertexId{0}, VertexId{3}},
                                                  {CornerId{5}, VertexId{0}, VertexId{4}},
                                                  {CornerId{9}, VertexId{1}, VertexId{5}}}));
  EXPECT_EQ(both.splits, (std::vector<topology::Split>{{VertexId{3}, VertexId{0}},
                                                       {VertexId{4}, VertexId{0}},
                                                       {VertexId{5}, VertexId{1}}}));
  EXPECT_EQ(composed({}, 3).vertices_after, 3u);
}

TEST(Thinned, KeepsTheFirstTheLastAndTheLastEstimate) {
  std::vector<fem::Sample> samples(1000);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].iteration = i;
    if (i < 991) samples[i].energy_error = 1.0;
  }
  const auto few = thinned(samples, 50);
  EXPECT_LE(few.size(), 50u);
  EXPECT_GE(few.size(), 49u);
  EXPECT_EQ(few.front().iteration, 0u);
  EXPECT_EQ(few.back().iteration, 999u);
  EXPECT_TRUE(std::any_of(few.begin(), few.end(),
                          [](const fem::Sample& sample) { return sample.iteration == 990; }));
  EXPECT_EQ(thinned(samples, 1000).size(), 1000u);
}

}  // namespace
}  // namespace cleave::app
