#include <algorithm>
#include <functional>
#include <memory>
#include <stdexcept>

#include "bench_meshes.hpp"
#include "bodies.hpp"
#include "cleave/topology/assemble.hpp"
#include "cleave/topology/complex.hpp"
#include "cleave/topology/star_walker.hpp"
#include "cleave/topology/vertex_index.hpp"
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
  topology::StarWalker walker(k);
  const auto vertices = static_cast<Index>(k.vertex_count());
  for (Index v = 0; v < vertices; ++v)
    for (const auto corner : walker.around({v})) visits += corner.value != topology::kNoIndex;
  return visits;
}

template <int D>
std::uint64_t visit_stars(const topology::VertexIndex<D>& index) {
  std::uint64_t visits = 0;
  const auto vertices = static_cast<Index>(index.vertex_count());
  for (Index v = 0; v < vertices; ++v)
    for (const auto corner : index[{v}]) visits += corner.value != topology::kNoIndex;
  return visits;
}

using Peers = std::map<std::string, std::unique_ptr<PeerMesh>>;

/// The structures of those that can be walked through at this size.
template <int D>
Peers walkable(const CellSoup<D>& soup) {
  Peers peers;
  for (const Assembler<D>& peer : assemblers<D>())
    if (soup.cells.size() <= peer.most_traversed) peers[peer.name] = peer.assemble(soup);
  return peers;
}

void same_visits(const std::string& name, std::uint64_t visits, std::uint64_t expected) {
  if (visits < expected) throw std::logic_error(name + " visits fewer cells");
}

/// Nanoseconds per cell to go from it to all its neighbours.
template <int D>
void neighbours(benchmark::State& state, const MakeMesh<D>& make) {
  const CellSoup<D>& soup = make();
  const Complex<D> k = topology::assemble(CellSoup<D>(soup));
  const Peers peers = walkable<D>(soup);
  TimesOf times;
  for (auto _ : state) {
    std::uint64_t expected = 0, visits = 0;
    times["ours"].push_back(seconds([&] { expected = visit_neighbours(k); }));
    state.SetIterationTime(times["ours"].back());
    for (const auto& [name, peer] : peers) {
      times[name].push_back(seconds([&, &p = *peer] { visits = p.visit_neighbours(); }));
      same_visits(name, visits, expected);
    }
  }
  const auto cells = static_cast<double>(soup.cells.size());
  report(state, times, [&](double time) { return 1e9 * time / cells; });
}

/// Nanoseconds per visit of a cell around a vertex. `ours` walks through the mates as the others
/// do, `indexed` looks the corners up in a VertexIndex, which `index_made` makes.
template <int D>
void stars(benchmark::State& state, const MakeMesh<D>& make) {
  const CellSoup<D>& soup = make();
  const Complex<D> k = topology::assemble(CellSoup<D>(soup));
  FlatMesh<D> flat = flat_mesh(soup);
  flat.match();
  const Peers peers = walkable<D>(soup);
  TimesOf times;
  const std::uint64_t expected = soup.cells.size() * (D + 1);
  for (auto _ : state) {
    std::uint64_t visits = 0;
    topology::VertexIndex<D> index;
    const auto time = [&](const std::string& name, auto visit) {
      times[name].push_back(seconds([&] { visits = visit(); }));
      same_visits(name, visits, expected);
    };
    time("ours", [&] { return visit_stars(k); });
    state.SetIterationTime(times["ours"].back());
    times["index_made"].push_back(seconds([&] { index = topology::VertexIndex<D>(k); }));
    time("indexed", [&] { return visit_stars(index); });
    time("flat", [&] {
      std::uint64_t sum = 0;
      for_each_star(flat, [&](std::uint32_t, const auto& star) { sum += star.size(); });
      return sum;
    });
    for (const auto& [name, peer] : peers) time(name, [&, &p = *peer] { return p.visit_stars(); });
  }
  report(state, times, [&](double time) { return 1e9 * time / static_cast<double>(expected); });
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
  with("neighbours", [make](benchmark::State& state) { neighbours<D>(state, make); });
  with("stars", [make](benchmark::State& state) { stars<D>(state, make); });
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
