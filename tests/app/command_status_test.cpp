#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <new>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "cleave/topology/assemble.hpp"
#include "cleave/topology/unglue.hpp"
#include "command_support.hpp"
#include "commands.hpp"
#include "error.hpp"
#include "reproducer.hpp"

namespace cleave::app::test {
namespace {

using nlohmann::json;

TEST(Guarded, TurnsWhatIsThrownIntoTheDocumentedStatus) {
  EXPECT_EQ(guarded([] { return 1; }), 1);
  EXPECT_EQ(guarded([]() -> int { throw InputError("m.mesh: bad"); }), kBadInput);
  EXPECT_EQ(guarded([]() -> int { throw OutputError("out.mesh: bad"); }), kBadInput);
  EXPECT_EQ(guarded([]() -> int { throw std::length_error("too many cells"); }), kBadInput);
  EXPECT_EQ(guarded([]() -> int { throw std::bad_alloc(); }), kBadInput);
  EXPECT_EQ(guarded([]() -> int { throw topology::InvariantBroken("mates differ"); }), kBroken);
  EXPECT_EQ(guarded([]() -> int { throw std::runtime_error("surprise"); }), kBroken);
}

class Dropped : public CommandTest {};

TEST_F(Dropped, WhatAMeshCannotHoldIsAWarning) {
  write("m.msh",
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n"
        "$Elements\n1\n1 2 2 0 1 1 2 3\n$EndElements\n$Custom\n$EndCustom\n");
  for (const std::vector<std::string>& args :
       {std::vector<std::string>{"check", "m.msh"}, {"cut", "m.msh", "--all", "-o", "o.msh"}}) {
    const Outcome outcome = cleave(args);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("warning: m.msh:14: the section $Custom"), std::string::npos)
        << outcome.err;
  }
  const Outcome packed = cleave({"cut", "m.msh", "--all", "-o", "o.msh.gz"});
  EXPECT_EQ(packed.status, 3);
  EXPECT_NE(packed.err.find("write 'o.msh' and compress it with gzip"), std::string::npos);
}

class Reproducer : public CommandTest {};

TEST_F(Reproducer, HoldsWhatIsNeededToDoTheCutAgain) {
  topology::CellSoup<2> soup{{{{{0}, {1}, {2}}}, {{{1}, {2}, {3}}}}, 4, {1, -1}};
  const auto before = topology::assemble(soup);
  const auto cut = topology::FacetSet::all(before);
  write_reproducer(folder_ / "r.json", before, cut, "mates differ");

  const json r = json::parse(read("r.json"));
  EXPECT_EQ(r["schema"], "cleave-reproducer/1");
  EXPECT_EQ(r["message"], "mates differ");
  topology::CellSoup<2> again;
  again.vertex_count = r["vertex_count"];
  for (const json& cell : r["cells"])
    again.cells.push_back(
        {{{cell[0].get<Index>()}, {cell[1].get<Index>()}, {cell[2].get<Index>()}}});
  again.signs = r["signs"].get<std::vector<std::int8_t>>();
  auto complex = topology::assemble(again);
  std::vector<topology::HalfFacetId> facets;
  for (const json& h : r["cut"]) facets.push_back({h.get<Index>()});
  const auto change = topology::unglue(
      complex, topology::FacetSet::of(complex, std::span<const topology::HalfFacetId>(facets)));
  EXPECT_EQ(change.opened.size(), 1u);
  EXPECT_EQ(change.splits.size(), 2u);
}

class Interrupted : public CommandTest {};

TEST_F(Interrupted, LeavesNoPartialFile) {
  // The output is a pipe that nobody reads to the end, so the command cannot finish before it is
  // interrupted; nothing of its report, which belongs to the output, may be there.
  const std::string pipe = folder_ / "out.mesh";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const int child = start({CLEAVE_COMMAND, "cut", data("liver-16k.mesh"), "-o", "out.mesh", "--all",
                           "--json", "report.json"});
  const int end = open(pipe.c_str(), O_RDONLY);
  char byte = 0;
  EXPECT_EQ(::read(end, &byte, 1), 1);
  kill(child, SIGINT);
  const Outcome outcome = finish(child);
  close(end);
  EXPECT_EQ(outcome.status, 128 + SIGINT) << outcome.err;
  EXPECT_EQ(files(), std::vector<std::string>{"out.mesh"});  // the pipe
}

}  // namespace
}  // namespace cleave::app::test
