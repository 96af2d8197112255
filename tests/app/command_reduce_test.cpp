#include <csignal>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <thread>

#include "check_report.hpp"
#include "command_support.hpp"
#include "kuhn_cube.hpp"
#include "mesh_file.hpp"
#include "sub_mesh.hpp"

namespace cleave::app::test {
namespace {

using nlohmann::json;
using Cell = std::array<Index, 4>;

constexpr Index kNodes = 10;  // along an axis of the haystack: 4374 cells

Mesh haystack() {
  Mesh mesh = kuhn_cube({{kNodes, kNodes, kNodes}, {9, 9, 9}});
  mesh.source = "haystack";
  return mesh;
}

Index node(Index x, Index y, Index z) { return x + kNodes * (y + kNodes * z); }

Index add_point(Mesh& mesh, double x, double y, double z) {
  mesh.points.push_back({x, y, z});
  mesh.vertex_numbers.push_back(mesh.vertex_numbers.back() + 1);
  return static_cast<Index>(mesh.points.size() - 1);
}

void add_cell(Mesh& mesh, const Cell& cell) {
  Elements& cells = mesh.elements[3];
  cells.vertices.insert(cells.vertices.end(), cell.begin(), cell.end());
  cells.numbers.push_back(cells.numbers.back() + 1);
}

Cell cell(const Mesh& mesh, std::size_t c) {
  Cell tuple{};
  std::copy_n(&mesh.elements[3].vertices[4 * c], 4, tuple.begin());
  return tuple;
}

// The mesh of a Medit text beside the haystack.
void put_beside(Mesh& mesh, const Mesh& other) {
  std::vector<Index> at;
  for (const auto& p : other.points) at.push_back(add_point(mesh, p[0] + 20, p[1], p[2]));
  for (std::size_t c = 0; c < other.cells().size(); ++c) {
    Cell tuple = cell(other, c);
    for (auto& v : tuple) v = at[v];
    add_cell(mesh, tuple);
  }
}

// All cells but those of these small boxes.
Mesh without_boxes(const Mesh& mesh, const std::set<std::array<int, 3>>& boxes) {
  std::vector<Index> rest;
  for (Index c = 0; c < mesh.cells().size(); ++c) {
    std::array<int, 3> box{9, 9, 9};
    for (const auto v : cell(mesh, c))
      for (std::size_t i = 0; i < 3; ++i)
        box[i] = std::min(box[i], static_cast<int>(mesh.points[v][i] + 0.5));
    if (boxes.count(box) == 0) rest.push_back(c);
  }
  return sub_mesh(mesh, rest).mesh;
}

class Reduce : public CommandTest {
 protected:
  void put(const std::string& name, const Mesh& mesh) const { write_mesh(folder_ / name, mesh); }
  Mesh get(const std::string& name) const { return read_mesh(folder_ / name); }

  // What `cleave check`, another process, finds in a file.
  std::set<std::string> rules(const std::string& name) const {
    const Outcome outcome = cleave({"check", name, "--json", "-"});
    EXPECT_LE(outcome.status, 1) << outcome.err;
    std::set<std::string> found;
    const json report = json::parse(outcome.out);
    for (const json& violation : report["violations"]) found.insert(violation["rule"]);
    return found;
  }

  static std::set<std::string> rules_of(const Mesh& mesh) {
    std::set<std::string> found;
    for (const Finding& finding : check_mesh(mesh, {}).findings) found.insert(finding.rule);
    return found;
  }

  // Reduces m.mesh by `rule` and checks what every reduction promises: the same rule and no rule
  // that the whole does not break, which is so no longer without any one of the cells. Returns the
  // number of cells.
  std::size_t reduce_by(const std::string& rule, const Mesh& whole) const {
    SCOPED_TRACE(rule);
    put("m.mesh", whole);
    const Outcome outcome = cleave({"reduce", "m.mesh", "-o", "small.mesh", "--rule", rule});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("kept: " + rule), std::string::npos) << outcome.out;
    const auto allowed = rules("m.mesh"), found = rules("small.mesh");
    EXPECT_EQ(allowed.count(rule), 1u);
    EXPECT_EQ(found.count(rule), 1u);
    EXPECT_TRUE(std::includes(allowed.begin(), allowed.end(), found.begin(), found.end()));

    const Mesh small = get("small.mesh");
    std::vector<Index> loose(small.points.size());
    std::iota(loose.begin(), loose.end(), 0U);
    for (const auto v : small.cells().vertices) std::erase(loose, v);
    for (Index gone = 0; small.cells().size() > 1 && gone < small.cells().size(); ++gone) {
      std::vector<Index> rest(small.cells().size());
      std::iota(rest.begin(), rest.end(), 0U);
      rest.erase(rest.begin() + gone);
      const auto left = rules_of(sub_mesh(small, rest, loose).mesh);
      EXPECT_TRUE(left.count(rule) == 0 ||
                  !std::includes(allowed.begin(), allowed.end(), left.begin(), left.end()))
          << "cell " << gone + 1 << " of " << small.cells().size() << " is not needed";
    }
    return small.cells().size();
  }
};

TEST_F(Reduce, KeepsTheOneCellThatIsToBlame) {
  Mesh degenerate = haystack();
  degenerate.elements[3].vertices[4 * 2000] = degenerate.elements[3].vertices[4 * 2000 + 1];
  EXPECT_EQ(reduce_by("degenerate-cell", degenerate), 1u);

  Mesh inverted = haystack();
  std::swap(inverted.elements[3].vertices[4 * 2000], inverted.elements[3].vertices[4 * 2000 + 1]);
  EXPECT_EQ(reduce_by("inverted-cell", inverted), 1u);
  EXPECT_EQ(reduce_by("orientation-conflict", inverted), 2u);

  Mesh flat = haystack();
  flat.points[node(5, 5, 5)] = {5, 5, 4};
  EXPECT_EQ(reduce_by("flat-cell", flat), 1u);

  Mesh endless = haystack();
  endless.points[node(5, 5, 5)][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(reduce_by("not-finite", endless), 1u);
}

TEST_F(Reduce, KeepsCellsThatAreThereTwiceOrThreeOfThemOnAFacet) {
  Mesh twice = haystack();
  add_cell(twice, cell(twice, 2000));
  EXPECT_LE(reduce_by("duplicate-cell", twice), 3u);

  Mesh three = haystack();
  Cell third = cell(three, 2000);
  third[0] = add_point(three, 30, 0, 0);
  add_cell(three, third);
  EXPECT_EQ(reduce_by("facet-in-three-cells", three), 3u);
}

TEST_F(Reduce, KeepsTwoPartsThatTouchInAVertex) {
  Mesh mesh = haystack();
  add_cell(mesh, {node(9, 9, 9), add_point(mesh, 10, 9, 9), add_point(mesh, 9, 10, 9),
                  add_point(mesh, 9, 9, 10)});
  EXPECT_EQ(reduce_by("not-cut-regular", mesh), 2u);
}

TEST_F(Reduce, KeepsWhatMakesAPinchedEdgeWithSoundEnds) {
  const Mesh mesh = without_boxes(haystack(), {{4, 4, 4}, {5, 5, 4}});
  EXPECT_EQ(rules_of(mesh), std::set<std::string>{"pinched-edge"});
  EXPECT_LE(reduce_by("pinched-edge", mesh), 24u);
}

TEST_F(Reduce, KeepsALinkThatIsAnAnnulus) {
  write("annulus.mesh", suspended_annulus());
  Mesh mesh = haystack();
  put_beside(mesh, get("annulus.mesh"));
  EXPECT_LE(reduce_by("bad-vertex-link", mesh), 12u);
}

TEST_F(Reduce, KeepsALoopThatHasNoOrientation) {
  write("band.mesh", solid_band(12));
  Mesh mesh = haystack();
  put_beside(mesh, get("band.mesh"));
  EXPECT_LE(reduce_by("non-orientable", mesh), 36u);
}

TEST_F(Reduce, KeepsOneVertexThatNoCellUses) {
  Mesh mesh = haystack();
  for (int i = 0; i < 20; ++i) add_point(mesh, 20 + i, 0, 0);
  EXPECT_EQ(reduce_by("orphan-vertex", mesh), 1u);
  EXPECT_EQ(get("small.mesh").points.size(), 5u);
}

TEST_F(Reduce, TakesTheFirstErrorUnlessTold) {
  Mesh mesh = haystack();
  add_point(mesh, 20, 0, 0);
  put("m.mesh", mesh);
  const Outcome clean = cleave({"reduce", "m.mesh", "-o", "small.mesh"});
  EXPECT_EQ(clean.status, 3);
  EXPECT_NE(clean.err.find("finds no error; what it finds, for --rule: orphan-vertex"),
            std::string::npos)
      << clean.err;
  EXPECT_EQ(files(), std::vector<std::string>{"m.mesh"});

  std::swap(mesh.elements[3].vertices[40], mesh.elements[3].vertices[41]);
  put("m.mesh", mesh);
  EXPECT_EQ(cleave({"reduce", "m.mesh", "-o", "small.mesh", "--quiet"}).out, "");
  EXPECT_EQ(rules("small.mesh").count("orientation-conflict"), 1u);
}

TEST_F(Reduce, KeepsGroupsAsFarAsTheirElementsStay) {
  Mesh mesh = haystack();
  mesh.groups.push_back({"needle", 3, 1, {2000, 2001}});
  mesh.groups.push_back({"hay", 3, 2, {0, 1}});
  std::swap(mesh.elements[3].vertices[8000], mesh.elements[3].vertices[8001]);
  put("m.msh", mesh);
  ASSERT_EQ(cleave({"reduce", "m.msh", "-o", "s.msh", "--rule", "inverted-cell"}).status, 0);
  const Mesh small = get("s.msh"), whole = get("m.msh");
  ASSERT_EQ(small.groups.size(), 1u);
  EXPECT_EQ(small.groups[0].name, "needle");
  EXPECT_EQ(small.groups[0].elements, std::vector<Index>{0});
  EXPECT_EQ(small.cells().numbers[0], whole.cells().numbers[2000]);  // .msh keeps numbers
}

// Facets of the plane x = 4, and one far from it whose vertices are all inside.
json facets_of_a_cut(const Mesh& mesh) {
  json facets = json::array();
  for (Index c = 0; c < mesh.cells().size(); ++c)
    for (std::size_t without = 0; without < 4; ++without) {
      json facet = json::array();
      bool on_plane = true, alone = c == 1500 && without == 0;
      for (std::size_t i = 0; i < 4; ++i) {
        if (i == without) continue;
        const auto v = cell(mesh, c)[i];
        on_plane = on_plane && mesh.points[v][0] == 4;
        facet.push_back(v + 1);  // .mesh numbers from 1
      }
      if (on_plane || alone) facets.push_back(facet);
    }
  return facets;
}

TEST_F(Reduce, KeepsAFacetThatStaysShutAndShrinksTheRequest) {
  const Mesh mesh = haystack();
  put("m.mesh", mesh);
  write("cut.json", json{{"facets", facets_of_a_cut(mesh)}}.dump());
  ASSERT_EQ(cleave({"reduce", "m.mesh", "-o", "s.mesh", "--facets", "cut.json"}).status, 0);
  const json rest = json::parse(read("s.mesh.facets.json"));
  EXPECT_EQ(rest["facets"].size(), 1u);
  const std::vector<std::string> again{
      "cut", "s.mesh", "--facets", "s.mesh.facets.json", "--dry-run", "--require-open"};
  EXPECT_EQ(cleave(again).status, 1);
  EXPECT_TRUE(rules("s.mesh").empty());

  const Mesh small = get("s.mesh");
  EXPECT_LE(small.cells().size(), 40u);
  std::size_t needed = 0;
  for (Index gone = 0; gone < small.cells().size(); ++gone) {
    std::vector<Index> cells(small.cells().size());
    std::iota(cells.begin(), cells.end(), 0U);
    cells.erase(cells.begin() + gone);
    const Mesh part = sub_mesh(small, cells).mesh;
    if (part.points.size() < small.points.size() || !rules_of(part).empty()) {
      ++needed;  // a vertex goes with it, or it leaves a mesh that is not sound
      continue;
    }
    put("part.mesh", part);
    needed += cleave({"cut", "part.mesh", "--facets", "s.mesh.facets.json", "--dry-run",
                      "--require-open"})
                          .status != 1
                  ? 1
                  : 0;
  }
  EXPECT_EQ(needed, small.cells().size());
}

TEST_F(Reduce, KeepsAnEdgeThatACutPinches) {
  const Mesh mesh = haystack();
  put("m.mesh", mesh);
  const auto box = [&](Index c) {
    std::array<int, 3> least{9, 9, 9};
    for (const auto v : cell(mesh, c))
      for (std::size_t i = 0; i < 3; ++i)
        least[i] = std::min(least[i], static_cast<int>(mesh.points[v][i] + 0.5));
    return least == std::array{4, 4, 4} || least == std::array{5, 5, 4};
  };
  std::map<std::set<Index>, std::pair<int, int>> sides;  // how many in, how many out
  for (Index c = 0; c < mesh.cells().size(); ++c)
    for (std::size_t without = 0; without < 4; ++without) {
      std::set<Index> facet;
      for (std::size_t i = 0; i < 4; ++i)
        if (i != without) facet.insert(cell(mesh, c)[i] + 1);
      ++(box(c) ? sides[facet].first : sides[facet].second);
    }
  json facets = json::array();
  for (const auto& [facet, count] : sides)
    if (count == std::pair(1, 1)) facets.push_back(facet);
  ASSERT_EQ(facets.size(), 24u);
  write("cut.json", json{{"facets", facets}}.dump());
  const Outcome outcome =
      cleave({"reduce", "m.mesh", "-o", "s.mesh", "--facets", "cut.json", "--expect", "pinched"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_LE(get("s.mesh").cells().size(), 40u);
  EXPECT_EQ(rules("s.mesh").count("pinched-edge"), 0u);  // the cut makes it
  const json report = json::parse(
      cleave({"cut", "s.mesh", "--facets", "s.mesh.facets.json", "--dry-run", "--json", "-"}).out);
  EXPECT_GE(report["pinched_edges"], 1);
}

TEST_F(Reduce, KeepsTheStatusOfACommand) {
  Mesh mesh = haystack();
  for (const std::size_t c : {100, 2000, 4000})
    std::swap(mesh.elements[3].vertices[4 * c], mesh.elements[3].vertices[4 * c + 1]);
  put("m.mesh", mesh);
  const std::string check = std::string(CLEAVE_COMMAND) + " check --quiet {}";
  const Outcome outcome = cleave({"reduce", "m.mesh", "-o", "it's.mesh", "--command", check});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_LE(get("it's.mesh").cells().size(), 2u);  // two cells that touch in a vertex fail as well
  EXPECT_EQ(cleave({"check", "it's.mesh"}).status, 1);
  EXPECT_EQ(files(), (std::vector<std::string>{"it's.mesh", "m.mesh"}));

  EXPECT_EQ(cleave({"reduce", "m.mesh", "-o", "s.mesh", "--command", "true {}"}).status, 3);
  EXPECT_EQ(cleave({"reduce", "m.mesh", "-o", "s.mesh", "--command", "false"}).status, 2);
  EXPECT_EQ(cleave({"reduce", "m.mesh", "-o", "s.txt", "--command", "false {}"}).status, 3);
}

TEST_F(Reduce, LeavesNothingAfterCtrlC) {
  put("m.mesh", haystack());
  const int child = start({CLEAVE_COMMAND, "reduce", "m.mesh", "-o", "s.mesh", "--command",
                           "touch now; sleep 20 # {}"});
  for (int i = 0; i < 600 && !std::filesystem::exists(folder_ / "now"); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_EQ(files().size(), 3u);
  kill(child, SIGINT);
  EXPECT_EQ(finish(child).status, 128 + SIGINT);
  EXPECT_EQ(files(), (std::vector<std::string>{"m.mesh", "now"}));
}

TEST_F(Reduce, SaysWhatCannotBeAskedTogether) {
  write("m.mesh", two_tetrahedra_with_groups());
  const auto status = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"reduce", "m.mesh", "-o", "s.mesh"});
    return cleave(more).status;
  };
  EXPECT_EQ(status({"--rule", "flat-cell", "--all"}), 2);
  EXPECT_EQ(status({"--rule", "flat-cell", "--expect", "shut"}), 2);
  EXPECT_EQ(status({"--all", "--expect", "open"}), 2);
  EXPECT_EQ(status({"--rule", "no-such-rule"}), 3);
  EXPECT_EQ(status({"--group", "no-such-group"}), 3);
  EXPECT_EQ(status({"--group", "7"}), 3);  // it opens
  EXPECT_EQ(status({"--all", "--expect", "pinched"}), 3);
  EXPECT_EQ(files(), std::vector<std::string>{"m.mesh"});
}

}  // namespace
}  // namespace cleave::app::test
