// Reading of scene files: what is accepted, and what each refusal says.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <variant>
#include <vector>

#include "error.hpp"
#include "scene.hpp"

namespace cleave::app {
namespace {

Scene parsed(const std::string& text) { return parse_scene(text, "s.json", "folder"); }

// The message with which `text` is refused; a test failure if it is not.
std::string refusal(const std::string& text) {
  try {
    parsed(text);
  } catch (const InputError& e) {
    return e.what();
  }
  ADD_FAILURE() << "accepted: " << text;
  return {};
}

const std::string kMesh = R"("mesh": {"cube": {"nodes": [2,2,2], "size": [1,1,1]}})";

std::string with_mesh(const std::string& more) { return "{" + kMesh + ", " + more + "}"; }

TEST(Scene, TheMeshAloneIsAScene) {
  const Scene scene = parsed("{" + kMesh + "}");
  EXPECT_EQ(scene.title, "s");
  EXPECT_EQ(std::get<CubeSpec>(scene.mesh).nodes[0], 2u);
  EXPECT_TRUE(scene.materials.empty());
  EXPECT_TRUE(scene.strokes.empty());
  EXPECT_FALSE(scene.solve.has_value());
  EXPECT_TRUE(scene.output.vtu);
  EXPECT_FALSE(scene.output.page);
}

TEST(Scene, PathsAreRelativeToItsFolder) {
  EXPECT_EQ(std::get<std::filesystem::path>(parsed(R"({"mesh": {"file": "a.mesh"}})").mesh),
            std::filesystem::path("folder/a.mesh"));
  EXPECT_EQ(std::get<std::filesystem::path>(parsed(R"({"mesh": {"file": "/b/a.mesh"}})").mesh),
            std::filesystem::path("/b/a.mesh"));
}

TEST(Scene, EveryPartIsRead) {
  const Scene scene = parsed(with_mesh(R"(
    "comment": ["any object", "may have one"], "title": "T",
    "material": {"young": 5, "poisson": 0.25, "density": 3},
    "supports": [{"where": {"half_space": {"point": [0,0,0], "normal": [0,0,-1]}}, "axes": ["x","z"],
                  "value": 0.5}, {"where": {"vertices": [7]}}],
    "loads": [{"where": {"group": "g"}, "traction": [1,2,3]}, {"gravity": [0,0,-9.81]},
              {"where": {"box": [[0,0,0],[1,1,1]]}, "total_force": [1,0,0]}],
    "strokes": [{"name": "first", "blade": [[[0,0,0],[1,0,0]],[[0,1,0],[1,1,0]]],
                 "select": "nearest-vertex", "ties": "both", "snap": false},
                {"facets": [[0,1,2]]}, {"group": ["a","b"]}],
    "solve": {"tolerance": 1e-6, "norm": "energy", "preconditioner": "none", "formulation": "p1",
              "max_iterations": 7, "on_unsupported": "modulo_free_modes"},
    "output": {"vtu": false, "frames": "final", "page": true})"));
  EXPECT_EQ(scene.title, "T");
  ASSERT_EQ(scene.materials.size(), 1u);
  EXPECT_DOUBLE_EQ(scene.materials[0].lame.mu, 2.0);
  EXPECT_DOUBLE_EQ(scene.materials[0].lame.lambda, 2.0);
  EXPECT_EQ(scene.materials[0].density, 3.0);
  ASSERT_EQ(scene.supports.size(), 2u);
  EXPECT_EQ(scene.supports[0].axes, (std::array<bool, 3>{true, false, true}));
  EXPECT_EQ(scene.supports[1].axes, (std::array<bool, 3>{true, true, true}));
  ASSERT_EQ(scene.loads.size(), 3u);
  EXPECT_EQ(scene.loads[0].kind, LoadSpec::Kind::traction);
  EXPECT_FALSE(scene.loads[1].where.has_value());
  ASSERT_EQ(scene.strokes.size(), 3u);
  EXPECT_EQ(scene.strokes[0].select.rule, cutting::Rule::nearest_vertex);
  EXPECT_EQ(scene.strokes[0].select.ties, cutting::Ties::both);
  EXPECT_EQ(std::get<BladePath>(scene.strokes[0].path).positions.size(), 2u);
  EXPECT_EQ(scene.strokes[1].name, "stroke 2");
  EXPECT_EQ(std::get<GroupNames>(scene.strokes[2].path).names.size(), 2u);
  ASSERT_TRUE(scene.solve.has_value());
  EXPECT_EQ(scene.solve->norm, SolveSpec::Norm::energy);
  EXPECT_EQ(scene.solve->max_iterations, 7u);
  EXPECT_EQ(scene.output.frames, OutputSpec::Frames::final_only);
}

struct Refused {
  std::string scene;
  std::vector<std::string> said;  // words that the message must hold
};

class SceneRefuses : public testing::TestWithParam<Refused> {};

TEST_P(SceneRefuses, AndSaysWhatWhereAndWhatIsKnown) {
  const std::string message = refusal(GetParam().scene);
  EXPECT_EQ(message.find("s.json: "), 0u) << message;
  for (const auto& word : GetParam().said)
    EXPECT_NE(message.find(word), std::string::npos) << word << " is missing in: " << message;
}

const std::string kLame = R"("material": {"lambda": 1, "mu": 1})";

INSTANTIATE_TEST_SUITE_P(
    Scene, SceneRefuses,
    testing::Values(
        Refused{"{}", {"mesh"}}, Refused{"{\"mesh\":\n{\"file\": }}", {"line 2"}},
        Refused{"", {"not JSON"}}, Refused{"[]", {"object"}},
        Refused{with_mesh(R"("strikes": [])"), {"/strikes", "\"strikes\"", "strokes", "supports"}},
        Refused{with_mesh(R"("supports": [{"where": {"vertices": [1]}, "axis": ["x"]}])"),
                {"/supports/0/axis", "known here: where, axes, value"}},
        Refused{with_mesh(R"("supports": [{"where": {"vertices": [1]}, "axes": ["w"]}])"),
                {"/supports/0/axes/0", "x, y, z"}},
        Refused{with_mesh(R"("supports": [{"where": {"vertices": [-1]}}])"),
                {"/supports/0/where/vertices/0"}},
        Refused{with_mesh(R"("supports": [{"where": {"box": [[1,0,0],[0,1,1]]}}])"),
                {"/supports/0/where/box", "lower"}},
        Refused{with_mesh(R"("supports": [{"where": {"group": "a", "vertices": [1]}}])"),
                {"/supports/0/where", "exclude"}},
        Refused{with_mesh(R"("material": {"lambda": 1, "mu": -1})"), {"/material", "mu", "-1"}},
        Refused{with_mesh(R"("material": {"lambda": 1, "mu": NaN})"), {"line 1"}},
        Refused{with_mesh(R"("material": {"lambda": 1, "mu": 1e999})"), {"1e999"}},
        Refused{with_mesh(R"("material": {"young": 1, "poisson": 0.5})"), {"/material", "0.5"}},
        Refused{with_mesh(R"("material": {"young": 1, "mu": 0.5})"), {"/material", "not both"}},
        Refused{with_mesh(R"("material": {"groups": {"a/b": {"lambda": 1}}})"),
                {"/material/groups/a~1b", "mu"}},
        Refused{with_mesh(R"("material": {"lambda": "1", "mu": 1})"),
                {"/material/lambda", "string"}},
        Refused{with_mesh(R"("material": {"lambda": 1, "lambda": 2, "mu": 1})"),
                {"lambda", "twice"}},
        Refused{with_mesh(R"("loads": [{"force": [0,0,1]}])"), {"/loads/0", "where"}},
        Refused{with_mesh(R"("loads": [{"where": {"vertices": [1]}, "force": [0,1]}])"),
                {"/loads/0/force", "three numbers"}},
        Refused{with_mesh(R"("strokes": [{"blade": [[[0,0,0],[1,0,0]]]}])"),
                {"/strokes/0/blade", "two positions"}},
        Refused{with_mesh(R"("strokes": [{"group": "a", "select": "dual-edge"}])"),
                {"/strokes/0/select", "blade"}},
        Refused{with_mesh(R"("strokes": [{"group": "a", "snap": true}])"),
                {"/strokes/0/snap", "unknown value", "false"}},
        Refused{with_mesh(kLame + R"(, "solve": {"preconditioner": "multilevel"})"),
                {"/solve/preconditioner", "\"multilevel\"", "none, jacobi"}},
        Refused{with_mesh(kLame + R"(, "solve": {"formulation": "nodal-pressure"})"),
                {"/solve/formulation", "p1"}},
        Refused{with_mesh(kLame + R"(, "solve": {"tolerance": 0})"), {"/solve/tolerance"}},
        Refused{with_mesh(R"("solve": {})"), {"/solve", "material"}},
        Refused{R"({"mesh": {"cube": {"nodes": [1,2,2], "size": [1,1,1]}}})",
                {"/mesh/cube/nodes/0", "at least 2"}},
        Refused{R"({"mesh": {"file": "a", "cube": {}}})", {"/mesh", "exclude"}}));

TEST(Scene, TheExamplesOfTheGuideAreScenes) {
  std::ifstream in(CLEAVE_DATA "/../docs/scenes.md");
  const std::string guide{std::istreambuf_iterator<char>(in), {}};
  const std::string open = "```json\n", close = "```";
  int examples = 0;
  for (auto at = guide.find(open); at != std::string::npos; at = guide.find(open, at + 1)) {
    const auto begin = at + open.size();
    parsed(guide.substr(begin, guide.find(close, begin) - begin));
    ++examples;
  }
  EXPECT_EQ(examples, 3);
}

TEST(Scene, AMissingFileIsNamed) {
  try {
    read_scene("nowhere/none.scene.json");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("nowhere/none.scene.json"), std::string::npos);
  }
}

}  // namespace
}  // namespace cleave::app
