// What a cut is asked for besides facets: what to keep, which level to reach, what would open more.
#include <nlohmann/json.hpp>

#include "command_cut_support.hpp"
#include "mesh_file.hpp"

namespace cleave::app::test {
namespace {

using nlohmann::json;

using Request = CutTest;

TEST_F(Request, OfferFacetsThatOpenWhatIsShut) {
  write("star.mesh", star());
  const Outcome asked = cleave({"cut", "star.mesh", "--group", "7", "--dry-run", "--explain",
                                "--fix-it", "more.json", "--json", "r.json"});
  ASSERT_EQ(asked.status, 0) << asked.err;
  EXPECT_NE(asked.out.find("would open with: ("), std::string::npos) << asked.out;
  const json report = json::parse(read("r.json"));
  ASSERT_EQ(report["shut_facets"].size(), 1u);
  EXPECT_EQ(report["shut_facets"][0]["fix"]["exact"], true);
  const json fix = report["shut_facets"][0]["fix"]["facets"];
  EXPECT_EQ(fix.size(), 1u);  // around a vertex on the rim the star has three cells
  EXPECT_EQ(json::parse(read("more.json"))["facets"], fix);
  const Outcome opened = cleave({"cut", "star.mesh", "-o", "a.mesh", "--group", "7", "--facets",
                                 "more.json", "--require-open"});
  EXPECT_EQ(opened.status, 0) << opened.out << opened.err;
}

TEST_F(Request, RequireALevel) {
  // Two cells that share an edge only, joined by others around a third vertex of it.
  write("annulus.mesh", suspended_annulus());
  write("none.json", R"({"facets": []})");
  refused({"cut", "annulus.mesh", "-o", "a.mesh", "--facets", "none.json", "--require", "manifold"},
          "link");
  done(
      {"cut", "annulus.mesh", "-o", "a.mesh", "--facets", "none.json", "--require", "cut-regular"});
  const Outcome cut = cleave({"cut", "annulus.mesh", "-o", "b.mesh", "--facets", "none.json",
                              "--require", "manifold", "--require-by", "cutting", "--json", "-"});
  ASSERT_EQ(cut.status, 0) << cut.err;
  const json report = json::parse(cut.out);
  EXPECT_GT(report["facets"]["added"], 0);
  EXPECT_EQ(report["facets"]["added"], report["added_facets"].size());
  EXPECT_EQ(cleave({"check", "b.mesh", "--require", "manifold"}).status, 0);
}

TEST_F(Request, TakeRequestsFromStandardInputAndRefuseOddOnes) {
  write("star.mesh", star());
  const auto piped = [&](const std::string& rest) {
    return run({"sh", "-c",
                "echo '{\"facets\": [[1, 2, 5], [2, 4, 5]]}' | " + std::string(CLEAVE_COMMAND) +
                    " cut star.mesh " + rest});
  };
  EXPECT_EQ(piped("-o a.mesh --facets -").status, 0);
  write("f.json", R"({"facets": [[1, 2, 5], [2, 4, 5]]})");
  done({"cut", "star.mesh", "-o", "b.mesh", "--facets", "f.json"});
  EXPECT_EQ(read("a.mesh"), read("b.mesh"));
  EXPECT_EQ(piped("-o c.mesh --facets - --sweep -").status, 2);
  EXPECT_EQ(
      cleave({"cut", "star.mesh", "-o", "c.mesh", "--sweep", "f.json", "--ties", "both"}).status,
      2);
  EXPECT_EQ(cleave({"stitch", "a.mesh", "-o", "c.mesh"}).status, 2);
  const Outcome none =
      run({"sh", "-c",
           std::string(CLEAVE_COMMAND) + " cut star.mesh -o c.mesh --facets - < /dev/null"});
  EXPECT_EQ(none.status, 3);
  EXPECT_NE(none.err.find("standard input"), std::string::npos) << none.err;
}

TEST_F(Request, WriteNothingIfTheReportCannotBePrinted) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  write("star.mesh", star());
  const auto before = files();
  for (const std::string& rest : {std::string("--json -"), std::string()}) {
    const Outcome full = run(
        {"sh", "-c",
         std::string(CLEAVE_COMMAND) + " cut star.mesh -o a.mesh --all " + rest + " > /dev/full"});
    EXPECT_EQ(full.status, 3) << full.err;
    EXPECT_NE(full.err.find("standard output"), std::string::npos) << full.err;
    EXPECT_EQ(files(), before);
  }
}

TEST_F(Request, KeepNamedFacetsOut) {
  write("star.mesh", star());
  const Outcome cut =
      cleave({"cut", "star.mesh", "-o", "a.mesh", "--all", "--keep", "7", "9", "--json", "-"});
  ASSERT_EQ(cut.status, 0) << cut.err;
  const json report = json::parse(cut.out);
  EXPECT_EQ(report["facets"]["kept"], 2);
  EXPECT_EQ(report["facets"]["requested"], 4);
  const Mesh out = read_mesh(folder_ / "a.mesh");
  for (const Group& group : out.groups) {
    if (group.name == "7" || group.name == "9") {
      EXPECT_EQ(group.elements.size(), 1u) << group.name;
    }
  }
  refused({"cut", "star.mesh", "-o", "b.mesh", "--all", "--keep", "10"}, "\"10\"");
}

TEST_F(Request, RefuseToReachALevelThroughFacetsToBeKept) {
  write("annulus.mesh", suspended_annulus());
  write("none.json", R"({"facets": []})");
  const std::vector<std::string> reach{"--require", "manifold", "--require-by", "cutting"};
  const auto cut = [&](const std::string& mesh, std::vector<std::string> args) {
    args.insert(args.begin(), {"cut", mesh});
    args.insert(args.end(), reach.begin(), reach.end());
    return args;
  };
  const Outcome free =
      cleave(cut("annulus.mesh", {"--dry-run", "--facets", "none.json", "--json", "-"}));
  ASSERT_EQ(free.status, 0) << free.err;
  const json wanted = json::parse(free.out)["added_facets"];
  ASSERT_FALSE(wanted.empty());

  // The same mesh with the first of these facets in a group.
  Mesh mesh = read_mesh(folder_ / "annulus.mesh");
  Group group;
  group.dimension = 2;
  group.name = "seam";
  group.elements = {static_cast<Index>(mesh.facets().size())};
  for (const json& number : wanted[0]) mesh.elements[2].vertices.push_back(number.get<Index>() - 1);
  mesh.elements[2].numbers.push_back(100000);
  mesh.groups.push_back(group);
  write_mesh(folder_ / "seam.msh", mesh);
  refused(cut("seam.msh", {"-o", "a.msh", "--facets", "none.json", "--keep", "seam"}),
          "1 facet that --keep excludes: (");
  const Outcome all = cleave(cut("seam.msh", {"-o", "a.msh", "--facets", "none.json"}));
  EXPECT_EQ(all.status, 0) << all.err;
}

TEST_F(Request, OfferNoFacetsThatAreToBeKept) {
  write("star.mesh", star());
  const auto ask = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"cut", "star.mesh", "--dry-run", "--explain", "--fix-it",
                               "more.json", "--json", "r.json"});
    const Outcome outcome = cleave(more);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.out;
  };
  ask({"--group", "7"});
  const json fix = json::parse(read("r.json"))["fix"];
  ASSERT_EQ(fix["facets"].size(), 1u);
  EXPECT_FALSE(fix.contains("kept"));

  // The same facet, now in the group 10.
  Tuple facet = fix["facets"][0].get<Tuple>();
  facet.push_back(10);
  write("star.mesh",
        medit({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1, 1, 1}}, {{1, 2, 5, 7}, facet},
              {{1, 2, 3, 5, 0}, {1, 4, 2, 5, 0}, {2, 4, 3, 5, 0}, {1, 3, 4, 5, 0}}));
  const std::string text = ask({"--group", "7", "--keep", "10"});
  EXPECT_EQ(text.find("would open with: "), std::string::npos) << text;
  EXPECT_NE(text.find("has facets of --keep"), std::string::npos) << text;
  const json report = json::parse(read("r.json"));
  for (const json& offer : {report["fix"], report["shut_facets"][0]["fix"]}) {
    EXPECT_EQ(offer["facets"], json::array());
    EXPECT_EQ(offer["exact"], false);
    EXPECT_EQ(offer["kept"], fix["facets"]);
  }
  EXPECT_EQ(json::parse(read("more.json")), json::parse(R"({"facets": []})"));
  const Outcome valid = run({"/usr/bin/python3", CLEAVE_VALIDATE_JSON,
                             CLEAVE_SCHEMAS "/cleave-cut-1.schema.json", "r.json"});
  EXPECT_TRUE(valid.status == 0 || valid.status == 77) << valid.err;  // 77: no validator here

  const std::string open = ask({"--all"});
  EXPECT_NE(open.find("nothing is shut"), std::string::npos) << open;
}

TEST_F(Request, LeaveSweptFacetsAloneThatAreToBeKept) {
  write("half.json", R"({"blade": [[[-1, 1.5, -1], [-1, 1.5, 5]], [[9, 1.5, -1], [9, 1.5, 5]]]})");
  const auto report = [&](const std::vector<std::string>& more) {
    std::vector<std::string> args{"cut",       data("fault.msh"), "--dry-run", "--sweep",
                                  "half.json", "--json",          "-"};
    args.insert(args.end(), more.begin(), more.end());
    const Outcome outcome = cleave(args);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return json::parse(outcome.out);
  };
  const json all = report({}), kept = report({"--keep", "fault"});
  ASSERT_GT(kept["facets"]["kept"], 0);
  EXPECT_EQ(kept["facets"]["kept"].get<int>() + kept["facets"]["requested"].get<int>(),
            all["facets"]["requested"].get<int>());
}

}  // namespace
}  // namespace cleave::app::test
