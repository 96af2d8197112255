#include <cleave/topology/assemble.hpp>
#include <cleave/topology/unglue.hpp>

// Two triangles that share an edge; cutting it sets them apart.
int main() {
  using namespace cleave::topology;
  CellSoup<2> soup;
  soup.cells = {Cell<2>{VertexId{0}, VertexId{1}, VertexId{2}},
                Cell<2>{VertexId{2}, VertexId{1}, VertexId{3}}};
  soup.vertex_count = 4;
  Complex<2> k = assemble(soup);
  const Relabelling change = unglue(k, FacetSet::all(k));
  return change.opened.size() == 1 && k.vertex_count() == 6 ? 0 : 1;
}
