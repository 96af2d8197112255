// Cutting in stages and taking back: what a cut writes is a function of the mesh that was cut first
// and of what has been asked for, whichever way there (T8, T12).
#include <nlohmann/json.hpp>

#include "command_cut_support.hpp"
#include "mesh_file.hpp"

namespace cleave::app::test {
namespace {

using nlohmann::json;

class Stages : public CutTest {
 protected:
  // The file in the form in which we write its format.
  void normalise(const std::string& from, const std::string& to) const {
    write_mesh(folder_ / to, read_mesh(from));
  }

  void expect_same(const std::string& a, const std::string& b) const {
    EXPECT_TRUE(read(a) == read(b)) << a << " and " << b << " differ";
    EXPECT_TRUE(read(a + ".cleave.json") == read(b + ".cleave.json"))
        << "the records of " << a << " and " << b << " differ";
  }

  bool there(const std::string& name) const { return std::filesystem::exists(folder_ / name); }

  // Cuts a, then b; a and b at once; takes b back, then a: all ways give the same bytes.
  void expect_all_ways_meet(const std::string& mesh, const std::string& extension, const Args& a,
                            const Args& b, const Args& how = {}) const {
    const auto named = [&](const std::string& name) { return name + extension; };
    const auto with = [](Args args, const Args& more) {
      args.insert(args.end(), more.begin(), more.end());
      return args;
    };
    done(with(with({"cut", mesh, "-o", named("a")}, a), how));
    done(with({"cut", named("a"), "-o", named("ab"), "--verify", "all"}, b));
    done(with(with({"cut", mesh, "-o", named("b")}, b), how));
    done(with({"cut", named("b"), "-o", named("ba")}, a));
    done(with(with(with({"cut", mesh, "-o", named("once")}, b), a), how));
    expect_same(named("ab"), named("once"));
    expect_same(named("ba"), named("once"));
    done(with({"stitch", named("once"), "-o", named("a2"), "--verify", "all"}, b));
    expect_same(named("a2"), named("a"));
    done(with({"stitch", named("ab"), "-o", named("ab")}, a));  // in place
    expect_same(named("ab"), named("b"));
    done({"stitch", named("ba"), "-o", named("back"), "--all"});
    normalise(mesh[0] == '/' ? mesh : (folder_ / mesh).string(), named("original"));
    EXPECT_TRUE(read(named("back")) == read(named("original")));
    EXPECT_FALSE(there(named("back") + ".cleave.json"));
    done(with({"stitch", named("a"), "-o", named("a")}, a));
    EXPECT_TRUE(read(named("a")) == read(named("original")));
    EXPECT_FALSE(there(named("a") + ".cleave.json"));
  }
};

TEST_F(Stages, OfAGmshFileGiveTheSameBytesWhicheverWay) {
  expect_all_ways_meet(data("fault.msh"), ".msh", {"--group", "fault"}, {"--group", "branch"});
}

TEST_F(Stages, OfAMeditFileGiveTheSameBytesWhicheverWay) {
  normalise(data("fault.msh"), "fault.mesh");
  expect_all_ways_meet("fault.mesh", ".mesh", {"--group", "fault"}, {"--group", "branch"});
}

TEST_F(Stages, OfAVtuFileGiveTheSameBytesWhicheverWay) {
  normalise(data("fault.msh"), "fault.vtu");
  expect_all_ways_meet("fault.vtu", ".vtu", {"--group", "fault"}, {"--group", "branch"});
}

TEST_F(Stages, OfAnyFormatGiveTheSameBytesWhicheverWay) {
  for (const std::string extension : {".vtk", ".inp", ".ele"}) {
    SCOPED_TRACE(extension);
    expect_all_ways_meet(data("fault.msh"), extension, {"--group", "fault"}, {"--group", "branch"});
  }
}

// A disk of triangles, its spokes in groups; vertex 1 is in no cell, and a second disk touches the
// first one in a vertex, which is regularised.
std::string disks() {
  return R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
3
1 1 "east"
1 2 "north"
2 3 "plate"
$EndPhysicalNames
$Nodes
9
1 9 9 0
20 0 0 0
3 1 0 0
4 0 1 0
5 -1 0 0
6 0 -1 0
7 2 1 0
8 2 -1 0
9 7 7 0
$EndNodes
$Elements
9
1 1 2 1 1 20 3
2 1 2 2 1 4 20
3 1 2 4 1 1 20
4 2 2 3 1 20 3 4
5 2 2 3 1 20 4 5
6 2 2 3 1 20 5 6
7 2 2 3 1 20 6 3
8 2 2 3 1 3 8 7
9 15 2 4 1 3
$EndElements
)";
}

TEST_F(Stages, RememberShutFacetsOrphansAndWhatWasRegularised) {
  write("disks.msh", disks());
  // One spoke alone is shut; the second opens both.
  const Outcome first =
      cleave({"cut", "disks.msh", "-o", "a.msh", "--group", "east", "--json", "-"});
  ASSERT_EQ(first.status, 0) << first.err;
  const json one = json::parse(first.out);
  EXPECT_EQ(one["facets"]["opened"], 1);  // from the rim, whose vertex 3 was regularised
  expect_all_ways_meet("disks.msh", ".msh", {"--group", "east"}, {"--group", "north"});
  EXPECT_EQ(read("back.msh"), read("original.msh"));
  EXPECT_EQ(read_mesh(folder_ / "back.msh").points.size(), 9u);  // the orphans are there again
}

TEST_F(Stages, OpenWhatWasShutBefore) {
  write("star.mesh", star());
  const Outcome first = cleave({"cut", "star.mesh", "-o", "a.mesh", "--group", "7", "--json", "-"});
  ASSERT_EQ(first.status, 0) << first.err;
  EXPECT_EQ(json::parse(first.out)["facets"]["shut"], 1);
  done({"cut", "a.mesh", "-o", "b.mesh", "--group", "8"});
  const Outcome last = cleave({"cut", "b.mesh", "-o", "c.mesh", "--group", "9", "--json", "-"});
  ASSERT_EQ(last.status, 0) << last.err;
  const json report = json::parse(last.out);
  EXPECT_EQ(report["facets"]["opened"], 3);  // one cell comes off
  EXPECT_EQ(report["facets"]["requested"], 3);
  EXPECT_EQ(report["earlier"]["opened"].get<int>() + report["earlier"]["shut"].get<int>(), 2);
  EXPECT_EQ(report["pieces"], json::parse(R"({"before": 1, "after": 2})"));
  EXPECT_NE(last.err.find("going on from b.mesh.cleave.json"), std::string::npos) << last.err;
  done({"cut", "star.mesh", "-o", "once.mesh", "--group", "9", "7", "8", "7"});
  expect_same("c.mesh", "once.mesh");

  const Outcome back =
      cleave({"stitch", "c.mesh", "-o", "d.mesh", "--group", "9_minus", "--json", "-"});
  ASSERT_EQ(back.status, 0) << back.err;
  const json stitched = json::parse(back.out);
  EXPECT_EQ(stitched["facets"]["requested"], 1);
  EXPECT_EQ(stitched["facets"]["closed"], 1);
  EXPECT_EQ(stitched["facets"]["opened"].get<int>() + stitched["facets"]["shut"].get<int>(), 2);
  EXPECT_EQ(stitched["mesh"]["vertices_before"].get<std::size_t>() - stitched["merges"].size(),
            stitched["mesh"]["vertices_after"].get<std::size_t>());
  expect_same("d.mesh", "b.mesh");
}

TEST_F(Stages, ForgetANameThatIsTakenBackThoughItSharesFacets) {
  write("shared.mesh", medit({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1, 1, 1}},
                             {{1, 2, 5, 7}, {2, 4, 5, 7}, {2, 4, 5, 8}, {1, 4, 5, 8}, {1, 4, 5, 9}},
                             {{1, 2, 3, 5, 0}, {1, 4, 2, 5, 0}, {2, 4, 3, 5, 0}, {1, 3, 4, 5, 0}}));
  expect_all_ways_meet("shared.mesh", ".mesh", {"--group", "7"}, {"--group", "8"});
  // 9 lies within 8: nothing closes, but the name goes.
  expect_all_ways_meet("shared.mesh", ".mesh", {"--group", "8"}, {"--group", "9"});

  done({"cut", "shared.mesh", "-o", "a.mesh", "--group", "7"});
  done({"cut", "a.mesh", "-o", "all.mesh", "--all"});
  done({"stitch", "all.mesh", "-o", "rest.mesh", "--group", "cut"});
  expect_same("rest.mesh", "a.mesh");
  done({"stitch", "all.mesh", "-o", "rest.mesh", "--group", "7"});
  done({"cut", "shared.mesh", "-o", "only.mesh", "--all"});
  expect_same("rest.mesh", "only.mesh");
}

TEST_F(Stages, TakeFacetsBackByNumberFromEitherSide) {
  write("star.mesh", star());
  done({"cut", "star.mesh", "-o", "all.mesh", "--all"});
  const Mesh all = read_mesh(folder_ / "all.mesh");
  ASSERT_EQ(all.points.size(), 16u);
  const Outcome opened =
      cleave({"cut", "all.mesh", "--dry-run", "--explain", "--all", "--json", "-"});
  ASSERT_EQ(opened.status, 0) << opened.err;
  const json facets = json::parse(opened.out)["opened_facets"];
  ASSERT_EQ(facets.size(), 6u);
  write("three.json",
        json{{"facets", {facets[0]["facet"], facets[2]["facet"], facets[3]["facet"]}}}.dump());
  done({"stitch", "all.mesh", "-o", "less.mesh", "--facets", "three.json", "--verify", "all"});
  const json record = json::parse(read("less.mesh.cleave.json"));
  EXPECT_EQ(record["opened"].size() + record["shut"].size(), 3u);

  // The same facets by the numbers of the mesh before, cut from the start.
  json others{{"facets", json::array()}};
  const Mesh star_mesh = read_mesh(folder_ / "star.mesh");
  for (const char* list : {"opened", "shut"})
    for (const json& sides : record[list]) {
      const auto h = sides[0].get<std::size_t>();
      json facet = json::array();
      for (std::size_t i = 0; i < 4; ++i)
        if (i != h % 4) facet.push_back(star_mesh.cells().vertices[4 * (h / 4) + i] + 1);
      others["facets"].push_back(facet);
    }
  write("others.json", others.dump());
  done({"cut", "star.mesh", "-o", "direct.mesh", "--facets", "others.json"});
  expect_same("less.mesh", "direct.mesh");

  write("never.json", R"({"facets": [[1, 2, 3]]})");
  const Outcome never = cleave({"stitch", "less.mesh", "-o", "x.mesh", "--facets", "never.json"});
  EXPECT_EQ(never.status, 0);
  EXPECT_NE(never.err.find("never cut"), std::string::npos) << never.err;
  EXPECT_EQ(read("x.mesh"), read("less.mesh"));
}

TEST_F(Stages, OfEdgesAndThroughOtherFormats) {
  write("line.mesh",
        "MeshVersionFormatted 2\nDimension 2\nVertices\n5\n0 0 0\n1 0 0\n2 0 4\n3 0 0\n8 8 0\n"
        "Edges\n3\n1 2 7\n2 3 7\n3 4 7\nEnd\n");
  normalise((folder_ / "line.mesh").string(), "normal.mesh");
  write("f.json", R"({"facets": [[2]]})");
  write("g.json", R"({"facets": [[3]]})");
  expect_all_ways_meet("line.mesh", ".mesh", {"--facets", "f.json"}, {"--group", "4"});
  done({"cut", "line.mesh", "-o", "a.msh", "--facets", "f.json"});
  done({"stitch", "a.msh", "-o", "line2.mesh", "--all"});
  EXPECT_EQ(read("line2.mesh"), read("normal.mesh"));

  done({"cut", data("fault.msh"), "-o", "a.vtu", "--group", "fault"});
  done({"cut", "a.vtu", "-o", "ab.msh", "--group", "branch"});
  done({"cut", data("fault.msh"), "-o", "once.msh", "--group", "fault", "branch"});
  EXPECT_EQ(read("ab.msh"), read("once.msh"));
}

TEST_F(Stages, RefuseARecordThatDoesNotBelong) {
  write("star.mesh", star());
  done({"cut", "star.mesh", "-o", "a.mesh", "--group", "7", "8"});
  const std::string mesh = read("a.mesh"), record = read("a.mesh.cleave.json");
  const auto both = [&](const std::string& word) {
    refused({"cut", "a.mesh", "-o", "b.mesh", "--group", "9"}, word);
    refused({"stitch", "a.mesh", "-o", "b.mesh", "--all"}, word);
  };
  write("a.mesh", mesh + "\n");
  both("SHA-256");
  done({"cut", "a.mesh", "-o", "b.mesh", "--group", "9", "--forget"});
  std::filesystem::remove(folder_ / "b.mesh");
  std::filesystem::remove(folder_ / "b.mesh.groups.json");
  std::filesystem::remove(folder_ / "b.mesh.cleave.json");
  write("a.mesh", mesh);
  for (const std::size_t length : {std::size_t{0}, std::size_t{1}, record.size() / 2}) {
    write("a.mesh.cleave.json", record.substr(0, length));
    both("a.mesh.cleave.json");
  }
  std::filesystem::remove(folder_ / "a.mesh.cleave.json");
  refused({"stitch", "a.mesh", "-o", "b.mesh", "--all"}, "no a.mesh.cleave.json beside it");
}

// Every number of a record is replaced by others, every entry of a list or object left out: such a
// record is refused, or does what a record may do; it never breaks anything.
TEST_F(Stages, SurviveEveryDamageToARecord) {
  write("star.mesh", star());
  done({"cut", "star.mesh", "-o", "a.mesh", "--group", "7", "8", "9"});
  const json record = json::parse(read("a.mesh.cleave.json"));
  std::vector<json> damaged;
  const json flat = record.flatten();
  for (const auto& item : flat.items()) {
    const json::json_pointer place(item.key());
    if (item.key().rfind("/sha256", 0) == 0) continue;
    json changed = record;
    if (record[place].is_number()) {
      for (const json& other : {json(record[place].get<double>() + 1), json(4294967294u),
                                json(18446744073709551615u), json(-1), json(0.5), json("7")}) {
        changed[place] = other;
        damaged.push_back(changed);
      }
    } else {
      changed[place] = 7;
      damaged.push_back(changed);
    }
    changed = record;
    if (changed[place.parent_pointer()].is_array())
      changed[place.parent_pointer()].erase(std::stoul(place.back()));
    else
      changed[place.parent_pointer()].erase(place.back());
    damaged.push_back(changed);
  }
  ASSERT_GT(damaged.size(), 200u);
  std::size_t refusals = 0;
  for (std::size_t i = 0; i < damaged.size(); i += 3) {  // every kind is met
    write("a.mesh.cleave.json", damaged[i].dump());
    const Outcome outcome = cleave({"stitch", "a.mesh", "--dry-run", "--all"});
    ASSERT_TRUE(outcome.status == 0 || outcome.status == 3)
        << outcome.status << ' ' << outcome.err << '\n'
        << damaged[i].dump();
    if (outcome.status == 3) ++refusals;
  }
  EXPECT_GT(3 * refusals, damaged.size() / 3);
}

TEST_F(Stages, MakeCohesiveElementsAnewForAllThatIsOpen) {
  expect_all_ways_meet(data("fault.msh"), ".msh", {"--group", "fault"}, {"--group", "branch"},
                       {"--cohesive"});
}

TEST_F(Stages, RefuseFormatsWithoutCohesiveElements) {
  done({"cut", data("fault.msh"), "-o", "a.msh", "--group", "fault", "branch", "--cohesive"});
  for (const std::string out : {"x.mesh", "x.node"}) {
    refused({"cut", data("fault.msh"), "-o", out, "--group", "fault", "--cohesive"}, out);
    refused({"cut", "a.msh", "-o", out, "--all"}, "cohesive elements");
    refused({"stitch", "a.msh", "-o", out, "--group", "fault"}, "cohesive elements");
    done({"stitch", "a.msh", "-o", out, "--all"});
  }
}

TEST_F(Stages, KeepTheRecordBesideTheFileThatALinkNames) {
  normalise(data("fault.msh"), "m.msh");
  std::filesystem::create_symlink("m.msh", folder_ / "l.msh");
  done({"cut", "l.msh", "-o", "l.msh", "--group", "fault"});
  EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "l.msh"));
  EXPECT_EQ(files(), (std::vector<std::string>{"l.msh", "m.msh", "m.msh.cleave.json"}));
  done({"cut", "m.msh", "-o", "m.msh", "--group", "branch"});
  done({"cut", data("fault.msh"), "-o", "once.msh", "--group", "fault", "branch"});
  expect_same("m.msh", "once.msh");
  done({"stitch", "l.msh", "-o", "l.msh", "--all"});
  EXPECT_FALSE(there("m.msh.cleave.json"));
  normalise(data("fault.msh"), "original.msh");
  EXPECT_TRUE(read("m.msh") == read("original.msh"));
}

TEST_F(Stages, OfAMeshThatAnotherCommandReplacesStartAnew) {
  done({"cut", data("fault.msh"), "-o", "a.msh", "--group", "fault"});
  done({"convert", data("fault.msh"), "a.msh"});
  EXPECT_EQ(files(), std::vector<std::string>{"a.msh"});
  done({"cut", "a.msh", "-o", "b.msh", "--group", "fault"});
  write("star.mesh", star());
  done({"reduce", "star.mesh", "-o", "b.msh", "--group", "7", "--expect", "shut"});
  EXPECT_FALSE(there("b.msh.cleave.json"));
  done({"cut", "b.msh", "-o", "c.msh", "--all"});
  EXPECT_EQ(cleave({"convert", "c.msh", "d.msh", "--json", "d.msh.cleave.json"}).status, 2);
}

TEST_F(Stages, WarnOfALostRecord) {
  done({"cut", data("fault.msh"), "-o", "a.msh", "--group", "fault"});
  std::filesystem::rename(folder_ / "a.msh", folder_ / "moved.msh");
  const Args cut{"cut", "moved.msh", "--dry-run", "--group", "branch"};
  const std::string warning =
      "moved.msh looks cut before, but moved.msh.cleave.json is missing: it is taken as a new mesh";
  const Outcome lost = cleave(cut);
  EXPECT_EQ(lost.status, 0);
  EXPECT_NE(lost.err.find(warning), std::string::npos) << lost.err;
  refused({"stitch", "moved.msh", "-o", "b.msh", "--all"}, "looks cut before: restore the file");
  std::filesystem::rename(folder_ / "a.msh.cleave.json", folder_ / "moved.msh.cleave.json");
  EXPECT_EQ(cleave(cut).err.find(warning), std::string::npos);
  const Outcome whole = cleave({"cut", data("fault.msh"), "--dry-run", "--group", "branch"});
  EXPECT_EQ(whole.err.find("looks cut"), std::string::npos) << whole.err;
}

TEST_F(Stages, KeepMovedPointsInTheRecord) {
  done({"cut", data("fault.msh"), "-o", "a.msh", "--group", "fault", "--offset", "0.01"});
  done({"cut", "a.msh", "-o", "ab.msh", "--group", "branch"});
  done({"cut", data("fault.msh"), "-o", "once.msh", "--group", "fault", "branch", "--offset",
        "0.01"});
  expect_same("ab.msh", "once.msh");
  done({"stitch", "ab.msh", "-o", "back.msh", "--all"});
  normalise(data("fault.msh"), "original.msh");
  EXPECT_TRUE(read("back.msh") == read("original.msh"));
}

TEST_F(Stages, MoveThePointsBackWhenAsked) {
  done({"cut", data("fault.msh"), "-o", "a.msh", "--group", "fault", "--offset", "0.01"});
  refused({"cut", "a.msh", "-o", "x.msh", "--group", "branch", "--cohesive"},
          "its record moves the sides apart by 0.01; give --offset 0 with --cohesive");
  done({"cut", "a.msh", "-o", "flat.msh", "--group", "branch", "--offset", "0"});
  done({"cut", data("fault.msh"), "-o", "once.msh", "--group", "fault", "branch"});
  expect_same("flat.msh", "once.msh");
  done({"cut", "a.msh", "-o", "c.msh", "--group", "branch", "--offset", "0", "--cohesive"});
  done({"cut", data("fault.msh"), "-o", "once.msh", "--group", "fault", "branch", "--cohesive"});
  expect_same("c.msh", "once.msh");
  refused({"cut", "c.msh", "-o", "x.msh", "--group", "branch", "--offset", "0.1"}, "thickness");
  for (const std::string distance : {"-1", "inf", "nan"}) {
    const Outcome odd = cleave({"cut", "a.msh", "--dry-run", "--all", "--offset", distance});
    EXPECT_EQ(odd.status, 2) << odd.err;
    EXPECT_LT(odd.err.size(), 200u) << odd.err;
  }
}

}  // namespace
}  // namespace cleave::app::test
