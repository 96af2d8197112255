#pragma once
#include <Eigen/SparseCore>

#include "cleave/fem/elastic_operator.hpp"

namespace cleave::fem {

/// The matrix of `k_operator`, size() x size(), for direct solvers, export and study; the solver
/// itself never needs it. Compressed rows (the matrix is symmetric, so they are its columns too).
/// A vertex that no cell uses has an empty row.
/// Time: linear in the cells, and sorting. Memory: 144 triplets of 16 bytes per cell on the way.
Eigen::SparseMatrix<double, Eigen::RowMajor> assemble_stiffness(const ElasticOperator& k_operator);

}  // namespace cleave::fem
