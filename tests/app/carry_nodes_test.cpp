// Nodes of second order, fields and vertices through random cuts, judged from what OUT holds.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "carry_support.hpp"
#include "check_report.hpp"
#include "edge_nodes.hpp"
#include "error.hpp"

namespace cleave::app::test {
namespace {

using Edge = std::pair<Index, Index>;

// Calls visit(edge as an ascending pair of places, node) for the edges of an element.
template <class Visit>
void for_edges(const Elements& elements, std::size_t k, std::size_t e, Visit visit) {
  std::size_t n = k * (k + 1) / 2 * e;
  for (std::size_t i = 0; i <= k; ++i)
    for (std::size_t j = i + 1; j <= k; ++j)
      visit(
          Edge(std::minmax(elements.vertices[(k + 1) * e + i], elements.vertices[(k + 1) * e + j])),
          elements.midside[n++]);
}

Index origin(const Mesh& out, Index place) {
  return static_cast<Index>(out.point_fields.front().values[place]);
}

// What the vertices of a facet were in the file, as one number.
double signature(std::vector<Index> places) {
  std::sort(places.begin(), places.end());
  double sum = 0;
  for (const Index p : places) sum = 1000 * sum + p + 1;
  return sum;
}

std::vector<Index> tuple(const Elements& elements, std::size_t corners, std::size_t e) {
  const auto from = elements.vertices.begin() + static_cast<std::ptrdiff_t>(corners * e);
  return {from, from + static_cast<std::ptrdiff_t>(corners)};
}

// A random mesh with groups and fields on everything, cut along the group "seam" or along the same
// facets named otherwise.
template <int D>
struct Case {
  Mesh mesh;
  std::vector<topology::HalfFacetId> facets;
};

template <int D>
Case<D> random_case(support::Rng& rng, bool second_order) {
  for (;;) {
    const auto mesh_class = support::kMeshClasses[rng.below(support::kMeshClasses.size())];
    const auto cut_class = support::kCutClasses[rng.below(support::kCutClasses.size())];
    if (!support::can_occur(cut_class, D)) continue;
    const auto cells = support::random_mesh<D>(mesh_class, rng);
    const auto facets = support::random_cut(cells, cut_class, rng);
    if (!facets) continue;
    RC_TAG(std::string(support::name(mesh_class)));
    Case<D> c{mesh_of(cells, rng), *facets};
    std::vector<topology::HalfFacetId> some;
    for (Index h = 0; h < static_cast<Index>(D + 1) * cells.cells.size(); ++h)
      if (rng.chance(0.1)) some.push_back({h});
    add_facets<D>(c.mesh, "other", some, rng);
    add_facets<D>(c.mesh, "seam", c.facets, rng);
    if (D == 3) {
      Elements& edges = c.mesh.elements[1];
      for (std::size_t e = 0; e < c.mesh.cells().size(); e += 3) {
        auto cell = tuple(c.mesh.cells(), 4, e);
        rng.shuffle(cell);
        edges.vertices.insert(edges.vertices.end(), {cell[0], cell[1]});
        edges.numbers.push_back(5000 + e);
      }
    }
    if (second_order) add_nodes(c.mesh, rng);
    if (D > 1) {
      Group pins{"pins", 0, 9, {}};
      for (Index p = 0; p < c.mesh.points.size(); p += 4) {
        c.mesh.elements[0].vertices.push_back(p);
        c.mesh.elements[0].numbers.push_back(9000 + p);
        pins.elements.push_back(static_cast<Index>(pins.elements.size()));
      }
      c.mesh.groups.push_back(pins);
    }
    add_places(c.mesh);
    Field& values = c.mesh.facet_fields.emplace_back(Field{"signature", 1, {}});
    for (std::size_t e = 0; e < c.mesh.facets().size(); ++e)
      values.values.push_back(signature(tuple(c.mesh.facets(), D, e)));
    return c;
  }
}

// Every point of OUT is a corner or a node of a cell, and every cell is what it was.
template <int D>
void require_cells_kept(const Mesh& before, const Mesh& out) {
  RC_ASSERT(out.cells().numbers == before.cells().numbers);
  std::set<Index> used(out.cells().vertices.begin(), out.cells().vertices.end());
  used.insert(out.cells().midside.begin(), out.cells().midside.end());
  RC_ASSERT(used.size() == out.points.size());
  for (std::size_t i = 0; i < before.cells().vertices.size(); ++i)
    RC_ASSERT(origin(out, out.cells().vertices[i]) == before.cells().vertices[i]);
  RC_ASSERT(out.cells().midside.size() == before.cells().midside.size());
  for (std::size_t i = 0; i < before.cells().midside.size(); ++i)
    RC_ASSERT(origin(out, out.cells().midside[i]) == before.cells().midside[i]);
  for (Index p = 0; p < out.points.size(); ++p)
    RC_ASSERT(out.points[p] == before.points[origin(out, p)]);
}

// Two corners with one node before have one after exactly if their edges are the same after.
template <int D>
void require_nodes_follow_edges(const Mesh& out) {
  std::map<Edge, Index> node_on;
  std::map<Index, Edge> edge_of;
  for (std::size_t c = 0; c < out.cells().size(); ++c)
    for_edges(out.cells(), D, c, [&](Edge edge, Index node) {
      RC_ASSERT(node_on.emplace(edge, node).first->second == node);
      RC_ASSERT(edge_of.emplace(node, edge).first->second == edge);
    });
  for (std::size_t k = 1; k < D; ++k)
    for (std::size_t e = 0; e < out.elements[k].size(); ++e)
      for_edges(out.elements[k], k, e,
                [&](Edge edge, Index node) { RC_ASSERT(node_on.at(edge) == node); });
}

// Original points in their order, copies of vertices, copies of nodes by (original, least cell).
template <int D>
void require_canonical_order(const Mesh& out) {
  std::map<Index, std::size_t> least_cell;  // of nodes
  constexpr std::size_t kEdges = D * (D + 1) / 2;
  for (std::size_t i = 0; i < out.cells().midside.size(); ++i)
    least_cell.emplace(out.cells().midside[i], i / kEdges);
  std::set<Index> seen;
  std::vector<std::pair<Index, std::size_t>> node_copies;
  Index last_original = 0;
  bool copies_began = false;
  for (Index p = 0; p < out.points.size(); ++p) {
    const Index from = origin(out, p);
    const bool node = least_cell.count(p) != 0;
    if (seen.insert(from).second) {
      RC_ASSERT(!copies_began);
      RC_ASSERT((p == 0 || from > last_original));
      last_original = from;
      continue;
    }
    copies_began = true;
    RC_ASSERT((node || node_copies.empty()));
    if (node) node_copies.emplace_back(from, least_cell[p]);
  }
  RC_ASSERT(std::is_sorted(node_copies.begin(), node_copies.end()));
  std::map<Index, std::size_t> of_original;
  for (const auto& [p, cell] : least_cell) {
    const auto at = of_original.emplace(origin(out, p), cell).first;  // ascending: original first
    RC_ASSERT(at->second <= cell);
  }
}

// Each facet element has the value of the element of MESH on its facet; new ones where MESH has
// none have no value.
template <int D>
void require_facet_values(const Mesh& before, const Mesh& out) {
  const auto& known = before.facet_fields.front().values;
  const std::set<double> signatures(known.begin(), known.end());
  RC_ASSERT(out.facet_fields.front().values.size() == out.facets().size());
  for (std::size_t e = 0; e < out.facets().size(); ++e) {
    auto vertices = tuple(out.facets(), D, e);
    for (Index& v : vertices) v = origin(out, v);
    const double value = out.facet_fields.front().values[e], expected = signature(vertices);
    RC_ASSERT((signatures.count(expected) != 0 ? value == expected : std::isnan(value)));
  }
}

// The vertex group is on all copies of the vertices and nodes it was on.
void require_pins(const Mesh& before, const Mesh& out) {
  std::set<Index> pinned, expected, in_cells;
  for (const Index v : before.cells().vertices) in_cells.insert(v);
  for (const Index e : group(out, "pins").elements) pinned.insert(out.elements[0].vertices[e]);
  for (Index p = 0; p < out.points.size(); ++p)
    if (origin(out, p) % 4 == 0) expected.insert(p);
  RC_ASSERT(pinned == expected);
}

template <int D>
void carries_everything() {
  support::Rng rng(*rc::gen::arbitrary<std::uint64_t>());
  const bool second_order = rng.chance(0.8);
  const bool by_group = rng.chance(0.5);
  const auto c = random_case<D>(rng, second_order);
  const Mesh& mesh = c.mesh;
  const auto done = by_group ? cut<D>(mesh, {"seam"}) : cut<D>(mesh, {}, c.facets);
  const Mesh& out = done.output.mesh;
  const std::size_t vertices = done.incision.complex().vertex_count() - mesh.points.size();
  RC_CLASSIFY(out.points.size() - vertices > mesh.points.size(), "nodes copied");
  RC_CLASSIFY(!done.body.regularized.empty(), "regularized");
  RC_CLASSIFY(!done.incision.shut().empty(), "some facet shut");
  RC_CLASSIFY(done.incision.opened().empty(), "nothing opened");

  require_cells_kept<D>(mesh, out);
  require_canonical_order<D>(out);
  require_facet_values<D>(mesh, out);
  if (D > 1) require_pins(mesh, out);
  if (!second_order) return;
  require_nodes_follow_edges<D>(out);
  RC_ASSERT(check_edge_nodes(out).empty());
}

// T3, T4 for edges: a node of second order is a function of its edge.
RC_GTEST_PROP(Carry, NodesFieldsAndPointsOfEdges, ()) { carries_everything<1>(); }
RC_GTEST_PROP(Carry, NodesFieldsAndPointsOfTriangles, ()) { carries_everything<2>(); }
RC_GTEST_PROP(Carry, NodesFieldsAndPointsOfTetrahedra, ()) { carries_everything<3>(); }

// Two triangles of second order, their common edge (0 1) with node 4.
Mesh two_triangles() {
  Mesh mesh;
  mesh.source = "two.msh";
  mesh.dimension = 2;
  mesh.points = {{0, 0, 0},  {2, 0, 0},   {1, 2, 0},   {1, -2, 0},  {1, 0, 0},
                 {.5, 1, 0}, {1.5, 1, 0}, {.5, -1, 0}, {1.5, -1, 0}};
  for (std::uint64_t v = 1; v <= 9; ++v) mesh.vertex_numbers.push_back(v);
  mesh.elements[2] = {{0, 1, 2, 1, 0, 3}, {1, 2}, {4, 5, 6, 4, 8, 7}};
  return mesh;
}

std::string first_finding(const Mesh& mesh) {
  const auto findings = check_edge_nodes(mesh);
  return findings.empty() ? "" : findings.front().message;
}

TEST(EdgeNodes, AreNoOrphansAndAreCounted) {
  const auto report = check_mesh(two_triangles(), {});
  EXPECT_TRUE(report.findings.empty());
  EXPECT_EQ(report.vertices, 4u);
  EXPECT_EQ(report.topology.euler_characteristic, 1);
  EXPECT_NE(text_of(report, 1, true).find("4 vertices, second order (5 nodes on edges)"),
            std::string::npos);
}

TEST(EdgeNodes, TheNodeOfACutEdgeIsCopied) {
  Mesh mesh = two_triangles();
  mesh.elements[1] = {{1, 0}, {3}, {4}};
  mesh.groups = {{"seam", 1, 1, {0}}};
  const auto done = cut<2>(mesh, {"seam"});
  const Mesh& out = done.output.mesh;
  EXPECT_EQ(out.points.size(), 12u);  // two copies of vertices, then one of node 5
  EXPECT_EQ(out.vertex_numbers[11], 12u);
  EXPECT_EQ(out.points[11], mesh.points[4]);
  EXPECT_EQ(out.cells().midside, (std::vector<Index>{4, 5, 6, 11, 8, 7}));
  EXPECT_EQ(out.elements[1].midside.size(), 2u);
  EXPECT_EQ(done.output.vertex_at[11], kNoVertex);
}

TEST(EdgeNodes, WhatIsNoFunctionOfTheEdgesIsRefused) {
  Mesh missing = two_triangles();
  missing.elements[2].midside[1] = kNoNode;
  EXPECT_EQ(first_finding(missing),
            "triangle 1 has no node on its edge (1 3), while other edges have");
  Mesh two_nodes = two_triangles();
  two_nodes.points.push_back({1, .1, 0});
  two_nodes.vertex_numbers.push_back(10);
  two_nodes.elements[2].midside[3] = 9;
  EXPECT_EQ(first_finding(two_nodes),
            "the edge (1 2) has node 5 in triangle 1 and node 10 in triangle 2");
  Mesh two_edges = two_triangles();
  two_edges.elements[2].midside[4] = 5;
  EXPECT_EQ(first_finding(two_edges),
            "node 6 is on the edge (1 3) of triangle 1 and on the edge (2 4) of triangle 2");
  Mesh corner = two_triangles();
  corner.elements[2].midside[1] = 3;
  EXPECT_EQ(first_finding(corner),
            "vertex 4 is the node on the edge (1 3) of triangle 1, and a corner of an element");
  Mesh mixed = two_triangles();
  mixed.elements[1] = {{0, 2}, {7}};
  EXPECT_EQ(first_finding(mixed),
            "triangle 1 has nodes on its edges and edge 7 has none; write the mesh in one order");
  for (const Mesh& mesh : {missing, two_nodes, two_edges, corner, mixed}) {
    EXPECT_GT(check_mesh(mesh, {}).count(Severity::error), 0u);
    EXPECT_THROW(make_body<2>(mesh), InputError);
  }
}

}  // namespace
}  // namespace cleave::app::test
