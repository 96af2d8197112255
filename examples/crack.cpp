// Opens a branching crack in a block of tetrahedra; points and loads on its faces follow.
#include <cleave/topology/assemble.hpp>
#include <cleave/topology/carry_over.hpp>
#include <cleave/topology/check.hpp>
#include <cleave/topology/link_view.hpp>
#include <cleave/topology/pieces.hpp>
#include <cleave/topology/ranges.hpp>
#include <cleave/topology/star_walker.hpp>
#include <cleave/topology/unglue.hpp>

#include <algorithm>
#include <fstream>
#include <iostream>

using namespace cleave::topology;
using Point = std::array<double, 3>;

int main(int argc, char** argv) {
  // A block of 6 x 6 x 3 cubes; Kuhn's six tetrahedra per cube go from one corner to the other.
  constexpr int kX = 6, kY = 6, kZ = 3;
  CellSoup<3> soup;
  std::vector<Point> points;
  for (int z = 0; z <= kZ; ++z)
    for (int y = 0; y <= kY; ++y)
      for (int x = 0; x <= kX; ++x) points.push_back({x * 1.0, y * 1.0, z * 1.0});
  soup.vertex_count = points.size();
  const std::array<Index, 3> step = {1, kX + 1, (kX + 1) * (kY + 1)};
  for (Index v = 0; v < points.size(); ++v) {
    if (points[v][0] == kX || points[v][1] == kY || points[v][2] == kZ) continue;
    std::array<int, 3> axes = {0, 1, 2};
    do {
      const Index a = v + step[axes[0]], b = a + step[axes[1]], c = b + step[axes[2]];
      soup.cells.push_back({VertexId{v}, VertexId{a}, VertexId{b}, VertexId{c}});
    } while (std::next_permutation(axes.begin(), axes.end()));
  }
  soup.signs = std::get<0>(orient(soup));
  Complex<3> k = assemble(std::move(soup));

  // The crack: the facets between three sectors, but for a margin, so that it ends in the block.
  const auto sector = [&](CellId cell) {
    double x = 0, y = 0;
    for (const VertexId v : k.vertices(cell)) x += points[v.value][0], y += points[v.value][1];
    return x < 4 * 3 ? 0 : y < 4 * 3 ? 1 : 2;
  };
  const auto in_margin = [&](VertexId v) {
    return points[v.value][0] > 5 || points[v.value][1] < 1;
  };
  std::vector<HalfFacetId> crack;
  for (const HalfFacetId h : interior_facets(k))
    if (sector(cell_of<3>(h)) != sector(cell_of<3>(*k.mate(h))))
      if (const Facet<3> f = k.facet(h); std::none_of(f.begin(), f.end(), in_margin))
        crack.push_back(h);

  const Relabelling change = unglue(k, FacetSet::of(k, crack));
  carry_over(points, change);
  std::cout << crack.size() << " facets scored, " << change.opened.size() << " opened\n"
            << change.splits.size() << " copies of vertices, " << pieces(k).count << " piece\n";

  // Pressure on both faces: a value per half-facet, whose numbers never change.
  std::vector<double> pressure(k.half_facet_count(), 0.0);
  for (const OpenedFacet& facet : change.opened)
    pressure[facet.half_facet.value] = pressure[facet.former_mate.value] = 1.5;
  std::cout << std::count(pressure.begin(), pressure.end(), 1.5) << " half-facets carry a load\n";

  if (argc < 2) return 0;
  std::ofstream obj(argv[1]);  // the surface; what was split is moved apart, for the eye alone
  StarWalker walker(k);
  const std::vector<Point> before = points;
  for (const Split& split : change.splits)
    for (const VertexId v : {split.vertex, split.parent}) {
      double x = 0, y = 0, count = 0;  // of the link's vertices
      for (const Facet<3>& facet : link(k, walker.around(v)))
        for (const VertexId w : facet) x += before[w.value][0], y += before[w.value][1], ++count;
      points[v.value][0] = 0.7 * before[v.value][0] + 0.3 * x / count;
      points[v.value][1] = 0.7 * before[v.value][1] + 0.3 * y / count;
    }
  for (const auto& [x, y, z] : points) obj << "v " << x << ' ' << y << ' ' << z << '\n';
  for (const HalfFacetId h : boundary_facets(k)) {
    obj << 'f';
    for (const VertexId v : k.facet(h)) obj << ' ' << v.value + 1;
    obj << '\n';
  }
}
