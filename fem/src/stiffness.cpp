#include "cleave/fem/stiffness.hpp"

#include <vector>

namespace cleave::fem {

Eigen::SparseMatrix<double, Eigen::RowMajor> assemble_stiffness(const ElasticOperator& k_operator) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(144 * k_operator.cell_count());
  for (topology::Index c = 0; c < k_operator.cell_count(); ++c) {
    const CellStiffness share = k_operator.cell_stiffness({c});
    const topology::Cell<3>& cell = k_operator.vertices({c});
    for (Eigen::Index row = 0; row < 12; ++row)
      for (Eigen::Index column = 0; column < 12; ++column) {
        const auto i = static_cast<int>(3 * cell[static_cast<std::size_t>(row / 3)].value);
        const auto j = static_cast<int>(3 * cell[static_cast<std::size_t>(column / 3)].value);
        entries.emplace_back(i + static_cast<int>(row % 3), j + static_cast<int>(column % 3),
                             share(row, column));
      }
  }
  Eigen::SparseMatrix<double, Eigen::RowMajor> matrix(k_operator.size(), k_operator.size());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace cleave::fem
