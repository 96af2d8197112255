// check, orient and assemble on input of every kind, with each defect planted in turn.
#include <algorithm>
#include <map>
#include <set>

#include "cleave/support/defects.hpp"
#include "cleave/topology/assemble.hpp"
#include "cleave/topology/check.hpp"
#include "property.hpp"
#include "witness.hpp"

namespace cleave::topology {
namespace {

using support::Defect;

CLEAVE_PROPERTIES(Soups);

/// A seed, and the size of the case to go round with.
struct Draw {
  std::uint64_t seed;
  std::size_t size;
};

rc::Gen<Draw> draws() {
  return [](const rc::Random& random, int size) {
    rc::Random source = random;
    return rc::shrinkable::just(Draw{source.next(), static_cast<std::size_t>(size)});
  };
}

std::string test_name() {
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  return std::string(info->test_suite_name()) + "." + info->name();
}

template <class Kind>
std::vector<Kind> of_kind(const std::vector<Violation>& violations) {
  std::vector<Kind> result;
  for (const Violation& violation : violations)
    if (const auto* found = std::get_if<Kind>(&violation)) result.push_back(*found);
  return result;
}

/// The level whose violations include the defect and nothing that follows from it.
Level level_of(Defect defect) {
  if (defect == Defect::none || defect == Defect::bad_vertex_link) return Level::manifold;
  return defect == Defect::pinched_simplex ? Level::edge_regular : Level::cut_regular;
}

/// Kinds that come with a defect and are no fault of check: a duplicate cell crowds interior
/// facets, and a corner overwritten may have been the only use of its vertex.
bool may_come_along(Defect defect, const Violation& violation) {
  if (std::holds_alternative<OrphanVertex>(violation))
    return defect == Defect::degenerate_cell || defect == Defect::vertex_out_of_range;
  return defect == Defect::duplicate_cell && std::holds_alternative<FacetInThreeCells>(violation);
}

/// Whether `violation` names the planted defect and its place.
template <int D>
bool names(const Violation& violation, Defect defect, const support::Planted<D>& planted) {
  switch (defect) {
    case Defect::none:
      return false;
    case Defect::degenerate_cell: {
      const auto* v = std::get_if<DegenerateCell>(&violation);
      return v != nullptr && v->cell == planted.cells[0] && v->repeated == planted.vertices[0];
    }
    case Defect::vertex_out_of_range: {
      const auto* v = std::get_if<VertexOutOfRange>(&violation);
      return v != nullptr && v->cell == planted.cells[0] && v->vertex == planted.vertices[0];
    }
    case Defect::duplicate_cell: {
      const auto* v = std::get_if<DuplicateCell>(&violation);
      return v != nullptr && v->first == planted.cells[0] && v->second == planted.cells[1];
    }
    case Defect::facet_in_three_cells: {
      const auto* v = std::get_if<FacetInThreeCells>(&violation);
      if (v == nullptr) return false;
      std::set<CellId> cells;
      for (const HalfFacetId h : v->half_facets) cells.insert(cell_of<D>(h));
      return cells == std::set<CellId>(planted.cells.begin(), planted.cells.end());
    }
    case Defect::orientation_conflict:
      return std::holds_alternative<OrientationConflict>(violation);
    case Defect::non_orientable:
      return std::holds_alternative<NonOrientable>(violation);
    case Defect::not_cut_regular: {
      const auto* v = std::get_if<NotCutRegular>(&violation);
      return v != nullptr && v->vertex == planted.vertices[0] && v->parts == 2 &&
             (v->one_part == planted.cells[0] || v->other_part == planted.cells[0]);
    }
    case Defect::pinched_simplex: {
      const auto* v = std::get_if<PinchedSimplex>(&violation);
      // For D = 4 the pinched part is a square of two triangles; the edge is one of its sides.
      return v != nullptr && (v->simplex == planted.vertices || D == 4);
    }
    case Defect::bad_vertex_link: {
      const auto* v = std::get_if<BadVertexLink>(&violation);
      return v != nullptr && v->vertex == planted.vertices[0] && v->euler_characteristic == 0 &&
             v->boundary_components == 0;
    }
    case Defect::orphan_vertex: {
      const auto* v = std::get_if<OrphanVertex>(&violation);
      return v != nullptr && v->vertex == planted.vertices[0];
    }
  }
  return false;
}

TYPED_TEST(Soups, APlantedDefectIsFoundWhereItIsAndNoOther) {
  constexpr int D = TypeParam::value;
  std::vector<Defect> possible;
  for (const Defect defect : support::kDefects)
    if (support::can_occur(defect, D)) possible.push_back(defect);
  const auto gen = draws();
  EXPECT_TRUE(rc::check(test_name(), [&] {
    const Draw drawn = *gen;
    Rng rng(drawn.seed);
    const Defect defect = possible[drawn.size % possible.size()];
    coverage().record_defect(D, defect);
    const auto planted = support::plant<D>(defect, rng);
    const CellSoup<D> soup{planted.mesh.cells, planted.mesh.vertex_count, planted.signs};
    const auto found = check(soup, level_of(defect));
    std::size_t hits = 0;
    for (const Violation& violation : found) {
      RC_ASSERT(refute<D>(violation, soup) == "");
      RC_ASSERT(!describe(violation).empty());
      const bool hit = names<D>(violation, defect, planted);
      RC_ASSERT(((hit || may_come_along(defect, violation))));
      if (hit) ++hits;
    }
    const bool many = defect == Defect::orientation_conflict || D == 4;
    RC_ASSERT((defect == Defect::none ? hits == 0 : (many ? hits >= 1 : hits == 1)));
    if (defect == Defect::pinched_simplex) {
      const auto pinched = of_kind<PinchedSimplex>(found);
      RC_ASSERT(std::any_of(pinched.begin(), pinched.end(), [&](const PinchedSimplex& p) {
        return p.simplex == planted.vertices;
      }));
    }
  }));
}

/// What keeps `assemble` from a complex: all but orphans.
std::size_t grave(const std::vector<Violation>& violations) {
  return violations.size() - of_kind<OrphanVertex>(violations).size();
}

TYPED_TEST(Soups, AssembleThrowsWhatCheckReports) {
  constexpr int D = TypeParam::value;
  const auto gen = draws();
  EXPECT_TRUE(rc::check(test_name(), [&] {
    const Draw drawn = *gen;
    Rng rng(drawn.seed);
    const Defect defect = support::kDefects[drawn.size % support::kDefects.size()];
    CellSoup<D> soup;
    if (support::can_occur(defect, D) && drawn.size % 2 == 0) {
      const auto planted = support::plant<D>(defect, rng);
      soup = {planted.mesh.cells, planted.mesh.vertex_count, planted.signs};
    } else {
      const auto mesh = support::random_soup<D>(rng);
      soup = {mesh.cells, mesh.vertex_count, {}};
    }
    const auto found = check(soup, Level::cut_regular);
    try {
      const Complex<D> k = assemble(soup);
      RC_ASSERT(grave(found) == 0U);
      RC_ASSERT(std::equal(soup.cells.begin(), soup.cells.end(), k.cells().begin()));
      RC_ASSERT(k.vertex_count() == soup.vertex_count);
      const auto mates = support::mates_of<D>(soup.cells);
      for (Index h = 0; h < mates.size(); ++h) RC_ASSERT(k.mate({h}) == mates[h]);
    } catch (const InvalidComplex& error) {
      RC_ASSERT(grave(found) > 0U);
      RC_ASSERT(grave(error.violations) == grave(found));
      for (std::size_t i = 0; i < error.violations.size(); ++i)
        RC_ASSERT(refute<D>(error.violations[i], soup) == "");
    }
  }));
}

TYPED_TEST(Soups, CheckFindsAllThatIsWrongWithRandomTuples) {
  constexpr int D = TypeParam::value;
  const auto gen = draws();
  EXPECT_TRUE(rc::check(test_name(), [&] {
    Rng rng((*gen).seed);
    const auto mesh = support::random_soup<D>(rng);
    const CellSoup<D> soup{mesh.cells, mesh.vertex_count, {}};
    const auto found = check(soup);
    for (const Violation& violation : found) RC_ASSERT(refute<D>(violation, soup) == "");
    std::set<CellId> degenerate;
    std::set<std::pair<CellId, VertexId>> out_of_range;
    std::set<CellId> repeated;
    std::map<std::set<VertexId>, std::size_t> times;
    for (Index c = 0; c < mesh.cells.size(); ++c) {
      const Cell<D>& cell = mesh.cells[c];
      const std::set<VertexId> vertices(cell.begin(), cell.end());
      if (vertices.size() < cell.size()) degenerate.insert({c});
      for (const VertexId v : vertices)
        if (v.value >= mesh.vertex_count) out_of_range.insert({CellId{c}, v});
      if (times[vertices]++ > 0) repeated.insert({c});
    }
    std::set<CellId> degenerate_found;
    for (const auto& v : of_kind<DegenerateCell>(found)) degenerate_found.insert(v.cell);
    RC_ASSERT(degenerate_found == degenerate);
    std::set<std::pair<CellId, VertexId>> out_of_range_found;
    for (const auto& v : of_kind<VertexOutOfRange>(found))
      out_of_range_found.insert({v.cell, v.vertex});
    RC_ASSERT(out_of_range_found == out_of_range);
    RC_ASSERT(of_kind<OrphanVertex>(found).size() + [&] {
      std::size_t used = 0;
      for (const auto& [vertex, star] : support::stars_of<D>(mesh.cells))
        if (vertex.value < mesh.vertex_count) ++used;
      return used;
    }() == mesh.vertex_count);
    if (!degenerate.empty() || !out_of_range.empty()) return;
    std::set<CellId> repeated_found;
    for (const auto& v : of_kind<DuplicateCell>(found)) repeated_found.insert(v.second);
    RC_ASSERT(repeated_found == repeated);
    std::size_t crowded = 0;
    for (const auto& [facet, sides] : support::facets_of<D>(mesh.cells))
      if (sides.size() >= 3) ++crowded;
    RC_ASSERT(of_kind<FacetInThreeCells>(found).size() == crowded);
    if (crowded > 0 || !repeated.empty()) return;
    std::size_t irregular = 0;
    for (const auto& [vertex, parts] : support::parts_of_stars<D>(mesh.cells))
      if (parts > 1) ++irregular;
    RC_ASSERT(of_kind<NotCutRegular>(found).size() == irregular);
    RC_ASSERT(support::coherent_signs<D>(mesh.cells).has_value() ==
              of_kind<NonOrientable>(found).empty());
  }));
}

/// The cells around each simplex of `size` vertices, by part: two cells that share a facet, which
/// then has the simplex, are of one part. Parts by their least cells.
template <int D>
std::map<std::vector<VertexId>, std::vector<std::vector<CellId>>> parts_around(
    const std::vector<Cell<D>>& cells, std::size_t size) {
  std::map<std::vector<VertexId>, std::vector<std::vector<CellId>>> parts;
  for (Index c = 0; c < cells.size(); ++c)
    for (unsigned mask = 0; mask < 1u << (D + 1); ++mask) {
      std::vector<VertexId> simplex;
      for (std::size_t i = 0; i < cells[c].size(); ++i)
        if (mask >> i & 1u) simplex.push_back(cells[c][i]);
      if (simplex.size() != size) continue;
      std::sort(simplex.begin(), simplex.end());
      // The parts that the cell touches become one, at the place of the first of them.
      auto& around = parts[simplex];
      const auto touches = [&](const std::vector<CellId>& part) {
        return std::any_of(part.begin(), part.end(), [&](CellId other) {
          return std::count_if(cells[c].begin(), cells[c].end(), [&](VertexId v) {
                   const Cell<D>& there = cells[other.value];
                   return std::find(there.begin(), there.end(), v) != there.end();
                 }) == D;
        });
      };
      std::vector<CellId>* joined = nullptr;
      for (auto& part : around) {
        if (!touches(part)) continue;
        if (joined == nullptr) {
          joined = &part;
        } else {
          joined->insert(joined->end(), part.begin(), part.end());
          part.clear();
        }
      }
      if (joined == nullptr) joined = &around.emplace_back();
      joined->push_back(CellId{c});
      std::erase_if(around, [](const auto& part) { return part.empty(); });
    }
  return parts;
}

/// The Euler characteristic of the link that these tetrahedra make around `vertex`, and how many
/// components its boundary has.
BadVertexLink link_by_definition(VertexId vertex, const std::vector<CellId>& star,
                                 const std::vector<Cell<3>>& cells) {
  std::set<VertexId> ends;
  std::map<std::vector<VertexId>, int> edges;  // and how many triangles have each
  for (const CellId c : star) {
    std::vector<VertexId> triangle;
    for (const VertexId v : cells[c.value])
      if (v != vertex) triangle.push_back(v);
    std::sort(triangle.begin(), triangle.end());
    ends.insert(triangle.begin(), triangle.end());
    for (std::size_t left_out = 0; left_out < 3; ++left_out) {
      auto edge = triangle;
      edge.erase(edge.begin() + static_cast<std::ptrdiff_t>(left_out));
      ++edges[edge];
    }
  }
  std::vector<std::set<VertexId>> rims;
  for (const auto& [edge, triangles] : edges) {
    if (triangles != 1) continue;
    const VertexId one = edge[0], other_end = edge[1];
    std::set<VertexId> rim{one, other_end};
    std::erase_if(rims, [&](std::set<VertexId>& other) {
      if (!other.contains(one) && !other.contains(other_end)) return false;
      rim.merge(other);
      return true;
    });
    rims.push_back(rim);
  }
  return {vertex,
          static_cast<int>(ends.size()) - static_cast<int>(edges.size()) +
              static_cast<int>(star.size()),
          static_cast<int>(rims.size())};
}

/// A mesh in which stars, edges and links are as bad as they may be.
template <int D>
Mesh<D> mesh_of_any_level(const Draw& drawn) {
  Rng rng(drawn.seed);
  const Defect defect = support::kDefects[drawn.size % support::kDefects.size()];
  if (rng.chance(0.3) && support::can_occur(defect, D)) return support::plant<D>(defect, rng).mesh;
  if (rng.chance(0.1)) return support::random_soup<D>(rng);
  return support::random_mesh<D>(support::kMeshClasses[rng.below(support::kMeshClasses.size())],
                                 rng);
}

TYPED_TEST(Soups, LevelsFailWhereTheirDefinitionsSay) {
  constexpr int D = TypeParam::value;
  const auto gen = draws();
  EXPECT_TRUE(rc::check(test_name(), [&] {
    const auto mesh = mesh_of_any_level<D>(*gen);
    const CellSoup<D> soup{mesh.cells, mesh.vertex_count, {}};
    const auto found = check(soup);
    for (const Violation& v : found)
      if (breaks(v) == Level::pseudo_manifold) return;  // stars have no meaning

    std::set<VertexId> bad;
    std::vector<NotCutRegular> irregular;
    const auto stars = parts_around<D>(mesh.cells, 1);
    for (const auto& [vertex, parts] : stars)
      if (parts.size() > 1) {
        irregular.push_back({vertex[0], parts[0][0], parts[1][0], parts.size()});
        bad.insert(vertex[0]);
      }
    std::vector<PinchedSimplex> pinched;
    for (std::size_t size = 2; size < D; ++size)
      for (const auto& [simplex, parts] : parts_around<D>(mesh.cells, size))
        if (parts.size() > 1) {
          pinched.push_back({simplex, parts[0][0], parts[1][0], parts.size()});
          bad.insert(simplex.begin(), simplex.end());
        }
    std::vector<BadVertexLink> links;
    if constexpr (D == 3)
      for (const auto& [vertex, parts] : stars) {
        if (bad.contains(vertex[0])) continue;
        const auto link = link_by_definition(vertex[0], parts[0], mesh.cells);
        if (link.euler_characteristic != (link.boundary_components == 0 ? 2 : 1) ||
            link.boundary_components > 1)
          links.push_back(link);
      }
    const auto same = [](const auto& one, const auto& other, auto equal) {
      return std::equal(one.begin(), one.end(), other.begin(), other.end(), equal);
    };
    RC_ASSERT(same(of_kind<NotCutRegular>(found), irregular, [](const auto& a, const auto& b) {
      return a.vertex == b.vertex && a.one_part == b.one_part && a.other_part == b.other_part &&
             a.parts == b.parts;
    }));
    RC_ASSERT(same(of_kind<PinchedSimplex>(found), pinched, [](const auto& a, const auto& b) {
      return a.simplex == b.simplex && a.one_part == b.one_part && a.other_part == b.other_part &&
             a.parts == b.parts;
    }));
    RC_ASSERT(same(of_kind<BadVertexLink>(found), links, [](const auto& a, const auto& b) {
      return a.vertex == b.vertex && a.euler_characteristic == b.euler_characteristic &&
             a.boundary_components == b.boundary_components;
    }));
    RC_CLASSIFY(!irregular.empty(), "not cut-regular");
    RC_CLASSIFY(!pinched.empty(), "pinched");
    RC_CLASSIFY(!links.empty(), "bad link");
    RC_CLASSIFY(bad.empty() && links.empty(), "manifold, or not decided");
  }));
}

/// The cone over a grid: every cell has the apex, vertex 0. In random order its star gets more
/// labels than there are (star_pass.hpp).
template <int D>
std::vector<Cell<D>> cone(Index first_vertex, Rng& rng) {
  constexpr int kNodes[] = {0, 2, 400, 15, 7};
  typename support::KuhnGrid<D - 1>::Point nodes{};
  nodes.fill(kNodes[D]);
  std::vector<Cell<D>> cells;
  for (const auto& facet : support::KuhnGrid<D - 1>(nodes).cells) {
    Cell<D>& cell = cells.emplace_back();
    for (std::size_t i = 0; i < facet.size(); ++i) cell[i + 1] = {facet[i].value + first_vertex};
  }
  rng.shuffle(cells);
  return cells;
}

template <int D>
void expect_hub_to_be_counted() {
  Rng rng(5);
  std::vector<Cell<D>> cells = cone<D>(1, rng);
  const auto vertex_count = [&] {
    Index greatest = 0;
    for (const Cell<D>& cell : cells)
      for (const VertexId v : cell) greatest = std::max(greatest, v.value);
    return std::size_t{greatest} + 1;
  };
  CellSoup<D> soup{cells, vertex_count(), {}};
  soup.signs = std::get<0>(orient(soup));
  EXPECT_TRUE(check(soup).empty());
  EXPECT_EQ(assemble(soup).cell_count(), cells.size());
  for (const Cell<D>& cell : cone<D>(static_cast<Index>(vertex_count()), rng))
    cells.push_back(cell);
  rng.shuffle(cells);
  soup = {cells, vertex_count(), {}};
  soup.signs = std::get<0>(orient(soup));
  const auto found = check(soup);
  ASSERT_EQ(found.size(), 1u);
  const auto& hub = std::get<NotCutRegular>(found[0]);
  EXPECT_EQ(hub.vertex, VertexId{0});
  EXPECT_EQ(hub.parts, 2u);
  EXPECT_EQ(refute<D>(found[0], soup), "");
}

TEST(Hubs, OfManyCellsInAnyOrderAreCountedInParts) {
  expect_hub_to_be_counted<2>();
  expect_hub_to_be_counted<3>();
  expect_hub_to_be_counted<4>();
}

TYPED_TEST(Soups, OrientGivesTheCoherentSignsOrALoop) {
  constexpr int D = TypeParam::value;
  const auto gen = draws();
  EXPECT_TRUE(rc::check(test_name(), [&] {
    const Draw drawn = *gen;
    Rng rng(drawn.seed);
    const bool one_sided = D >= 2 && drawn.size % 2 == 0;
    const auto mesh_class = support::kMeshClasses[drawn.size % support::kMeshClasses.size()];
    const Mesh<D> mesh = one_sided ? support::plant<D>(Defect::non_orientable, rng).mesh
                                   : support::random_mesh<D>(mesh_class, rng);
    const CellSoup<D> soup{mesh.cells, mesh.vertex_count, {}};
    const auto expected = support::coherent_signs<D>(mesh.cells);
    RC_ASSERT(expected.has_value() == !one_sided);
    const auto found = orient(soup);
    if (expected)
      RC_ASSERT(std::get<0>(found) == *expected);
    else
      RC_ASSERT(refute<D>(std::get<1>(found), soup) == "");
  }));
}

}  // namespace
}  // namespace cleave::topology
