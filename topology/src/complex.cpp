#include "cleave/topology/complex.hpp"

#include <stdexcept>
#include <string>

#include "cleave/topology/cell_soup.hpp"
#include "cleave/topology/star_walker.hpp"

namespace cleave::topology {

void require_ids_suffice(int dimension, std::size_t cells, std::size_t vertices) {
  const auto corners_per_cell = static_cast<std::size_t>(dimension) + 1;
  if (cells > (detail::kSevered - std::size_t{1}) / corners_per_cell)
    throw std::length_error(std::to_string(cells) + " cells of dimension " +
                            std::to_string(dimension) + " have more corners than " +
                            std::to_string(kIdBits) + "-bit ids can number");
  if (vertices >= kNoIndex)
    throw std::length_error(std::to_string(vertices) + " vertices are more than " +
                            std::to_string(kIdBits) + "-bit ids can number");
}

template <int D>
std::vector<CornerId> star(const Complex<D>& k, VertexId vertex) {
  StarWalker<D> walker(k);
  const auto corners = walker.around(vertex);
  return {corners.begin(), corners.end()};
}

template std::vector<CornerId> star<1>(const Complex<1>&, VertexId);
template std::vector<CornerId> star<2>(const Complex<2>&, VertexId);
template std::vector<CornerId> star<3>(const Complex<3>&, VertexId);
template std::vector<CornerId> star<4>(const Complex<4>&, VertexId);

}  // namespace cleave::topology
