// TetGen's and Triangle's files: what is accepted, what is refused and how.
#include "files/tetgen.hpp"

#include "error.hpp"
#include "files_support.hpp"
#include "mesh_file.hpp"

namespace cleave::app::test {
namespace {

const std::string kNode =
    "# by hand\n5 3 1 1\n1 0 0 0 0.5 3\n2 1 0 0 1.5 0\n3 0 1 0 2 -4\n\n4 0 0 1 3 0\n"
    "5 1 1 1 1e300 0\n";
const std::string kEle = "2 4 2\n1 1 2 3 4 7 0.25\n2 2 3 4 5 8 0.5\n";
const std::string kFace = "2 1\n1 2 3 4 9 1 2\n2 1 2 3 0 1 -1\n";
const std::string kEdge = "1 1\n1 1 2 6\n";

class Tetgen : public Files {
 protected:
  void put_all(const std::string& node, const std::string& ele, const std::string& face = kFace,
               const std::string& edge = kEdge) const {
    put("a.node", node);
    put("a.ele", ele);
    put("a.face", face);
    put("a.edge", edge);
  }
};

std::string with(std::string text, const std::string& piece, const std::string& other) {
  const auto at = text.find(piece);
  if (at == std::string::npos) throw std::logic_error(piece);
  return text.replace(at, piece.size(), other);
}

TEST_F(Tetgen, ReadsAllFourFilesByEitherName) {
  put_all(kNode, kEle);
  for (const char* name : {"a.node", "a.ele"}) {
    const Mesh mesh = read_mesh(path(name));
    EXPECT_EQ(mesh.source, path(name).string());
    EXPECT_EQ(mesh.dimension, 3);
    EXPECT_EQ(mesh.points[4], (std::array<double, 3>{1, 1, 1}));
    EXPECT_EQ(mesh.vertex_numbers, (std::vector<std::uint64_t>{1, 2, 3, 4, 5}));
    EXPECT_EQ(mesh.cells().vertices, (std::vector<Index>{0, 1, 2, 3, 1, 2, 3, 4}));
    EXPECT_EQ(mesh.elements[2].vertices, (std::vector<Index>{1, 2, 3, 0, 1, 2}));
    EXPECT_EQ(mesh.elements[1].vertices, (std::vector<Index>{0, 1}));
    EXPECT_EQ(mesh.elements[0].vertices, (std::vector<Index>{0, 2}));
    EXPECT_EQ(mesh.elements[0].numbers, (std::vector<std::uint64_t>{1, 3}));
    std::vector<std::string> groups;
    for (const Group& group : mesh.groups)
      groups.push_back(std::to_string(group.dimension) + ":" + group.name);
    EXPECT_EQ(groups, (std::vector<std::string>{"0:-4", "0:3", "1:6", "2:9", "3:7", "3:8"}));
    ASSERT_EQ(mesh.point_fields.size(), 1u);
    EXPECT_EQ(mesh.point_fields[0].name, "attribute_1");
    EXPECT_EQ(mesh.point_fields[0].values, (std::vector<double>{0.5, 1.5, 2, 3, 1e300}));
    ASSERT_EQ(mesh.cell_fields.size(), 1u);
    EXPECT_EQ(mesh.cell_fields[0].values, (std::vector<double>{0.25, 0.5}));
  }
}

TEST_F(Tetgen, AnAttributeThatIsNoIntegerIsAField) {
  put_all(kNode, "2 4 1\n1 1 2 3 4 7\n2 2 3 4 5 8.5\n");
  const Mesh mesh = read_mesh(path("a.ele"));
  ASSERT_EQ(mesh.cell_fields.size(), 1u);
  EXPECT_EQ(mesh.cell_fields[0].values, (std::vector<double>{7, 8.5}));
  EXPECT_EQ(mesh.groups.back().dimension, 2);
}

TEST_F(Tetgen, KeepsNumbersFromZeroOrOne) {
  Mesh mesh = grouped_mesh();
  for (const std::uint64_t first : {0, 1}) {
    for (std::size_t v = 0; v < mesh.points.size(); ++v) mesh.vertex_numbers[v] = first + v;
    write_mesh(path("a.node"), mesh);
    const Mesh read = read_mesh(path("a.node"));
    expect_same_content(read, mesh);
    EXPECT_EQ(read.vertex_numbers, mesh.vertex_numbers);
    EXPECT_EQ(read.cells().numbers, (std::vector<std::uint64_t>{first, first + 1, first + 2}));
  }
}

TEST_F(Tetgen, ReadsTrianglesOfSecondOrder) {
  put("a.node", "6 2 0 0\n0 0 0\n1 2 0\n2 0 2\n3 1 1\n4 0 1\n5 1 0\n");
  put("a.ele", "1 6 0\n0 0 1 2 3 4 5\n");
  put("a.edge", "2 1\n0 0 1 4\n1 1 2 0\n");
  const Mesh mesh = read_mesh(path("a.ele"));
  EXPECT_EQ(mesh.dimension, 2);
  EXPECT_TRUE(mesh.two_dimensional_points);
  EXPECT_EQ(mesh.cells().vertices, (std::vector<Index>{0, 1, 2}));
  // Triangle lists the nodes opposite the corners: (1,2) (0,2) (0,1).
  EXPECT_EQ(mesh.cells().midside, (std::vector<Index>{5, 4, 3}));
  EXPECT_FALSE(mesh.facets().second_order());
  EXPECT_EQ(mesh.groups.front().elements, std::vector<Index>{0});
}

TEST_F(Tetgen, NamesTheLineOfEveryDefect) {
  const struct {
    std::string node, ele, face;
    std::vector<std::string> parts;
  } cases[] = {
      {with(kNode, "5 3 1", "5 4 1"), kEle, kFace, {"a.node:2:", "4 coordinates"}},
      {with(kNode, "5 3 1", "0 3 1"), kEle, kFace, {"a.node:2:", "no points"}},
      {with(kNode, "5 3 1 1", "5 3 1 2"), kEle, kFace, {"a.node:2:", "not 0 or 1"}},
      {with(kNode, "5 3 1", "5 3 99999"), kEle, kFace, {"a.node:2:", "99999", "bytes follow"}},
      {with(kNode, "5 3 1", "5 3 40"), kEle, kFace, {"a.node:2:", "too short for 40 attributes"}},
      {with(kNode, "5 3 1", "6 3 1"), kEle, kFace, {"a.node:8:", "nothing more"}},
      {with(kNode, "5 3 1", "4 3 1"), kEle, kFace, {"a.node:8:", "more rows than the points"}},
      {with(kNode, "1 0 0 0", "2 0 0 0"), kEle, kFace, {"a.node:3:", "start from 0 or 1"}},
      {with(kNode, "2 1 0 0", "3 1 0 0"), kEle, kFace, {"a.node:4:", "where 2 comes next"}},
      {with(kNode, "2 1 0 0", "2 1 x 0"), kEle, kFace, {"a.node:4:", "y coordinate", "'x'"}},
      {with(kNode, "1.5 0", "1.5 0 0"), kEle, kFace, {"a.node:4:", "goes on with '0'"}},
      {kNode.substr(0, kNode.size() - 1), kEle, kFace, {"a.node:8:", "no line end"}},
      {kNode, with(kEle, "2 4 2", "2 5 2"), kFace, {"a.ele:1:", "5 nodes", "4 or 10"}},
      {kNode, with(kEle, "2 4 2", "0 4 2"), kFace, {"a.ele:1:", "no cells"}},
      {kNode, with(kEle, "2 2 3 4 5", "2 2 3 4 6"), kFace, {"a.ele:3:", "no point 6", "1 to 5"}},
      {kNode, with(kEle, "2 2 3 4 5", "2 2 3 4 0"), kFace, {"a.ele:3:", "no point 0"}},
      {kNode, with(kEle, "2 2 3 4 5", "0 2 3 4 5"), kFace, {"a.ele:3:", "where 2 comes next"}},
      {kNode, kEle, with(kFace, "0 1 -1", "0 1"), {"a.face:3:", "6 columns", "the first has 7"}},
      {kNode, kEle, "1 1\n1 2 3 4 9 1 2 3\n", {"a.face:2:", "wrong length"}},
      {kNode, kEle, "1 1\n1\n", {"a.face:2:", "wrong length"}},
      {kNode, kEle, "1 3\n1 2 3 4 9\n", {"a.face:1:", "not 0 or 1"}},
  };
  for (const auto& one : cases) {
    put_all(one.node, one.ele, one.face);
    expect_reading_error(path("a.node"), one.parts);
  }
  put("b.node", kNode);
  expect_reading_error(path("b.node"), {"cannot read", "b.ele"});
}

TEST_F(Tetgen, WhatIsCutOffIsNoticed) {
  const auto node = [](const InputText& text) { return read_tetgen({text, {"e", kEle}}); };
  const auto ele = [](const InputText& text) { return read_tetgen({{"n", kNode}, text}); };
  const auto face = [](const InputText& text) {
    return read_tetgen({{"n", kNode}, {"e", kEle}, &text});
  };
  expect_prefixes_are_refused(node, kNode);
  expect_prefixes_are_refused(ele, kEle);
  expect_prefixes_are_refused(face, kFace);
  expect_defects_are_noticed(node, kNode);
  expect_defects_are_noticed(ele, kEle);
  expect_defects_are_noticed(face, kFace);
}

TEST_F(Tetgen, FilesThatNoLongerBelongToTheMeshGo) {
  write_mesh(path("a.node"), grouped_mesh());
  EXPECT_EQ(names(), (std::vector<std::string>{"a.edge", "a.ele", "a.face", "a.node",
                                               "a.node.groups.json"}));
  Mesh mesh = grouped_mesh();
  mesh.elements[1] = mesh.elements[2] = {};
  mesh.groups = {{"1", 3, 1, {0}}};
  write_mesh(path("a.ele"), mesh);
  EXPECT_EQ(names(), (std::vector<std::string>{"a.ele", "a.node"}));
  expect_same_content(read_mesh(path("a.node")), [&] {
    mesh.elements[0] = {};  // in no group
    return mesh;
  }());
}

TEST_F(Tetgen, RefusesWhatTheFormatCannotHold) {
  Mesh mesh = grouped_mesh();
  mesh.elements[3] = {};
  mesh.dimension = 2;
  mesh.groups.resize(6);
  EXPECT_THROW(write_mesh(path("a.node"), mesh), OutputError);  // not in a plane
  mesh.elements[2] = {};
  mesh.dimension = 1;
  EXPECT_THROW(write_mesh(path("a.node"), mesh), OutputError);
  EXPECT_TRUE(names().empty());
}

}  // namespace
}  // namespace cleave::app::test
