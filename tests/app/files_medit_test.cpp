// The Medit reader: what it accepts, what it refuses and how it says so.
#include "files/medit.hpp"
#include "files_support.hpp"
#include "mesh_file.hpp"

namespace cleave::app::test {
namespace {

using Medit = Files;

const std::string kTetrahedron =
    "MeshVersionFormatted 1\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 5\n0 0 1 0\n"
    "Tetrahedra\n1\n1 2 3 4 2\nEnd\n";

/// The tetrahedron with one piece of its text replaced.
std::string with(const std::string& piece, const std::string& other) {
  std::string text = kTetrahedron;
  const auto at = text.find(piece);
  if (at == std::string::npos) throw std::logic_error(piece);
  return text.replace(at, piece.size(), other);
}

TEST_F(Medit, ReadsElementsReferencesAndNumbers) {
  const Mesh mesh = read_mesh(put("a.mesh", kTetrahedron));
  EXPECT_EQ(mesh.source, path("a.mesh").string());
  EXPECT_EQ(mesh.dimension, 3);
  EXPECT_EQ(mesh.points[3], (std::array<double, 3>{0, 0, 1}));
  EXPECT_EQ(mesh.vertex_numbers, (std::vector<std::uint64_t>{1, 2, 3, 4}));
  EXPECT_EQ(mesh.cells().vertices, (std::vector<Index>{0, 1, 2, 3}));
  EXPECT_EQ(mesh.cells().numbers, std::vector<std::uint64_t>{1});
  EXPECT_EQ(mesh.elements[0].vertices, std::vector<Index>{2});
  EXPECT_EQ(mesh.elements[0].numbers, std::vector<std::uint64_t>{3});
  ASSERT_EQ(mesh.groups.size(), 2u);
  EXPECT_EQ(mesh.groups[0].name, "5");
  EXPECT_EQ(mesh.groups[0].dimension, 0);
  EXPECT_EQ(mesh.groups[1].name, "2");
  EXPECT_EQ(mesh.groups[1].elements, std::vector<Index>{0});
}

TEST_F(Medit, AcceptsEveryWayTheFormatIsWritten) {
  const Mesh plain = read_mesh(put("plain.mesh", kTetrahedron));
  const std::string dressed =
      "# made by hand\r\n\r\nMeshVersionFormatted\r\n2\r\n\r\nDimension\r\n3 # space\r\n"
      "Geometry\r\n\"body.geom\"\r\nAngleOfCornerBound 30\r\nTetrahedra 1\r\n1 2\t3 4 +2\r\n"
      "Normals\r\n2\r\n0 0 1\r\n0 1 0\r\nCorners 1\r\n4\r\nQuadrilaterals\r\n0\r\n"
      "\tVertices 4 # four\r\n+0 -0e5 .0 0\r\n1. 0 0 0   \r\n0 1e0 0 5\r\n# between\r\n"
      "0 0 +1.0E+00 0\r\nEnd\r\n# after\r\n\r\n";
  Mesh mesh = read_mesh(put("dressed.mesh", dressed));
  mesh.points[0][1] = 0;  // the file says minus zero, which is kept
  expect_same_content(mesh, plain);
  expect_same_numbers(mesh, plain);
}

TEST_F(Medit, NumbersAreReadToTheLastBit) {
  const Mesh mesh = read_mesh(
      put("a.mesh", with("1 0 0 0\n", "0.1 123456789.123456789 4.9406564584124654e-324 0\n")));
  EXPECT_EQ(mesh.points[1], (std::array<double, 3>{0.1, 123456789.123456789, 5e-324}));
}

TEST_F(Medit, NamesTheLineOfEveryDefect) {
  const struct {
    std::string text;
    std::vector<std::string> parts;
  } cases[] = {
      {with("0 1 0 5", "0 1 x 5"), {"a.mesh:7:", "the z coordinate of a vertex", "found 'x'"}},
      {with("0 1 0 5", "0 1 5"), {"a.mesh:7:", "the reference of a vertex", "line ends"}},
      {with("0 1 0 5", "0 1 0 5 6"), {"a.mesh:7:", "goes on with '6'"}},
      {with("0 1 0 5", "0 1 0 5.5"), {"a.mesh:7:", "an integer", "found '5.5'"}},
      {with("0 1 0 5", "0 1 0 99999999999"), {"a.mesh:7:", "32 bits"}},
      {with("0 1 0 5", "0 1e999 0 5"), {"a.mesh:7:", "range of doubles"}},
      {with("0 1 0 5", "0 1,5 0 5"), {"a.mesh:7:", "found '1,5'"}},
      {with("1 2 3 4 2", "1 2 3 5 2"), {"a.mesh:11:", "tetrahedron 1 uses vertex 5", "4 vertices"}},
      {with("1 2 3 4 2", "0 2 3 4 2"), {"a.mesh:11:", "vertex number 0", "from 1 on"}},
      {with("1 2 3 4 2", "-1 2 3 4 2"), {"a.mesh:11:", "non-negative integer", "'-1'"}},
      {with("1 2 3 4 2", "1 2 3 4294967296 2"), {"a.mesh:11:", "32 bits"}},
      {with("Vertices\n4", "Vertices\n-4"), {"a.mesh:4:", "negative: -4"}},
      {with("Vertices\n4", "Vertices\n3"), {"a.mesh:8:", "unknown keyword '0'"}},
      {with("Vertices\n4", "Vertices\n5"), {"a.mesh:9:", "found 'Tetrahedra'"}},
      {with("Vertices\n4", "Vertices\n4000000000"), {"a.mesh:4:", "4000000000", "bytes follow"}},
      {with("Vertices\n4", "Vertices\n5000000000"), {"a.mesh:4:", "32-bit ids"}},
      {with("Vertices\n4", "Vertices\n99999999999999999999"), {"a.mesh:4:", "64 bits"}},
      {with("Tetrahedra\n1", "Tetrahedra\n2"), {"a.mesh:12:", "found 'End'"}},
      {with("Tetrahedra", "Hexahedra"),
       {"a.mesh:9:", "Hexahedra are not simplices of order 1 or 2"}},
      {with("Tetrahedra", "TetrahedraP3"), {"a.mesh:9:", "TetrahedraP3 are not simplices"}},
      {with("Tetrahedra\n1\n1 2 3 4 2", "TetrahedraP2\n1\n1 2 3 4 1 2 3 4 1 7 2"),
       {"a.mesh:11:", "tetrahedron 1 uses vertex 7"}},
      {with("End\n", "TetrahedraP2\n0\nEnd\n"), {"a.mesh:12:", "in one order"}},
      {with("Tetrahedra", "Tetraedra"), {"a.mesh:9:", "unknown keyword 'Tetraedra'"}},
      {with("Dimension 3", "Dimension 4"), {"a.mesh:2:", "must be 2 or 3"}},
      {with("Dimension 3\n", ""), {"a.mesh:2:", "Vertices before Dimension"}},
      {with("Dimension 3", "Dimension 3\nDimension 3"), {"a.mesh:3:", "second Dimension"}},
      {with("Formatted 1", "Formatted 9"), {"a.mesh:1:", "MeshVersionFormatted is 9"}},
      {with("End\n", "Tetrahedra\n1\n1 2 3 4 2\nEnd\n"), {"a.mesh:12:", "second section"}},
      {with("End\n", "End\n1 2 3\n"), {"a.mesh:13:", "nothing may follow"}},
      {with("End\n", ""), {"without the keyword End", "truncated"}},
      {with("Tetrahedra\n1\n1 2 3 4 2\n", ""), {"holds no edges, triangles or tetrahedra"}},
  };
  for (const auto& one : cases) expect_reading_error(put("a.mesh", one.text), one.parts);
}

TEST_F(Medit, TetrahedraNeedThreeDimensions) {
  put("a.mesh",
      "MeshVersionFormatted 1\nDimension 2\nVertices\n4\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n"
      "Tetrahedra\n1\n1 2 3 4 2\nEnd\n");
  expect_reading_error(path("a.mesh"), {"a.mesh:9:", "Dimension 3"});
}

TEST_F(Medit, EveryTruncatedFileIsRefused) {
  write_mesh(path("whole.mesh"), grouped_mesh());
  expect_prefixes_are_refused(read_medit, bytes("whole.mesh"));
  expect_prefixes_are_refused(read_medit, kTetrahedron);
}

TEST_F(Medit, DefectsAnywhereAreNoticedOrHarmless) {
  expect_defects_are_noticed(read_medit, kTetrahedron);
}

}  // namespace
}  // namespace cleave::app::test
