#include <algorithm>
#include <functional>
#include <memory>
#include <stdexcept>

#include "bench_meshes.hpp"
#include "bodies.hpp"
#include "cleave/topology/assemble.hpp"
#include "cleave/topology/complex.hpp"
#include "flat_checks.hpp"
#include "peers.hpp"
#include "peers_bench.hpp"
#include "resident.hpp"

namespace cleave::bench {
namespace {

using topology::CellSoup;
using topology::Complex;
using topology::Index;

template <int D>
using MakeMesh = std::function<const CellSoup<D>&()>;

/// Mates by the faster of the yardstick's two ways, and a walk around every vertex.
template <int D>
double seconds_of_yardstick(FlatMesh<D>& flat) {
  bool sound = true;
  flat.mates = {};
  const double by_cells = seconds([&] { sound &= flat.match(); });
  flat.mates = {};
  const double by_facets = seconds([&] { sound &= flat.match_by_facets(); });
  const double stars = seconds([&] { sound &= is_cut_regular(flat); });
  if (!sound) throw std::logic_error("the yardstick finds something wrong");
  return std::min(by_cells, by_facets) + stars;
}

/// Million cells per second, from tuples to a structure that knows neighbours. The library and the
/// yardstick make sure that the cells are coherent and every star is one part; the others do not
/// ask.
template <int D>
void assembly(benchmark::State& state, const MakeMesh<D>& make) {
  const CellSoup<D>& soup = make();
  const std::size_t cells = soup.cells.size();
  FlatMesh<D> flat = flat_mesh(soup);
  TimesOf times;
  for (auto _ : state) {
    CellSoup<D> input = soup;
    {
      Complex<D> ours;
      times["ours"].push_back(seconds([&] { ours = topology::assemble(std::move(input)); }));
    }
    state.SetIterationTime(times["ours"].back());
    times["flat"].push_back(seconds_of_yardstick(flat));
    for (const Assembler<D>& peer : assemblers<D>()) {
      if (cells > peer.most_cells) continue;
      std::unique_ptr<PeerMesh> theirs;
      const double time = seconds([&] { theirs = peer.assemble(soup); });
      if (theirs)
        times[peer.name].push_back(time);
      else
        state.counters[peer.name + "_refuses"] = 1;
    }
  }
  state.counters["cells"] = static_cast<double>(cells);
  report(state, times, [&](double time) { return 1e-6 * static_cast<double>(cells) / time; });
}

/// Bytes per cell in memory, afterwards and at the worst moment, beyond the input; for the library
/// with the input, which becomes part of its complex.
template <int D>
void memory(benchmark::State& state, const MakeMesh<D>& make) {
  const CellSoup<D>& soup = make();
  const auto cells = static_cast<double>(soup.cells.size());
  const auto measure = [&](const std::string& name, auto assemble) {
    forget_resident_peak();
    const std::size_t before = resident_bytes();
    const auto made = assemble();
    const std::size_t peak = resident_peak();
    state.counters[name + "_peak"] = static_cast<double>(peak - before) / cells;
    state.counters[name + "_held"] = static_cast<double>(resident_bytes() - before) / cells;
  };
  for (auto _ : state) {
    measure("ours", [&] { return topology::assemble(CellSoup<D>(soup)); });
    for (const Assembler<D>& peer : assemblers<D>())
      if (soup.cells.size() <= peer.most_cells)
        measure(peer.name, [&] { return peer.assemble(soup); });
  }
}

template <int D>
std::uint64_t visit_neighbours(const Complex<D>& k) {
  std::uint64_t steps = 0;
  const auto half_facets = static_cast<Index>(k.half_facet_count());
  for (Index h = 0; h < half_facets; ++h) steps += k.is_interior({h}) ? 1 : 0;
  return steps;
}

template <int D>
std::uint64_t visit_stars(const Complex<D>& k) {
  std::uint64_t visits = 0;
  const auto vertices = static_cast<Index>(k.vertex_count());
  for (Index v = 0; v < vertices; ++v) visits += star(k, {v}).size();
  return visits;
}

/// Nanoseconds per visit for `ours` and `theirs`, which go from each cell to all its neighbours, or
/// visit the cells of all stars. For the yardstick see traversal_bench.cpp.
template <int D, class Ours, class Theirs>
void traverse(benchmark::State& state, const MakeMesh<D>& make, Ours ours, Theirs theirs,
              double visits_per_cell) {
  const CellSoup<D>& soup = make();
  const Complex<D> k = topology::assemble(CellSoup<D>(soup));
  std::map<std::string, std::unique_ptr<PeerMesh>> peers;
  for (const Assembler<D>& peer : assemblers<D>())
    if (soup.cells.size() <= peer.most_traversed) peers[peer.name] = peer.assemble(soup);
  TimesOf times;
  for (auto _ : state) {
    std::uint64_t expected = 0;
    times["ours"].push_back(seconds([&] { expected = ours(k); }));
    state.SetIterationTime(times["ours"].back());
    for (const auto& [name, peer] : peers) {
      std::uint64_t visits = 0;
      times[name].push_back(seconds([&] { visits = theirs(*peer); }));
      if (visits < expected) throw std::logic_error(name + " visits fewer cells");
    }
  }
  const double items = visits_per_cell * static_cast<double>(soup.cells.size());
  report(state, times, [&](double time) { return 1e9 * time / items; });
}

template <int D>
void register_mesh(const std::string& name, const MakeMesh<D>& make, int iterations) {
  const std::string dimension = "/D" + std::to_string(D) + "/" + name;
  const auto with = [&](const std::string& what, auto run) {
    benchmark::RegisterBenchmark(("peers_" + what + dimension).c_str(), run)
        ->Iterations(iterations)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  };
  with("assembly", [make](benchmark::State& state) { assembly<D>(state, make); });
  with("neighbours", [make](benchmark::State& state) {
    traverse<D>(
        state, make, [](const Complex<D>& k) { return visit_neighbours(k); },
        [](PeerMesh& peer) { return peer.visit_neighbours(); }, 1);
  });
  with("stars", [make](benchmark::State& state) {
    traverse<D>(
        state, make, [](const Complex<D>& k) { return visit_stars(k); },
        [](PeerMesh& peer) { return peer.visit_stars(); }, D + 1);
  });
  benchmark::RegisterBenchmark(("peers_memory" + dimension).c_str(), [make](
                                                                         benchmark::State& state) {
    memory<D>(state, make);
  })->Iterations(1);
}

void register_named(const std::string& name, int iterations) {
  register_mesh<3>(
      name,
      [name]() -> const auto& {
        return last_made<CellSoup<3>>(name, [&] { return named_mesh(name); });
      },
      iterations);
}

}  // namespace

void register_peer_assembly() {
  register_named("cube-5", 5);  // small enough for what is quadratic
  register_named("cube-40", 5);
  register_named("cube-40-shuffled", 5);
  register_named("cube-100", 3);
  register_named("cube-100-shuffled", 1);
  for (const std::string& name : mesh_files()) {
    register_named(name, 3);
    register_named(name + "-shuffled", 1);
  }
  for (const int squares : {20, 707})
    register_mesh<2>(
        "square-" + std::to_string(squares),
        [squares]() -> const auto& {
          return last_made<CellSoup<2>>(squares, [&] { return kuhn_soup<2>(squares); });
        },
        5);
}

}  // namespace cleave::bench
