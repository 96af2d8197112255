#include "command_support.hpp"

namespace cleave::app::test {
namespace {

// What every refusal has in common: status 3, one message that says what and where, and nothing new
// in the folder.
class BadInput : public CommandTest {
 protected:
  void refused(const std::vector<std::string>& args, const std::vector<std::string>& said) const {
    const auto before = files();
    const Outcome outcome = cleave(args);
    EXPECT_EQ(outcome.status, 3) << outcome.out << outcome.err;
    EXPECT_EQ(outcome.err.rfind("cleave: error: ", 0), 0u) << outcome.err;
    for (const std::string& words : said)
      EXPECT_NE(outcome.err.find(words), std::string::npos) << words << " is not in\n"
                                                            << outcome.err;
    EXPECT_EQ(files(), before);
  }

  // Both commands refuse this mesh; the report of `check` says so as well.
  void mesh_refused(const std::string& name, const std::vector<std::string>& said) const {
    refused({"check", name}, said);
    EXPECT_EQ(cleave({"check", name, "--json", "r.json"}).status, 3);
    for (const std::string& words : said)
      EXPECT_NE(read("r.json").find(words), std::string::npos) << words;
    std::filesystem::remove(folder_ / "r.json");
    refused({"cut", name, "-o", "out.mesh", "--all", "--json", "r.json"}, said);
  }

  // `cut` refuses m.mesh with this file of facets or sweep.
  void request_refused(const std::string& option, const std::string& text,
                       const std::vector<std::string>& said) const {
    write("m.mesh", two_tetrahedra());
    write("request.json", text);
    refused({"cut", "m.mesh", "-o", "out.mesh", option, "request.json"}, said);
  }
};

TEST_F(BadInput, MissingEmptyOrUnknownFile) {
  mesh_refused("none.mesh", {"none.mesh"});
  write("empty.mesh", "");
  mesh_refused("empty.mesh", {"empty.mesh", "empty"});
  write("m.stl", two_tetrahedra());
  mesh_refused("m.stl", {"m.stl", ".mesh"});
  std::filesystem::create_directory(folder_ / "folder.mesh");
  refused({"check", "folder.mesh", "--json", "r.json"}, {"folder.mesh"});
  refused({"cut", "folder.mesh", "-o", "out.mesh", "--all", "--json", "r.json"}, {"folder.mesh"});
}

TEST_F(BadInput, OnlyAListIsTakenForJson) {
  write("list.inp", "[[1, 2], [3, 4]]\n");
  mesh_refused("list.inp", {"list.inp", "a JSON file"});
  write("sections.inp", "[section]\nkey = 1\n");
  mesh_refused("sections.inp", {"sections.inp"});
  EXPECT_EQ(cleave({"check", "sections.inp"}).err.find("JSON"), std::string::npos);
}

TEST_F(BadInput, TruncatedFile) {
  const std::string whole = two_tetrahedra();
  for (const std::size_t part : {whole.size() / 4, whole.size() / 2, whole.size() - 6}) {
    write("m.mesh", whole.substr(0, part));
    mesh_refused("m.mesh", {"m.mesh:"});
  }
}

TEST_F(BadInput, MeshesThatCannotBeCutAreRefusedWithTheirNumbers) {
  const std::vector<Point> points{{0, 0, 0}, {1, 0, 0},  {0, 1, 0},
                                  {0, 0, 1}, {0, 0, -1}, {1, 1, 1}};
  const auto cut_refused = [&](const std::string& mesh, const std::vector<std::string>& said) {
    write("m.mesh", mesh);
    refused({"cut", "m.mesh", "-o", "out.mesh", "--all"}, said);
  };
  cut_refused(medit(points, {}, {{1, 2, 3, 4, 0}, {2, 3, 1, 4, 0}}), {"cells 1 and 2"});
  cut_refused(medit(points, {}, {{1, 2, 3, 4, 0}, {1, 2, 2, 5, 0}}), {"cell 2", "vertex 2"});
  cut_refused(medit(points, {}, {{1, 2, 3, 4, 0}, {1, 3, 2, 5, 0}, {1, 2, 3, 6, 0}}),
              {"facet (1 2 3) is in 3 cells: 1 2 3"});
  cut_refused(band(6, true), {"cannot be oriented", "closed chain of"});
  cut_refused(solid_band(6), {"cannot be oriented", "closed chain of"});
  cut_refused(
      "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 nan 0 0\n0 1 0 0\n"
      "0 0 1 0\nTetrahedra\n1\n1 2 3 4 0\nEnd\n",
      {"vertex 2", "not finite"});
}

TEST_F(BadInput, UnknownGroupListsTheGroupsThereAre) {
  write("m.mesh", two_tetrahedra_with_groups());
  refused({"cut", "m.mesh", "-o", "out.mesh", "--group", "fault"}, {"\"fault\"", "7, 8"});
  refused({"cut", "m.mesh", "-o", "out.mesh", "--group", "1"}, {"\"1\"", "7, 8"});  // of cells
  write("n.mesh", two_tetrahedra());
  refused({"cut", "n.mesh", "-o", "out.mesh", "--group", "fault"}, {"has no facet groups"});
}

TEST_F(BadInput, FacetsThatAreNotInTheMesh) {
  request_refused("--facets", R"({"facets": [[1, 2, 3], [1, 4, 5]]})", {"(1 4 5)", "request.json"});
  request_refused("--facets", R"({"facets": [[1, 2, 3], [1, 2, 99]]})",
                  {"/facets/1/2", "vertex 99"});
  request_refused("--facets", R"({"facets": [[1, 2, 2]]})", {"(1 2 2)"});
  request_refused("--facets", R"({"facets": [[1, 2]]})", {"/facets/0", "3 vertices"});
}

TEST_F(BadInput, MalformedRequests) {
  request_refused("--facets", "{\n\"facets\": [[1, 2, 3]\n", {"request.json", "line 3"});
  request_refused("--facets", R"({"faces": [[1, 2, 3]]})", {"faces"});
  request_refused("--facets", R"([[1, 2, 3]])", {"request.json"});
  request_refused("--facets", R"({"facets": [[1, 2, -3]]})", {"/facets/0/2"});
  request_refused("--facets", R"({"facets": [[1, 2, 2.5]]})", {"/facets/0/2"});
  request_refused("--facets", R"({"facets": [], "facets": []})", {"twice"});
  request_refused("--facets", "", {"request.json", "empty"});
  request_refused("--sweep", R"({"blade": [[[0,0,0],[1,0,0]], [[0,1,0],[1,NaN,0]]]})", {"line 1"});
  request_refused("--sweep", R"({"blade": [[[0,0,0],[1,0,0]], [[0,1,0],[1,1e999,0]]]})", {"1e999"});
  request_refused("--sweep", R"({"blade": [[[0,0,0],[1,0,0]], [[0,1,0],[1,1]]]})", {"/blade/1/1"});
  request_refused("--sweep", R"({"blade": [[[0,0,0],[1,0,0]]]})", {"/blade", "two positions"});
  request_refused("--sweep", R"({"blade": [], "triangles": []})", {"exclude"});
  request_refused("--sweep", R"({"triangles": [], "speed": 1})", {"speed"});
  const std::string two =
      R"({"triangles": [[[0,0,0],[1,0,0],[0,1,0]], [[0,0,0],[1,0,0],[0,1,0]]],)";
  request_refused("--sweep", two + R"("step_of_triangle": [0]})", {"/step_of_triangle", "2"});
  request_refused("--sweep", two + R"("step_of_triangle": [1, 0]})", {"/step_of_triangle/1"});
  request_refused("--sweep", R"({"polyline": [[0,0],[1,1]]})", {"three-dimensional"});
}

TEST_F(BadInput, ASweepThatMissesTheBodySelectsNothing) {
  write("m.mesh", two_tetrahedra());
  write("s.json", R"({"blade": [[[50,0,0],[51,0,0]], [[50,1,0],[51,1,0]]]})");
  const Outcome outcome = cleave({"cut", "m.mesh", "-o", "out.mesh", "--sweep", "s.json"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.err.find("cleave: warning: s.json: the sweep selects no facet"),
            std::string::npos)
      << outcome.err;
  EXPECT_EQ(files(),
            (std::vector<std::string>{"m.mesh", "out.mesh", "out.mesh.cleave.json", "s.json"}));
}

TEST_F(BadInput, OutputThatCannotBeWritten) {
  write("m.mesh", two_tetrahedra());
  refused({"cut", "m.mesh", "-o", "nowhere/out.mesh", "--all"}, {"nowhere"});
  refused({"cut", "m.mesh", "-o", "out.xyz", "--all"}, {"out.xyz"});
  refused({"cut", "m.mesh", "-o", "out.mesh", "--all", "--json", "nowhere/r.json"}, {"nowhere"});
  refused({"check", "m.mesh", "--json", "nowhere/r.json"}, {"nowhere"});
  if (std::filesystem::exists("/dev/full")) {
    refused({"cut", "m.mesh", "--dry-run", "--all", "--json", "/dev/full"}, {"/dev/full"});
    std::filesystem::create_symlink("/dev/full", folder_ / "full.mesh");
    refused({"cut", "m.mesh", "-o", "full.mesh", "--all"}, {"full.mesh"});
    const Outcome full =
        run({"sh", "-c", std::string(CLEAVE_COMMAND) + " check m.mesh > /dev/full"});
    EXPECT_EQ(full.status, 3);
    EXPECT_NE(full.err.find("standard output"), std::string::npos) << full.err;
  }
}

TEST_F(BadInput, AReadOnlyFolderIsLeftAsItWas) {
  write("m.mesh", two_tetrahedra());
  std::filesystem::create_directory(folder_ / "locked");
  std::filesystem::permissions(
      folder_ / "locked", std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  const Outcome outcome = cleave({"cut", "m.mesh", "-o", "locked/out.mesh", "--all"});
  const bool written = std::filesystem::exists(folder_ / "locked" / "out.mesh");
  EXPECT_EQ(outcome.status, written ? 0 : 3);  // the superuser may write anywhere
  EXPECT_EQ(std::filesystem::is_empty(folder_ / "locked"), !written);
}

TEST_F(BadInput, WrongUsageIsStatusTwo) {
  write("m.mesh", two_tetrahedra());
  for (const std::vector<std::string>& args : std::vector<std::vector<std::string>>{
           {},
           {"split"},
           {"check"},
           {"check", "m.mesh", "--require", "perfect"},
           {"cut", "m.mesh", "-o", "out.mesh"},
           {"cut", "m.mesh", "--all"},
           {"cut", "m.mesh", "-o", "out.mesh", "--all", "--group", "7"},
           {"cut", "m.mesh", "-o", "out.mesh", "--all", "--select", "dual-edge"},
           {"cut", "m.mesh", "-o", "out.mesh", "--all", "--sharp"}}) {
    const Outcome outcome = cleave(args);
    EXPECT_EQ(outcome.status, 2) << outcome.out << outcome.err;
    EXPECT_FALSE(outcome.err.empty());
  }
  EXPECT_EQ(files(), std::vector<std::string>{"m.mesh"});
}

TEST_F(BadInput, WrongUsageIsAnsweredWithWhatThereIs) {
  write("m.mesh", two_tetrahedra());
  const auto answer = [&](const std::vector<std::string>& args) {
    const Outcome outcome = cleave(args);
    EXPECT_EQ(outcome.status, 2) << outcome.out << outcome.err;
    EXPECT_EQ(outcome.err.rfind("cleave: error: ", 0), 0u) << outcome.err;
    return outcome.err;
  };
  EXPECT_NE(answer({"split"}).find("no command 'split'; there are check, "), std::string::npos);
  EXPECT_NE(answer({"cut", "m.mesh"}).find("`cleave cut --help`"), std::string::npos);
  EXPECT_NE(answer({"check", "m.mesh", "--require", "perfect"})
                .find("'perfect'; known are pseudo-manifold, cut-regular, edge-regular, manifold"),
            std::string::npos);
  for (const std::vector<std::string>& args : std::vector<std::vector<std::string>>{
           {"check", "m.mesh", "--require", "2"},
           {"cut", "m.mesh", "--dry-run", "--all", "--verify", "1"},
           {"cut", "m.mesh", "--dry-run", "--sweep", "s.json", "--select", "1"}})
    EXPECT_NE(answer(args).find("unknown value"), std::string::npos);
}

TEST_F(BadInput, AReportDoesNotOverwriteWhatTheCommandReadsOrWrites) {
  write("m.mesh", two_tetrahedra());
  write("f.json", R"({"facets": [[1, 2, 3]]})");
  const std::vector<std::string> cut{"cut", "m.mesh", "-o", "out.mesh", "--facets", "f.json"};
  for (const std::string report : {"m.mesh", "./m.mesh", "out.mesh", "./out.mesh", "f.json"}) {
    auto args = cut;
    args.insert(args.end(), {"--json", report});
    const Outcome outcome = cleave(args);
    EXPECT_EQ(outcome.status, 2) << report;
    EXPECT_NE(outcome.err.find("would overwrite"), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(cleave({"check", "m.mesh", "--json", "m.mesh"}).status, 2);
  EXPECT_EQ(files(), (std::vector<std::string>{"f.json", "m.mesh"}));
  EXPECT_EQ(read("m.mesh"), two_tetrahedra());
}

TEST_F(BadInput, AnErrorIsAnErrorAlsoWhereNobodyHears) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  const Outcome deaf =
      run({"sh", "-c", std::string(CLEAVE_COMMAND) + " check none.mesh 2> /dev/full"});
  EXPECT_EQ(deaf.status, 3);
}

TEST_F(BadInput, HelpAndVersionAreFine) {
  for (const std::vector<std::string>& args :
       std::vector<std::vector<std::string>>{{"--help"}, {"check", "--help"}, {"cut", "--help"}}) {
    const Outcome outcome = cleave(args);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_TRUE(outcome.err.empty());
    EXPECT_NE(outcome.out.find("cleave"), std::string::npos);
  }
  EXPECT_EQ(cleave({"--version"}).out.rfind("cleave 0.", 0), 0u);
}

}  // namespace
}  // namespace cleave::app::test
