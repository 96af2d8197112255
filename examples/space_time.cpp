// A crack that appears in time: a mesh of space and time is cut from one moment on.
#include <cleave/topology/assemble.hpp>
#include <cleave/topology/carry_over.hpp>
#include <cleave/topology/check.hpp>
#include <cleave/topology/pieces.hpp>
#include <cleave/topology/ranges.hpp>
#include <cleave/topology/unglue.hpp>

#include <algorithm>
#include <iostream>
#include <string>

using namespace cleave::topology;
using Event = std::array<int, 4>;  // x, y, z and the time

int main() {
  // A beam of 2 x 1 x 1 cubes from time 0 to 3, in 24 pentachora per cube and unit of time.
  const Event size = {2, 1, 1, 3}, step = {1, 3, 6, 12};
  std::vector<Event> events;
  for (int n = 0; n < 3 * 2 * 2 * 4; ++n) events.push_back({n % 3, n / 3 % 2, n / 6 % 2, n / 12});
  CellSoup<4> soup;
  soup.vertex_count = events.size();
  for (Index v = 0; v < events.size(); ++v) {
    bool last = false;  // a cube begins at v unless v is last along some axis
    for (int i = 0; i < 4; ++i) last = last || events[v][i] == size[i];
    std::array<int, 4> axes = {0, 1, 2, 3};
    if (!last) do {
        Cell<4>& cell = soup.cells.emplace_back();
        cell[0] = {v};
        for (int i = 0; i < 4; ++i)
          cell[i + 1] = {cell[i].value + static_cast<Index>(step[axes[i]])};
      } while (std::next_permutation(axes.begin(), axes.end()));
  }
  soup.signs = std::get<0>(orient(soup));
  Complex<4> k = assemble(std::move(soup));
  std::cout << k.cell_count() << " pentachora, " << k.vertex_count() << " events\n";

  // The crack is at x = 1, from time 1 on. Its facets are tetrahedra.
  std::vector<HalfFacetId> crack;
  for (const HalfFacetId h : interior_facets(k)) {
    const Facet<4> facet = k.facet(h);
    if (std::all_of(facet.begin(), facet.end(),
                    [&](VertexId v) { return events[v.value][0] == 1 && events[v.value][3] >= 1; }))
      crack.push_back(h);
  }
  const Relabelling change = unglue(k, FacetSet::of(k, crack));
  carry_over(events, change);
  std::cout << crack.size() << " facets scored, " << change.opened.size() << " opened, "
            << change.splits.size() << " copies, " << pieces(k).count << " piece\n";

  // The beam at the first and at the last moment: the part of the boundary that lies there.
  for (const int time : {0, 3}) {
    CellSoup<3> slice;
    slice.vertex_count = k.vertex_count();
    for (const HalfFacetId h : boundary_facets(k)) {
      const Facet<4> facet = k.facet(h);
      if (std::all_of(facet.begin(), facet.end(),
                      [&](VertexId v) { return events[v.value][3] == time; }))
        slice.cells.push_back(facet);
    }
    slice.signs = std::get<0>(orient(slice));
    std::cout << "time " << time << ": " << slice.cells.size() << " tetrahedra in "
              << pieces(assemble(std::move(slice))).count << " piece(s)\n";
  }
}
