// The parts of the check that stand alone: patterns, text for XML, points that lie together, rules.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>
#include <set>

#include "check_report.hpp"
#include "check_rules.hpp"
#include "glob.hpp"
#include "point_sets.hpp"
#include "rule_examples.hpp"
#include "xml_text.hpp"

namespace cleave::app::test {
namespace {

TEST(Glob, MatchesNamesAndPaths) {
  const auto yes = [](const char* pattern, const char* text) {
    EXPECT_TRUE(glob_matches(pattern, text)) << pattern << ' ' << text;
  };
  const auto no = [](const char* pattern, const char* text) {
    EXPECT_FALSE(glob_matches(pattern, text)) << pattern << ' ' << text;
  };
  yes("", "");
  no("", "a");
  yes("*", "");
  yes("*.msh", "a.b.msh");
  no("*.msh", "a/b.msh");
  yes("a?c", "abc");
  no("a?c", "a/c");
  yes("**", "a/b/c");
  yes("a/**/b", "a/b");
  yes("a/**/b", "a/x/y/b");
  no("a/**/b", "a/xb");
  yes("a/**", "a/x/y");
  yes("*a*a*a*b", "aaaaaaaab");
  no("*a*a*a*b", "aaaaaaaac");
}

TEST(Glob, SpeaksOfFilesFromItsFolder) {
  const auto names = [](const char* pattern, const char* file) {
    return glob_names(pattern, file, "base");
  };
  EXPECT_TRUE(names("x.mesh", "base/deep/x.mesh"));
  EXPECT_TRUE(names("deep", "base/deep/x.mesh"));
  EXPECT_TRUE(names("deep/", "base/deep/x.mesh"));
  EXPECT_TRUE(names("./deep/*.mesh", "base/deep/x.mesh"));
  EXPECT_FALSE(names("deep/*.mesh", "base/other/deep/x.mesh"));
  EXPECT_TRUE(names("**/deep/*.mesh", "base/other/deep/x.mesh"));
  EXPECT_FALSE(names("eep", "base/deep/x.mesh"));
  EXPECT_TRUE(names("*.mesh", "elsewhere/x.mesh"));
}

TEST(XmlText, EscapesMarkupAndReplacesWhatXmlCannotSay) {
  EXPECT_EQ(xml_text("a<b>&\"c'"), "a&lt;b&gt;&amp;&quot;c'");
  EXPECT_EQ(xml_text("\t\n\x02\x7f"), "\t\n\xef\xbf\xbd\xef\xbf\xbd");
  EXPECT_EQ(xml_text("\xc3\xa4\xe2\x82\xac\xf0\x9f\x94\xaa"),
            "\xc3\xa4\xe2\x82\xac\xf0\x9f\x94\xaa");
  for (const char* wrong : {"\xff", "\xc0", "\xc3", "\x80"})
    EXPECT_EQ(xml_text(wrong), "\xef\xbf\xbd");
  EXPECT_EQ(xml_text("\xed\xa0\x80").substr(0, 3), "\xef\xbf\xbd");  // half of a surrogate pair
  EXPECT_EQ(xml_text("\xef\xbf\xbf"), "\xef\xbf\xbd");               // U+FFFF
  EXPECT_EQ(xml_text("\xe0\x80\xaf").find('/'), std::string::npos);  // an overlong slash
}

// Sets of points joined by steps of at most `distance`, by comparing all with all.
std::set<std::vector<Index>> close_by_definition(const std::vector<std::array<double, 3>>& points,
                                                 double distance) {
  std::vector<std::size_t> set(points.size());
  for (std::size_t i = 0; i < set.size(); ++i) set[i] = i;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto &a = points[i], &b = points[j];
      if (std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) > distance) continue;
      const std::size_t old = set[i], now = set[j];
      for (std::size_t& s : set)
        if (s == old) s = now;
    }
  std::set<std::vector<Index>> sets;
  for (std::size_t name = 0; name < set.size(); ++name) {
    std::vector<Index> members;
    for (Index i = 0; i < set.size(); ++i)
      if (set[i] == name) members.push_back(i);
    if (members.size() > 1) sets.insert(members);
  }
  return sets;
}

TEST(ClosePoints, AreThoseOfTheDefinition) {
  std::mt19937_64 random(3);
  std::size_t found = 0;
  for (int round = 0; round < 60; ++round) {
    std::vector<std::array<double, 3>> points(60);
    std::vector<Index> places;
    for (Index i = 0; i < points.size(); ++i) {
      for (double& x : points[i])
        x = static_cast<double>(random() % 1000) / 100 - 5 + (round % 3 == 0 ? 0 : 1e6);
      if (round % 5 == 0 && i % 3 == 0 && i > 0) points[i] = points[i - 1];
      places.push_back(i);
    }
    const double distance =
        std::array{0.0, 0.3, 1.0, 2.5, 40.0}[static_cast<std::size_t>(round) % 5];
    const auto sets = close_points(points, places, distance);
    found += sets.size();
    EXPECT_EQ((std::set<std::vector<Index>>(sets.begin(), sets.end())),
              close_by_definition(points, distance))
        << round;
  }
  EXPECT_GE(found, 100u);
}

TEST(ClosePoints, TakesZerosOfBothSignsForOne) {
  EXPECT_EQ(close_points({{0.0, 1, 2}, {5, 5, 5}, {-0.0, 1, 2}}, {0, 1, 2}, 0),
            (std::vector<std::vector<Index>>{{0, 2}}));
  EXPECT_TRUE(close_points({{0.0, 1, 2}, {-0.0, 1, 2}}, {1}, 0).empty());
}

TEST(Reports, HideNoWarningBehindNotes) {
  CheckReport report;
  report.source = "m.msh";
  report.dimension = 3;
  for (const Severity severity :
       {Severity::note, Severity::note, Severity::note, Severity::warning})
    report.findings.push_back({"coincident-vertices", severity, "together", {}});
  EXPECT_EQ(text_of(report, 1, false),
            "m.msh: note: coincident-vertices: together\n"
            "m.msh: note: coincident-vertices: 2 more like these; --json lists them all\n"
            "m.msh: warning: coincident-vertices: together\n");
  const std::string sarif = sarif_of({report}, 1);
  EXPECT_NE(sarif.find("together (and 2 more like this)"), std::string::npos);
  EXPECT_NE(sarif.find("\"level\": \"warning\",\n     \"message\""), std::string::npos);
}

TEST(Rules, HaveAnExampleThatBreaksThemAndAllTheirText) {
  std::set<std::string> shown;
  for (const RuleExample& example : rule_examples()) {
    std::set<std::string> broken;
    for (const Finding& finding : check_mesh(example.mesh, {}).findings) {
      broken.insert(finding.rule);
      EXPECT_NE(find_rule(finding.rule), nullptr) << finding.rule;
    }
    EXPECT_EQ(broken.count(example.rule), 1u) << example.rule;
    shown.insert(example.rule);
  }
  for (const Rule& rule : rules()) {
    EXPECT_EQ(shown.count(std::string(rule.name)), 1u) << rule.name;
    for (const std::string_view text : {rule.title, rule.meaning, rule.matters, rule.mend,
                                        rule.by_hand, rule.severity, rule.subject})
      EXPECT_FALSE(text.empty()) << rule.name;
    EXPECT_EQ(&rules()[place_of_rule(rule.name)], &rule);
    std::istringstream lines(explanation(rule));
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80u) << line;
  }
}

}  // namespace
}  // namespace cleave::app::test
