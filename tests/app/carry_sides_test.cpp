// Sides and sheets, judged from the coordinates of OUT and the regions that a sheet divides.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "carry_support.hpp"

namespace cleave::app::test {
namespace {

using topology::HalfFacetId;
using Tuple = std::vector<Index>;

// A Kuhn grid with every cell in region 0 or 1, and the facets between the regions.
struct Regions {
  Mesh mesh;
  std::vector<int> of_cell;
  std::vector<HalfFacetId> between;  // one half-facet of each, in random order
};

// The facets between the regions that `region` gives by the least point of a cube.
template <class Region>
Regions divide(const support::KuhnGrid<3>& grid, support::Rng& rng, Region region) {
  Regions r;
  r.mesh = grid_mesh(grid, rng);
  for (std::size_t c = 0; c < grid.cells.size(); ++c) r.of_cell.push_back(region(grid.cube(c)));
  std::map<Tuple, HalfFacetId> first;
  for (Index h = 0; h < 4 * grid.cells.size(); ++h) {
    Tuple facet;
    for (Index i = 0; i < 4; ++i)
      if (i != h % 4) facet.push_back(r.mesh.cells().vertices[4 * (h / 4) + i]);
    std::sort(facet.begin(), facet.end());
    const auto [at, is_new] = first.emplace(facet, HalfFacetId{h});
    if (!is_new && r.of_cell[h / 4] != r.of_cell[at->second.value / 4])
      r.between.push_back(rng.chance(0.5) ? at->second : HalfFacetId{h});
  }
  rng.shuffle(r.between);
  return r;
}

Regions random_regions(support::Rng& rng) {
  const support::KuhnGrid<3> grid({rng.between(2, 4), rng.between(3, 4), rng.between(3, 4)});
  const int kind = rng.between(0, 3);
  const double density = 0.2 + 0.6 * rng.unit();
  const int fold = rng.between(1, 2);
  std::map<std::array<int, 3>, int> chosen;
  return divide(grid, rng, [&](std::array<int, 3> p) {
    if (kind == 0) return p[1] >= fold ? 1 : 0;                           // a plane
    if (kind == 1) return p[1] >= fold && p[2] >= fold ? 1 : 0;           // a fold
    if (kind == 2) return p[1] + p[2] >= fold + 1 ? 1 : 0;                // stairs
    return chosen.emplace(p, rng.chance(density) ? 1 : 0).first->second;  // anything
  });
}

// The cell of OUT that has the facet `e` of OUT, and its half-facet there.
std::map<Tuple, Index> half_facets(const Mesh& out) {
  std::map<Tuple, Index> of;
  for (Index h = 0; h < 4 * out.cells().size(); ++h) {
    Tuple facet;
    for (Index i = 0; i < 4; ++i)
      if (i != h % 4) facet.push_back(out.cells().vertices[4 * (h / 4) + i]);
    std::sort(facet.begin(), facet.end());
    of[facet] = h;
  }
  return of;
}

Tuple facet_tuple(const Mesh& mesh, Index e) {
  const auto from = mesh.elements[2].vertices.begin() + 3 * e;
  return {from, from + 3};
}

// Whether the normal of the stored triangle points away from the cell of half-facet `h`.
bool points_away(const Mesh& mesh, const Tuple& t, Index h) {
  const auto& p = mesh.points;
  const auto apex = p[mesh.cells().vertices[h]];
  double volume = 0;
  std::array<std::array<double, 3>, 3> e{};
  for (std::size_t x = 0; x < 3; ++x) {
    e[0][x] = p[t[1]][x] - p[t[0]][x];
    e[1][x] = p[t[2]][x] - p[t[0]][x];
    e[2][x] = apex[x] - p[t[0]][x];
  }
  volume = e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
           e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
           e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
  return volume < 0;
}

// Sheets of opened facets, from the definition: facets of MESH that meet in a ridge of exactly two.
// `facets`: their vertices in MESH. Returns the sheet of each.
std::vector<std::size_t> sheets(const std::vector<Tuple>& facets) {
  std::map<Tuple, std::vector<std::size_t>> at_ridge;
  for (std::size_t f = 0; f < facets.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      Tuple ridge{facets[f][(i + 1) % 3], facets[f][(i + 2) % 3]};
      std::sort(ridge.begin(), ridge.end());
      at_ridge[ridge].push_back(f);
    }
  std::vector<std::size_t> sheet(facets.size());
  std::iota(sheet.begin(), sheet.end(), std::size_t{0});
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [ridge, around] : at_ridge) {
      if (around.size() != 2) continue;
      const std::size_t least = std::min(sheet[around[0]], sheet[around[1]]);
      for (const std::size_t f : around) {
        changed = changed || sheet[f] != least;
        sheet[f] = least;
      }
    }
  }
  return sheet;
}

// A facet of OUT's minus side: its vertices and half-facets in MESH.
struct Sided {
  Tuple facet;
  Index least, minus;
};

std::vector<Sided> sided(const CutMesh<3>& done, const std::string& name) {
  const Mesh& out = done.output.mesh;
  const auto in_out = half_facets(out);
  std::vector<Sided> all;
  for (const Index e : group(out, name).elements) {
    Tuple now = facet_tuple(out, e);
    std::sort(now.begin(), now.end());
    Sided s{{}, 0, in_out.at(now)};
    for (const Index v : now) s.facet.push_back(done.output.origin[v]);
    s.least = std::min(s.minus, done.body.complex.mate({s.minus})->value);
    all.push_back(s);
  }
  std::sort(all.begin(), all.end(),
            [](const Sided& a, const Sided& b) { return a.least < b.least; });
  return all;
}

// Along a sheet minus lies on one side, whatever the tuples of the file say; the triangle stored
// for the sheet's least facet says which.
RC_GTEST_PROP(Sides, AreOneAlongASheetWhicheverWayItsFacetsAreStored, ()) {
  support::Rng rng(*rc::gen::arbitrary<std::uint64_t>());
  Regions r = random_regions(rng);
  RC_PRE(!r.between.empty());
  add_facets<3>(r.mesh, "seam", r.between, rng);
  const auto done = cut<3>(r.mesh, {"seam"});
  const auto minus = sided(done, "seam_minus");
  RC_ASSERT(minus.size() == done.incision.opened().size());
  RC_ASSERT(done.output.one_sided.empty());
  std::vector<Tuple> facets;
  for (const Sided& s : minus) facets.push_back(s.facet);
  const auto sheet = sheets(facets);
  std::map<Tuple, Tuple> stored;
  for (Index e = 0; e < r.mesh.elements[2].size(); ++e) {
    const Tuple t = facet_tuple(r.mesh, e);
    Tuple key = t;
    std::sort(key.begin(), key.end());
    stored.emplace(key, t);
  }
  std::set<std::size_t> seen(sheet.begin(), sheet.end());
  RC_CLASSIFY(seen.size() > 1, "several sheets");
  RC_CLASSIFY(done.incision.shut().size() > 0, "some facet shut");
  for (std::size_t f = 0; f < minus.size(); ++f) {
    const Sided &s = minus[f], &least = minus[sheet[f]];  // `minus` is sorted by least half-facet
    RC_ASSERT(r.of_cell[s.minus / 4] == r.of_cell[least.minus / 4]);
    if (sheet[f] != f) continue;
    Tuple key = s.facet;
    std::sort(key.begin(), key.end());
    RC_ASSERT(points_away(r.mesh, stored.at(key), s.minus));
  }
}

// Facets named otherwise: minus is the lesser half-facet of the sheet's least facet.
RC_GTEST_PROP(Sides, OfOtherRequestsFollowTheLeastHalfFacet, ()) {
  support::Rng rng(*rc::gen::arbitrary<std::uint64_t>());
  const Regions r = random_regions(rng);
  RC_PRE(!r.between.empty());
  const auto done = cut<3>(r.mesh, {}, r.between);
  const auto minus = sided(done, "cut_minus");
  std::vector<Tuple> facets;
  for (const Sided& s : minus) facets.push_back(s.facet);
  const auto sheet = sheets(facets);
  for (std::size_t f = 0; f < minus.size(); ++f) {
    RC_ASSERT(r.of_cell[minus[f].minus / 4] == r.of_cell[minus[sheet[f]].minus / 4]);
    if (sheet[f] == f) RC_ASSERT(minus[f].minus == minus[f].least);
  }
}

// What OUT holds below the cells.
bool same_sides(const Mesh& a, const Mesh& b) {
  if (a.groups.size() != b.groups.size()) return false;
  for (std::size_t g = 0; g < a.groups.size(); ++g)
    if (a.groups[g].name != b.groups[g].name || a.groups[g].elements != b.groups[g].elements)
      return false;
  return a.elements[2].vertices == b.elements[2].vertices;
}

// Neither the order of the request nor repetition, nor turning over the triangles of a file other
// than those that decide, changes a side.
RC_GTEST_PROP(Sides, DoNotDependOnTheOrderOfTheRequest, ()) {
  support::Rng rng(*rc::gen::arbitrary<std::uint64_t>());
  const Regions r = random_regions(rng);
  RC_PRE(!r.between.empty());
  const auto done = cut<3>(r.mesh, {}, r.between);
  auto again = r.between;
  again.push_back(again.front());
  for (auto& h : again)
    if (rng.chance(0.5)) h = *done.body.complex.mate(h);
  rng.shuffle(again);
  RC_ASSERT(same_sides(done.output.mesh, cut<3>(r.mesh, {}, again).output.mesh));

  Regions one = r;
  const std::size_t half = r.between.size() / 2;
  const auto middle = r.between.begin() + static_cast<std::ptrdiff_t>(half);
  add_facets<3>(one.mesh, "a", {r.between.begin(), middle}, rng);
  add_facets<3>(one.mesh, "b", {middle, r.between.end()}, rng);
  RC_ASSERT(same_sides(cut<3>(one.mesh, {"a", "b"}).output.mesh,
                       cut<3>(one.mesh, {"b", "a", "b"}).output.mesh));

  Regions turned = r, straight = r;
  support::Rng same(7), same_again(7);
  add_facets<3>(straight.mesh, "seam", r.between, same);
  add_facets<3>(turned.mesh, "seam", r.between, same_again);
  const auto cut_straight = cut<3>(straight.mesh, {"seam"});
  const auto minus = sided(cut_straight, "seam_minus");
  std::vector<Tuple> facets;
  for (const Sided& s : minus) facets.push_back(s.facet);
  const auto sheet = sheets(facets);
  std::set<Tuple> deciding;
  for (std::size_t f = 0; f < minus.size(); ++f) {
    if (sheet[f] != f) continue;
    Tuple key = facets[f];
    std::sort(key.begin(), key.end());
    deciding.insert(key);
  }
  std::size_t flips = 0;
  for (Index e = 0; e < turned.mesh.elements[2].size(); ++e) {
    Tuple key = facet_tuple(turned.mesh, e);
    std::sort(key.begin(), key.end());
    if (deciding.count(key) != 0 || rng.chance(0.5)) continue;
    std::swap(turned.mesh.elements[2].vertices[3 * e], turned.mesh.elements[2].vertices[3 * e + 1]);
    ++flips;
  }
  RC_CLASSIFY(flips > 0, "triangles turned over");
  const auto again_sided = sided(cut<3>(turned.mesh, {"seam"}), "seam_minus");
  RC_ASSERT(again_sided.size() == minus.size());
  for (std::size_t f = 0; f < minus.size(); ++f) RC_ASSERT(again_sided[f].minus == minus[f].minus);
}

// A V whose two halves are stored with opposite normals: minus is inside all along, or outside.
TEST(Sides, AVFoldHasItsMinusOnOneSide) {
  support::Rng rng(11);
  const support::KuhnGrid<3> grid({3, 4, 4});
  for (int turn = 0; turn < 8; ++turn) {
    Regions r = divide(grid, rng, [](std::array<int, 3> p) { return p[1] >= 1 && p[2] >= 1; });
    add_facets<3>(r.mesh, "fold", r.between, rng);
    const auto done = cut<3>(r.mesh, {"fold"});
    EXPECT_EQ(done.incision.shut().size(), 0u);
    std::set<int> sides;
    for (const Sided& s : sided(done, "fold_minus")) sides.insert(r.of_cell[s.minus / 4]);
    EXPECT_EQ(sides.size(), 1u) << turn;
  }
}

}  // namespace
}  // namespace cleave::app::test
