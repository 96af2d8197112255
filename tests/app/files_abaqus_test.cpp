// Abaqus input files: what is accepted, what is refused and how.
#include "files/abaqus.hpp"

#include "error.hpp"
#include "files_support.hpp"
#include "mesh_file.hpp"

namespace cleave::app::test {
namespace {

using Abaqus = Files;

// Two tetrahedra on the facet (2, 3, 4).
const std::string kInp =
    "*HEADING\nby hand\n** a comment\n*Node, nset=ALL\n1, 0, 0, 0\n2, 1., 0.\n 3 , 0, 1, 0\n"
    "4, 0, 0, +1\n50, 1, 1, 1\n*ELEMENT, TYPE=C3D4,\n ELSET=Body\n11, 1, 2, 3, 4\n12, 2, 3, 4,\n"
    " 50\n*element, type=S3\n20, 2, 3, 4\n*NSET, NSET=ends\n1, 50,\n*NSET, NSET=\"Low ones\", "
    "GENERATE\n1, 3, 2\n*NSET, NSET=both\nends, 2\n*ELSET, ELSET=\"7\"\n12\n*ELSET, ELSET=_s, "
    "INTERNAL\n11\n*SURFACE, NAME=Fault, TYPE=ELEMENT\n11, S3\n_s, s2\n*ELSET, ELSET=fault\n20\n"
    "*MATERIAL, NAME=steel\n*ELASTIC\n2.1e11, 0.3\n*STEP\n*STATIC\n*END STEP\n";

std::string with(const std::string& piece, const std::string& other) {
  std::string text = kInp;
  const auto at = text.find(piece);
  if (at == std::string::npos) throw std::logic_error(piece);
  return text.replace(at, piece.size(), other);
}

const Group* find_group(const Mesh& mesh, int dimension, const std::string& name) {
  for (const Group& group : mesh.groups)
    if (group.dimension == dimension && group.name == name) return &group;
  return nullptr;
}

std::vector<Index> members(const Mesh& mesh, int dimension, const std::string& name) {
  const Group* group = find_group(mesh, dimension, name);
  EXPECT_NE(group, nullptr) << name;
  return group == nullptr ? std::vector<Index>{} : group->elements;
}

TEST_F(Abaqus, ReadsElementsSetsAndSurfaces) {
  const Mesh mesh = read_mesh(put("a.inp", kInp));
  EXPECT_EQ(mesh.dimension, 3);
  EXPECT_EQ(mesh.vertex_numbers, (std::vector<std::uint64_t>{1, 2, 3, 4, 50}));
  EXPECT_EQ(mesh.points[1], (std::array<double, 3>{1, 0, 0}));
  EXPECT_EQ(mesh.cells().vertices, (std::vector<Index>{0, 1, 2, 3, 1, 2, 3, 4}));
  EXPECT_EQ(mesh.cells().numbers, (std::vector<std::uint64_t>{11, 12}));
  // S3 of element 11 is the S3 element 20; S2, on no element, becomes one, outward of element 11.
  EXPECT_EQ(mesh.elements[2].vertices, (std::vector<Index>{1, 2, 3, 3, 0, 1}));
  EXPECT_EQ(mesh.elements[2].numbers, (std::vector<std::uint64_t>{20, 21}));
  EXPECT_EQ(members(mesh, 3, "Body"), (std::vector<Index>{0, 1}));
  EXPECT_EQ(members(mesh, 3, "7"), (std::vector<Index>{1}));
  EXPECT_EQ(find_group(mesh, 3, "7")->tag, 7);
  EXPECT_EQ(members(mesh, 2, "Fault"), (std::vector<Index>{0, 1}));
  EXPECT_EQ(mesh.elements[0].vertices, (std::vector<Index>{0, 1, 2, 3, 4}));
  EXPECT_EQ(members(mesh, 0, "ALL").size(), 5u);
  EXPECT_EQ(members(mesh, 0, "ends"), (std::vector<Index>{0, 4}));
  EXPECT_EQ(members(mesh, 0, "Low ones"), (std::vector<Index>{0, 2}));
  EXPECT_EQ(members(mesh, 0, "both"), (std::vector<Index>{0, 1, 4}));
  EXPECT_EQ(mesh.groups.size(), 7u);
  ASSERT_EQ(mesh.dropped.size(), 1u);
  EXPECT_NE(mesh.dropped[0].find("4 keywords do not concern the mesh"), std::string::npos);
  EXPECT_NE(mesh.dropped[0].find("*ELASTIC, *MATERIAL"), std::string::npos) << mesh.dropped[0];
}

TEST_F(Abaqus, ReadsOnePartAndItsInstance) {
  const std::string part =
      "*Part, name=P\n*Node\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0, 0, 1\n"
      "*Element, type=C3D4\n1, 1, 2, 3, 4\n*End Part\n";
  const std::string assembly =
      "*Assembly, name=A\n*Instance, name=P-1, part=P\n*End Instance\n*Node\n1, 9, 9, 9\n"
      "*Nset, nset=reference\n1,\n*Nset, nset=top, instance=P-1\n4,\n*End Assembly\n";
  const Mesh mesh = read_mesh(put("a.inp", part + assembly));
  EXPECT_EQ(mesh.points.size(), 4u);
  EXPECT_EQ(members(mesh, 0, "top"), std::vector<Index>{0});
  EXPECT_EQ(find_group(mesh, 0, "reference"), nullptr);
  EXPECT_NE(mesh.dropped.at(0).find("*NODE, *NSET"), std::string::npos) << mesh.dropped.at(0);
  expect_reading_error(put("a.inp", part + part), {"a.inp:10:", "second *PART"});
  expect_reading_error(
      put("a.inp", part + "*Assembly, name=A\n*Instance, name=P-1, part=P\n0, 0, 5\n"),
      {"a.inp:12:", "moves the instance"});
  expect_reading_error(put("a.inp", part + assembly + "*Assembly\n*Instance, name=Q, part=P\n"),
                       {"second *INSTANCE"});
}

TEST_F(Abaqus, NamesTheLineOfEveryDefect) {
  const struct {
    std::string text;
    std::vector<std::string> parts;
  } cases[] = {
      {with("4, 0, 0, +1", "4, 0, 0, x"), {"a.inp:8:", "the z coordinate", "found 'x'"}},
      {with("4, 0, 0, +1", "0, 0, 0, 1"), {"a.inp:8:", "numbered from 1 on"}},
      {with("4, 0, 0, +1", "3, 0, 0, 1"), {"a.inp:8:", "node number 3", "second time"}},
      {with("4, 0, 0, +1", "4, 0, 0, 1, 0, 0, 0, 0"), {"a.inp:8:", "more fields than a node"}},
      {with("4, 0, 0, +1", "4.5, 0, 0, 1"), {"a.inp:8:", "integer", "4.5"}},
      {with("11, 1, 2, 3, 4", "11, 1, 2, 3"), {"a.inp:12:", "the number of a node", "line ends"}},
      {with("11, 1, 2, 3, 4", "11, 1, 2, 3, 4, 50"), {"a.inp:12:", "more than the 4 nodes"}},
      {with("11, 1, 2, 3, 4", "11, 1, 2, 3, 5"), {"a.inp:12:", "there is no node 5"}},
      {with("11, 1, 2, 3, 4", "12, 1, 2, 3, 4"), {"a.inp:13:", "element number 12", "second"}},
      {with("TYPE=C3D4", "TYPE=C3D8R"), {"a.inp:10:", "type C3D8R", "no simplices"}},
      {with("*ELEMENT, TYPE=C3D4,\n ELSET=Body", "*ELEMENT"), {"a.inp:10:", "TYPE="}},
      {with(" ELSET=Body", "11, 1"), {"a.inp:11:", "*ELEMENT must go on here"}},
      {with("1, 50,", "1, 51,"), {"a.inp:18:", "there is no node 51"}},
      {with("ends, 2", "end, 2"), {"a.inp:22:", "no set of this name", "END"}},
      {with("1, 3, 2", "1, 4, 2"), {"a.inp:20:", "does not lead"}},
      {with("1, 3, 2", "1, 3000000000"), {"a.inp:20:", "bytes can have"}},
      {with("\"7\"\n12", "\"7\"\n13"), {"a.inp:24:", "there is no element 13"}},
      {with("11, S3", "11, S5"), {"a.inp:28:", "no side 'S5'"}},
      {with("11, S3", "11"), {"a.inp:28:", "expected an element or a set"}},
      {with("11, S3", "20, S1"), {"a.inp:28:", "no side 'S1'"}},
      {with("*MATERIAL, NAME=steel", "*INCLUDE, INPUT=b.inp"), {"a.inp:32:", "*INCLUDE makes"}},
      {with("*MATERIAL, NAME=steel", "*NGEN"), {"a.inp:32:", "*NGEN makes"}},
      {with("*Node, nset=ALL", "*Node, system=C"), {"a.inp:4:", "cylindrical"}},
      {with("*element, type=S3", "*ELEMENT, TYPE=S3\n19, 1, 2, 3\n*ELEMENT, TYPE=STRI65"),
       {"a.inp:17:", "first and second order"}},
      {kInp.substr(0, kInp.size() - 1), {"no line end", "truncated"}},
      {"<html>\n", {"a.inp:1:", "not an Abaqus input file", "XML"}},
      {"*NODE\n1, 0, 0, 0\n", {"holds no edges, triangles or tetrahedra"}},
  };
  for (const auto& one : cases) expect_reading_error(put("a.inp", one.text), one.parts);
}

TEST_F(Abaqus, KeepsNumbersAndSecondOrder) {
  Mesh mesh = second_order(grouped_mesh());
  for (std::size_t v = 0; v < mesh.points.size(); ++v) mesh.vertex_numbers[v] = 900 - v;
  write_mesh(path("a.inp"), mesh);
  const Mesh read = read_mesh(path("a.inp"));
  EXPECT_EQ(read.vertex_numbers, mesh.vertex_numbers);
  for (std::size_t d = 1; d <= 3; ++d) {
    EXPECT_EQ(read.elements[d].vertices, mesh.elements[d].vertices);
    EXPECT_EQ(read.elements[d].midside, mesh.elements[d].midside);
    EXPECT_EQ(read.elements[d].numbers, mesh.elements[d].numbers);
  }
}

TEST_F(Abaqus, SurfacesAreOnTheSideTheFacetPointsAwayFrom) {
  Mesh mesh = read_mesh(put("a.inp", kInp));
  const auto surface = [&] {
    write_mesh(path("b.inp"), mesh);
    const std::string text = bytes("b.inp");
    return text.substr(text.find("NAME=Fault\n") + 11);
  };
  // (2, 3, 4) points from element 11 (vertex 1 below it) to element 12.
  EXPECT_EQ(surface(), "11, S3\n11, S2\n");
  std::swap(mesh.elements[2].vertices[0], mesh.elements[2].vertices[1]);
  EXPECT_EQ(surface(), "12, S1\n11, S2\n");
}

TEST_F(Abaqus, NamesThatDifferInCaseOnlyAreQuoted) {
  Mesh mesh = grouped_mesh();
  mesh.groups = {{"Fault", 2, 1, {0}}, {"fault", 2, 2, {1}}, {"a, b", 3, 3, {0}}};
  write_mesh(path("a.inp"), mesh);
  const Mesh read = read_mesh(path("a.inp"));
  EXPECT_EQ(members(read, 2, "Fault"), std::vector<Index>{0});
  EXPECT_EQ(members(read, 2, "fault"), std::vector<Index>{1});
  EXPECT_EQ(members(read, 3, "a, b"), std::vector<Index>{0});
  mesh.groups[0].name = "a \"quoted\" name";
  EXPECT_THROW(write_mesh(path("b.inp"), mesh), OutputError);
}

TEST_F(Abaqus, WhatIsCutOffOrDamagedIsNoticedOrHarmless) {
  expect_defects_are_noticed(read_abaqus, kInp);
  // An input file has no end mark: what ends with a line may be whole.
  for (std::size_t size = 1; size < kInp.size(); ++size) {
    const std::string part = kInp.substr(0, size);
    try {
      expect_valid_places(read_abaqus({"part", part}));
      EXPECT_EQ(part.back(), '\n');
    } catch (const InputError&) {
    }
  }
}

}  // namespace
}  // namespace cleave::app::test
