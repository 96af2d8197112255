// What a cut carries is in the files it is written to.
#include <algorithm>

#include "carry_support.hpp"
#include "cohesive.hpp"
#include "files_support.hpp"
#include "mesh_file.hpp"

namespace cleave::app::test {
namespace {

using CarriedFiles = Files;

// A grid cut across, with everything that .msh holds.
Mesh cut_grid(bool second_order, bool cohesive) {
  support::Rng rng(21);
  const support::KuhnGrid<3> grid({3, 3, 3});
  Mesh mesh = grid_mesh(grid, rng);
  Periodicity ends{2, 11, 12, {}, {}};
  for (int y = 0; y < 3; ++y)
    for (int z = 0; z < 3; ++z)
      ends.pairs.push_back({grid.vertex({2, y, z}).value, grid.vertex({0, y, z}).value});
  mesh.periodic = {ends};
  const auto body = make_body<3>(mesh);
  std::vector<topology::HalfFacetId> plane;
  for (const auto h : topology::FacetSet::all(body.complex).half_facets()) {
    const auto facet = body.complex.facet(h);
    if (std::all_of(facet.begin(), facet.end(),
                    [&](auto v) { return mesh.points[v.value][2] == 1; }))
      plane.push_back(h);
  }
  add_facets<3>(mesh, "plane", plane, rng);
  if (second_order) {
    mesh.periodic.clear();
    add_nodes(mesh, rng);
  }
  auto done = cut<3>(mesh, {"plane"});
  if (cohesive) add_cohesive(done.body, done.output);
  return done.output.mesh;
}

void expect_same_carried(const Mesh& a, const Mesh& b) {
  expect_same_content(a, b);
  for (std::size_t k = 1; k <= 3; ++k) EXPECT_EQ(a.elements[k].midside, b.elements[k].midside);
  EXPECT_EQ(a.cohesive.vertices, b.cohesive.vertices);
  EXPECT_EQ(a.cohesive.names, b.cohesive.names);
  ASSERT_EQ(a.periodic.size(), b.periodic.size());
  for (std::size_t p = 0; p < a.periodic.size(); ++p) {
    ASSERT_EQ(a.periodic[p].pairs.size(), b.periodic[p].pairs.size());
    for (std::size_t i = 0; i < a.periodic[p].pairs.size(); ++i) {
      EXPECT_EQ(a.periodic[p].pairs[i].vertex, b.periodic[p].pairs[i].vertex);
      EXPECT_EQ(a.periodic[p].pairs[i].master, b.periodic[p].pairs[i].master);
    }
  }
}

TEST_F(CarriedFiles, MshHoldsPairsAndCohesiveElements) {
  for (const auto version : {MshVersion::k22, MshVersion::k41}) {
    Mesh mesh = cut_grid(false, true);
    EXPECT_EQ(mesh.cohesive.size(), 8u);
    EXPECT_EQ(mesh.periodic[0].pairs.size(), 12u);
    mesh.msh_version = version;
    write_mesh(path("a.msh"), mesh);
    expect_same_carried(read_mesh(path("a.msh")), mesh);
  }
}

TEST_F(CarriedFiles, MshHoldsNodesOfSecondOrder) {
  for (const auto version : {MshVersion::k22, MshVersion::k41}) {
    Mesh mesh = cut_grid(true, false);
    EXPECT_TRUE(mesh.facets().second_order());
    mesh.msh_version = version;
    write_mesh(path("a.msh"), mesh);
    expect_same_carried(read_mesh(path("a.msh")), mesh);
  }
}

}  // namespace
}  // namespace cleave::app::test
