#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

/// mesh_points COUNT FILE: the Delaunay triangulation of COUNT random points in a cube, as CGAL
/// numbers and orders it, in the Medit format (.mesh).
namespace {
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_3<unsigned, Kernel>;
using Structure =
    CGAL::Triangulation_data_structure_3<Vertex, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, Structure>;
}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return std::fputs("usage: mesh_points COUNT FILE\n", stderr), 2;
  std::mt19937_64 random(1);
  const auto coordinate = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::vector<Kernel::Point_3> points;
  for (long n = std::atol(argv[1]); n > 0; --n) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    points.emplace_back(x, y, z);
  }
  Delaunay mesh(points.begin(), points.end());

  std::FILE* file = std::fopen(argv[2], "w");
  if (file == nullptr) return std::perror(argv[2]), 1;
  std::fprintf(file, "MeshVersionFormatted 2\nDimension 3\nVertices\n%zu\n",
               static_cast<std::size_t>(mesh.number_of_vertices()));
  unsigned number = 0;
  for (const auto v : mesh.finite_vertex_handles()) {
    v->info() = ++number;
    std::fprintf(file, "%.17g %.17g %.17g 0\n", v->point().x(), v->point().y(), v->point().z());
  }
  std::fprintf(file, "Tetrahedra\n%zu\n", static_cast<std::size_t>(mesh.number_of_finite_cells()));
  for (const auto c : mesh.finite_cell_handles())
    std::fprintf(file, "%u %u %u %u 0\n", c->vertex(0)->info(), c->vertex(1)->info(),
                 c->vertex(2)->info(), c->vertex(3)->info());
  std::fputs("End\n", file);
  return std::fclose(file) == 0 ? 0 : 1;
}
