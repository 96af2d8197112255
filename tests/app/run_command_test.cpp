// `cleave run` as users meet it: files, exit statuses, messages; and the two demo scenes.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "command_support.hpp"

namespace cleave::app::test {
namespace {

using nlohmann::json;
using Names = std::vector<std::string>;

class RunCommand : public CommandTest {
 protected:
  Outcome run_scene(const std::string& scene, const std::string& folder = "out") const {
    write("s.json", scene);
    return cleave({"run", "s.json", "-o", folder});
  }

  json summary(const std::string& folder = "out") const {
    return json::parse(read(folder + "/summary.json"));
  }

  // Whether `folder`/summary.json is what docs/schemas says.
  void expect_valid_summary(const std::string& folder) const {
    expect_valid(folder + "/summary.json", "cleave-run-1.schema.json");
  }

  void expect_valid(const std::string& file, const std::string& schema) const {
    const Outcome checked = run({"/usr/bin/python3", "-c",
                                 "import sys, json\n"
                                 "try: import jsonschema\n"
                                 "except ImportError: sys.exit(77)\n"
                                 "schema = json.load(open(sys.argv[2]))\n"
                                 "jsonschema.Draft202012Validator.check_schema(schema)\n"
                                 "jsonschema.Draft202012Validator(schema).validate("
                                 "json.load(open(sys.argv[1])))",
                                 file, data("../docs/schemas/" + schema)});
    if (checked.status == 77 || checked.status == 127)
      GTEST_SKIP() << "python3-jsonschema is not installed";
    EXPECT_EQ(checked.status, 0) << checked.err;
  }

  // A refusal: status 3, all words on stderr, and no folder.
  void expect_refused(const std::string& scene, const Names& words) const {
    const Outcome result = run_scene(scene);
    EXPECT_EQ(result.status, 3) << scene << result.err;
    for (const auto& word : words)
      EXPECT_NE(result.err.find(word), std::string::npos)
          << word << " is missing in " << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
  }
};

Names part_names(const json& summary) {
  Names names;
  for (const auto& part : summary["parts"]) names.push_back(part["name"]);
  return names;
}

const std::string kCube = R"("mesh": {"cube": {"nodes": [4,4,4], "size": [3,3,3]}})";
const std::string kPulled = kCube + R"(, "material": {"lambda": 1, "mu": 1},
  "supports": [{"where": {"box": [[0,0,0],[3,3,0]]}}],
  "loads": [{"where": {"box": [[3,0,0],[3,3,3]]}, "traction": [0.01,0,0]}], "solve": {})";

TEST_F(RunCommand, TheLiverIsCutAndPulledOpen) {
  const Outcome result = cleave({"run", data("liver.scene.json"), "-o", "out"});
  ASSERT_EQ(result.status, 0) << result.err;
  for (const auto* vertex : {"vertex 577 ", "vertex 1124 ", "vertex 1367 "})
    EXPECT_NE(result.err.find(vertex), std::string::npos) << result.err;
  const json s = summary();
  EXPECT_EQ(s["mesh"]["cells"], 16014);
  EXPECT_EQ(s["mesh"]["vertices_before"], 3449);
  EXPECT_EQ(s["mesh"]["vertices_after"], 3449 + 3 + 59);
  EXPECT_EQ(s["cut_regular"], false);
  std::set<int> parents;
  for (const auto& vertex : s["regularized"]) parents.insert(vertex["parent"].get<int>());
  EXPECT_EQ(parents, (std::set<int>{577, 1124, 1367}));
  EXPECT_EQ(s["pinched_edges"].size(), 3u);
  EXPECT_EQ(s["pinched_edges"][0]["vertices"], (json{577, 1288}));

  const json& stroke = s["strokes"].at(0);
  EXPECT_EQ(stroke["steps"], 15);
  EXPECT_EQ(stroke["facets"]["requested"], 112);
  EXPECT_EQ(stroke["facets"]["opened"], 112);
  EXPECT_EQ(stroke["facets"]["shut"], 0);
  EXPECT_EQ(stroke["pieces"], (json{{"before", 1}, {"after", 1}}));
  EXPECT_EQ(stroke["pinched_edges"], 1);
  EXPECT_GT(stroke["gap"]["mean"].get<double>(), 5.0);  // millimetres
  EXPECT_LT(stroke["gap"]["mean"].get<double>(), 6.0);
  EXPECT_GT(stroke["gap"]["max"].get<double>(), 11.0);
  EXPECT_LT(stroke["gap"]["max"].get<double>(), 15.0);

  ASSERT_EQ(s["solves"].size(), 2u);
  for (const auto& solve : s["solves"]) {
    EXPECT_EQ(solve["outcome"], "converged");
    EXPECT_LE(solve["residual"].get<double>(), 1e-8);
    EXPECT_LE(solve["samples"].size(), 200u);
    EXPECT_EQ(solve["samples"].front()["iteration"], 0);
    EXPECT_EQ(solve["samples"].back()["iteration"], solve["iterations"]);
  }
  EXPECT_EQ(part_names(s),
            (Names{"mesh", "material", "complex", "incision", "pinched-edge check", "operator",
                   "supports", "loads", "solver", "vtu", "page", "selector"}));
  EXPECT_EQ(s["vtu"], (json{"state-000.vtu", "state-001.vtu"}));
  EXPECT_EQ(read("out/final.vtu"), read("out/state-001.vtu"));
  EXPECT_NE(read("out/index.html").find("<html"), std::string::npos);
  expect_valid_summary("out");
}

TEST_F(RunCommand, StrictRefusesAMeshThatIsNotCutRegular) {
  const Outcome result = cleave({"run", data("liver.scene.json"), "-o", "out", "--strict"});
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.err.find("vertex 577 "), std::string::npos) << result.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

TEST_F(RunCommand, TheSameSceneGivesTheSameBytes) {
  const std::string scene = "{" + kPulled + R"(, "strokes": [
    {"blade": [[[1.1,-1,4],[1.1,-1,0.9]],[[1.3,4,4],[1.2,4,0.9]]]}]})";
  for (const auto* folder : {"a", "b"}) ASSERT_EQ(run_scene(scene, folder).status, 0);
  EXPECT_EQ(read("a/final.vtu"), read("b/final.vtu"));
  EXPECT_EQ(read("a/state-000.vtu"), read("b/state-000.vtu"));
}

TEST_F(RunCommand, TheCubeIsTornApart) {
  const Outcome result = cleave({"run", data("cube.scene.json"), "-o", "out"});
  ASSERT_EQ(result.status, 0) << result.err;
  const json s = summary();
  EXPECT_EQ(s["mesh"]["vertices_before"], 1000);
  EXPECT_EQ(s["mesh"]["cells"], 6 * 9 * 9 * 9);
  Names pieces;
  for (const auto& stroke : s["strokes"])
    pieces.push_back(stroke["name"].get<std::string>() + ": " + stroke["pieces"]["before"].dump() +
                     " to " + stroke["pieces"]["after"].dump());
  EXPECT_EQ(pieces, (Names{"Planned incision: 1 to 1", "Second cut: 1 to 2", "Across: 2 to 4",
                           "Left tear: 4 to 4", "Right tear: 4 to 4", "Corner off: 4 to 6"}));
  EXPECT_GT(s["strokes"][0]["gap"]["mean"].get<double>(), 0.05);  // folded open, figure 10
  EXPECT_GT(s["strokes"][1]["gap"]["mean"].get<double>(), 0.05);  // figure 11
  ASSERT_EQ(s["solves"].size(), 7u);
  for (const auto& solve : s["solves"]) EXPECT_EQ(solve["outcome"], "converged");
  EXPECT_TRUE(s["solves"][5]["unsupported"].empty());
  const json& floating = s["solves"][6]["unsupported"];  // the corner, and a crumb
  ASSERT_EQ(floating.size(), 2u);
  double removed = 0.0;
  for (const auto& piece : floating) {
    EXPECT_EQ(piece["free_modes"], 6);
    removed += piece["removed_force"][0].get<double>();
  }
  EXPECT_GT(removed, 0.0);   // the pull to the right
  EXPECT_LT(removed, 0.04);  // on less than the whole side
  expect_valid_summary("out");
}

TEST_F(RunCommand, GroupsOfAFileAreHeldFilledAndCut) {
  const Outcome result = run_scene(R"({"mesh": {"file": ")" + data("fault.msh") + R"("},
    "material": {"groups": {"rock": {"young": 1, "poisson": 0.25}}},
    "supports": [{"where": {"group": "base"}}],
    "loads": [{"where": {"half_space": {"point": [4,0,0], "normal": [1,0,0]}},
               "traction": [0.01,0.01,0]}],
    "strokes": [{"group": "fault"}, {"name": "branch", "group": ["branch", "fault"]}],
    "solve": {}})");
  ASSERT_EQ(result.status, 0) << result.err;
  const json s = summary();
  const json &fault = s["strokes"][0], &branch = s["strokes"][1];
  EXPECT_EQ(fault["facets"]["requested"], fault["facets"]["opened"]);
  EXPECT_EQ(fault["facets"]["newly_opened"], fault["facets"]["opened"]);
  EXPECT_EQ(branch["facets"]["opened"].get<int>(),
            fault["facets"]["opened"].get<int>() + branch["facets"]["newly_opened"].get<int>());
  EXPECT_GT(fault["gap"]["mean"].get<double>(), 0.0);
  EXPECT_NE(fault["gap"]["mean"], fault["final_gap"]["mean"]);  // the branch let it open further
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/final.vtu.groups.json"));  // names "rock"

  // Another run into the same folder, whose mesh has no groups, leaves no stale names behind.
  ASSERT_EQ(run_scene("{" + kCube + "}").status, 0);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/final.vtu.groups.json"));
}

TEST_F(RunCommand, TheDemoScenesFitTheSchemaOfScenes) {
  expect_valid(data("liver.scene.json"), "cleave-scene-1.schema.json");
  expect_valid(data("cube.scene.json"), "cleave-scene-1.schema.json");
}

TEST_F(RunCommand, AMeshAloneIsWrittenAndNothingElseIsBuilt) {
  ASSERT_EQ(run_scene("{" + kCube + "}").status, 0);
  const json s = summary();
  EXPECT_EQ(part_names(s), (Names{"mesh", "vtu"}));
  EXPECT_EQ(s["cut_regular"], nullptr);
  EXPECT_TRUE(s["solves"].empty());
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/index.html"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/final.vtu"));
  expect_valid_summary("out");
}

TEST_F(RunCommand, OnlyWhatTheSceneNamesIsWritten) {
  ASSERT_EQ(run_scene("{" + kCube + R"(, "output": {"frames": "final", "page": true}})").status, 0);
  Names names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "out"))
    names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (Names{"final.vtu", "index.html", "summary.json"}));
}

TEST_F(RunCommand, AnExistingFolderKeepsItsOtherFiles) {
  std::filesystem::create_directories(folder_ / "out");
  write("out/mine.txt", "mine");
  write("out/final.vtu", "old");
  ASSERT_EQ(run_scene("{" + kCube + "}").status, 0);
  EXPECT_EQ(read("out/mine.txt"), "mine");
  EXPECT_NE(read("out/final.vtu"), "old");
}

TEST_F(RunCommand, AFailedSolveIsStatusOne) {
  const Outcome floating = run_scene("{" + kCube + R"(, "material": {"lambda": 1, "mu": 1},
    "solve": {}})");
  EXPECT_EQ(floating.status, 1) << floating.err;
  EXPECT_NE(floating.out.find("unsupported_piece"), std::string::npos) << floating.out;
  EXPECT_NE(floating.out.find("6 free rigid motions"), std::string::npos) << floating.out;
  EXPECT_EQ(floating.out.find("load removed"), std::string::npos) << floating.out;
  EXPECT_EQ(summary()["solves"][0]["outcome"], "unsupported_piece");
  expect_valid_summary("out");
  const Outcome quiet = cleave({"run", "s.json", "-o", "out", "--quiet"});
  EXPECT_EQ(quiet.status, 1);
  EXPECT_TRUE(quiet.out.empty()) << quiet.out;
  EXPECT_NE(quiet.err.find("nothing holds 1 piece"), std::string::npos) << quiet.err;
}

TEST_F(RunCommand, AStrokeThatMissesIsAWarning) {
  const Outcome missed = run_scene("{" + kPulled + R"(,
    "strokes": [{"blade": [[[9,9,9],[9,9,8]],[[9,8,9],[9,8,8]]]}]})");
  EXPECT_EQ(missed.status, 0) << missed.err;
  EXPECT_NE(missed.err.find("misses the body"), std::string::npos) << missed.err;
  EXPECT_EQ(summary()["strokes"][0]["facets"]["requested"], 0);
}

TEST_F(RunCommand, BadScenesAreRefusedAndNothingIsWritten) {
  expect_refused("{" + kCube + R"(, "strokse": []})", {"s.json", "/strokse", "strokes"});
  expect_refused("{" + kCube + ",\n \"loads\": [NaN]}", {"s.json", "line 2"});
  expect_refused("{" + kCube + R"(, "material": {"lambda": 1, "mu": -1}})", {"/material", "mu"});
  expect_refused("{" + kCube + R"(, "material": {"lambda": 1, "mu": -1e-9}})", {"mu is -1e-09"});
  expect_refused("{" + kCube + R"(, "supports": [{"where": {"group": "no"}}],
    "material": {"lambda": 1, "mu": 1}, "solve": {}})",
                 {"/supports/0", "\"no\""});
  expect_refused("{" + kPulled + R"(, "strokes": [{"group": "no"}]})", {"/strokes/0", "\"no\""});
  expect_refused(R"({"mesh": {"file": "none.mesh"}})", {"none.mesh"});
  expect_refused("{" + kCube + R"(, "material": {"lambda": 1, "mu": 1}, "solve": {}, "supports": [
    {"where": {"vertices": [5]}}, {"where": {"vertices": [5]}, "axes": ["x"], "value": 1}]})",
                 {"vertex 5", "/supports/0", "/supports/1"});
  EXPECT_EQ(cleave({"run", "none.json", "-o", "out"}).status, 3);
  EXPECT_EQ(cleave({"run", "s.json"}).status, 2);
}

TEST_F(RunCommand, ACellWithoutMaterialIsNamed) {
  write("two.mesh", medit({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}}, {},
                          {{1, 2, 3, 4, 7}, {1, 3, 2, 5, 8}}));
  const std::string scene = R"({"mesh": {"file": "two.mesh"}, "material": {"groups": {)";
  expect_refused(scene + R"("5": {"lambda": 1, "mu": 1}}}})",
                 {"/material/groups/5", "cell group \"5\"", "\"7\", \"8\""});
  expect_refused(scene + R"("7": {"lambda": 1, "mu": 1}}}})",
                 {"cell 2 of", "no material", "group \"8\""});
}

TEST_F(RunCommand, ASurfaceIsRefused) {
  write("band.mesh", band(6, false));
  expect_refused(R"({"mesh": {"file": "band.mesh"}})", {"band.mesh", "triangles", "volume"});
}

TEST_F(RunCommand, AFileThatCannotBeReplacedLeavesTheFolderAsItWas) {
  std::filesystem::create_directories(folder_ / "out" / "summary.json");
  const Outcome outcome = run_scene("{" + kCube + "}");
  EXPECT_EQ(outcome.status, 3);
  EXPECT_NE(outcome.err.find("summary.json"), std::string::npos) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out" / "final.vtu"));
}

TEST_F(RunCommand, WhatCannotBeWrittenIsSaid) {
  const Outcome device = run_scene("{" + kCube + "}", "/dev/full");
  EXPECT_EQ(device.status, 3);
  EXPECT_NE(device.err.find("/dev/full"), std::string::npos) << device.err;
  write("s.json", "{" + kCube + "}");
  const Outcome full =
      run({"sh", "-c", std::string(CLEAVE_COMMAND) + " run s.json -o out > /dev/full"});
  EXPECT_EQ(full.status, 3) << full.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

}  // namespace
}  // namespace cleave::app::test
