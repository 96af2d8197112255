#include <benchmark/benchmark.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bodies.hpp"
#include "cleave/topology/incision.hpp"
#include "cleave/topology/ranges.hpp"
#include "cleave/topology/star_walker.hpp"
#include "cleave/topology/unglue.hpp"
#include "figure.hpp"
#include "flat_checks.hpp"
#include "patches.hpp"

/// D = 1, 2 and 4 beside D = 3: nanoseconds per corner on grids of about eight million corners.
/// Both dimensions are measured in turn; `ratio` is here to D = 3.
namespace cleave::bench {
namespace {

using namespace topology;  // NOLINT(google-build-using-namespace): it is what is measured

/// Cubes along each axis.
template <int D>
constexpr int kCubes = D == 1   ? 4'000'000
                       : D == 2 ? 1'150
                       : D == 3 ? 70
                                : 16;

/// Facets to cut, such that the stars of their vertices have about as many corners each.
template <int D>
constexpr std::size_t kFacets = D == 1   ? 100'000
                                : D == 2 ? 40'000
                                : D == 3 ? 20'000
                                         : 20'000;

/// Nanoseconds per corner, and how many corners that are.
struct Cost {
  double seconds;
  std::size_t corners;
  double per_corner() const { return seconds / static_cast<double>(corners); }
};

template <int D>
struct Assembly {
  static constexpr const char* kName = "assembly";
  CellSoup<D> soup = kuhn_soup<D>(kCubes<D>);
  Cost measure() {
    CellSoup<D> input = soup;
    Complex<D> k;
    const double time = seconds([&] { k = assemble(std::move(input)); });
    return {time, k.half_facet_count()};
  }
  FlatMesh<D> flat = flat_mesh(soup);
  double flat_seconds() {
    flat.mates = {};
    bool good = false;
    const double time = seconds([&] { good = flat.match() && is_cut_regular(flat); });
    if (!good) throw std::logic_error("the grid is a manifold");
    return time;
  }
};

template <int D>
struct Check {
  static constexpr const char* kName = "check";
  CellSoup<D> soup = kuhn_soup<D>(kCubes<D>);
  Cost measure() {
    bool good = false;
    const double time = seconds([&] { good = check(soup).empty(); });
    if (!good) throw std::logic_error("the grid is a manifold");
    return {time, (D + 1) * soup.cells.size()};
  }
};

template <int D>
struct Stars {
  static constexpr const char* kName = "stars";
  Complex<D> k = assemble(kuhn_soup<D>(kCubes<D>));
  Cost measure() {
    std::size_t corners = 0;
    const double time = seconds([&] {
      StarWalker walker(k);
      for (const VertexId v : vertices(k)) corners += walker.around(v).size();
    });
    return {time, corners};
  }
  FlatMesh<D> flat = matched_flat_mesh(kuhn_soup<D>(kCubes<D>));
  double flat_seconds() {
    return seconds([&] { benchmark::DoNotOptimize(is_cut_regular(flat)); });
  }
};

template <int D>
struct Cut {
  const Body<D>& whole = body<D>(kCubes<D>);
  FacetSet facets = patches(whole, kFacets<D>);
  std::size_t corners = corners_around(whole, facets);
};

template <int D>
struct Unglue : Cut<D> {
  static constexpr const char* kName = "unglue";
  Complex<D> k;
  Cost measure() {
    k = this->whole.complex;
    return {seconds([&] { unglue(k, this->facets, Verify::none); }), this->corners};
  }
  FlatMesh<D> flat;
  double flat_seconds() {
    flat = this->whole.flat;
    return seconds([&] { flat.unglue(numbers(this->facets.half_facets())); });
  }
};

template <int D>
struct Verified : Cut<D> {
  static constexpr const char* kName = "verified";
  Complex<D> k;
  Cost measure() {
    k = this->whole.complex;
    return {seconds([&] { unglue(k, this->facets); }), this->corners};
  }
};

template <int D>
struct Stitch : Cut<D> {
  static constexpr const char* kName = "stitch";
  Incision<D> incision{this->whole.complex};
  Cost measure() {
    incision.cut(this->facets, Verify::none);
    const Cost cost{seconds([&] { incision.stitch(this->facets, Verify::none); }), this->corners};
    incision.forget_steps();
    return cost;
  }
};

template <template <int> class Work, int D>
void beside_tetrahedra(benchmark::State& state) {
  Work<D> work;
  Work<3> tetrahedra;
  Turns turns, beside_flat;
  std::size_t corners = 0;
  for (auto _ : state) {
    const Cost cost = work.measure();
    turns.ours.push_back(cost.per_corner());
    turns.flat.push_back(tetrahedra.measure().per_corner());
    if constexpr (requires { work.flat_seconds(); })
      beside_flat.flat.push_back(work.flat_seconds() / static_cast<double>(cost.corners));
    corners = cost.corners;
    state.SetIterationTime(cost.seconds);
  }
  beside_flat.ours = turns.ours;
  state.counters["ns/corner"] = 1e9 * median(turns.ours);
  state.counters["D3"] = 1e9 * median(turns.flat);
  state.counters["per_D3"] = turns.ratio();
  if (!beside_flat.flat.empty()) state.counters["ratio"] = beside_flat.ratio();
  state.counters["corners"] = static_cast<double>(corners);
}

template <template <int> class Work, int D>
void add_dimension() {
  const std::string name = std::string("dimension/") + Work<D>::kName + "/D:" + std::to_string(D);
  benchmark::RegisterBenchmark(name.c_str(), beside_tetrahedra<Work, D>)
      ->Iterations(5)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
}

template <template <int> class Work>
void add() {
  add_dimension<Work, 1>();
  add_dimension<Work, 2>();
  add_dimension<Work, 4>();
}

const bool kRegistered = [] {
  add<Assembly>();
  add<Stars>();
  add<Check>();
  add<Unglue>();
  add<Verified>();
  add<Stitch>();
  return true;
}();

}  // namespace
}  // namespace cleave::bench
