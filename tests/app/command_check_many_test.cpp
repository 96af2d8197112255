#include <filesystem>
#include <nlohmann/json.hpp>

#include "command_support.hpp"

namespace cleave::app::test {
namespace {

using nlohmann::json;

std::string one_tetrahedron(bool inverted) {
  return medit({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {},
               {inverted ? Tuple{1, 3, 2, 4, 0} : Tuple{1, 2, 3, 4, 0}});
}

// Two tetrahedra that meet in the places 1 2 3, where each has vertices of its own.
std::string two_separate_tetrahedra(double gap) {
  return medit({{0, 0, gap},
                {1, 0, gap},
                {0, 1, gap},
                {0, 0, 1},
                {0, 0, 0},
                {1, 0, 0},
                {0, 1, 0},
                {0, 0, -1}},
               {}, {{1, 2, 3, 4, 0}, {5, 7, 6, 8, 0}});
}

class CheckMany : public CommandTest {
 protected:
  void put(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((folder_ / name).parent_path());
    write(name, text);
  }

  // The JSON reports of `cleave check ARGS..`, as a list even of one.
  json reports(std::vector<std::string> args, int status) const {
    args.insert(args.begin(), "check");
    args.insert(args.end(), {"--json", "-"});
    const Outcome outcome = cleave(args);
    EXPECT_EQ(outcome.status, status) << outcome.out << outcome.err;
    const json all = json::parse(outcome.out);
    return all.is_array() ? all : json::array({all});
  }

  static std::vector<std::string> names(const json& reports) {
    std::vector<std::string> files;
    for (const json& report : reports) files.push_back(report["mesh"]["file"]);
    return files;
  }
};

using Names = std::vector<std::string>;

TEST_F(CheckMany, TakesFoldersInOrderAndLeavesOutWhatIsNoMesh) {
  for (const char* name : {"m/b.mesh", "m/a/z.mesh", "m/a/y.mesh", "m/c.MESH"})
    put(name, two_tetrahedra());
  for (const char* name : {"m/notes.txt", "m/b.groups.json", "m/.hidden/x.mesh", "m/.h.mesh"})
    put(name, "no mesh");
  std::filesystem::create_directory_symlink("..", folder_ / "m/up");
  EXPECT_EQ(names(reports({"m"}, 0)), (Names{"m/a/y.mesh", "m/a/z.mesh", "m/b.mesh", "m/c.MESH"}));
  EXPECT_EQ(names(reports({"."}, 0)), (Names{"m/a/y.mesh", "m/a/z.mesh", "m/b.mesh", "m/c.MESH"}));
  // Each file once, where it is named first.
  EXPECT_EQ(names(reports({"m/b.mesh", "m/", "m/a/../b.mesh"}, 0)),
            (Names{"m/b.mesh", "m/a/y.mesh", "m/a/z.mesh", "m/c.MESH"}));
  EXPECT_EQ(names(reports({"m", "--exclude", "a", "--exclude", "*.MESH"}, 0)), (Names{"m/b.mesh"}));
  EXPECT_EQ(names(reports({"--exclude", "m/a/z*", "m"}, 0)),
            (Names{"m/a/y.mesh", "m/b.mesh", "m/c.MESH"}));
  EXPECT_EQ(names(reports({"m/b.mesh", "--exclude", "b.*"}, 0)), Names{});

  put("empty/readme.txt", "");
  const Outcome nothing = cleave({"check", "empty"});
  EXPECT_EQ(nothing.status, 3);
  EXPECT_NE(nothing.err.find("'empty'"), std::string::npos) << nothing.err;
}

TEST_F(CheckMany, GoesOnAfterAFileThatCannotBeRead) {
  put("m/a.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices\n7\n");
  put("m/b.mesh", one_tetrahedron(true));
  put("m/c.mesh", two_tetrahedra());
  const json all = reports({"m"}, 3);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_NE(all[0]["unreadable"].get<std::string>().find("a.mesh:"), std::string::npos);
  EXPECT_EQ(all[1]["violations"][0]["rule"], "inverted-cell");
  EXPECT_TRUE(all[2]["violations"].empty());

  const Outcome text = cleave({"check", "m"});
  EXPECT_EQ(text.status, 3);
  EXPECT_NE(text.err.find("a.mesh"), std::string::npos);
  EXPECT_NE(text.out.find("3 meshes checked, 1 of them cannot be read: 1 error in 1 mesh"),
            std::string::npos)
      << text.out;
  EXPECT_NE(text.out.find("cleave check --explain inverted-cell"), std::string::npos);
}

TEST_F(CheckMany, ReadsItsConfigurationFromTheFoldersAbove) {
  put("p/.cleave-check.json", R"({
    "comment": "for all meshes of this project",
    "severity": {"inverted-cell": "warning"},
    "exclude": ["drafts"],
    "overrides": [{"files": ["strict/**"], "severity": {"inverted-cell": "error"}},
                  {"files": ["loose.mesh"], "severity": {"inverted-cell": "off"}}]})");
  for (const char* name : {"p/a.mesh", "p/strict/b.mesh", "p/strict/loose.mesh", "p/drafts/c.mesh"})
    put(name, one_tetrahedron(true));
  const Outcome outcome =
      run({"/bin/sh", "-c", "cd p/strict && '" CLEAVE_COMMAND "' check .. --json -"});
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  const json all = json::parse(outcome.out);
  EXPECT_EQ(names(all), (Names{"../a.mesh", "../strict/b.mesh", "../strict/loose.mesh"}));
  EXPECT_EQ(all[0]["violations"][0]["severity"], "warning");
  EXPECT_EQ(all[1]["violations"][0]["severity"], "error");
  EXPECT_TRUE(all[2]["violations"].empty());

  // The command line wins; elsewhere the file is not found, unless it is named.
  EXPECT_EQ(reports({"p/a.mesh"}, 1)[0]["violations"][0]["severity"], "error");
  EXPECT_EQ(reports({"p/a.mesh", "--config", "p/.cleave-check.json"}, 0)[0]["violations"].size(),
            1u);
  EXPECT_EQ(reports({"p/strict/b.mesh", "--config", "p/.cleave-check.json", "--severity",
                     "inverted-cell=note"},
                    0)[0]["violations"][0]["severity"],
            "note");
}

TEST_F(CheckMany, ChangesLevelsAndThresholds) {
  put("t.mesh", medit({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1e-3}}, {}, {{1, 2, 3, 4, 0}}));
  put("c.json", R"({"flat_ratio": 0.01, "require": "manifold", "betti": "never"})");
  EXPECT_TRUE(reports({"t.mesh"}, 0)[0]["violations"].empty());
  const json report = reports({"t.mesh", "--config", "c.json"}, 1)[0];
  EXPECT_EQ(report["violations"][0]["rule"], "flat-cell");
  EXPECT_TRUE(report["topology"]["betti"].is_null());
  EXPECT_EQ(
      reports({"t.mesh", "--config", "c.json", "--betti", "always"}, 1)[0]["topology"]["betti"],
      (json{1, 0, 0, 0}));
  put("s.mesh", suspended_annulus());
  EXPECT_EQ(reports({"s.mesh", "--config", "c.json"}, 1)[0]["violations"][0]["severity"], "error");
  EXPECT_EQ(reports({"s.mesh", "--config", "c.json", "--require", "cut-regular"},
                    0)[0]["violations"][0]["severity"],
            "warning");
}

TEST_F(CheckMany, ShowsAsManyFindingsAsAskedFor) {
  put("m.mesh", two_separate_tetrahedra(0));
  const auto lines = [&](const std::vector<std::string>& more) {
    std::vector<std::string> args{"check", "m.mesh", "--quiet"};
    args.insert(args.end(), more.begin(), more.end());
    const std::string out = cleave(args).out;
    return std::count(out.begin(), out.end(), '\n');
  };
  put("c.json", R"({"max_findings": 2})");
  EXPECT_EQ(lines({}), 3);
  EXPECT_EQ(lines({"--max-findings", "1"}), 2);  // and a line that counts the others
  EXPECT_EQ(lines({"--config", "c.json"}), 3);
  EXPECT_EQ(lines({"--config", "c.json", "--max-findings", "3"}), 3);
}

TEST_F(CheckMany, CountsFindingsThatAreNotShown) {
  put("m.mesh", one_tetrahedron(true));
  const Outcome none = cleave({"check", "m.mesh", "--max-findings", "0", "--junit", "j.xml"});
  EXPECT_EQ(none.status, 1);
  EXPECT_NE(none.out.find("inverted-cell: 1 finding, not shown; --json"), std::string::npos)
      << none.out;
  EXPECT_NE(read("j.xml").find("1 finding, not shown"), std::string::npos) << read("j.xml");
  for (const char* wrong : {"-1", "1.5", "many", "", "99999999999999999999999"}) {
    const Outcome refused = cleave({"check", "m.mesh", "--max-findings", wrong});
    EXPECT_EQ(refused.status, 2) << wrong;
    EXPECT_NE(refused.err.find("whole number from 0 on"), std::string::npos) << refused.err;
  }
}

TEST_F(CheckMany, InsistsOnALevelAskedForOnTheCommandLine) {
  put("twice.mesh",
      medit({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {}, {{1, 2, 3, 4, 0}, {1, 2, 3, 4, 0}}));
  put("m.mesh", suspended_annulus());
  put("c.json", R"({"severity": {"duplicate-cell": "off", "facet-in-three-cells": "note"},
                    "overrides": [{"files": ["m.mesh"], "severity": {"bad-vertex-link": "off"}}]})");
  const auto check = [&](const std::string& mesh, std::vector<std::string> more, int status) {
    more.insert(more.begin(), {mesh, "--config", "c.json"});
    return reports(more, status)[0]["violations"];
  };
  EXPECT_TRUE(check("twice.mesh", {}, 0).empty());
  EXPECT_EQ(check("twice.mesh", {"--require", "pseudo-manifold"}, 1)[0]["rule"], "duplicate-cell");
  EXPECT_TRUE(check("m.mesh", {}, 0).empty());
  EXPECT_TRUE(check("m.mesh", {"--require", "edge-regular"}, 0).empty());  // the rule is above it
  EXPECT_EQ(check("m.mesh", {"--require", "manifold"}, 1)[0]["severity"], "error");
  EXPECT_TRUE(
      check("m.mesh", {"--require", "manifold", "--severity", "bad-vertex-link=off"}, 0).empty());
}

TEST_F(CheckMany, RefusesConfigurationsThatSayNothing) {
  put("m.mesh", two_tetrahedra());
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {R"({"severty": {}})", "severty"},
      {R"({"severity": {"bad-luck": "off"}})", "/severity/bad-luck"},
      {R"({"severity": {"flat-cell": "fatal"}})", "/severity/flat-cell"},
      {R"({"flat_ratio": -1})", "/flat_ratio"},
      {R"({"flat_ratio": "big"})", "/flat_ratio"},
      {R"({"coincident_distance": null})", "/coincident_distance"},
      {R"({"require": "perfect"})", "/require"},
      {R"({"max_findings": 1.5})", "/max_findings"},
      {R"({"exclude": "x"})", "/exclude"},
      {R"({"exclude": [""]})", "/exclude/0"},
      {R"({"overrides": [{"severity": {}}]})", "/overrides/0"},
      {R"({"overrides": [{"files": [], "exclude": []}]})", "/overrides/0/exclude"},
      {R"({"betti": "sometimes"})", "/betti"},
      {"{", "c.json"}};
  for (const auto& [text, place] : wrong) {
    put("c.json", text);
    const Outcome outcome = cleave({"check", "m.mesh", "--config", "c.json"});
    EXPECT_EQ(outcome.status, 3) << text;
    EXPECT_NE(outcome.err.find("c.json"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(place), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
  EXPECT_EQ(cleave({"check", "m.mesh", "--config", "missing.json"}).status, 3);
  EXPECT_EQ(cleave({"check", "m.mesh", "--severity", "flat-cell"}).status, 2);
  EXPECT_EQ(cleave({"check", "m.mesh", "--severity", "flat=off"}).status, 2);
  EXPECT_EQ(cleave({"check", "m.mesh", "--json", "x", "--sarif", "x"}).status, 2);
  EXPECT_EQ(cleave({"check", ".", "--junit", "m.mesh"}).status, 3);
  EXPECT_EQ(read("m.mesh"), two_tetrahedra());
  EXPECT_EQ(cleave({"check"}).status, 2);
}

TEST_F(CheckMany, WarnsOfSeparateVerticesInOnePlace) {
  put("m.mesh", two_separate_tetrahedra(0));
  const json report = reports({"m.mesh"}, 0)[0];
  ASSERT_EQ(report["violations"].size(), 3u);
  EXPECT_EQ(report["violations"][0]["rule"], "coincident-vertices");
  EXPECT_EQ(report["violations"][0]["severity"], "warning");
  EXPECT_EQ(report["violations"][0]["witness"]["vertices"], (json{1, 5}));
  EXPECT_EQ(report["violations"][0]["witness"]["distance"], 0.0);

  put("near.mesh", two_separate_tetrahedra(1e-7));
  put("c.json", R"({"coincident_distance": 1e-6})");
  EXPECT_TRUE(reports({"near.mesh"}, 0)[0]["violations"].empty());
  EXPECT_EQ(reports({"near.mesh", "--config", "c.json"}, 0)[0]["violations"].size(), 3u);
}

TEST_F(CheckMany, TakesCoincidencesThatACutMadeForMeant) {
  ASSERT_EQ(cleave({"cut", data("fault.msh"), "-o", "open.msh", "--group", "fault"}).status, 0);
  const json groups = reports({"open.msh"}, 0)[0];
  ASSERT_FALSE(groups["violations"].empty());
  for (const json& violation : groups["violations"]) {
    EXPECT_EQ(violation["rule"], "coincident-vertices");
    EXPECT_EQ(violation["severity"], "note") << violation;
  }
  // The point data `parent` says it as well.
  ASSERT_EQ(cleave({"cut", data("fault.msh"), "-o", "open.vtu", "--group", "fault"}).status, 0);
  const json carried = reports({"open.vtu"}, 0)[0];
  for (const json& violation : carried["violations"])
    EXPECT_EQ(violation["severity"], "note") << violation;
}

TEST_F(CheckMany, SaysWhichRulesAreUndecided) {
  put("m.mesh",
      medit({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {}, {{1, 2, 3, 4, 0}, {1, 2, 2, 4, 0}}));
  EXPECT_EQ(reports({"m.mesh"}, 1)[0]["undecided"].size(), 7u);
  EXPECT_NE(
      cleave({"check", "m.mesh"}).out.find("undecided until these are mended: duplicate-cell"),
      std::string::npos);
  put("m.mesh", two_tetrahedra());
  EXPECT_TRUE(reports({"m.mesh"}, 0)[0]["undecided"].empty());
}

TEST_F(CheckMany, ListsAndExplainsRules) {
  const Outcome list = cleave({"check", "--rules"});
  EXPECT_EQ(list.status, 0);
  EXPECT_NE(list.out.find("coincident-vertices   warning"), std::string::npos) << list.out;
  const Outcome text = cleave({"check", "--explain", "flat-cell", "orphan-vertex"});
  EXPECT_EQ(text.status, 0);
  EXPECT_NE(text.out.find("How to mend it"), std::string::npos);
  EXPECT_NE(text.out.find("orphan-vertex: no cell uses a vertex"), std::string::npos);
  const Outcome unknown = cleave({"check", "--explain", "bad-luck"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find("flat-cell"), std::string::npos);
}

}  // namespace
}  // namespace cleave::app::test
