#include <nlohmann/json.hpp>

#include "command_support.hpp"

namespace cleave::app::test {
namespace {

using nlohmann::json;

class Check : public CommandTest {
 protected:
  // Checks m.mesh with these contents; expects this status and returns the report.
  json report(const std::string& mesh, int status, std::vector<std::string> more = {}) const {
    write("m.mesh", mesh);
    std::vector<std::string> args{"check", "m.mesh", "--json", "-"};
    args.insert(args.end(), more.begin(), more.end());
    const Outcome outcome = cleave(args);
    EXPECT_EQ(outcome.status, status) << outcome.out << outcome.err;
    return json::parse(outcome.out);
  }

  // The violations of one rule.
  static std::vector<json> of_rule(const json& report, const std::string& rule) {
    std::vector<json> found;
    for (const json& violation : report["violations"])
      if (violation["rule"] == rule) found.push_back(violation);
    return found;
  }
};

TEST_F(Check, FindsNothingWrongWithTwoTetrahedra) {
  const json r = report(two_tetrahedra(), 0);
  EXPECT_EQ(r["schema"], "cleave-check/1");
  EXPECT_EQ(r["mesh"]["dimension"], 3);
  EXPECT_EQ(r["mesh"]["cells"], 2);
  EXPECT_EQ(r["mesh"]["vertices"], 5);
  EXPECT_EQ(r["level"], "manifold");
  EXPECT_TRUE(r["violations"].empty());
  EXPECT_EQ(r["topology"]["pieces"], 1);
  EXPECT_EQ(r["topology"]["boundary_components"], 1);
  EXPECT_EQ(r["topology"]["euler_characteristic"], 1);
  EXPECT_EQ(r["topology"]["betti"], (json{1, 0, 0, 0}));
}

TEST_F(Check, NamesInvertedAndFlatCells) {
  const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}};
  const json r = report(medit(points, {}, {{1, 2, 4, 3, 0}, {2, 3, 5, 1, 0}}), 1);
  const auto inverted = of_rule(r, "inverted-cell"), flat = of_rule(r, "flat-cell");
  ASSERT_EQ(inverted.size(), 1u);
  EXPECT_EQ(inverted[0]["severity"], "error");
  EXPECT_EQ(inverted[0]["witness"]["cell"], 1);
  ASSERT_EQ(flat.size(), 1u);
  EXPECT_EQ(flat[0]["severity"], "error");
  EXPECT_EQ(flat[0]["witness"]["cell"], 2);
  EXPECT_EQ(flat[0]["witness"]["vertices"], (std::vector{2, 3, 5, 1}));
}

TEST_F(Check, CallsAThinCellFlatOnlyBelowTheThreshold) {
  const auto sliver = [](double height) {
    return medit({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, height}}, {}, {{1, 2, 3, 4, 0}});
  };
  EXPECT_EQ(of_rule(report(sliver(1e-9), 0), "flat-cell").size(), 0u);
  EXPECT_EQ(of_rule(report(sliver(1e-11), 1), "flat-cell").size(), 1u);
  EXPECT_EQ(of_rule(report(sliver(-1e-9), 1), "inverted-cell").size(), 1u);
}

TEST_F(Check, FindsInvertedTrianglesInAPlaneOnly) {
  const std::vector<Tuple> reversed{{1, 3, 2, 0}};
  EXPECT_EQ(
      of_rule(report(medit({{0, 0, 2}, {1, 0, 2}, {0, 1, 2}}, reversed, {}), 1), "inverted-cell")
          .size(),
      1u);
  EXPECT_EQ(report(medit({{0, 0, 2}, {1, 0, 2}, {0, 1, 3}}, reversed, {}), 0)["violations"].size(),
            0u);
}

TEST_F(Check, NamesDuplicateAndDegenerateCells) {
  const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const json twice = report(medit(points, {}, {{1, 2, 3, 4, 0}, {2, 3, 1, 4, 0}}), 1);
  const auto duplicate = of_rule(twice, "duplicate-cell");
  ASSERT_EQ(duplicate.size(), 1u);
  EXPECT_EQ(duplicate[0]["witness"]["cells"], (std::vector{1, 2}));

  const json repeated = report(medit(points, {}, {{1, 2, 3, 4, 0}, {1, 2, 2, 4, 0}}), 1);
  const auto degenerate = of_rule(repeated, "degenerate-cell");
  ASSERT_EQ(degenerate.size(), 1u);
  EXPECT_EQ(degenerate[0]["witness"]["cell"], 2);
  EXPECT_EQ(degenerate[0]["witness"]["repeated"], 2);
}

TEST_F(Check, NamesThreeCellsOnAFacet) {
  const json r = report(medit({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {1, 1, 1}},
                              {}, {{1, 2, 3, 4, 0}, {1, 3, 2, 5, 0}, {1, 2, 3, 6, 0}}),
                        1);
  const auto three = of_rule(r, "facet-in-three-cells");
  ASSERT_EQ(three.size(), 1u);
  EXPECT_EQ(three[0]["witness"]["facet"], (std::vector{1, 2, 3}));
  EXPECT_EQ(three[0]["witness"]["cells"], (std::vector{1, 2, 3}));
}

TEST_F(Check, TellsAnOrientationConflictFromAMoebiusBand) {
  const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}};
  const json mixed = report(medit(points, {}, {{1, 2, 3, 4, 0}, {1, 2, 3, 5, 0}}), 1);
  ASSERT_EQ(of_rule(mixed, "orientation-conflict").size(), 1u);
  EXPECT_EQ(of_rule(mixed, "non-orientable").size(), 0u);

  EXPECT_EQ(of_rule(report(band(6, false), 0), "non-orientable").size(), 0u);
  for (const std::string& mesh : {band(6, true), solid_band(6)}) {
    const json r = report(mesh, 1);
    const auto witnesses = of_rule(r, "non-orientable");
    ASSERT_EQ(witnesses.size(), 1u);
    const auto& cells = witnesses[0]["witness"]["cells"];
    const auto& facets = witnesses[0]["witness"]["facets"];
    EXPECT_GE(cells.size(), 3u);
    EXPECT_EQ(cells.size(), facets.size());
  }
}

TEST_F(Check, ReportsEveryCoordinateThatIsNotFinite) {
  const json r = report(
      "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 nan 0 0\n0 1 inf 0\n0 0 1 0\n"
      "Tetrahedra\n1\n1 2 3 4 0\nEnd\n",
      1);
  const auto found = of_rule(r, "not-finite");
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0]["witness"]["vertex"], 2);
  EXPECT_EQ(found[0]["witness"]["axis"], "y");
  EXPECT_EQ(found[1]["witness"]["vertex"], 3);
}

TEST_F(Check, MakesFindingsAboveTheRequiredLevelWarnings) {
  // Two tetrahedra that share a vertex only.
  const std::string pinched =
      medit({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}, {},
            {{1, 2, 3, 4, 0}, {1, 6, 5, 7, 0}});
  EXPECT_EQ(of_rule(report(pinched, 1), "not-cut-regular")[0]["severity"], "error");
  const json lenient = report(pinched, 0, {"--require", "pseudo-manifold"});
  EXPECT_EQ(of_rule(lenient, "not-cut-regular")[0]["severity"], "warning");
  EXPECT_EQ(lenient["level"], "pseudo-manifold");
}

TEST_F(Check, WarnsOfVerticesNoCellUses) {
  const json r = report(
      medit({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {9, 9, 9}}, {}, {{1, 2, 3, 4, 0}}), 0);
  const auto orphans = of_rule(r, "orphan-vertex");
  ASSERT_EQ(orphans.size(), 1u);
  EXPECT_EQ(orphans[0]["severity"], "warning");
  EXPECT_EQ(orphans[0]["witness"]["vertex"], 5);
}

TEST_F(Check, TakesTheHighestDimensionForTheCells) {
  // A triangle beside two tetrahedra is no cell.
  const json r = report(medit({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}},
                              {{1, 2, 5, 3}}, {{1, 2, 3, 4, 0}, {1, 3, 2, 5, 0}}),
                        0);
  EXPECT_EQ(r["mesh"]["dimension"], 3);
  EXPECT_EQ(r["mesh"]["cells"], 2);
}

TEST_F(Check, PrintsOneLinePerFindingAndShortensLongLists) {
  std::vector<Point> points;
  std::vector<Tuple> cells;
  for (int i = 0; i < 30; ++i) {
    const double x = 2.0 * i;
    for (const Point& p : {Point{x, 0, 0}, Point{x + 1, 0, 0}, Point{x, 1, 0}, Point{x, 0, 1}})
      points.push_back(p);
    cells.push_back({4 * i + 1, 4 * i + 3, 4 * i + 2, 4 * i + 4, 0});
  }
  write("m.mesh", medit(points, {}, cells));
  const Outcome text = cleave({"check", "m.mesh"});
  EXPECT_EQ(text.status, 1);
  EXPECT_NE(text.out.find("m.mesh: error: inverted-cell: cell 20 "), std::string::npos);
  EXPECT_EQ(text.out.find("cell 21 "), std::string::npos);
  EXPECT_NE(text.out.find("10 more like these"), std::string::npos);
  EXPECT_NE(text.out.find("30 pieces"), std::string::npos);
  EXPECT_EQ(cleave({"check", "--quiet", "m.mesh"}).out.find("pieces"), std::string::npos);
  EXPECT_EQ(of_rule(report(read("m.mesh"), 1), "inverted-cell").size(), 30u);
}

TEST_F(Check, TakesSeveralMeshesAndReportsThemAsAList) {
  write("a.mesh", two_tetrahedra());
  write("b.mesh", medit({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {}, {{1, 3, 2, 4, 0}}));
  EXPECT_EQ(cleave({"check", "a.mesh", "b.mesh", "--json", "r.json"}).status, 1);
  const json reports = json::parse(read("r.json"));
  ASSERT_EQ(reports.size(), 2u);
  EXPECT_EQ(reports[0]["mesh"]["file"], "a.mesh");
  EXPECT_TRUE(reports[0]["violations"].empty());
  EXPECT_EQ(reports[1]["violations"].size(), 1u);
}

TEST_F(Check, FindsWhatIsWrongWithTheLiver) {
  const Outcome outcome = cleave({"check", data("liver-16k.mesh"), "--json", "-"});
  EXPECT_EQ(outcome.status, 1);
  const json r = json::parse(outcome.out);
  EXPECT_EQ(r["mesh"]["cells"], 16014);
  EXPECT_EQ(r["mesh"]["vertices"], 3449);
  EXPECT_EQ(r["level"], "pseudo-manifold");
  EXPECT_EQ(of_rule(r, "not-cut-regular").size(), 3u);
  for (const json& violation : of_rule(r, "not-cut-regular"))
    EXPECT_EQ(violation["severity"], "error");
  EXPECT_EQ(of_rule(r, "pinched-edge").size(), 3u);
  for (const json& violation : of_rule(r, "pinched-edge"))
    EXPECT_EQ(violation["severity"], "warning");
  EXPECT_EQ(of_rule(r, "inverted-cell").size(), 0u);
  EXPECT_EQ(of_rule(r, "flat-cell").size(), 0u);
}

}  // namespace
}  // namespace cleave::app::test
