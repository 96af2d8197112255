#pragma once
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <utility>
#include <vector>

#include "cleave/topology/cell_soup.hpp"

namespace cleave::bench {

using SurfaceMesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

/// Triangles as CGAL wants them, coherent without signs.
inline std::vector<std::array<std::size_t, 3>> polygons(const topology::CellSoup<2>& soup) {
  std::vector<std::array<std::size_t, 3>> all;
  for (std::size_t c = 0; c < soup.cells.size(); ++c) {
    const auto& v = soup.cells[c];
    all.push_back({v[0].value, v[1].value, v[2].value});
    if (soup.signs[c] < 0) std::swap(all.back()[1], all.back()[2]);
  }
  return all;
}

/// CGAL's way from a soup to a Surface_mesh.
inline SurfaceMesh surface_mesh(const topology::CellSoup<2>& soup) {
  const std::vector<SurfaceMesh::Point> points(soup.vertex_count, SurfaceMesh::Point(0, 0, 0));
  SurfaceMesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, polygons(soup), mesh);
  return mesh;
}

}  // namespace cleave::bench
