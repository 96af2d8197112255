// Cohesive elements: between the right facets, and positive when the sides move apart.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "carry_support.hpp"
#include "cohesive.hpp"
#include "error.hpp"

namespace cleave::app::test {
namespace {

using Vector = std::array<double, 3>;
using Tuple = std::vector<Index>;

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double volume(const Vector& a, const Vector& b, const Vector& c, const Vector& d) {
  return dot(minus(b, a), cross(minus(c, a), minus(d, a))) / 6;
}

// The volume of a prism in the order of gmsh and Abaqus, or the area of the quadrangle (0 1 3 2):
// positive when the first face is seen counter-clockwise from the other.
double measure(const std::vector<Vector>& p) {
  if (p.size() == 6)
    return volume(p[0], p[1], p[2], p[5]) + volume(p[0], p[1], p[5], p[4]) +
           volume(p[0], p[4], p[5], p[3]);
  return (cross(minus(p[1], p[0]), minus(p[3], p[0]))[2] +
          cross(minus(p[3], p[0]), minus(p[2], p[0]))[2]) /
         2;
}

// The facets of a group of OUT, each ascending.
template <int D>
std::multiset<Tuple> facets_in(const Mesh& out, const std::string& name) {
  std::multiset<Tuple> all;
  for (const Index e : group(out, name).elements) {
    const auto from = out.facets().vertices.begin() + static_cast<std::ptrdiff_t>(D) * e;
    Tuple facet(from, from + D);
    std::sort(facet.begin(), facet.end());
    all.insert(facet);
  }
  return all;
}

// For each facet of OUT the mean of its cells' centres: of the one cell, if it is on the boundary.
template <int D>
Vector centre_of_cell_at(const Mesh& out, const Tuple& facet) {
  for (std::size_t c = 0; c < out.cells().size(); ++c) {
    const Index* cell = &out.cells().vertices[(D + 1) * c];
    if (!std::all_of(facet.begin(), facet.end(),
                     [&](Index v) { return std::find(cell, cell + D + 1, v) != cell + D + 1; }))
      continue;
    Vector centre{};
    for (std::size_t i = 0; i <= D; ++i)
      for (std::size_t x = 0; x < 3; ++x) centre[x] += out.points[cell[i]][x] / (D + 1);
    return centre;
  }
  ADD_FAILURE() << "no cell has the facet";
  return {};
}

template <int D>
void lie_between_the_sides() {
  support::Rng rng(*rc::gen::arbitrary<std::uint64_t>());
  typename support::KuhnGrid<D>::Point nodes{};
  for (int& n : nodes) n = rng.between(2, 4);
  const support::KuhnGrid<D> grid(nodes);
  const auto cut_class = support::kCutClasses[rng.below(support::kCutClasses.size())];
  const auto facets = support::random_cut<D>(grid, cut_class, rng);
  RC_PRE(facets.has_value());
  RC_TAG(std::string(support::name(cut_class)));
  Mesh mesh = grid_mesh(grid, rng);
  // random_cut numbers half-facets by the order of the grid's tuples: name facets by vertices.
  std::vector<Index> places;
  for (const auto h : *facets)
    for (int i = 0; i <= D; ++i)
      if (i != topology::local_index<D>(h))
        places.push_back(
            grid.cells[topology::cell_of<D>(h).value][static_cast<std::size_t>(i)].value);
  const auto asked = locate(make_body<D>(mesh), places, "the test");
  auto done = cut<D>(mesh, {}, asked);
  add_cohesive(done.body, done.output);
  const Mesh& out = done.output.mesh;
  const CohesiveElements& cohesive = out.cohesive;
  RC_ASSERT(cohesive.size() == done.incision.opened().size());
  auto minus_side = facets_in<D>(out, "cut_minus"), plus_side = facets_in<D>(out, "cut_plus");
  std::set<std::uint64_t> numbers;
  for (const Elements& elements : out.elements)
    numbers.insert(elements.numbers.begin(), elements.numbers.end());
  std::size_t degenerate = 0;
  for (std::size_t e = 0; e < cohesive.size(); ++e) {
    RC_ASSERT(cohesive.names[e] == "cut_cohesive");
    RC_ASSERT(numbers.insert(cohesive.numbers[e]).second);
    const auto from = cohesive.vertices.begin() + static_cast<std::ptrdiff_t>(2 * D * e);
    Tuple bottom(from, from + D), top(from + D, from + 2 * D);
    std::vector<Vector> p;
    for (const Index v : bottom) p.push_back(out.points[v]);
    for (std::size_t i = 0; i < D; ++i) RC_ASSERT(out.points[top[i]] == p[i]);
    RC_ASSERT(measure([&] {
                auto q = p;
                q.insert(q.end(), p.begin(), p.end());
                return q;
              }()) == 0);
    bool shared = false;
    std::sort(bottom.begin(), bottom.end());
    auto top_sorted = top;
    std::sort(top_sorted.begin(), top_sorted.end());
    const auto below = minus_side.find(bottom), above = plus_side.find(top_sorted);
    RC_ASSERT((below != minus_side.end() && above != plus_side.end()));
    minus_side.erase(below);
    plus_side.erase(above);
    // The plus side moves towards its cell; vertices that both sides share stay.
    const Vector to = centre_of_cell_at<D>(out, top_sorted);
    Tuple minus_order(from, from + D);
    for (std::size_t i = 0; i < D; ++i) {
      const bool tip = top[i] == minus_order[i];
      shared = shared || tip;
      Vector q = p[i];
      for (std::size_t x = 0; x < 3 && !tip; ++x) q[x] += 0.01 * (to[x] - q[x]);
      p.push_back(q);
    }
    degenerate += shared ? 1 : 0;
    RC_ASSERT(measure(p) > 0);
  }
  RC_ASSERT((minus_side.empty() && plus_side.empty()));
  RC_CLASSIFY(degenerate > 0, "elements at a tip");
  RC_CLASSIFY(cohesive.size() == 0, "nothing opened");
}

RC_GTEST_PROP(Cohesive, QuadranglesLieBetweenTheSides, ()) { lie_between_the_sides<2>(); }
RC_GTEST_PROP(Cohesive, PrismsLieBetweenTheSides, ()) { lie_between_the_sides<3>(); }

TEST(Cohesive, TheGroupIsNamedAfterTheCut) {
  support::Rng rng(3);
  const support::KuhnGrid<3> grid({3, 3, 3});
  Mesh mesh = grid_mesh(grid, rng);
  const auto body = make_body<3>(mesh);
  std::vector<topology::HalfFacetId> middle;
  for (const auto h : topology::FacetSet::all(body.complex).half_facets()) {
    const auto facet = body.complex.facet(h);
    if (std::all_of(facet.begin(), facet.end(),
                    [&](auto v) { return mesh.points[v.value][0] == 1; }))
      middle.push_back(h);
  }
  add_facets<3>(mesh, "fault", middle, rng);
  auto done = cut<3>(mesh, {"fault"});
  add_cohesive(done.body, done.output);
  EXPECT_EQ(done.output.mesh.cohesive.size(), 8u);
  EXPECT_EQ(done.output.mesh.cohesive.names.front(), "fault_cohesive");
  EXPECT_THROW(make_body<3>(done.output.mesh), InputError);  // it holds its two sides together
}

TEST(Cohesive, EdgesAndSecondOrderAreRefused) {
  support::Rng rng(1);
  Mesh edges = grid_mesh(support::KuhnGrid<1>({4}), rng);
  EXPECT_THROW(require_cohesive(edges), InputError);
  Mesh quadratic = grid_mesh(support::KuhnGrid<2>({3, 3}), rng);
  EXPECT_NO_THROW(require_cohesive(quadratic));
  add_nodes(quadratic, rng);
  EXPECT_THROW(require_cohesive(quadratic), InputError);
}

}  // namespace
}  // namespace cleave::app::test
