// Splits a network of roads into routes and cuts routes at nodes: edges are cells, nodes facets.
#include <cleave/topology/assemble.hpp>
#include <cleave/topology/carry_over.hpp>
#include <cleave/topology/check.hpp>
#include <cleave/topology/pieces.hpp>
#include <cleave/topology/ranges.hpp>
#include <cleave/topology/unglue.hpp>

#include <iostream>

using namespace cleave::topology;

int main() {
  // A ring road 0-1-2-3-4-5 and a road 2-6-7 that leaves it at node 2, each way as it comes.
  CellSoup<1> roads;
  roads.vertex_count = 8;
  for (const auto& [from, to] :
       {std::array<Index, 2>{0, 1}, {2, 1}, {2, 3}, {3, 4}, {5, 4}, {5, 0}, {2, 6}, {6, 7}})
    roads.cells.push_back({VertexId{from}, VertexId{to}});
  const std::vector<double> length = {1.0, 2.0, 2.0, 1.5, 1.0, 1.5, 4.0, 3.0};  // one per road

  // A node of three roads is a facet of three cells, which no complex has: `check` names it.
  for (const Violation& violation : check(roads))
    if (const auto* junction = std::get_if<FacetInThreeCells>(&violation))
      std::cout << "node 2 is a junction: " << describe(*junction) << '\n';

  // So routes end at junctions: each road gets an end of its own there.
  std::vector<int> degree(roads.vertex_count);
  for (const Cell<1>& road : roads.cells)
    for (const VertexId node : road) ++degree[node.value];
  std::vector<Index> node_of;  // vertex -> node, for names, places, signals
  for (Index node = 0; node < roads.vertex_count; ++node) node_of.push_back(node);
  for (Cell<1>& road : roads.cells)
    for (VertexId& end : road)
      if (const Index node = end.value; degree[node] > 2) {
        end = {static_cast<Index>(node_of.size())};
        node_of.push_back(node);
      }
  roads.vertex_count = node_of.size();
  roads.signs = std::get<0>(orient(roads));  // roads keep their direction
  Complex<1> routes = assemble(std::move(roads));
  std::cout << pieces(routes).count << " routes\n";

  // The bridge at node 4 is closed: the ring is cut there. A cut is named by half-facets.
  std::vector<HalfFacetId> cut;
  for (const HalfFacetId h : interior_facets(routes))
    if (node_of[routes.facet(h)[0].value] == 4) cut.push_back(h);
  const Relabelling change = unglue(routes, FacetSet::of(routes, cut));
  carry_over(node_of, change);

  const Pieces parts = pieces(routes);
  std::vector<double> total(parts.count);
  for (const CellId road : cells(routes)) total[parts.of_cell[road.value]] += length[road.value];
  for (std::size_t part = 0; part < parts.count; ++part)
    std::cout << "route " << part << ": length " << total[part] << '\n';
  for (const HalfFacetId h : boundary_facets(routes))
    std::cout << "road " << cell_of<1>(h).value << " ends at node "
              << node_of[routes.facet(h)[0].value] << '\n';
}
