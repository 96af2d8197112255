#include "sub_mesh.hpp"

#include <gtest/gtest.h>

namespace cleave::app::test {
namespace {

using Places = std::vector<Index>;

Elements elements(Places vertices, std::vector<std::uint64_t> numbers) {
  Elements result;
  result.vertices = std::move(vertices);
  result.numbers = std::move(numbers);
  return result;
}

// A strip of three triangles, 0-1-2, 1-3-2 and 2-3-4, with everything that a mesh can have besides.
// Vertex 5 is in no cell; 6 is the far end of a stray edge.
Mesh strip() {
  Mesh mesh;
  mesh.source = "strip";
  mesh.dimension = 2;
  for (Index v = 0; v < 7; ++v) {
    mesh.points.push_back({1.0 * v, 1.0 * (v % 2), 0});
    mesh.vertex_numbers.push_back(10 * v);
  }
  mesh.elements[0] = elements({0, 4, 5}, {1, 2, 3});
  mesh.elements[1] = elements({0, 1, 3, 2, 4, 3, 4, 6}, {4, 5, 6, 7});
  mesh.elements[2] = elements({0, 1, 2, 1, 3, 2, 2, 3, 4}, {8, 9, 11});
  mesh.groups = {{"nails", 0, 1, {0, 1, 2}},
                 {"inner", 1, 2, {1, 2}},
                 {"first", 1, 3, {0}},
                 {"all", 2, 4, {0, 1, 2}}};
  mesh.point_fields = {{"warmth", 1, {0, 1, 2, 3, 4, 5, 6}, false}};
  mesh.cell_fields = {{"flow", 2, {0, 0.5, 1, 1.5, 2, 2.5}, false}};
  mesh.facet_fields = {{"gap", 1, {0, 1, 2, 3}, false}};
  mesh.periodic = {{0, 1, 2, {}, {{3, 1}, {4, 0}}}};
  mesh.cohesive.vertices = {1, 2, 3, 4, 0, 1, 2, 3};
  mesh.cohesive.numbers = {12, 13};
  mesh.cohesive.names = {"late", "early"};
  return mesh;
}

TEST(SubMesh, KeepsWhatBelongsToTheCellsThatStay) {
  const SubMesh part = sub_mesh(strip(), Places{1, 2});
  const Mesh& mesh = part.mesh;
  EXPECT_EQ(part.place, (Places{1, 2, 3, 4}));
  EXPECT_EQ(mesh.vertex_numbers, (std::vector<std::uint64_t>{10, 20, 30, 40}));
  EXPECT_EQ(mesh.points[2], (std::array<double, 3>{3, 1, 0}));
  EXPECT_EQ(mesh.elements[2].vertices, (Places{0, 2, 1, 1, 2, 3}));
  EXPECT_EQ(mesh.elements[2].numbers, (std::vector<std::uint64_t>{9, 11}));
  // The edge 3-2 and the edge 4-3 are sides of these cells; 0-1 and the stray one are not.
  EXPECT_EQ(mesh.elements[1].vertices, (Places{2, 1, 3, 2}));
  EXPECT_EQ(mesh.elements[0].vertices, Places{3});

  ASSERT_EQ(mesh.groups.size(), 3u);  // "first" has lost its only element
  EXPECT_EQ(mesh.groups[0].name, "nails");
  EXPECT_EQ(mesh.groups[0].elements, Places{0});
  EXPECT_EQ(mesh.groups[1].name, "inner");
  EXPECT_EQ(mesh.groups[1].elements, (Places{0, 1}));
  EXPECT_EQ(mesh.groups[2].name, "all");
  EXPECT_EQ(mesh.groups[2].elements, (Places{0, 1}));

  EXPECT_EQ(mesh.point_fields[0].values, (std::vector<double>{1, 2, 3, 4}));
  EXPECT_EQ(mesh.cell_fields[0].values, (std::vector<double>{1, 1.5, 2, 2.5}));
  EXPECT_EQ(mesh.facet_fields[0].values, (std::vector<double>{1, 2}));
  ASSERT_EQ(mesh.periodic.size(), 1u);
  ASSERT_EQ(mesh.periodic[0].pairs.size(), 1u);
  EXPECT_EQ(mesh.periodic[0].pairs[0].vertex, 2u);
  EXPECT_EQ(mesh.periodic[0].pairs[0].master, 0u);
  EXPECT_EQ(mesh.cohesive.vertices, (Places{0, 1, 2, 3}));
  EXPECT_EQ(mesh.cohesive.names, std::vector<std::string>{"late"});
}

TEST(SubMesh, KeepsLooseVerticesThatAreNamed) {
  const SubMesh part = sub_mesh(strip(), Places{0}, Places{5});
  EXPECT_EQ(part.place, (Places{0, 1, 2, 5}));
  EXPECT_EQ(part.mesh.elements[0].vertices, (Places{0, 3}));
  EXPECT_TRUE(part.mesh.periodic.empty());
  EXPECT_EQ(part.mesh.cohesive.size(), 0u);
}

TEST(SubMesh, OfAllCellsIsTheMeshWithoutWhatIsLoose) {
  const Mesh whole = strip();
  const SubMesh part = sub_mesh(whole, Places{0, 1, 2});
  EXPECT_EQ(part.place, (Places{0, 1, 2, 3, 4}));
  EXPECT_EQ(part.mesh.elements[2].vertices, whole.elements[2].vertices);
  EXPECT_EQ(part.mesh.elements[1].numbers, (std::vector<std::uint64_t>{4, 5, 6}));
  EXPECT_EQ(part.mesh.cohesive.vertices, whole.cohesive.vertices);
}

TEST(SubMesh, TakesNodesOfSecondOrderWithTheirCells) {
  Mesh mesh = strip();
  for (Index v = 7; v < 14; ++v) {
    mesh.points.push_back({1.0 * v, 0, 0});
    mesh.vertex_numbers.push_back(10 * v);
  }
  mesh.point_fields.clear();
  mesh.elements[2].midside = {7, 8, 9, 10, 9, 11, 11, 12, 13};  // 01 02 12, 13 12 23, 23 24 34
  mesh.elements[1] = elements({1, 2}, {4});
  mesh.elements[1].midside = {9};
  mesh.facet_fields.clear();
  mesh.groups.clear();
  const SubMesh part = sub_mesh(mesh, Places{1});
  EXPECT_EQ(part.place, (Places{1, 2, 3, 9, 10, 11}));
  EXPECT_EQ(part.mesh.elements[2].midside, (Places{4, 3, 5}));
  EXPECT_EQ(part.mesh.elements[1].midside, Places{3});
  EXPECT_TRUE(part.mesh.elements[1].second_order());
}

}  // namespace
}  // namespace cleave::app::test
