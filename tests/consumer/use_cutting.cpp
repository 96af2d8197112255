#include <cleave/cutting/stroke.hpp>
#include <cleave/topology/assemble.hpp>

// A square of two triangles, cut along its diagonal by a straight stroke.
int main() {
  using namespace cleave;
  topology::CellSoup<2> soup;
  using topology::VertexId;
  soup.cells = {topology::Cell<2>{VertexId{0}, VertexId{1}, VertexId{2}},
                topology::Cell<2>{VertexId{2}, VertexId{1}, VertexId{3}}};
  soup.vertex_count = 4;
  topology::Incision<2> incision(topology::assemble(soup));
  std::vector<cutting::Point<2>> points = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  const std::vector<cutting::Point<2>> path = {{-1, 2}, {2, -1}};
  cutting::cut_along(incision, points, cutting::sweep_of_polyline(path));
  return incision.complex().vertex_count() == 6 && points.size() == 6 ? 0 : 1;
}
