// Cuts a triangle mesh along the seams of its texture, so that each vertex has one place in it.
#include <cleave/topology/assemble.hpp>
#include <cleave/topology/carry_over.hpp>
#include <cleave/topology/ranges.hpp>
#include <cleave/topology/unglue.hpp>

#include <fstream>
#include <iostream>

using namespace cleave::topology;

struct Face {
  std::array<Index, 4> vertices;  // anticlockwise, seen from outside
  int column, row;                // of its square in the texture, of 4 x 3 squares
};

int main(int argc, char** argv) {
  // A cube, unfolded: vertex v has the coordinates that are bits of v.
  const std::array<Face, 6> cube = {{{{0, 1, 5, 4}, 0, 1},
                                     {{1, 3, 7, 5}, 1, 1},
                                     {{3, 2, 6, 7}, 2, 1},
                                     {{2, 0, 4, 6}, 3, 1},
                                     {{5, 7, 6, 4}, 1, 2},
                                     {{0, 2, 3, 1}, 1, 0}}};
  using UV = std::array<int, 2>;
  CellSoup<2> soup;
  soup.vertex_count = 8;
  std::vector<UV> uv;  // one per corner
  for (const Face& face : cube)
    for (const std::array<int, 3> three : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
      Cell<2>& cell = soup.cells.emplace_back();
      for (int i = 0; i < 3; ++i) {
        cell[i] = {face.vertices[three[i]]};
        uv.push_back({face.column + (three[i] == 1 || three[i] == 2), face.row + three[i] / 2});
      }
    }
  Complex<2> k = assemble(std::move(soup));

  // A seam is an edge of which one end lies in two places of the texture.
  const auto place = [&](CellId cell, VertexId vertex) {
    for (const CornerId corner : corners(k, cell))
      if (k.vertex(corner) == vertex) return uv[corner.value];
    return UV{};
  };
  std::vector<HalfFacetId> seams;
  for (const HalfFacetId edge : interior_facets(k)) {
    const CellId one = cell_of<2>(edge), other = cell_of<2>(*k.mate(edge));
    const auto [a, b] = k.facet(edge);
    if (place(one, a) != place(other, a) || place(one, b) != place(other, b)) seams.push_back(edge);
  }

  std::vector<std::array<int, 3>> points;  // one per vertex: they follow by carry_over
  for (int v = 0; v < 8; ++v) points.push_back({v & 1, v >> 1 & 1, v >> 2});
  const Relabelling change = unglue(k, FacetSet::of(k, seams));
  carry_over(points, change);
  std::cout << seams.size() << " of 18 edges are seams; " << change.shut.size() << " stay shut\n"
            << change.vertices_before << " vertices became " << change.vertices_after << '\n';

  std::vector<UV> vertex_uv(k.vertex_count());  // what a graphics card wants
  for (const CornerId corner : corners(k)) vertex_uv[k.vertex(corner).value] = uv[corner.value];
  bool unique = true;  // values of corners needed nothing
  for (const CornerId corner : corners(k))
    unique = unique && vertex_uv[k.vertex(corner).value] == uv[corner.value];
  std::cout << "each vertex has one place in the texture: " << (unique ? "yes" : "no") << '\n';

  if (argc < 2) return 0;
  std::ofstream obj(argv[1]);
  for (const auto& [x, y, z] : points) obj << "v " << x << ' ' << y << ' ' << z << '\n';
  for (const auto& [u, v] : vertex_uv) obj << "vt " << u / 4.0 << ' ' << v / 3.0 << '\n';
  for (const Cell<2>& cell : k.cells()) {
    obj << 'f';
    for (const VertexId v : cell) obj << ' ' << v.value + 1 << '/' << v.value + 1;
    obj << '\n';
  }
}
