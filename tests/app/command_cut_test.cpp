#include <nlohmann/json.hpp>
#include <set>

#include "command_support.hpp"
#include "mesh_file.hpp"

namespace cleave::app::test {
namespace {

using nlohmann::json;

class Cut : public CommandTest {
 protected:
  // Cuts with these arguments, expects status 0 and returns the report.
  json report(std::vector<std::string> args) const {
    args.insert(args.begin(), "cut");
    args.insert(args.end(), {"--json", "-"});
    const Outcome outcome = cleave(args);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.status == 0 ? json::parse(outcome.out) : json();
  }

  Mesh mesh(const std::string& name) const { return read_mesh(folder_ / name); }

  static const Group* group(const Mesh& mesh, const std::string& name) {
    for (const Group& g : mesh.groups)
      if (g.name == name) return &g;
    return nullptr;
  }

  // The numbers of the vertices of the elements of a group, each sorted.
  static std::multiset<std::vector<std::uint64_t>> tuples(const Mesh& mesh, const Group& g) {
    std::multiset<std::vector<std::uint64_t>> all;
    const auto corners = static_cast<std::size_t>(g.dimension) + 1;
    const auto& elements = mesh.elements[static_cast<std::size_t>(g.dimension)];
    for (const auto e : g.elements) {
      std::vector<std::uint64_t> tuple;
      for (std::size_t i = 0; i < corners; ++i)
        tuple.push_back(mesh.vertex_numbers[elements.vertices[corners * e + i]]);
      std::sort(tuple.begin(), tuple.end());
      all.insert(tuple);
    }
    return all;
  }
};

TEST_F(Cut, OpensTheFacetBetweenTwoTetrahedra) {
  write("m.mesh", two_tetrahedra());
  write("f.json", R"({"facets": [[3, 1, 2]]})");
  const json r = report({"m.mesh", "-o", "out.mesh", "--facets", "f.json", "--explain"});
  EXPECT_EQ(r["schema"], "cleave-cut/1");
  EXPECT_EQ(r["mesh"], json::parse(R"({"cells":2,"vertices_before":5,"vertices_after":8})"));
  EXPECT_EQ(
      r["facets"],
      json::parse(R"({"requested":1,"opened":1,"shut":0,"not_interior":0,"kept":0,"added":0})"));
  EXPECT_EQ(r["pieces"], json::parse(R"({"before":1,"after":2})"));
  EXPECT_EQ(r["cut_regular"], true);
  EXPECT_EQ(r["pinched_edges"], 0);
  EXPECT_EQ(r["splits"], json::parse(R"([{"vertex":6,"parent":1},{"vertex":7,"parent":2},
                                         {"vertex":8,"parent":3}])"));
  EXPECT_TRUE(r["shut_facets"].empty());
  EXPECT_EQ(r["opened_facets"], json::parse(R"([{"facet":[1,2,3],"by":1}])"));

  const Mesh out = mesh("out.mesh");
  EXPECT_EQ(out.cells().vertices, (std::vector<Index>{0, 1, 2, 3, 5, 7, 6, 4}));
  const Group *minus = group(out, "cut_minus"), *plus = group(out, "cut_plus");
  ASSERT_TRUE(minus && plus);
  EXPECT_EQ(group(out, "cut_shut"), nullptr);
  EXPECT_EQ(tuples(out, *minus).count({1, 2, 3}), 1u);  // the lower half-facet
  EXPECT_EQ(tuples(out, *plus).count({6, 7, 8}), 1u);
}

TEST_F(Cut, SaysWhichCellsKeepAFacetShut) {
  // A tetrahedron divided by a vertex inside it: no single inner facet can open.
  write("m.mesh", medit({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1, 1, 1}}, {},
                        {{1, 2, 3, 5, 0}, {1, 4, 2, 5, 0}, {2, 4, 3, 5, 0}, {1, 3, 4, 5, 0}}));
  write("f.json", R"({"facets": [[1, 2, 5]]})");
  const json r = report({"m.mesh", "-o", "out.vtu", "--facets", "f.json"});
  EXPECT_EQ(
      r["facets"],
      json::parse(R"({"requested":1,"opened":0,"shut":1,"not_interior":0,"kept":0,"added":0})"));
  ASSERT_EQ(r["shut_facets"].size(), 1u);
  EXPECT_EQ(r["shut_facets"][0]["facet"], (std::vector{1, 2, 5}));
  ASSERT_EQ(r["shut_facets"][0]["because"].size(), 3u);
  std::set<int> vertices;
  for (const json& because : r["shut_facets"][0]["because"]) {
    vertices.insert(because["vertex"].get<int>());
    const auto through = because["through"].get<std::vector<int>>();
    EXPECT_GE(through.size(), 3u);  // round the facet, not through it
    EXPECT_EQ((std::set{through.front(), through.back()}), (std::set{1, 2}));
  }
  EXPECT_EQ(vertices, (std::set{1, 2, 5}));

  const Outcome strict = cleave(
      {"cut", "m.mesh", "-o", "again.mesh", "--facets", "f.json", "--require-open", "--explain"});
  EXPECT_EQ(strict.status, 1);
  EXPECT_NE(strict.out.find("facet (1 2 5) is shut"), std::string::npos) << strict.out;
  EXPECT_NE(group(mesh("again.mesh"), "cut_shut"), nullptr);  // written all the same
}

TEST_F(Cut, CutsByGroupAndKeepsTheOthers) {
  write("m.mesh", two_tetrahedra_with_groups());
  report({"m.mesh", "-o", "out.mesh", "--group", "7"});
  const Mesh out = mesh("out.mesh");
  EXPECT_EQ(group(out, "7"), nullptr);
  ASSERT_NE(group(out, "7_minus"), nullptr);
  ASSERT_NE(group(out, "7_plus"), nullptr);
  EXPECT_EQ(group(out, "7_minus")->elements.size(), 1u);
  EXPECT_EQ(group(out, "7_plus")->elements.size(), 1u);
  ASSERT_NE(group(out, "8"), nullptr);
  EXPECT_EQ(tuples(out, *group(out, "8")).count({1, 2, 4}), 1u);
  // The normal of (1 2 3) points to the upper cell, so minus is the lower one's side.
  EXPECT_EQ(tuples(out, *group(out, "7_minus")).count({6, 7, 8}), 1u);
}

TEST_F(Cut, WarnsOfAGroupThatHasTheNameOfASide) {
  write("m.mesh", two_tetrahedra_with_groups());
  write("m.mesh.groups.json", R"({"format": "cleave-groups/1", "overlaps": [], "groups": [
    {"dimension": 2, "name": "seam", "tag": 7}, {"dimension": 2, "name": "seam_plus", "tag": 8}]})");
  const Outcome cut = cleave({"cut", "m.mesh", "-o", "out.mesh", "--group", "seam"});
  EXPECT_EQ(cut.status, 0);
  EXPECT_NE(cut.err.find("a group seam_plus already"), std::string::npos) << cut.err;
  EXPECT_EQ(cut.err.find("seam_minus"), std::string::npos) << cut.err;
}

TEST_F(Cut, LeavesBothSidesOfAnOpenedFacetInAGroupNotAskedFor) {
  write("m.mesh", two_tetrahedra_with_groups());
  write("f.json", R"({"facets": [[1, 2, 3]]})");
  report({"m.mesh", "-o", "out.mesh", "--facets", "f.json"});
  const Mesh out = mesh("out.mesh");
  ASSERT_NE(group(out, "7"), nullptr);
  EXPECT_EQ(tuples(out, *group(out, "7")),
            (std::multiset<std::vector<std::uint64_t>>{{1, 2, 3}, {6, 7, 8}}));
}

TEST_F(Cut, ThatIsAskedForTwiceOrInAnotherOrderWritesTheSameBytes) {
  write("f.json", R"({"facets": [[1, 2, 3]]})");
  write("g.json", R"({"facets": [[2, 1, 3], [1, 2, 3], [3, 2, 1]]})");
  write("m.mesh", two_tetrahedra());
  report({"m.mesh", "-o", "a.mesh", "--facets", "f.json"});
  report({"m.mesh", "-o", "b.mesh", "--facets", "g.json"});
  EXPECT_EQ(read("a.mesh"), read("b.mesh"));

  const auto fault = data("fault.msh");
  report({fault, "-o", "a.msh", "--group", "fault", "branch"});
  report({fault, "-o", "b.msh", "--group", "branch", "--group", "fault", "branch"});
  EXPECT_EQ(read("a.msh"), read("b.msh"));
  EXPECT_EQ(read("a.msh").find("tmp"), std::string::npos);
}

TEST_F(Cut, KeepsGroupsAndSidesOfAGmshFile) {
  const Mesh before = read_mesh(data("fault.msh"));
  const json r = report({data("fault.msh"), "-o", "out.msh", "--group", "fault", "branch"});
  const Mesh out = mesh("out.msh");
  ASSERT_GT(r["facets"]["opened"], 0);
  for (const char* name : {"fault", "branch"}) {
    const Group *minus = group(out, std::string(name) + "_minus"),
                *plus = group(out, std::string(name) + "_plus"),
                *shut = group(out, std::string(name) + "_shut");
    ASSERT_TRUE(minus && plus) << name;
    EXPECT_EQ(group(out, name), nullptr);
    EXPECT_EQ(minus->elements.size(), plus->elements.size());
    EXPECT_EQ(minus->elements.size() + (shut ? shut->elements.size() : 0),
              group(before, name)->elements.size());
  }
  EXPECT_EQ(group(out, "rock")->elements.size(), before.cells().size());
  EXPECT_GE(group(out, "base")->elements.size(), group(before, "base")->elements.size());
  for (std::size_t i = 0; i < before.points.size(); ++i)
    EXPECT_EQ(out.vertex_numbers[i], before.vertex_numbers[i]);
  EXPECT_EQ(out.cells().numbers, before.cells().numbers);

  // Every facet of fault_minus lies on the side that its own normal points away from, and all
  // cells of fault_minus on one side of the plane y = 1.5.
  const auto& triangles = out.elements[2];
  std::set<bool> below;
  for (const auto e : group(out, "fault_minus")->elements) {
    std::set<Index> facet(&triangles.vertices[3 * e], &triangles.vertices[3 * e] + 3);
    for (std::size_t c = 0; c < out.cells().size(); ++c) {
      const Index* cell = &out.cells().vertices[4 * c];
      Index apex = UINT32_MAX;
      int common = 0;
      for (int i = 0; i < 4; ++i)
        if (facet.count(cell[i]) != 0)
          ++common;
        else
          apex = cell[i];
      if (common == 3) below.insert(out.points[apex][1] < 1.5);
    }
  }
  EXPECT_EQ(below.size(), 1u);
}

TEST_F(Cut, KeepsATagAbove32Bits) {
  write("m.msh",
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n"
        "5000000000 0 0 -1\n$EndNodes\n$Elements\n2\n1 4 2 1 1 1 2 3 4\n"
        "2 4 2 1 1 1 3 2 5000000000\n$EndElements\n");
  write("f.json", R"({"facets": [[1, 2, 3]]})");
  const json r = report({"m.msh", "-o", "out.msh", "--facets", "f.json"});
  EXPECT_EQ(r["splits"][0]["vertex"], 5000000001u);
  EXPECT_EQ(mesh("out.msh").vertex_numbers.back(), 5000000003u);
}

TEST_F(Cut, NumbersByTheFormatInWhateverCaseItsExtensionIs) {
  write("m.mesh", two_tetrahedra());
  write("f.json", R"({"facets": [[1, 2, 3]]})");
  for (const std::string out : {"out.mesh", "out.MESH", "out.Mesh"}) {
    const Outcome cut = cleave({"cut", "m.mesh", "-o", out, "--facets", "f.json", "--json", "-"});
    ASSERT_EQ(cut.status, 0) << cut.err;
    EXPECT_EQ(json::parse(cut.out)["splits"][0], (json{{"vertex", 6}, {"parent", 1}})) << out;
  }
}

TEST_F(Cut, WritesParentsPiecesAndGroupsToVtu) {
  write("m.mesh", two_tetrahedra());
  report({"m.mesh", "-o", "out.vtu", "--all"});
  const Mesh out = mesh("out.vtu");
  const auto field = [](const std::vector<Field>& fields, const std::string& name) {
    for (const Field& f : fields)
      if (f.name == name) return f.values;
    return std::vector<double>{};
  };
  EXPECT_EQ(field(out.point_fields, "parent"), (std::vector<double>{1, 2, 3, 4, 5, 1, 2, 3}));
  EXPECT_EQ(field(out.cell_fields, "piece"), (std::vector<double>{0, 1}));
  ASSERT_NE(group(out, "1"), nullptr);  // of the cells
  EXPECT_EQ(group(out, "1")->elements.size(), 2u);
}

TEST_F(Cut, DropsVerticesNoCellUsesAndSaysSo) {
  write("m.mesh", medit({{0, 0, 0}, {9, 9, 9}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}}, {},
                        {{1, 3, 4, 5, 0}, {1, 4, 3, 6, 0}}));
  const Outcome outcome = cleave({"cut", "m.mesh", "-o", "out.mesh", "--all"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.err.find("cleave: warning: m.mesh: 1 vertex is dropped"), std::string::npos)
      << outcome.err;
  EXPECT_EQ(mesh("out.mesh").points.size(), 8u);
}

TEST_F(Cut, LeavesFacetsOnTheBoundaryAloneAndCountsThem) {
  write("m.mesh", two_tetrahedra());
  write("f.json", R"({"facets": [[1, 2, 3], [1, 2, 4], [4, 2, 1]]})");
  const Outcome outcome =
      cleave({"cut", "m.mesh", "-o", "out.mesh", "--facets", "f.json", "--json", "r.json"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.err.find("cleave: warning: m.mesh: 1 facet asked for is on the boundary"),
            std::string::npos);
  EXPECT_EQ(
      json::parse(read("r.json"))["facets"],
      json::parse(R"({"requested":1,"opened":1,"shut":0,"not_interior":1,"kept":0,"added":0})"));
}

TEST_F(Cut, MakesADryRunThatWritesNoMesh) {
  write("m.mesh", two_tetrahedra());
  const json r = report({"m.mesh", "--all", "--dry-run", "-o", "out.mesh"});
  EXPECT_EQ(r["facets"]["opened"], 1);
  EXPECT_EQ(report({"m.mesh", "--all", "--dry-run"}), r);
  EXPECT_EQ(files(), std::vector<std::string>{"m.mesh"});
}

TEST_F(Cut, RegularisesFirstOrRefusesWithStrict) {
  write("m.mesh",
        medit({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}, {},
              {{1, 2, 3, 4, 0}, {1, 6, 5, 7, 0}}));
  const Outcome strict = cleave({"cut", "m.mesh", "-o", "out.mesh", "--all", "--strict"});
  EXPECT_EQ(strict.status, 3);
  EXPECT_NE(strict.err.find("not cut-regular: 1;"), std::string::npos) << strict.err;
  EXPECT_EQ(files(), std::vector<std::string>{"m.mesh"});
  const json r = report({"m.mesh", "-o", "out.mesh", "--all"});
  EXPECT_EQ(r["regularized"], json::parse(R"([{"vertex":8,"parent":1}])"));
  EXPECT_TRUE(r["splits"].empty());
  EXPECT_EQ(r["mesh"]["vertices_after"], 8);
}

TEST_F(Cut, CertifiesTheWholeWithVerifyAll) {
  for (const std::string verify : {"none", "touched", "all"})
    report({data("fault.msh"), "-o", verify + ".msh", "--group", "fault", "--verify", verify});
  EXPECT_EQ(read("none.msh"), read("touched.msh"));
  EXPECT_EQ(read("none.msh"), read("all.msh"));
}

TEST_F(Cut, CutsTrianglesByPolylineAndRefusesSurfacesInSpace) {
  std::vector<Point> points;
  std::vector<Tuple> triangles;
  for (int y = 0; y <= 4; ++y)
    for (int x = 0; x <= 4; ++x) points.push_back({double(x), double(y), 0});
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) {
      const int a = 5 * y + x + 1;
      triangles.push_back({a, a + 1, a + 6, 0});
      triangles.push_back({a, a + 6, a + 5, 0});
    }
  write("plane.mesh", medit(points, triangles, {}));
  write("line.json", R"({"polyline": [[-1, 2.1], [5, 2.2]]})");
  const json r = report({"plane.mesh", "-o", "out.mesh", "--sweep", "line.json"});
  EXPECT_EQ(r["pieces"]["after"], 2);
  EXPECT_EQ(r["facets"]["shut"], 0);

  points.front()[2] = 1;
  write("bent.mesh", medit(points, triangles, {}));
  EXPECT_EQ(cleave({"cut", "bent.mesh", "-o", "b.mesh", "--sweep", "line.json"}).status, 3);
  write("blade.json", R"({"blade": [[[0,0,0],[1,0,0]],[[0,1,0],[1,1,0]]]})");
  EXPECT_EQ(cleave({"cut", "plane.mesh", "-o", "b.mesh", "--sweep", "blade.json"}).status, 3);
}

TEST_F(Cut, ReportsASheetWithOneSide) {
  write("m.mesh", solid_torus_with_moebius_band());
  const Outcome outcome =
      cleave({"cut", "m.mesh", "-o", "out.mesh", "--group", "9", "--json", "-"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const json r = json::parse(outcome.out);
  ASSERT_EQ(r["one_sided"].size(), 1u) << outcome.out;
  EXPECT_EQ(r["one_sided"][0]["name"], "9");
  EXPECT_GE(r["one_sided"][0]["loop"].size(), 3u);
  EXPECT_NE(outcome.err.find("one side only"), std::string::npos);
}

}  // namespace
}  // namespace cleave::app::test
