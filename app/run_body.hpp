#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "body.hpp"
#include "cleave/fem/body.hpp"
#include "cleave/topology/complex.hpp"
#include "run_report.hpp"

/// What a run reports about its body.
namespace cleave::app {

/// The number of vertices that cells of `mesh` use.
std::size_t used_vertices(const Mesh& mesh);
std::size_t used_vertices(const topology::Complex<3>& k);

/// The edges of the file whose cells fall into several parts. Requires sound cells. Time: O(n log
/// n) in the cells.
std::vector<PinchedEdge> pinched_edges(const Mesh& mesh);

/// How many such edges `k` has. Time: O(n log n) in the cells.
std::size_t count_pinched_edges(const topology::Complex<3>& k);

/// What regularisation split, copies in the numbering of the .vtu files, which leaves out vertices
/// that no cell uses.
std::vector<RegularizedVertex> regularized_vertices(const Body<3>& body);

/// The flaws of a body in the numbers of its file, for an InputError.
std::string describe_flaws(const fem::InvalidBody& invalid, const Mesh& mesh);

}  // namespace cleave::app
