#include <array>
#include <memory>
#include <stdexcept>

#include "bodies.hpp"
#include "cleave/topology/assemble.hpp"
#include "cleave/topology/facet_set.hpp"
#include "cleave/topology/locate.hpp"
#include "cleave/topology/unglue.hpp"
#include "peers.hpp"
#include "peers_bench.hpp"

namespace cleave::bench {
namespace {

using topology::Complex;
using topology::Facet;
using topology::FacetSet;
using topology::Index;
using topology::Verify;
using topology::VertexId;

/// The vertex of a grid at a point.
template <std::size_t D>
VertexId at(int cubes, const std::array<int, D>& point) {
  Index number = 0;
  for (const int x : point) number = number * static_cast<Index>(cubes + 1) + static_cast<Index>(x);
  return {number};
}

template <int D>
CutMesh<D> grid(int cubes) {
  CutMesh<D> mesh{kuhn_soup<D>(cubes), {}, {}, {}};
  for (Index v = 0; v < mesh.soup.vertex_count; ++v) {
    std::array<double, 3> point{};
    for (Index rest = v, axis = D; axis-- > 0; rest /= static_cast<Index>(cubes + 1))
      point[axis] = static_cast<double>(rest % static_cast<Index>(cubes + 1));
    mesh.coordinates.insert(mesh.coordinates.end(), point.begin(), point.end());
  }
  return mesh;
}

/// A cube with a plane through its middle, which falls apart: 2*cubes^2 facets, all turned the same
/// way, and (cubes+1)^2 new vertices.
CutMesh<3> halved_cube(int cubes) {
  CutMesh<3> mesh = grid<3>(cubes);
  const auto vertex = [&](int y, int z) { return at<3>(cubes, {cubes / 2, y, z}); };
  for (int y = 0; y < cubes; ++y)
    for (int z = 0; z < cubes; ++z) {
      mesh.cut.push_back({vertex(y, z), vertex(y + 1, z), vertex(y + 1, z + 1)});
      mesh.cut.push_back({vertex(y, z), vertex(y + 1, z + 1), vertex(y, z + 1)});
    }
  for (const int side : {0, cubes})
    for (int n = 0; n < cubes; ++n) {
      mesh.rim.push_back({vertex(side, n), vertex(side, n + 1)});
      mesh.rim.push_back({vertex(n, side), vertex(n + 1, side)});
    }
  return mesh;
}

/// A square with `edges` edges cut, in straight seams that end inside: each adds one vertex less
/// than it has edges.
CutMesh<2> seams(int squares, int edges) {
  CutMesh<2> mesh = grid<2>(squares);
  const int longest = squares - 2;
  const int lines = (edges + longest - 1) / longest;
  for (int line = 1, left = edges; line <= lines; ++line) {
    const int length = left / (lines - line + 1);
    const int x = line * squares / (lines + 1), low = (squares - length) / 2;
    for (int y = low; y < low + length; ++y)
      mesh.cut.push_back({at<2>(squares, {x, y}), at<2>(squares, {x, y + 1})});
    left -= length;
  }
  return mesh;
}

/// Nanoseconds per facet. `ours` has the facets as a set of the complex's and verifies what it
/// touched, as is the default; `bare` does not verify; `located` begins with the facets' vertices
/// and looks for them in the whole mesh. Throws if the programs do not find the same number of new
/// vertices.
template <int D>
void cut(benchmark::State& state, const std::function<CutMesh<D>()>& make) {
  const CutMesh<D> mesh = make();
  const Complex<D> whole = topology::assemble(topology::CellSoup<D>(mesh.soup));
  const auto locate = [&] {
    std::vector<topology::HalfFacetId> half_facets;
    for (const auto& found : topology::locate_facets<D>(whole.cells(), mesh.cut))
      half_facets.push_back(found.value());
    return FacetSet::of(whole, half_facets);
  };
  const FacetSet facets = locate();
  FlatMesh<D> flat_whole = flat_mesh(mesh.soup);
  flat_whole.match();
  std::vector<std::uint32_t> flat_cut;
  for (const auto h : facets.half_facets()) flat_cut.push_back(static_cast<std::uint32_t>(h.value));

  TimesOf times;
  std::size_t new_vertices = 0;
  const auto agree = [&](const std::string& name, std::size_t count) {
    if (count != new_vertices)
      throw std::logic_error(name + " makes " + std::to_string(count) + " new vertices, ours " +
                             std::to_string(new_vertices));
  };
  for (auto _ : state) {
    const auto time_ours = [&](auto work) {
      const auto k = std::make_unique<Complex<D>>(whole);
      return seconds([&] { new_vertices = work(*k).splits.size(); });
    };
    times["bare"].push_back(
        time_ours([&](Complex<D>& k) { return topology::unglue(k, facets, Verify::none); }));
    times["located"].push_back(
        time_ours([&](Complex<D>& k) { return topology::unglue(k, locate()); }));
    times["ours"].push_back(time_ours([&](Complex<D>& k) { return topology::unglue(k, facets); }));
    state.SetIterationTime(times["ours"].back());
    {
      FlatMesh<D> flat = flat_whole;
      std::uint32_t added = 0;
      times["flat"].push_back(seconds([&] { added = flat.unglue(flat_cut); }));
      agree("the yardstick", added);
    }
    for (const Splitter<D>& peer : splitters<D>()) {
      if (mesh.soup.cells.size() > peer.most_cells || mesh.cut.size() > peer.most_facets) continue;
      const Split split = peer.split(mesh);
      times[peer.name].push_back(split.seconds);
      agree(peer.name, split.new_vertices);
    }
  }
  state.counters["cells"] = static_cast<double>(mesh.soup.cells.size());
  state.counters["facets"] = static_cast<double>(mesh.cut.size());
  state.counters["copies"] = static_cast<double>(new_vertices);
  report(state, times,
         [&](double time) { return 1e9 * time / static_cast<double>(mesh.cut.size()); });
}

template <int D>
void register_cut(const std::string& name, const std::function<CutMesh<D>()>& make,
                  int iterations) {
  benchmark::RegisterBenchmark(("peers_cut/D" + std::to_string(D) + "/" + name).c_str(),
                               [make](benchmark::State& state) { cut<D>(state, make); })
      ->Iterations(iterations)
      ->UseManualTime()
      ->Unit(benchmark::kMicrosecond);
}

}  // namespace

void register_peer_cuts() {
  // Of 200, 882, 3 200 and 20 000 facets; gmsh does the last if CLEAVE_BENCH_LARGE is set.
  for (const int cubes : {10, 21, 40, 100})
    register_cut<3>(
        "cube-" + std::to_string(cubes), [cubes] { return halved_cube(cubes); },
        cubes < 100 ? 3 : 1);
  for (const int edges : {1'000, 10'000, 100'000})
    register_cut<2>(
        "seam-" + std::to_string(edges), [edges] { return seams(707, edges); }, 5);
}

}  // namespace cleave::bench
