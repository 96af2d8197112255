#include <nlohmann/json.hpp>
#include <set>

#include "command_support.hpp"

namespace cleave::app::test {
namespace {

using nlohmann::json;

// What the command writes is what docs/schemas promises, and what it reads is what they allow.
class Schema : public CommandTest {
 protected:
  void SetUp() override {
    write("empty.json", "{}");
    if (validate("cleave-cut-1", "empty.json").status == 77)
      GTEST_SKIP() << "python3-jsonschema is not installed";
  }

  Outcome validate(const std::string& schema, const std::string& file) const {
    return run({"/usr/bin/python3", CLEAVE_VALIDATE_JSON,
                CLEAVE_SCHEMAS "/" + schema + ".schema.json", file});
  }

  void expect_valid(const std::string& schema, const std::string& file) const {
    const Outcome outcome = validate(schema, file);
    EXPECT_EQ(outcome.status, 0) << file << " against " << schema << ":\n" << outcome.err;
  }

  void expect_invalid(const std::string& schema, const std::string& text) const {
    write("changed.json", text);
    EXPECT_EQ(validate(schema, "changed.json").status, 1) << text;
  }
};

TEST_F(Schema, HoldsForCheckReportsWithEveryRule) {
  const std::vector<Point> points{{0, 0, 0},  {1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                                  {0, 0, -1}, {1, 1, 0}, {9, 9, 9}};
  const std::vector<std::string> meshes{
      two_tetrahedra(),
      medit(points, {}, {{1, 2, 3, 4, 0}, {1, 2, 3, 5, 0}}),
      medit(points, {}, {{1, 2, 3, 6, 0}}),
      medit(points, {}, {{1, 2, 3, 4, 0}, {2, 3, 1, 4, 0}}),
      medit(points, {}, {{1, 2, 2, 4, 0}}),
      medit(points, {}, {{1, 2, 3, 4, 0}, {1, 3, 2, 5, 0}, {1, 2, 3, 7, 0}}),
      "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 nan 0 0\n0 1 0 0\n0 0 1 0\n"
      "Tetrahedra\n1\n1 2 3 4 0\nEnd\n",
      medit(
          {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}, {5, 0, 0}, {0, 5, 0}, {0, 0, 5}},
          {}, {{1, 2, 3, 4, 0}, {5, 6, 7, 8, 0}}),
      "no mesh",
      suspended_annulus(),
      solid_band(6)};
  std::vector<std::string> all{"check", data("liver-16k.mesh")};
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const std::string name = std::to_string(i) + ".mesh";
    write(name, meshes[i]);
    cleave({"check", name, "--json", "one.json"});
    expect_valid("cleave-check-1", "one.json");
    all.push_back(name);
  }
  all.insert(all.end(), {"--json", "all.json"});
  cleave(all);
  expect_valid("cleave-check-1", "all.json");

  std::set<std::string> rules;
  json reports = json::parse(read("all.json"));
  for (const json& report : reports)
    if (report.contains("violations"))
      for (const json& violation : report["violations"]) rules.insert(violation["rule"]);
  EXPECT_EQ(rules, (std::set<std::string>{"degenerate-cell", "duplicate-cell",
                                          "facet-in-three-cells", "orientation-conflict",
                                          "non-orientable", "not-cut-regular", "pinched-edge",
                                          "bad-vertex-link", "orphan-vertex", "inverted-cell",
                                          "flat-cell", "not-finite", "coincident-vertices"}));
  reports[0]["violations"][0]["rule"] = "bad-luck";
  expect_invalid("cleave-check-1", reports.dump());
  reports[0]["violations"][0]["rule"] = "not-cut-regular";
  reports[0]["violations"][0]["witness"].erase("parts");
  expect_invalid("cleave-check-1", reports.dump());
}

TEST_F(Schema, AllowsTheConfigurationsThatCheckTakes) {
  write("m.mesh", two_tetrahedra());
  const auto status = [&](const std::string& text) {
    write("c.json", text);
    return cleave({"check", "m.mesh", "--config", "c.json"}).status;
  };
  for (
      const std::string text :
      {R"({})",
       R"({"comment": ["two", "lines"], "severity": {"flat-cell": "off"}, "betti": "never"})",
       R"({"require": "manifold", "flat_ratio": 1e-6, "coincident_distance": 0, "max_findings": 3})",
       R"({"exclude": ["a*"], "overrides": [{"files": ["b"], "severity": {}, "comment": "x"}]})"}) {
    EXPECT_EQ(status(text), 0) << text;
    expect_valid("cleave-check-config-1", "c.json");
  }
  for (const std::string text :
       {R"({"flat-ratio": 1})", R"({"severity": {"flat": "off"}})", R"({"betti": true})",
        R"({"max_findings": -1})", R"({"overrides": [{}]})", R"([])"}) {
    EXPECT_EQ(status(text), 3) << text;
    expect_invalid("cleave-check-config-1", text);
  }
}

TEST_F(Schema, HoldsForVerdictsOnCertificates) {
  write("m.mesh", two_tetrahedra());
  cleave({"cut", "m.mesh", "--all", "--dry-run", "--certificate", "c.cert"});
  EXPECT_EQ(cleave({"certify", "c.cert", "--json", "verdict.json"}).out, "accepted\n");
  expect_valid("cleave-certify-1", "verdict.json");
  json verdict = json::parse(read("verdict.json"));
  verdict["accepted"] = false;
  expect_invalid("cleave-certify-1", verdict.dump());
  const std::string text = read("c.cert");
  const std::string rows = text.substr(0, text.rfind("\nend\n"));
  for (const std::string& after : {rows.substr(0, rows.rfind(' ')) + " 1", rows + "\n1 2 3 4"}) {
    write("c.cert", after + "\nend\n");
    EXPECT_EQ(cleave({"certify", "c.cert", "--json", "verdict.json"}).status, 1);
    expect_valid("cleave-certify-1", "verdict.json");
  }
}

TEST_F(Schema, HoldsForCutReports) {
  write("m.mesh", medit({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1, 1, 1}}, {},
                        {{1, 2, 3, 5, 0}, {1, 4, 2, 5, 0}, {2, 4, 3, 5, 0}, {1, 3, 4, 5, 0}}));
  write("f.json", R"({"comment": "shut", "facets": [[1, 2, 5]]})");
  expect_valid("facets", "f.json");
  cleave({"cut", "m.mesh", "--facets", "f.json", "--dry-run", "--json", "shut.json"});
  expect_valid("cleave-cut-1", "shut.json");
  cleave({"cut", data("fault.msh"), "--group", "fault", "branch", "--dry-run", "--explain",
          "--json", "opened.json"});
  expect_valid("cleave-cut-1", "opened.json");
  write("torus.mesh", solid_torus_with_moebius_band());
  cleave({"cut", "torus.mesh", "--group", "9", "--dry-run", "--json", "torus.json"});
  expect_valid("cleave-cut-1", "torus.json");
  write("s.json",
        R"({"blade": [[[-10, 20, 95], [-10, 160, 95]], [[110, 20, 100], [110, 160, 100]]]})");
  expect_valid("sweep", "s.json");
  cleave({"cut", data("liver-16k.mesh"), "--sweep", "s.json", "--dry-run", "--json", "liver.json"});
  expect_valid("cleave-cut-1", "liver.json");

  json report = json::parse(read("liver.json"));
  EXPECT_EQ(report["regularized"].size(), 3u);
  report["facets"]["opened"] = 1.5;
  expect_invalid("cleave-cut-1", report.dump());
}

TEST_F(Schema, HoldsForIncisionRecordsAndStitchReports) {
  write("f.json", R"({"facets": [[1, 2, 5]]})");
  write("m.mesh",
        medit({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1, 1, 1}, {9, 9, 9}}, {{1, 2, 6, 3}},
              {{1, 2, 3, 5, 0}, {1, 4, 2, 5, 0}, {2, 4, 3, 5, 0}, {1, 3, 4, 5, 0}}));
  cleave({"cut", "m.mesh", "-o", "shut.vtu", "--facets", "f.json", "--explain", "--fix-it",
          "more.json", "--json", "shut.json"});
  expect_valid("cleave-cut-1", "shut.json");
  expect_valid("facets", "more.json");
  expect_valid("cleave-incision-1", "shut.vtu.cleave.json");
  cleave({"cut", data("fault.msh"), "-o", "a.msh", "--group", "fault"});
  cleave({"cut", "a.msh", "-o", "b.mesh", "--group", "branch", "--keep", "fault", "--json",
          "on.json"});
  expect_valid("cleave-cut-1", "on.json");
  expect_valid("cleave-incision-1", "a.msh.cleave.json");
  expect_valid("cleave-incision-1", "b.mesh.cleave.json");
  cleave({"stitch", "b.mesh", "--dry-run", "--group", "fault", "--json", "stitch.json"});
  expect_valid("cleave-stitch-1", "stitch.json");

  json record = json::parse(read("a.msh.cleave.json"));
  record["opened"][0][0] = -1;
  expect_invalid("cleave-incision-1", record.dump());
  json stitch = json::parse(read("stitch.json"));
  stitch["merges"][0].erase("into");
  expect_invalid("cleave-stitch-1", stitch.dump());
}

TEST_F(Schema, AllowsWhatTheCommandReadsAndNothingElse) {
  write("m.mesh", two_tetrahedra());
  const auto status = [&](const std::string& option, const std::string& text) {
    write("request.json", text);
    return cleave({"cut", "m.mesh", "--dry-run", option, "request.json"}).status;
  };
  const std::string triangle = "[[[0,0,0],[1,0,0],[0,1,0]]]";
  for (const std::string& text :
       {std::string(R"({"facets": []})"), std::string(R"({"facets": [[1, 2, 3], [3, 2, 1]]})")}) {
    EXPECT_EQ(status("--facets", text), 0) << text;
    expect_valid("facets", "request.json");
  }
  for (const std::string& text :
       {R"({"triangles": )" + triangle + "}",
        R"({"triangles": )" + triangle + R"(, "step_of_triangle": [4]})"}) {
    EXPECT_EQ(status("--sweep", text), 0) << text;
    expect_valid("sweep", "request.json");
  }
  for (const std::string text : {R"({"facets": [[1, 2, "3"]]})", R"({"facets": 3})", R"({})"}) {
    EXPECT_EQ(status("--facets", text), 3) << text;
    expect_invalid("facets", text);
  }
  for (const std::string text : {R"({"blade": [[[0, 0, 0], [1, 0, 0]]]})", R"({"blades": []})",
                                 R"({"triangles": [], "blade": []})"}) {
    EXPECT_EQ(status("--sweep", text), 3) << text;
    expect_invalid("sweep", text);
  }
}

}  // namespace
}  // namespace cleave::app::test
