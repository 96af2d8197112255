#include <CGAL/Triangulation_data_structure_3.h>

#include <algorithm>
#include <array>
#include <boost/functional/hash.hpp>
#include <boost/unordered_map.hpp>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "peers.hpp"

/// CGAL's Triangulation_data_structure_3 with bare vertices and cells. It is filled by hand: cells
/// are made, and neighbours set by a table of facets. It knows no boundary, so that cells of a
/// vertex "at infinity" close it; where four of those meet at an edge, they are paired as they
/// come. CGAL_TDS_3 keeps all facets in the table, as CGAL's own loaders do; CGAL_TDS_3_lean drops
/// those that are matched, the best we can do for it.
namespace cleave::bench {
namespace {

using Tds = CGAL::Triangulation_data_structure_3<CGAL::Triangulation_ds_vertex_base_3<>,
                                                 CGAL::Triangulation_ds_cell_base_3<>>;
using CellHandle = Tds::Cell_handle;
using VertexHandle = Tds::Vertex_handle;
using Side = std::pair<CellHandle, int>;  // a facet, seen from a cell

template <std::size_t N>
using Key = std::array<topology::Index, N>;
template <std::size_t N>
using Table = boost::unordered_map<Key<N>, Side, boost::hash<Key<N>>>;

enum class Matched { stay, leave };

/// Makes neighbours of `side` and the one with the same key, or keeps it until that one comes.
template <Matched matched, std::size_t N>
void match(Tds& tds, Table<N>& table, Key<N> key, Side side) {
  std::sort(key.begin(), key.end());
  const auto [found, is_new] = table.try_emplace(key, side);
  if (is_new) return;
  tds.set_adjacency(found->second.first, found->second.second, side.first, side.second);
  if (matched == Matched::leave) table.erase(found);
}

template <Matched matched>
class CgalMesh : public PeerMesh {
 public:
  explicit CgalMesh(const topology::CellSoup<3>& soup) {
    std::vector<VertexHandle> vertices(soup.vertex_count);
    for (VertexHandle& v : vertices) v = tds_.create_vertex();
    infinite_ = tds_.create_vertex();
    tds_.set_dimension(3);

    Table<3> open;
    if (matched == Matched::stay) open.reserve(2 * soup.cells.size() + soup.vertex_count);
    for (std::size_t c = 0; c < soup.cells.size(); ++c) {
      auto v = soup.cells[c];
      if (soup.signs[c] < 0) std::swap(v[2], v[3]);
      const CellHandle cell = tds_.create_cell(vertices[v[0].value], vertices[v[1].value],
                                               vertices[v[2].value], vertices[v[3].value]);
      for (int i = 0; i < 4; ++i) {
        cell->vertex(i)->set_cell(cell);
        match<matched, 3>(tds_, open,
                          {v[(i + 1) % 4].value, v[(i + 2) % 4].value, v[(i + 3) % 4].value},
                          {cell, i});
      }
    }

    Table<2> open_edges;
    boost::unordered_map<VertexHandle, topology::Index> number;
    for (const auto& [key, side] : open) {
      if (side.first->neighbor(side.second) != CellHandle()) continue;
      for (const topology::Index v : key) number[vertices[v]] = v;
      const auto corner = [&, cell = side.first, i = side.second](int n) {
        return cell->vertex((i + n) % 4);
      };
      // The new cell has the facet from behind; whose turn is even depends on i.
      std::array<VertexHandle, 3> facet{corner(2), corner(1), corner(3)};
      if (side.second % 2 == 1) std::swap(facet[0], facet[2]);
      const CellHandle cell = tds_.create_cell(infinite_, facet[0], facet[1], facet[2]);
      infinite_->set_cell(cell);
      tds_.set_adjacency(side.first, side.second, cell, 0);
      for (int i = 1; i < 4; ++i)
        match<Matched::leave, 2>(
            tds_, open_edges,
            {number[cell->vertex(i % 3 + 1)], number[cell->vertex((i + 1) % 3 + 1)]}, {cell, i});
    }
    if (!open_edges.empty()) throw std::invalid_argument("CGAL: the boundary is not closed");
  }

  std::uint64_t visit_neighbours() override {
    std::uint64_t steps = 0;
    for (auto cell = tds_.cells_begin(); cell != tds_.cells_end(); ++cell)
      for (int i = 0; i < 4; ++i) steps += cell->neighbor(i) != CellHandle() ? 1 : 0;
    return steps;
  }

  std::uint64_t visit_stars() override {
    std::uint64_t visits = 0;
    std::vector<CellHandle> star;
    for (auto v = tds_.vertices_begin(); v != tds_.vertices_end(); ++v) {
      if (v->cell() == CellHandle()) continue;
      star.clear();
      tds_.incident_cells(v, std::back_inserter(star));
      visits += star.size();
    }
    return visits;
  }

  bool is_valid() const { return tds_.is_valid(); }

 private:
  Tds tds_;
  VertexHandle infinite_;
};

template <Matched matched>
std::unique_ptr<PeerMesh> assemble(const topology::CellSoup<3>& soup) {
  auto mesh = std::make_unique<CgalMesh<matched>>(soup);
  if (soup.cells.size() < 10'000 && !mesh->is_valid())
    throw std::logic_error("CGAL does not accept its structure as we filled it");
  return mesh;
}

const Registration kTds(Assembler<3>{"CGAL_TDS_3", assemble<Matched::stay>, 10'000'000,
                                     10'000'000});
const Registration kLean(Assembler<3>{"CGAL_TDS_3_lean", assemble<Matched::leave>, 10'000'000, 0});

}  // namespace
}  // namespace cleave::bench
