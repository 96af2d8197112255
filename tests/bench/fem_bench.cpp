#include <benchmark/benchmark.h>

#include <Eigen/SparseCore>
#include <array>
#include <cstdint>
#include <map>
#include <variant>
#include <vector>

#include "cleave/fem/elastic_operator.hpp"
#include "cleave/fem/stiffness.hpp"
#include "cleave/support/meshes.hpp"
#include "cleave/topology/assemble.hpp"
#include "cleave/topology/check.hpp"
#include "cleave/topology/unglue.hpp"

/// K u without a matrix against the product with the assembled one, on cubes of 6 n^3 cells; what
/// building either costs; and what following a cut costs. Figures of one run are to be compared
/// with each other.
namespace cleave::bench {
namespace {

struct Cube {
  topology::Complex<3> k;
  std::vector<std::array<double, 3>> points;
  fem::Materials materials;
};

/// The Kuhn cube with `edges` cubes along each axis, made once.
const Cube& cube_of(int edges) {
  static std::map<int, Cube> made;
  if (const auto at = made.find(edges); at != made.end()) return at->second;
  const int n = edges + 1;
  const support::KuhnGrid<3> grid({n, n, n});
  topology::CellSoup<3> soup{grid.cells, grid.vertex_count, {}};
  soup.signs = std::get<std::vector<std::int8_t>>(topology::orient(soup));
  Cube cube{topology::assemble(std::move(soup)), {}, {}};
  for (std::uint32_t v = 0; v < grid.vertex_count; ++v) {
    const auto p = grid.point({v});
    cube.points.push_back({p[0] / double(edges), p[1] / double(edges), p[2] / double(edges)});
  }
  cube.materials = fem::Materials::uniform(cube.k.cell_count(), {1.0, 1.0});
  return made.emplace(edges, std::move(cube)).first->second;
}

Eigen::VectorXd some_displacement(Eigen::Index size) {
  return Eigen::VectorXd::LinSpaced(size, -1.0, 1.0).array().sin();
}

void report_per_cell(benchmark::State& state, std::size_t cells) {
  state.counters["time_per_cell"] =
      benchmark::Counter(static_cast<double>(cells), benchmark::Counter::kIsIterationInvariantRate |
                                                         benchmark::Counter::kInvert);
  state.SetComplexityN(static_cast<std::int64_t>(cells));
}

void apply_matrix_free(benchmark::State& state) {
  const Cube& cube = cube_of(static_cast<int>(state.range(0)));
  const fem::ElasticOperator k_operator(cube.k, cube.points, cube.materials);
  const Eigen::VectorXd u = some_displacement(k_operator.size());
  Eigen::VectorXd f;
  for (auto _ : state) {
    k_operator.apply(u, f);
    benchmark::DoNotOptimize(f.data());
  }
  report_per_cell(state, cube.k.cell_count());
}

void apply_assembled(benchmark::State& state) {
  const Cube& cube = cube_of(static_cast<int>(state.range(0)));
  const auto matrix = fem::assemble_stiffness({cube.k, cube.points, cube.materials});
  const Eigen::VectorXd u = some_displacement(matrix.cols());
  Eigen::VectorXd f(matrix.rows());
  for (auto _ : state) {
    f.noalias() = matrix * u;
    benchmark::DoNotOptimize(f.data());
  }
  report_per_cell(state, cube.k.cell_count());
}

void build_operator(benchmark::State& state) {
  const Cube& cube = cube_of(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    fem::ElasticOperator k_operator(cube.k, cube.points, cube.materials);
    benchmark::DoNotOptimize(k_operator);
  }
  report_per_cell(state, cube.k.cell_count());
}

void build_matrix(benchmark::State& state) {
  const Cube& cube = cube_of(static_cast<int>(state.range(0)));
  const fem::ElasticOperator k_operator(cube.k, cube.points, cube.materials);
  for (auto _ : state) benchmark::DoNotOptimize(fem::assemble_stiffness(k_operator));
  report_per_cell(state, cube.k.cell_count());
}

/// The patch after a cut of 64 facets in the middle, and the patch after taking it back: half of
/// the time is for one. The mesh grows, the cut does not.
void update_there_and_back(benchmark::State& state) {
  Cube cube = cube_of(static_cast<int>(state.range(0)));
  const auto whole = cube.k;
  fem::ElasticOperator k_operator(cube.k, cube.points, cube.materials);
  std::vector<topology::HalfFacetId> facets;
  for (auto h = static_cast<std::uint32_t>(cube.k.half_facet_count() / 2); facets.size() < 64; ++h)
    if (cube.k.is_interior({h})) facets.push_back({h});
  const auto change = topology::unglue(cube.k, topology::FacetSet::of(cube.k, facets));
  const auto back = topology::inverse(change);
  for (auto _ : state) {
    k_operator.update(cube.k, change);
    k_operator.update(whole, back);
  }
  state.counters["renamed_corners"] = static_cast<double>(change.corners.size());
}

BENCHMARK(apply_matrix_free)->RangeMultiplier(2)->Range(8, 64)->Complexity();
BENCHMARK(apply_assembled)->RangeMultiplier(2)->Range(8, 64)->Complexity();
BENCHMARK(build_operator)->RangeMultiplier(2)->Range(8, 64)->Unit(benchmark::kMillisecond);
BENCHMARK(build_matrix)->RangeMultiplier(2)->Range(8, 32)->Unit(benchmark::kMillisecond);
BENCHMARK(update_there_and_back)->RangeMultiplier(2)->Range(8, 64);

}  // namespace
}  // namespace cleave::bench
