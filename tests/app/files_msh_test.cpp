// The reader of gmsh's formats: what it accepts, what it refuses and how it says so.
#include "files/msh_format.hpp"
#include "files_support.hpp"
#include "mesh_file.hpp"

namespace cleave::app::test {
namespace {

using Msh = Files;

const std::string k22 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 7 \"skin side\"\n3 1 \"body\"\n"
    "$EndPhysicalNames\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n8589934592 1 1 1\n"
    "$EndNodes\n$Elements\n4\n1 15 2 0 1 1\n2 2 2 7 3 1 2 3\n3 4 2 1 1 1 2 3 4\n"
    "4 4 3 1 1 0 2 3 4 8589934592\n$EndElements\n";

const std::string k41 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 7 \"skin side\"\n3 1 \"body\"\n"
    "$EndPhysicalNames\n$Entities\n1 0 1 1\n1 0 0 0 0 \n3 0 0 0 1 1 0 2 7 -9 0 \n"
    "1 0 0 0 1 1 1 1 1 2 3 -4 \n$EndEntities\n$Nodes\n2 5 1 8589934592\n2 3 1 3\n1\n2\n3\n"
    "0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n3 1 0 2\n4\n8589934592\n0 0 1\n1 1 1\n$EndNodes\n"
    "$Elements\n3 4 1 4\n0 1 15 1\n1 1 \n2 3 2 1\n2 1 2 3 \n3 1 4 2\n3 1 2 3 4 \n"
    "4 2 3 4 8589934592 \n$EndElements\n";

std::string with(std::string text, const std::string& piece, const std::string& other) {
  const auto at = text.find(piece);
  if (at == std::string::npos) throw std::logic_error(piece);
  return text.replace(at, piece.size(), other);
}

void expect_the_mesh(const Mesh& mesh) {
  EXPECT_EQ(mesh.vertex_numbers, (std::vector<std::uint64_t>{1, 2, 3, 4, 8589934592}));
  EXPECT_EQ(mesh.points[4], (std::array<double, 3>{1, 1, 1}));
  EXPECT_EQ(mesh.elements[0].vertices, std::vector<Index>{0});
  EXPECT_EQ(mesh.elements[2].vertices, (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(mesh.elements[3].vertices, (std::vector<Index>{0, 1, 2, 3, 1, 2, 3, 4}));
  EXPECT_EQ(mesh.elements[3].numbers, (std::vector<std::uint64_t>{3, 4}));
  EXPECT_EQ(mesh.groups.front().name, "skin side");
  EXPECT_EQ(mesh.groups.front().elements, std::vector<Index>{0});
  EXPECT_EQ(mesh.groups.back().name, "body");
  EXPECT_EQ(mesh.groups.back().elements, (std::vector<Index>{0, 1}));
}

TEST_F(Msh, ReadsBothVersionsWithNodeNumbersAboveTwoToThe32) {
  const Mesh mesh22 = read_mesh(put("a.msh", k22));
  expect_the_mesh(mesh22);
  EXPECT_EQ(mesh22.msh_version, MshVersion::k22);
  const Mesh mesh41 = read_mesh(put("a.msh", k41));
  expect_the_mesh(mesh41);
  EXPECT_EQ(mesh41.msh_version, MshVersion::k41);
  ASSERT_EQ(mesh41.groups.size(), 3u);
  EXPECT_EQ(mesh41.groups[1].tag, 9);  // the sign means orientation
  EXPECT_EQ(mesh41.groups[1].name, "9");
}

TEST_F(Msh, SkipsSectionsThatSayNothingAboutElements) {
  const std::string more =
      "$Parametrizations\n0 0\n$EndParametrizations\n$ElementNodeData\n1\n\"a $ sign\"\n"
      "$EndElementNodeData\n$ElementNodeData\n1\n\"again\"\n$EndElementNodeData\n";
  const Mesh mesh = read_mesh(put("a.msh", k22 + more));
  expect_the_mesh(mesh);
  ASSERT_EQ(mesh.dropped.size(), 3u);
  EXPECT_NE(mesh.dropped[0].find("a.msh:24: the section $Parametrizations"), std::string::npos);
  expect_the_mesh(read_mesh(put("a.msh", k41 + "\r\n" + more)));
  expect_the_mesh(read_mesh(put("a.msh", "$Comments\nby hand\n$EndComments\n" + k22)));
}

TEST_F(Msh, AcceptsWindowsLineEndsTabsAndBlankLines) {
  std::string text;
  for (const char c : k41) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  expect_the_mesh(read_mesh(put("a.msh", text)));
  text = with(with(k22, "2 1 0 0", "\t+2  +1.0e0\t0 0 "), "$Elements\n4", "$Elements\n\n4");
  expect_the_mesh(read_mesh(put("a.msh", text)));
}

TEST_F(Msh, AnElementRepeatedPerGroupIsOneElement) {
  const Mesh mesh =
      read_mesh(put("a.msh", with(with(k22, "$Elements\n4", "$Elements\n5"), "3 4 2 1 1 1 2 3 4\n",
                                  "3 4 2 1 1 1 2 3 4\n9 4 2 6 1 2 1 4 3\n")));
  EXPECT_EQ(mesh.cells().numbers, (std::vector<std::uint64_t>{3, 4}));
  ASSERT_EQ(mesh.groups.size(), 3u);
  EXPECT_EQ(mesh.groups[1].name, "body");
  EXPECT_EQ(mesh.groups[1].elements, (std::vector<Index>{0, 1}));
  EXPECT_EQ(mesh.groups[2].tag, 6);
  EXPECT_EQ(mesh.groups[2].elements, std::vector<Index>{0});
}

TEST_F(Msh, GroupNumberZeroIsNoGroup) {
  const Mesh mesh = read_mesh(put("a.msh", with(k41, "2 7 -9 0 ", "2 7 0 0 ")));
  ASSERT_EQ(mesh.groups.size(), 2u);
  EXPECT_EQ(mesh.groups[0].name, "skin side");
  EXPECT_EQ(mesh.groups[1].name, "body");
}

TEST_F(Msh, TheSameCellTwiceIsTwoCells) {
  const Mesh mesh =
      read_mesh(put("a.msh", with(with(k22, "$Elements\n4", "$Elements\n5"), "3 4 2 1 1 1 2 3 4\n",
                                  "3 4 2 1 1 1 2 3 4\n9 4 2 1 1 1 2 3 4\n")));
  EXPECT_EQ(mesh.cells().size(), 3u);
}

TEST_F(Msh, NamesTheLineOfEveryDefect22) {
  const struct {
    std::string text;
    std::vector<std::string> parts;
  } cases[] = {
      {with(k22, "2.2 0 8", "2.2 1 8"), {"a.msh:2:", "binary number 1", "does not follow"}},
      {with(k22, "2.2 0 8", "2.2 2 8"), {"a.msh:2:", "0 (text) or 1 (binary)"}},
      {with(k22, "2.2 0 8", "1.0 0 8"), {"a.msh:2:", "version 1.0", "2.2 and 4.1"}},
      {with(k22, "2.2 0 8", "4 0 8"), {"a.msh:2:", "version 4 "}},
      {with(k22, "2 7 \"skin side\"", "2 0 \"skin side\""), {"a.msh:6:", "must be positive"}},
      {with(k22, "$EndMeshFormat", "$End"), {"a.msh:3:", "expected $EndMeshFormat"}},
      {with(k22, "2 1 0 0\n", "2 1 0 0 0\n"), {"a.msh:12:", "goes on with '0'"}},
      {with(k22, "2 1 0 0\n", "2 1 0\n"), {"a.msh:12:", "the z coordinate", "line ends"}},
      {with(k22, "2 1 0 0\n", "3 1 0 0\n"), {"a.msh:13:", "node number 3", "second time"}},
      {with(k22, "2 1 0 0\n", "-2 1 0 0\n"), {"a.msh:12:", "found '-2'"}},
      {with(k22, "$Nodes\n5", "$Nodes\n4"), {"a.msh:15:", "more nodes than"}},
      {with(k22, "$Nodes\n5", "$Nodes\n6"), {"a.msh:15:", "nothing more"}},
      {with(k22, "$Nodes\n5", "$Nodes\n-5"), {"a.msh:10:", "negative: -5"}},
      {with(k22, "$Nodes\n5", "$Nodes\n4000000000"), {"a.msh:10:", "bytes follow"}},
      {with(k22, "$Nodes\n5", "$Nodes\n4294967296"), {"a.msh:10:", "32-bit ids"}},
      {with(k22, "1 2 3 4\n4", "1 2 3 77\n4"), {"a.msh:21:", "element 3 uses node 77", "$Nodes"}},
      {with(k22, "4 4 3 1", "3 4 3 1"), {"a.msh:22:", "element number 3", "second time"}},
      {with(k22, "3 4 2 1", "3 5 2 1"), {"a.msh:21:", "element 3 is a 8-node hexahedron (type 5)"}},
      {with(k22, "3 4 2 1 1 1 2 3 4", "3 11 2 1 1 1 2 3 4 1 2 3 4 1 2"),
       {"a.msh:22:", "element 4 is a 4-node tetrahedron", "the other order"}},
      {with(k22, "3 4 2 1", "3 29 2 1"), {"a.msh:21:", "third order tetrahedron", "ElementOrder"}},
      {with(k22, "3 4 2 1 1 1", "3 3 2 1 1 1"), {"a.msh:21:", "element 3 is a 4-node quadrangle"}},
      {with(k22, "2 2 2 7 3 1 2 3\n", "2 6 2 7 3 1 2 3 1 2 4\n"),
       {"a.msh:20:", "element 2 is a 6-node prism", "two sides are at the same place"}},
      {with(k22, "3 4 2 1", "3 99 2 1"), {"a.msh:21:", "(type 99)"}},
      {with(k22, "3 4 2 1", "3 4 -2 1"), {"a.msh:21:", "the number of tags"}},
      {with(k22, "$Elements\n4", "$Elements\n3"), {"a.msh:22:", "more elements than"}},
      {with(k22, "$Elements\n4", "$Elements\n5"), {"a.msh:22:", "nothing more"}},
      {with(k22, "\"body\"", "body"), {"a.msh:7:", "quotation marks"}},
      {with(k22, "3 1 \"body\"", "4 1 \"body\""), {"a.msh:7:", "must be 0, 1, 2 or 3"}},
      {with(k22, "$EndElements", ""), {"a.msh:17:", "$Elements is not closed"}},
      {with(k22, "$EndNodes\n", ""), {"a.msh:9:", "$Nodes is not closed"}},
      {with(k22, "$EndNodes\n", "$EndNodes\nhello\n"), {"a.msh:17:", "found 'hello'"}},
      {k22 + "$Nodes\n0\n$EndNodes\n", {"a.msh:24:", "a second section $Nodes"}},
      {k22.substr(0, k22.find("$Elements")), {"no section $Elements", "truncated"}},
      {k22 + "$PartitionedEntities\n$EndPartitionedEntities\n", {"a.msh:24:", "unpartition"}},
  };
  for (const auto& one : cases) expect_reading_error(put("a.msh", one.text), one.parts);
}

TEST_F(Msh, NamesTheLineOfEveryDefect41) {
  const struct {
    std::string text;
    std::vector<std::string> parts;
  } cases[] = {
      {with(k41, "1 0 1 1\n", "1 0 1 2\n"), {"a.msh:13:", "nothing more"}},
      {with(k41, "1 0 1 1\n", "1 0 1\n"), {"a.msh:10:", "the number of entities"}},
      {with(k41, "2 7 -9 0 \n", "2 7 0 \n"), {"a.msh:12:", "the number of bounds"}},
      {with(k41, "3 0 0 0 1 1 0", "x 0 0 0 1 1 0"), {"a.msh:12:", "the number of an entity"}},
      {with(k41, "2 3 2 1\n", "1 3 2 1\n"), {"a.msh:34:", "in an entity of dimension 1"}},
      {with(k41, "2 5 1 858", "2 6 1 858"), {"a.msh:16:", "is 6, but the blocks hold 5"}},
      {with(k41, "2 5 1 858", "1 5 1 858"), {"a.msh:24:", "more blocks"}},
      {with(k41, "2 5 1 858", "3 5 1 858"), {"nothing more"}},
      {with(k41, "3 1 0 2\n4\n", "3 1 0 2\n3\n"), {"a.msh:25:", "node number 3"}},
      {with(k41, "2 3 1 3\n", "2 3 0 3\n"), {"a.msh:21:", "goes on with '0'"}},
      {with(k41, "2 3 1 3\n", "5 3 1 3\n"), {"a.msh:17:", "must be 0, 1, 2 or 3"}},
      {with(k41, "3 1 4 2\n", "3 1 5 2\n"), {"a.msh:36:", "8-node hexahedron (type 5)"}},
      {with(k41, "3 1 4 2\n", "3 1 29 2\n"), {"a.msh:36:", "third order", "order 1"}},
      {with(k41, "3 1 4 2\n", "3 1 4 3\n"), {"nothing more"}},
      {with(k41, "3 1 4 2\n", "3 1 4 1\n"), {"a.msh:38:", "more blocks"}},
      {with(k41, "3 1 2 3 4 \n", "4 1 2 3 4 \n"), {"a.msh:38:", "element number 4"}},
      {with(k41, "3 1 2 3 4 \n", "3 1 2 3 5 \n"), {"a.msh:37:", "uses node 5"}},
      {with(k41, "3 4 1 4\n", "3 4000000000 1 4\n"), {"a.msh:31:", "bytes follow"}},
  };
  for (const auto& one : cases) expect_reading_error(put("a.msh", one.text), one.parts);
}

TEST_F(Msh, WithoutEntitiesElementsHaveNoGroups) {
  const auto from = k41.find("$Entities");
  const auto to = k41.find("$Nodes");
  const Mesh mesh = read_mesh(put("a.msh", k41.substr(0, from) + k41.substr(to)));
  EXPECT_EQ(mesh.cells().size(), 2u);
  for (const Group& group : mesh.groups) EXPECT_TRUE(group.elements.empty());
}

TEST_F(Msh, EveryTruncatedFileIsRefused) {
  for (const std::string& text : {k22, k41}) expect_prefixes_are_refused(read_msh, text);
  Mesh mesh = grouped_mesh();
  for (const MshVersion version : {MshVersion::k22, MshVersion::k41}) {
    mesh.msh_version = version;
    write_mesh(path("whole.msh"), mesh);
    expect_prefixes_are_refused(read_msh, bytes("whole.msh"));
  }
}

TEST_F(Msh, DefectsAnywhereAreNoticedOrHarmless) {
  for (const std::string& text : {k22, k41}) expect_defects_are_noticed(read_msh, text);
}

}  // namespace
}  // namespace cleave::app::test
