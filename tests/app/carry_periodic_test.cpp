// Periodic pairs: split together, judged by the coordinates of OUT's boundary, or refused with what
// to cut as well.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "carry_support.hpp"
#include "error.hpp"

namespace cleave::app::test {
namespace {

using Point = std::array<double, 3>;
using Tuple = std::vector<Index>;
using Pairs = std::set<std::pair<Index, Index>>;

// A Kuhn grid, and the condition that makes its ends in each of the first `axes` axes periodic: the
// far end is the entity 10 + axis, the near end its master 20 + axis.
template <int D>
Mesh periodic_grid(const support::KuhnGrid<D>& grid, int axes, support::Rng& rng) {
  Mesh mesh = grid_mesh(grid, rng);
  for (int axis = 0; axis < axes; ++axis) {
    const auto x = static_cast<std::size_t>(axis);
    Periodicity p{D - 1, 10 + axis, 20 + axis, {}, {}};
    for (Index v = 0; v < mesh.points.size(); ++v) {
      auto at = grid.point({v});
      if (at[x] != grid.nodes[x] - 1) continue;
      at[x] = 0;
      p.pairs.push_back({v, grid.vertex(at).value});
    }
    mesh.periodic.push_back(p);
  }
  return mesh;
}

// Also pairs nodes of second order, by their coordinates.
void pair_nodes(Mesh& mesh, const std::array<double, 3>& length) {
  std::map<Point, Index> at;
  for (Index p = 0; p < mesh.points.size(); ++p) at[mesh.points[p]] = p;
  for (std::size_t x = 0; x < mesh.periodic.size(); ++x) {
    mesh.periodic[x].pairs.clear();
    for (const auto& [point, place] : at) {
      if (point[x] != length[x]) continue;
      Point image = point;
      image[x] = 0;
      mesh.periodic[x].pairs.push_back({place, at.at(image)});
    }
  }
}

// The boundary facets of `mesh` in the plane where coordinate `x` is `value`: vertices and nodes,
// by their points.
template <int D>
std::vector<std::map<Point, Index>> facets_in_plane(const Mesh& mesh, std::size_t x, double value) {
  std::vector<std::map<Point, Index>> all;
  for (std::size_t c = 0; c < mesh.cells().size(); ++c)
    for (std::size_t apex = 0; apex <= D; ++apex) {
      std::map<Point, Index> facet;
      for (std::size_t i = 0; i <= D; ++i) {
        if (i == apex) continue;
        const Index v = mesh.cells().vertices[(D + 1) * c + i];
        facet[mesh.points[v]] = v;
      }
      std::size_t edge = D * (D + 1) / 2 * c;
      for (std::size_t i = 0; i <= D && mesh.cells().second_order(); ++i)
        for (std::size_t j = i + 1; j <= D; ++j, ++edge)
          if (i != apex && j != apex)
            facet[mesh.points[mesh.cells().midside[edge]]] = mesh.cells().midside[edge];
      if (std::all_of(facet.begin(), facet.end(),
                      [&](const auto& point) { return point.first[x] == value; }))
        all.push_back(facet);
    }
  return all;
}

// What the two ends of axis `x` make pairs, from coordinates alone.
template <int D>
Pairs pairs_by_coordinates(const Mesh& mesh, std::size_t x, double length) {
  std::map<std::set<Point>, std::map<Point, Index>> near;
  for (const auto& facet : facets_in_plane<D>(mesh, x, 0)) {
    std::set<Point> key;
    for (const auto& [point, place] : facet) key.insert(point);
    near[key] = facet;
  }
  Pairs pairs;
  for (const auto& facet : facets_in_plane<D>(mesh, x, length)) {
    std::map<Point, Index> image;
    std::set<Point> key;
    for (const auto& [point, place] : facet) {
      Point moved = point;
      moved[x] = 0;
      image[moved] = place;
      key.insert(moved);
    }
    for (const auto& [point, place] : image) pairs.emplace(place, near.at(key).at(point));
  }
  return pairs;
}

bool one_to_one(const Pairs& pairs) {
  std::set<Index> ones, others;
  for (const auto& [one, other] : pairs)
    if (!ones.insert(one).second || !others.insert(other).second) return false;
  return true;
}

Pairs pairs_of(const Periodicity& p) {
  Pairs pairs;
  for (const auto& pair : p.pairs) pairs.emplace(pair.vertex, pair.master);
  return pairs;
}

// Half-facets of the interior facets whose vertices and cells satisfy `chosen`.
template <int D, class Chosen>
std::vector<topology::HalfFacetId> choose(const Mesh& mesh, Chosen chosen) {
  const auto body = make_body<D>(mesh);
  std::vector<topology::HalfFacetId> facets;
  for (const auto h : topology::FacetSet::all(body.complex).half_facets()) {
    std::vector<Point> points;
    for (const auto v : body.complex.facet(h)) points.push_back(mesh.points[v.value]);
    if (chosen(points)) facets.push_back(h);
  }
  return facets;
}

template <int D>
void splits_pairs_together_or_refuses() {
  support::Rng rng(*rc::gen::arbitrary<std::uint64_t>());
  typename support::KuhnGrid<D>::Point nodes{};
  for (int& n : nodes) n = rng.between(2, 4);
  const support::KuhnGrid<D> grid(nodes);
  const int axes = rng.between(1, D);
  Mesh mesh = periodic_grid(grid, axes, rng);
  std::array<double, 3> length{};
  for (std::size_t x = 0; x < D; ++x) length[x] = nodes[x] - 1;
  // A sheet between cells on two sides of planes across the last axis meets both ends alike; noise
  // makes it differ.
  const double height = rng.between(0, nodes[D - 1] - 1);
  const double noise = rng.chance(0.5) ? 0 : 0.15 * rng.unit();
  const bool everything = rng.chance(0.1);
  const auto facets = choose<D>(mesh, [&](const std::vector<Point>& p) {
    const bool plane =
        std::all_of(p.begin(), p.end(), [&](const Point& q) { return q[D - 1] == height; });
    return everything || plane || rng.chance(noise);
  });
  RC_PRE(!facets.empty());
  if (rng.chance(0.5)) {
    // Facets keep their cells, so the half-facets stay what they are.
    add_nodes(mesh, rng);
    pair_nodes(mesh, length);
  }
  Mesh alone = mesh;
  alone.periodic.clear();
  const auto expected = cut<D>(alone, {}, facets);
  bool possible = true;
  for (int axis = 0; axis < axes; ++axis) {
    const auto x = static_cast<std::size_t>(axis);
    possible = possible && one_to_one(pairs_by_coordinates<D>(expected.output.mesh, x, length[x]));
  }
  RC_CLASSIFY(possible, "possible");
  RC_CLASSIFY(possible && expected.output.mesh.points.size() > mesh.points.size(),
              "possible, and split");
  RC_CLASSIFY(mesh.cells().second_order(), "second order");
  try {
    const auto done = cut<D>(mesh, {}, facets);
    RC_ASSERT(possible);
    for (int axis = 0; axis < axes; ++axis) {
      const auto x = static_cast<std::size_t>(axis);
      const Periodicity& p = done.output.mesh.periodic[x];
      RC_ASSERT((p.entity == 10 + axis && p.master == 20 + axis && p.dimension == D - 1));
      RC_ASSERT(p.pairs.size() == pairs_of(p).size());
      RC_ASSERT(pairs_of(p) == pairs_by_coordinates<D>(done.output.mesh, x, length[x]));
    }
  } catch (const InputError& e) {
    RC_LOG() << e.what();
    RC_ASSERT(!possible);
  }
}

RC_GTEST_PROP(Periodic, PairsOfCurvesSplitTogether, ()) { splits_pairs_together_or_refuses<2>(); }
RC_GTEST_PROP(Periodic, PairsOfSurfacesSplitTogether, ()) { splits_pairs_together_or_refuses<3>(); }

std::string refusal(const Mesh& mesh, const std::vector<topology::HalfFacetId>& facets) {
  try {
    if (mesh.dimension == 2)
      cut<2>(mesh, {}, facets);
    else
      cut<3>(mesh, {}, facets);
  } catch (const InputError& e) {
    return e.what();
  }
  return {};
}

// The facets that the message says to cut, each by its vertices' places.
std::vector<Tuple> advised(const std::string& message) {
  std::vector<Tuple> facets;
  auto from = message.find("cut the facet");
  if (from == std::string::npos) return facets;
  while ((from = message.find('(', from)) != std::string::npos) {
    Tuple& facet = facets.emplace_back();
    std::istringstream in(message.substr(++from));
    for (Index n = 0; in >> n;) facet.push_back((n - 10) / 3);
  }
  return facets;
}

// Follows the advice until nothing is refused; returns how many facets that took in all.
template <int D>
std::size_t facets_after_advice(const Mesh& mesh, std::vector<topology::HalfFacetId> facets) {
  for (int steps = 0; steps < 20; ++steps) {
    const std::string message = refusal(mesh, facets);
    if (message.empty()) return facets.size();
    const auto advice = advised(message);
    EXPECT_FALSE(advice.empty()) << message;
    for (const Tuple& facet : advice) {
      const auto more = locate(make_body<D>(mesh), facet, "the advice");
      EXPECT_EQ(std::count(facets.begin(), facets.end(), more.front()), 0) << message;
      facets.push_back(more.front());
    }
  }
  ADD_FAILURE() << "the advice does not end";
  return 0;
}

TEST(Periodic, TheRefusalSaysWhichFacetToCutAsWell) {
  support::Rng rng(2);
  const support::KuhnGrid<2> grid({5, 3});
  for (const double end : {0., 4.}) {
    const Mesh mesh = periodic_grid(grid, 1, rng);
    const auto one = choose<2>(mesh, [&](const std::vector<Point>& p) {
      return p[0][1] == 1 && p[1][1] == 1 && (p[0][0] == end || p[1][0] == end);
    });
    ASSERT_EQ(one.size(), 1u);
    const std::string message = refusal(mesh, one);
    EXPECT_NE(message.find(end == 0 ? "splits vertex 13 and leaves vertex 49 joined"
                                    : "splits vertex 49 and leaves vertex 13 joined"),
              std::string::npos)
        << message;
    EXPECT_NE(message.find("curve 10 and its master 20 are periodic"), std::string::npos)
        << message;
    EXPECT_NE(message.find(end == 0 ? "so that vertex 49 splits" : "so that vertex 13 splits"),
              std::string::npos)
        << message;
    EXPECT_EQ(advised(message).size(), 1u) << message;
    EXPECT_EQ(facets_after_advice<2>(mesh, one), 2u);
  }
}

TEST(Periodic, InSpaceTheAdviceLeadsToACutThatIsPossible) {
  support::Rng rng(4);
  const support::KuhnGrid<3> grid({4, 3, 3});
  const Mesh mesh = periodic_grid(grid, 1, rng);
  for (const double end : {0., 3.}) {
    const auto half = choose<3>(mesh, [&](const std::vector<Point>& p) {
      return std::all_of(p.begin(), p.end(),
                         [&](const Point& q) { return q[1] == 1 && std::abs(q[0] - end) <= 1; });
    });
    EXPECT_EQ(half.size(), 4u);
    const std::size_t facets = facets_after_advice<3>(mesh, half);
    EXPECT_GE(facets, 6u);
    EXPECT_LE(facets, 10u);
  }
}

TEST(Periodic, CurvesInSpaceFollowTheSurfaces) {
  // Ends of two axes: the edges along the third are paired by way of either, the opposite ones by
  // way of both.
  support::Rng rng(9);
  const support::KuhnGrid<3> grid({3, 3, 3});
  Mesh mesh = periodic_grid(grid, 2, rng);
  Periodicity curves{1, 7, 8, {}, {}};
  for (int z = 0; z < 3; ++z)
    curves.pairs.push_back({grid.vertex({2, 2, z}).value, grid.vertex({0, 0, z}).value});
  mesh.periodic.push_back(curves);
  const auto plane = choose<3>(mesh, [](const std::vector<Point>& p) {
    return std::all_of(p.begin(), p.end(), [](const Point& q) { return q[2] == 1; });
  });
  const auto done = cut<3>(mesh, {}, plane);
  const Mesh& out = done.output.mesh;
  const Periodicity& now = out.periodic[2];
  EXPECT_EQ(now.pairs.size(), 4u);
  const Pairs x = pairs_of(out.periodic[0]), y = pairs_of(out.periodic[1]);
  std::size_t by_way = 0;
  for (const auto& pair : now.pairs)
    for (const auto& [one, other] : x)
      if (one == pair.vertex && y.count({other, pair.master}) != 0) ++by_way;
  EXPECT_EQ(by_way, 4u);
}

TEST(Periodic, ACopyThatIsOnNoIdentifiedFacetIsInNoPairAndWarnedAbout) {
  // The far end is two entities, as a mesher makes them of a plane that a fault divides. Each has
  // one of the two copies; what is on neither is a wedge that touches the end in a vertex alone.
  support::Rng rng(13);
  const support::KuhnGrid<2> grid({3, 3});
  Mesh mesh = grid_mesh(grid, rng);
  for (int half = 0; half < 2; ++half) {
    Periodicity p{1, 10 + half, 20 + half, {}, {}};
    for (const int y : {half, half + 1})
      p.pairs.push_back({grid.vertex({2, y}).value, grid.vertex({0, y}).value});
    mesh.periodic.push_back(p);
  }
  const auto row =
      choose<2>(mesh, [](const std::vector<Point>& p) { return p[0][1] == 1 && p[1][1] == 1; });
  const auto plain = cut<2>(mesh, {}, row);
  EXPECT_TRUE(plain.output.warnings.empty());
  for (const Periodicity& p : plain.output.mesh.periodic) EXPECT_EQ(p.pairs.size(), 2u);
  const auto fan = choose<2>(mesh, [](const std::vector<Point>& p) {
    return std::count_if(p.begin(), p.end(),
                         [](const Point& q) { return (q[0] == 2 || q[0] == 0) && q[1] == 1; }) == 1;
  });
  const auto wedge = cut<2>(mesh, {}, fan);
  ASSERT_EQ(wedge.output.warnings.size(), 1u);
  EXPECT_NE(wedge.output.warnings.front().find("in no periodic pair"), std::string::npos);
  for (const Periodicity& p : wedge.output.mesh.periodic) EXPECT_EQ(p.pairs.size(), 2u);
}

TEST(Periodic, PairsThatNoFacetsIdentifyStayOrAreRefused) {
  support::Rng rng(12);
  const support::KuhnGrid<2> grid({4, 3});
  Mesh mesh = grid_mesh(grid, rng);
  mesh.periodic = {{0, 1, 2, {}, {{grid.vertex({3, 1}).value, grid.vertex({0, 1}).value}}}};
  const auto column =
      choose<2>(mesh, [](const std::vector<Point>& p) { return p[0][0] == 1 && p[1][0] == 1; });
  EXPECT_EQ(cut<2>(mesh, {}, column).output.mesh.periodic[0].pairs.size(), 1u);
  const auto row =
      choose<2>(mesh, [](const std::vector<Point>& p) { return p[0][1] == 1 && p[1][1] == 1; });
  EXPECT_NE(refusal(mesh, row).find("no facets that are identified say which belong together"),
            std::string::npos);
}

}  // namespace
}  // namespace cleave::app::test
