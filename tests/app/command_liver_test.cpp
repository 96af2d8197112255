#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "command_support.hpp"
#include "mesh_file.hpp"

namespace cleave::app::test {
namespace {

using nlohmann::json;

// Cuts of a real mesh: a liver segmented from a CT scan, with three vertices that are not
// cut-regular and three pinched edges.
class Liver : public CommandTest {
 protected:
  json cut(std::vector<std::string> args) const {
    args.insert(args.begin(), "cut");
    args.insert(args.end(), {"--verify", "all", "--json", "-"});
    const Outcome outcome = cleave(args);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.status == 0 ? json::parse(outcome.out) : json();
  }

  static std::string liver() { return data("liver-16k.mesh"); }
};

TEST_F(Liver, FallsIntoItsCellsWhenEverythingIsCut) {
  const json r = cut({liver(), "-o", "all.mesh", "--all"});
  EXPECT_EQ(r["mesh"]["cells"], 16014);
  EXPECT_EQ(r["mesh"]["vertices_before"], 3449);
  EXPECT_EQ(r["mesh"]["vertices_after"], 4 * 16014);
  EXPECT_EQ(r["pieces"]["after"], 16014);
  EXPECT_EQ(r["facets"]["shut"], 0);
  EXPECT_EQ(r["facets"]["requested"], r["facets"]["opened"]);
  EXPECT_GE(r["regularized"].size(), 3u);
  EXPECT_EQ(r["regularized"].size() + r["splits"].size(), 4u * 16014 - 3449);
  EXPECT_EQ(cleave({"check", "all.mesh", "--require", "manifold"}).status, 0);

  const json again = cut({"all.mesh", "-o", "again.mesh", "--all", "--forget"});
  EXPECT_EQ(again["facets"]["requested"], 0);
  EXPECT_EQ(again["mesh"]["vertices_after"], 4 * 16014);
}

TEST_F(Liver, OpensAlongASweepAndNothingMoreTheSecondTime) {
  write("blade.json", R"({"blade": [[[-10, 20, 95], [-10, 160, 95]], [[60, 20, 97], [60, 160, 97]],
                                    [[110, 20, 100], [110, 160, 100]]]})");
  const json r = cut({liver(), "-o", "cut.mesh", "--sweep", "blade.json"});
  const int opened = r["facets"]["opened"], shut = r["facets"]["shut"];
  EXPECT_GT(opened, 50);
  EXPECT_EQ(r["facets"]["requested"], opened + shut);
  EXPECT_EQ(r["cut_regular"], true);
  EXPECT_EQ(r["shut_facets"].size(), static_cast<std::size_t>(shut));

  const Mesh out = read_mesh(folder_ / "cut.mesh");
  std::size_t sides = 0;
  for (const Group& group : out.groups)
    if (group.name == "cut_minus" || group.name == "cut_plus") sides += group.elements.size();
  EXPECT_EQ(sides, 2u * opened);

  // The sides are boundary now; the shut facets stay shut when asked for again.
  std::vector<std::string> again{"cut.mesh", "-o",        "again.mesh", "--forget",
                                 "--group",  "cut_minus", "cut_plus"};
  if (shut > 0) again.push_back("cut_shut");
  const json second = cut(again);
  EXPECT_EQ(second["facets"]["opened"], 0);
  EXPECT_EQ(second["facets"]["shut"], shut);
  EXPECT_EQ(second["facets"]["not_interior"], 2 * opened);
  EXPECT_EQ(second["mesh"]["vertices_after"], r["mesh"]["vertices_after"]);

  const json repeated = cut({liver(), "-o", "cut.vtu", "--sweep", "blade.json"});
  EXPECT_EQ(repeated, [&] {  // the same cut, numbered from 0
    json expected = r;
    for (const char* key : {"splits", "regularized"})
      for (json& copy : expected[key]) copy["vertex"] = copy["vertex"].get<int>() - 1;
    return expected;
  }());
}

TEST_F(Liver, CutsWhatTheNearestVertexRuleSelects) {
  write("blade.json",
        R"({"blade": [[[-10, 20, 95], [-10, 160, 95]], [[110, 20, 100], [110, 160, 100]]]})");
  const json r = cut({liver(), "-o", "cut.mesh", "--sweep", "blade.json", "--select",
                      "nearest-vertex", "--ties", "both"});
  EXPECT_GT(r["facets"]["requested"], 20);
}

// The facets of a group, and how many cells have them.
struct Facets {
  std::size_t sides = 0;                   // of all its elements
  std::size_t interior = 0, boundary = 0;  // distinct ones
};

Facets facets_of(const Mesh& mesh, const Group& group) {
  std::map<std::set<Index>, std::size_t> cells_at;
  for (std::size_t c = 0; c < mesh.cells().size(); ++c)
    for (std::size_t left_out = 0; left_out < 4; ++left_out) {
      std::set<Index> facet;
      for (std::size_t i = 0; i < 4; ++i)
        if (i != left_out) facet.insert(mesh.cells().vertices[4 * c + i]);
      ++cells_at[facet];
    }
  Facets facets;
  std::set<std::set<Index>> distinct;
  for (const auto e : group.elements) {
    const auto* vertices = &mesh.facets().vertices[3 * std::size_t{e}];
    const std::set<Index> facet(vertices, vertices + 3);
    facets.sides += cells_at[facet];
    if (distinct.insert(facet).second) ++(cells_at[facet] == 2 ? facets.interior : facets.boundary);
  }
  return facets;
}

TEST_F(Liver, KeepsItsLabelsAndBothSidesOfTheSurfacesBetweenThem) {
  cut({liver(), "-o", "cut.mesh", "--all"});
  const Mesh before = read_mesh(liver()), after = read_mesh(folder_ / "cut.mesh");
  std::size_t compared = 0;
  for (const Group& group : before.groups)
    for (const Group& other : after.groups) {
      if (other.dimension != group.dimension || other.name != group.name || group.dimension < 2)
        continue;
      EXPECT_EQ(other.elements.size(),
                group.dimension == 3 ? group.elements.size() : facets_of(before, group).sides);
      ++compared;
    }
  EXPECT_EQ(compared, 6u);  // three labels, of facets and of cells
}

TEST_F(Liver, ScoresEachInteriorFacetOfALabelOnce) {
  const Mesh mesh = read_mesh(liver());
  std::size_t labels = 0;
  for (const Group& group : mesh.groups) {
    if (group.dimension != 2) continue;
    const json r = cut({liver(), "-o", "cut.mesh", "--group", group.name});
    const Facets facets = facets_of(mesh, group);
    EXPECT_EQ(r["facets"]["requested"], facets.interior);
    EXPECT_EQ(r["facets"]["not_interior"], facets.boundary);
    EXPECT_EQ(r["facets"]["opened"].get<int>() + r["facets"]["shut"].get<int>(),
              r["facets"]["requested"]);
    ++labels;
  }
  EXPECT_EQ(labels, 3u);
}

}  // namespace
}  // namespace cleave::app::test
