// Certificates: what `cut` and `stitch` write, and what `certify` says of that and of anything
// else.
#include <nlohmann/json.hpp>
#include <regex>

#include "certificate.hpp"
#include "command_cut_support.hpp"
#include "mesh_file.hpp"

namespace cleave::app::test {
namespace {

using nlohmann::json;

class Certify : public CutTest {
 protected:
  // The certificate is that of the mesh in `original` cut to the one in `out`, along `facets`
  // facets.
  void expect_certifies(const std::string& certificate, const std::string& original,
                        const std::string& out, std::size_t facets) const {
    const Outcome outcome = cleave({"certify", certificate});
    EXPECT_EQ(outcome.out, "accepted\n") << outcome.err;
    EXPECT_EQ(outcome.status, 0);
    const CertificateFile file(InputText(folder_ / certificate));
    EXPECT_EQ(file.certificate().before, numbers_of(original));
    EXPECT_EQ(file.certificate().after, numbers_of(out));
    EXPECT_EQ(file.certificate().facet_count(), facets);
  }

  std::vector<Index> numbers_of(const std::string& name) const {
    const Mesh mesh = read_mesh(folder_ / name);
    std::vector<Index> numbers;
    for (const Index v : mesh.cells().vertices)
      numbers.push_back(static_cast<Index>(mesh.vertex_numbers[v]));
    return numbers;
  }

  void expect_verdict(const std::string& text, const std::string& verdict, int status) const {
    write("c.cert", text);
    const Outcome outcome = cleave({"certify", "c.cert"});
    EXPECT_EQ(outcome.out.substr(0, verdict.size()), verdict) << text << outcome.err;
    EXPECT_EQ(outcome.status, status) << text << outcome.err;
  }

  void expect_malformed(const std::string& text, const std::string& message) const {
    write("c.cert", text);
    const Outcome outcome = cleave({"certify", "c.cert"});
    EXPECT_EQ(outcome.status, 3) << text;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, "cleave: error: c.cert:" + message + "\n");
  }
};

std::string two_triangles(const std::string& after, const std::string& cut = "cut 0\n") {
  return "cleave-certificate 1\ndimension 2\ncells 2\nbefore\n1 2 3\n2 3 4\n" + cut + "after\n" +
         after + "end\n";
}

// T12_regular: to stitch all gives the start back; that is unglue of it iff it is cut-regular.
TEST_F(Certify, WhatIsLeftOfAMeshThatIsNotCutRegularHasNoCertificateWhenNothingIs) {
  for (const auto& [mesh, how] :
       {std::pair<std::string, Args>{data("bowtie.msh"), {"--group", "line"}},
        {data("liver-16k.mesh"), {"--sweep", data("liver.sweep.json")}}}) {
    SCOPED_TRACE(mesh);
    const std::string extension = std::filesystem::path(mesh).extension().string();
    const std::string cut = "cut" + extension, whole = "whole" + extension;
    Args args = {"cut", mesh, "-o", cut, "--certificate", "cut.cert", "--verify", "all"};
    args.insert(args.end(), how.begin(), how.end());
    done(args);
    EXPECT_EQ(cleave({"certify", "cut.cert"}).out, "accepted\n");
    refused({"stitch", cut, "-o", whole, "--all", "--certificate", "w.cert"}, "no certificate");
    const Outcome back = cleave({"stitch", cut, "-o", whole, "--all", "--verify", "all"});
    EXPECT_EQ(back.status, 0) << back.err;
    EXPECT_NE(back.err.find("that have no facet in common"), std::string::npos) << back.err;
    EXPECT_EQ(numbers_of(whole), numbers_of(mesh));
  }
}

TEST_F(Certify, WhatCutWritesInEveryFormat) {
  for (const std::string extension : {".msh", ".mesh", ".vtu", ".vtk", ".inp", ".ele"}) {
    SCOPED_TRACE(extension);
    done({"cut", data("fault.msh"), "-o", "out" + extension, "--group", "fault", "--certificate",
          "c.cert"});
    expect_certifies("c.cert", data("fault.msh"), "out" + extension, 104);
    done({"convert", data("fault.msh"), "in" + extension});
    const Outcome all = cleave({"cut", "in" + extension, "-o", "out.msh", "--all", "--certificate",
                                "c.cert", "--json", "-"});
    expect_certifies("c.cert", "in" + extension, "out.msh",
                     json::parse(all.out)["facets"]["requested"]);
  }
}

TEST_F(Certify, AMeshThatIsRegularizedFirst) {
  done({"cut", data("liver-16k.mesh"), "-o", "out.mesh", "--sweep", data("liver.sweep.json"),
        "--certificate", "c.cert"});
  expect_certifies("c.cert", data("liver-16k.mesh"), "out.mesh", 112);
}

TEST_F(Certify, TheWholeStateOfAMeshThatWasCutBefore) {
  const std::string mesh = data("fault.msh");
  done({"cut", mesh, "-o", "a.msh", "--group", "branch"});
  done({"cut", "a.msh", "-o", "b.msh", "--group", "fault", "--certificate", "b.cert"});
  done({"cut", mesh, "-o", "once.msh", "--group", "fault", "branch", "--certificate", "once.cert"});
  expect_certifies("b.cert", mesh, "b.msh", 104 + 52);
  EXPECT_EQ(read("b.cert"), read("once.cert"));
  done({"stitch", "b.msh", "-o", "c.msh", "--group", "fault", "--certificate", "c.cert"});
  expect_certifies("c.cert", mesh, "c.msh", 52);
  done({"stitch", "c.msh", "-o", "d.msh", "--all", "--certificate", "d.cert"});
  expect_certifies("d.cert", mesh, "d.msh", 0);
  // The whole scored set: what stays shut is in it, too, and what is kept is not.
  write("star.mesh", star());
  done({"cut", "star.mesh", "-o", "s.mesh", "--group", "7", "8", "--keep", "8", "--certificate",
        "s.cert"});
  expect_certifies("s.cert", "star.mesh", "s.mesh", 1);
}

TEST_F(Certify, CornerNodesOfSecondOrderMeshesAndEdgesAndTriangles) {
  write("line.msh",
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n7 0 0 0\n4294967294 1 0 0\n9 2 0 0\n"
        "$EndNodes\n$Elements\n2\n1 1 2 0 1 7 4294967294\n2 1 2 0 1 4294967294 9\n$EndElements\n");
  done({"cut", "line.msh", "-o", "apart.msh", "--all", "--certificate", "c.cert"});
  expect_certifies("c.cert", "line.msh", "apart.msh", 1);
  done({"cut", "line.msh", "-o", "apart.inp", "--all", "--certificate", "c.cert"});
  expect_certifies("c.cert", "line.msh", "apart.inp", 1);  // with other numbers
  // The next number of a copy is one too many.
  done({"cut", "apart.msh", "-o", "n.msh", "--all", "--certificate", "c.cert"});
  write("long.msh", std::regex_replace(read("line.msh"), std::regex("4294967294"), "4294967295"));
  refused({"cut", "long.msh", "-o", "n2.msh", "--all", "--certificate", "no.cert"},
          "a certificate holds numbers up to 4294967295");
  done({"cut", "long.msh", "-o", "n.vtu", "--all", "--certificate", "c.cert"});
  expect_certifies("c.cert", "long.msh", "n.vtu", 1);

  write("six.msh",
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n9\n1 0 0 0\n2 2 0 0\n3 0 2 0\n4 2 2 0\n"
        "5 1 0 0\n6 1 1 0\n7 0 1 0\n8 2 1 0\n9 1 2 0\n$EndNodes\n$Elements\n2\n"
        "1 9 2 0 1 1 2 3 5 6 7\n2 9 2 0 1 2 4 3 8 9 6\n$EndElements\n");
  done({"cut", "six.msh", "-o", "out.msh", "--all", "--certificate", "c.cert"});
  expect_certifies("c.cert", "six.msh", "out.msh", 1);
  EXPECT_EQ(read("c.cert"), R"(cleave-certificate 1
dimension 2
cells 2
before
1 2 3
2 4 3
cut 1
2 3
after
1 2 3
10 4 11
end
)");
}

TEST_F(Certify, GoesWhereOtherOutputsGo) {
  write("m.mesh", two_tetrahedra());
  const std::vector<std::string> cut{"cut", "m.mesh", "--all", "--dry-run", "--certificate"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> args = cut;
    args.insert(args.end(), more.begin(), more.end());
    return cleave(args);
  };
  EXPECT_EQ(with({"c.cert"}).status, 0);
  EXPECT_EQ(files(), (std::vector<std::string>{"c.cert", "m.mesh"}));
  EXPECT_EQ(with({"-"}).out, read("c.cert"));
  EXPECT_EQ(with({"-", "--json", "r.json"}).out, read("c.cert"));
  EXPECT_EQ(json::parse(with({"c.cert", "--json", "-"}).out)["facets"]["opened"], 1);
  for (const std::vector<std::string>& clash :
       std::vector<std::vector<std::string>>{{"-", "--json", "-"},
                                             {"m.mesh"},
                                             {"m.mesh.cleave.json"},
                                             {"r.json", "--json", "r.json"},
                                             {"f.json", "--fix-it", "f.json"}})
    EXPECT_EQ(with(clash).status, 2) << clash[0];
  EXPECT_EQ(with({"no/folder/c.cert"}).status, 3);
  const Outcome piped = run({"sh", "-c",
                             std::string(CLEAVE_COMMAND) + " cut m.mesh --all --dry-run --quiet" +
                                 " --certificate - | " + CLEAVE_COMMAND + " certify -"});
  EXPECT_EQ(piped.out, "accepted\n") << piped.err;
  done({"cut", "m.mesh", "--all", "-o", "o.mesh"});
  EXPECT_EQ(cleave({"stitch", "o.mesh", "-o", "p.mesh", "--all", "--certificate", "p.mesh"}).status,
            2);
  EXPECT_EQ(cleave({"certify", "c.cert", "--json", "c.cert"}).status, 2);
  EXPECT_EQ(cleave({"certify"}).status, 2);
}

TEST_F(Certify, NamesTheFirstClauseThatFails) {
  expect_verdict(two_triangles("1 2 3\n2 3 4\n"), "accepted\n", 0);
  expect_verdict(two_triangles("8 0 3\n0 3 9\n"), "accepted\n", 0);
  expect_verdict(two_triangles("1 2 3\n5 6 4\n", "cut 1\n3 2\n"), "accepted\n", 0);
  expect_verdict(two_triangles("1 2 3\n5 6 4\n", "cut 3 2 3 3 2 1 2\n"), "accepted\n", 0);
  expect_verdict(two_triangles("1 2 3\n"), "rejected: cells: 2 before and 1 after\n", 1);
  expect_verdict(two_triangles(""), "rejected: cells: 2 before and 0 after\n", 1);
  expect_verdict(two_triangles("1 2 3\n5 6 4\n7 8 9\n"), "rejected: cells: ", 1);
  expect_verdict(two_triangles("1 2 2\n2 3 4\n"),
                 "rejected: parent: cell 0 has vertex 2 twice after, for vertices 2 and 3 before\n",
                 1);
  expect_verdict(two_triangles("1 2 3\n2 3 1\n"),
                 "rejected: parent: cells 0 and 1 share vertex 1 after, which is vertex 1 of the "
                 "one and 4 of the other before\n",
                 1);
  expect_verdict(two_triangles("1 2 3\n7 3 1\n"), "rejected: parent: ", 1);  // and uncut
  expect_verdict(two_triangles("1 2 3\n7 3 4\n"),
                 "rejected: uncut: cells 0 and 1 have a facet that is not in the cut, but its "
                 "vertex 2 is vertex 2 of the one and 7 of the other after\n",
                 1);
  expect_verdict(two_triangles("1 2 3\n2 6 4\n", "cut 1\n2 3\n"),
                 "rejected: connected: cells 0 and 1 share vertex 2 after, but no chain of facets "
                 "that are not in the cut connects them around vertex 2\n",
                 1);
  expect_verdict("cleave-certificate 1 dimension 4 cells 0 before cut 0 after end", "accepted\n",
                 0);

  write("c.cert", two_triangles("1 2 3\n7 3 4\n"));
  const Outcome told = cleave({"certify", "c.cert", "--json", "-"});
  EXPECT_EQ(told.status, 1);
  const json report = json::parse(told.out);
  EXPECT_EQ(report["rejection"]["clause"], "uncut");
  EXPECT_EQ(report["rejection"]["corners"], json::parse(R"([{"cell": 0, "before": 2, "after": 2},
                            {"cell": 1, "before": 2, "after": 7}])"));
}

TEST_F(Certify, ReadsCommentsAndAnyBlanks) {
  expect_verdict(
      "# of nothing\ncleave-certificate\t1\r\n#\ndimension 2 cells 002 before 1 2 3 2 3 4 "
      "cut\n0 after\n1 2 3 2 3\n#9\n4 end\n# the end",
      "accepted\n", 0);
}

TEST_F(Certify, RefusesWhatIsNoCertificateAndSaysWhere) {
  const std::string good = two_triangles("1 2 3\n2 3 4\n", "cut 1\n2 3\n");
  const auto with = [&](const std::string& what, const std::string& instead) {
    std::string text = good;
    return text.replace(text.find(what), what.size(), instead);
  };
  expect_malformed("{}\n", "1: this is no certificate, which begins with 'cleave-certificate 1'");
  expect_malformed(with("cate 1", "cate 2"), "1: the version should be 1, not '2'");
  expect_malformed(with("sion 2", "sion 0"), "2: the dimension should be 1 to 4, not '0'");
  expect_malformed(with("sion 2", "sion 5"), "2: the dimension should be 1 to 4, not '5'");
  expect_malformed(with("cells 2", "cell 2"), "3: here should be 'cells', not 'cell'");
  expect_malformed(with("cells 2", "cells 3"), "7: here should be a vertex of a cell, not 'cut'");
  expect_malformed(with("cells 2", "cells 4294967295"),
                   "7: here should be a vertex of a cell, not 'cut'");
  expect_malformed(with("cells 2", "cells 1"), "6: here should be 'cut', not '2'");
  expect_malformed(with("1 2 3\n", "1 2\n"), "7: here should be a vertex of a cell, not 'cut'");
  for (const std::string odd : {"-1", "+1", "0x1", "1_0", "1.0", "1e3", "a"})
    expect_malformed(with("1 2 3\n", odd + " 2 3\n"),
                     "5: here should be a vertex of a cell, not '" + odd + "'");
  for (const std::string large : {"4294967296", "99999999999999999999999"})
    expect_malformed(with("1 2 3\n", large + " 2 3\n"),
                     "5: numbers go up to 4294967295, not '" + large + "'");
  expect_malformed(with("cut 1", "cut 2"), "9: here should be a vertex of a facet, not 'after'");
  expect_malformed(with("end", "2"), "13: here should be a vertex or 'end', and the file ends");
  expect_malformed(with("end", "2 end"),
                   "12: here should be a further vertex: a cell has 3, not 'end'");
  expect_malformed(with("end", "end end"), "12: after 'end' there should be nothing, not 'end'");
  expect_malformed(with("1 2 3\n", "1 2 3 # one\n"),
                   "5: here should be a vertex of a cell, not '#'");

  expect_malformed(with("2 3 4\n", "2 3 2\n"), "6: cell 1 has vertex 2 twice");
  expect_malformed(with("2 3 4\n", "3 1 2\n"), "6: cells 0 and 1 have the same vertices");
  expect_malformed(with("cells 2\nbefore\n1 2 3\n", "cells 3\nbefore\n3 2 9\n# a comment\n1 2 3\n"),
                   "8: the facet (2 3) is in three cells: 0, 1 and 2");
  expect_malformed(with("cut 1\n2 3", "cut 2\n2 3\n4 1"), "9: (4 1) is no facet of a cell");
  expect_malformed(with("cut 1\n2 3", "cut 1\n2 2"), "8: (2 2) is no facet of a cell");
  EXPECT_EQ(cleave({"certify", "nothing.cert"}).status, 3);
  EXPECT_EQ(cleave({"certify", "."}).status, 3);
}

}  // namespace
}  // namespace cleave::app::test
