#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "check_rules.hpp"
#include "command_support.hpp"

namespace cleave::app::test {
namespace {

using nlohmann::json;

// A name as nasty as a file system allows: quotes, markup, a control character, bytes that are no
// UTF-8, and what a URI has to encode.
const std::string kNasty = "a \"<&'>\x01\xff#%?.mesh";

class CheckFormats : public CommandTest {
 protected:
  void SetUp() override {
    write("good.mesh", two_tetrahedra());
    write("bad.mesh",
          medit({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {9, 9, 9}}, {}, {{1, 3, 2, 4, 0}}));
    write("broken.mesh", "MeshVersionFormatted 2\n");
    write("crowd.mesh", medit({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {},
                              {{1, 2, 3, 4, 0}, {1, 2, 3, 4, 0}}));
    write("band.mesh", band(8, true));
    write(kNasty, medit({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {}, {{1, 3, 2, 4, 0}}));
  }

  void expect_sarif(const std::string& file) const {
    const Outcome outcome = run({"/usr/bin/python3", CLEAVE_VALIDATE_JSON,
                                 CLEAVE_FOREIGN_SCHEMAS "/sarif-2.1.0.schema.json", file});
    if (outcome.status == 77) GTEST_SKIP() << "python3-jsonschema is not installed";
    EXPECT_EQ(outcome.status, 0) << outcome.err;
  }

  void expect_junit(const std::string& file) const {
    const Outcome outcome =
        run({"xmllint", "--noout", "--schema", CLEAVE_FOREIGN_SCHEMAS "/junit.xsd", file});
    if (outcome.status == 127) GTEST_SKIP() << "xmllint is not installed";
    EXPECT_EQ(outcome.status, 0) << outcome.err;
  }

  // The value of an XPath expression in a file.
  std::string xpath(const std::string& file, const std::string& expression) const {
    std::string value = run({"xmllint", "--xpath", expression, file}).out;
    while (!value.empty() && value.back() == '\n') value.pop_back();
    return value;
  }
};

TEST_F(CheckFormats, SarifIsValidAndNamesRulesPlacesAndWitnesses) {
  EXPECT_EQ(cleave({"check", ".", "--sarif", "r.sarif"}).status, 3);
  expect_sarif("r.sarif");
  const json log = json::parse(read("r.sarif"));
  EXPECT_EQ(log["version"], "2.1.0");
  const json& run = log["runs"][0];
  const json& described = run["tool"]["driver"]["rules"];
  ASSERT_EQ(described.size(), rules().size());
  for (const json& rule : described) {
    EXPECT_FALSE(rule["help"]["markdown"].get<std::string>().empty());
    EXPECT_FALSE(rule["fullDescription"]["text"].get<std::string>().empty());
  }
  EXPECT_FALSE(run["invocations"][0]["executionSuccessful"]);
  EXPECT_NE(run["invocations"][0]["toolExecutionNotifications"][0]["message"]["text"]
                .get<std::string>()
                .find("broken.mesh"),
            std::string::npos);

  std::set<std::string> uris, fingerprints;
  std::size_t inverted = 0;
  for (const json& result : run["results"]) {
    EXPECT_EQ(described[result["ruleIndex"].get<std::size_t>()]["id"], result["ruleId"]);
    const json& artifact = result["locations"][0]["physicalLocation"]["artifactLocation"];
    uris.insert(artifact["uri"].get<std::string>());
    if (artifact["uri"] == "bad.mesh")
      fingerprints.insert(result["partialFingerprints"]["cleaveWitness/v1"].get<std::string>());
    if (result["ruleId"] == "inverted-cell") {
      ++inverted;
      EXPECT_EQ(result["level"], "error");
      EXPECT_EQ(result["locations"][0]["logicalLocations"][0]["fullyQualifiedName"], "cell 1");
      EXPECT_EQ(result["properties"]["witness"]["cell"], 1);
    }
  }
  EXPECT_EQ(inverted, 2u);
  EXPECT_EQ(fingerprints.size(), 2u);  // inverted-cell, orphan-vertex
  EXPECT_EQ(uris, (std::set<std::string>{"bad.mesh", "band.mesh", "crowd.mesh",
                                         "a%20%22%3C%26%27%3E%01%FF%23%25%3F.mesh"}));
}

TEST_F(CheckFormats, SarifIsTheSameOnEveryRunAndOutsideTheFolderHasFileUris) {
  ASSERT_EQ(cleave({"check", "bad.mesh", "--sarif", "a.sarif"}).status, 1);
  ASSERT_EQ(cleave({"check", folder_ / "bad.mesh", "--sarif", "b.sarif"}).status, 1);
  EXPECT_EQ(read("a.sarif"), read("b.sarif"));
  ASSERT_EQ(cleave({"check", data("liver-16k.mesh"), "--sarif", "c.sarif"}).status, 1);
  expect_sarif("c.sarif");
  const std::string uri =
      json::parse(read("c.sarif"))["runs"][0]["results"][0]["locations"][0]["physicalLocation"]
                                  ["artifactLocation"]["uri"];
  EXPECT_EQ(uri.rfind("file:///", 0), 0u) << uri;
}

TEST_F(CheckFormats, SarifSaysOnWhichLineAnElementStands) {
  const auto lines = [&](const std::string& name, const std::string& text) {
    write(name, text);
    cleave({"check", name, "--sarif", "r.sarif"});
    expect_sarif("r.sarif");
    std::map<std::string, std::string> line_of_rule;
    const std::string bytes = read(name);
    const json log = json::parse(read("r.sarif"));
    for (const json& result : log["runs"][0]["results"]) {
      const json& place = result["locations"][0]["physicalLocation"];
      if (!place.contains("region")) continue;
      std::istringstream in(bytes);
      std::string line;
      for (int i = 0; i < place["region"]["startLine"].get<int>(); ++i) std::getline(in, line);
      line_of_rule[result["ruleId"].get<std::string>()] = line;
    }
    return line_of_rule;
  };
  const auto medit_lines = lines("l.mesh",
                                 "MeshVersionFormatted 2 # a comment\nDimension\n3\n\nVertices\n5\n"
                                 "0 0 0 0\n1 0 0 0 # here\n0 1 0 0\n# between\n0 0 1 0\n7 7 7 0\n"
                                 "Triangles 1\n1 2 3 0\nTetrahedra\n1\n1 3 2 4 0\nEnd\n");
  EXPECT_EQ(medit_lines.at("inverted-cell"), "1 3 2 4 0");
  EXPECT_EQ(medit_lines.at("orphan-vertex"), "7 7 7 0");
  const auto old_lines =
      lines("l22.msh",
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n10 0 0 0\n20 1 0 0\n"
            "30 0 1 0\n40 0 0 1\n50 7 7 7\n$EndNodes\n$Elements\n2\n"
            "8 2 2 1 1 10 20 30\n9 4 2 2 1 10 30 20 40\n$EndElements\n");
  EXPECT_EQ(old_lines.at("inverted-cell"), "9 4 2 2 1 10 30 20 40");
  EXPECT_EQ(old_lines.at("orphan-vertex"), "50 7 7 7");
  const auto new_lines =
      lines("l41.msh",
            "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n2 5 10 50\n2 1 0 3\n10\n20\n30\n0 0 0\n"
            "1 0 0\n0 1 0\n3 1 0 2\n40\n50\n0 0 1\n7 7 7\n$EndNodes\n$Elements\n2 2 8 9\n2 1 2 1\n"
            "8 10 20 30\n3 1 4 1\n9 10 30 20 40\n$EndElements\n");
  EXPECT_EQ(new_lines.at("inverted-cell"), "9 10 30 20 40");
  EXPECT_EQ(new_lines.at("orphan-vertex"), "50");
}

TEST_F(CheckFormats, SarifCountsWhatItLeavesOut) {
  std::vector<Point> points;
  std::vector<Tuple> cells;
  for (int i = 0; i < 1010; ++i) {
    for (const Point& p : {Point{3.0 * i, 0, 0}, Point{3.0 * i + 1, 0, 0}, Point{3.0 * i, 1, 0},
                           Point{3.0 * i, 0, 1}})
      points.push_back(p);
    cells.push_back({4 * i + 1, 4 * i + 3, 4 * i + 2, 4 * i + 4, 0});
  }
  write("many.mesh", medit(points, {}, cells));
  ASSERT_EQ(cleave({"check", "many.mesh", "--sarif", "r.sarif"}).status, 1);
  expect_sarif("r.sarif");
  const json results = json::parse(read("r.sarif"))["runs"][0]["results"];
  ASSERT_EQ(results.size(), 1000u);
  EXPECT_NE(results[999]["message"]["text"].get<std::string>().find("and 10 more"),
            std::string::npos);
}

TEST_F(CheckFormats, JUnitHasASuitePerFileAndACasePerRule) {
  EXPECT_EQ(cleave({"check", ".", "--junit", "r.xml"}).status, 3);
  expect_junit("r.xml");
  const std::string cases = std::to_string(rules().size() + 1);
  EXPECT_EQ(xpath("r.xml", "count(//testsuite)"), "6");
  EXPECT_EQ(xpath("r.xml", "count(//testsuite[@name='good.mesh']/testcase)"), cases);
  EXPECT_EQ(xpath("r.xml", "count(//testsuite[@name='good.mesh']/testcase/*)"), "0");
  EXPECT_EQ(xpath("r.xml", "string(//testsuite[@name='broken.mesh']/@errors)"), "1");
  EXPECT_EQ(xpath("r.xml", "string(//testsuite[@name='broken.mesh']/testcase/@name)"), "readable");
  EXPECT_EQ(xpath("r.xml", "string(//testsuite[@name='bad.mesh']/@failures)"), "1");
  EXPECT_EQ(xpath("r.xml", "string(//testsuite[@name='bad.mesh']//failure/../@name)"),
            "inverted-cell");
  // A warning fails nothing, and is told.
  EXPECT_NE(
      xpath("r.xml",
            "string(//testsuite[@name='bad.mesh']/testcase[@name='orphan-vertex']/system-out)")
          .find("no cell uses vertex 5"),
      std::string::npos);
  EXPECT_EQ(xpath("r.xml", "string(//testsuite[@name='crowd.mesh']/@skipped)"), "5");
  EXPECT_EQ(xpath("r.xml", "sum(//testsuite/@failures) = //testsuites/@failures"), "true");
  EXPECT_EQ(xpath("r.xml", "count(//failure) = //testsuites/@failures"), "true");
  EXPECT_EQ(xpath("r.xml", "count(//testcase) = //testsuites/@tests"), "true");
  EXPECT_EQ(xpath("r.xml", "string(//testsuite[contains(@name, '#%?.mesh')]/@name)"),
            "a \"<&'>\xef\xbf\xbd\xef\xbf\xbd#%?.mesh");
}

TEST_F(CheckFormats, EveryReportIsWrittenWhateverThereIsToReport) {
  EXPECT_EQ(
      cleave({"check", "broken.mesh", "--sarif", "a.sarif", "--junit", "a.xml", "--json", "a.json"})
          .status,
      3);
  expect_sarif("a.sarif");
  expect_junit("a.xml");
  EXPECT_TRUE(json::parse(read("a.json")).contains("unreadable"));
  EXPECT_EQ(cleave({"check", "good.mesh", "--exclude", "good*", "--sarif", "b.sarif", "--junit",
                    "b.xml", "--json", "b.json"})
                .status,
            0);
  expect_sarif("b.sarif");
  expect_junit("b.xml");
  EXPECT_EQ(json::parse(read("b.json")), json::array());
  const Outcome out = cleave({"check", "bad.mesh", "--junit", "-"});
  EXPECT_EQ(out.out.rfind("<?xml", 0), 0u);
}

}  // namespace
}  // namespace cleave::app::test
