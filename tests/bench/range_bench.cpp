#include <benchmark/benchmark.h>

#include <cstdint>
#include <stdexcept>

#include "bodies.hpp"
#include "cleave/topology/arrays.hpp"
#include "cleave/topology/link_view.hpp"
#include "cleave/topology/ranges.hpp"
#include "cleave/topology/ridge_walk.hpp"
#include "cleave/topology/simplices.hpp"
#include "cleave/topology/star_walker.hpp"
#include "cleave/topology/vertex_index.hpp"
#include "figure.hpp"
#include "flat_checks.hpp"

/// Each range beside a loop over plain arrays that visits the same, in turn: `ratio` says what the
/// range costs over it.
namespace cleave::bench {
namespace {

using namespace topology;  // NOLINT(google-build-using-namespace): it is what is measured

/// The body, and per vertex its corners: ours and the same as plain arrays.
struct Indexed {
  const Body<3>* body;
  VertexIndex<3> index;
  std::vector<std::uint32_t> first, corners;
};

const Indexed& indexed(const benchmark::State& state) {
  const std::pair key(static_cast<int>(state.range(0)),
                      state.range(1) == 0 ? Order::mesh : Order::random);
  return last_made<Indexed>(key, [&] {
    Indexed made{&body<3>(key.first, key.second), {}, {0}, {}};
    made.index = VertexIndex<3>(made.body->complex);
    for (const VertexId v : vertices(made.body->complex)) {
      for (const CornerId corner : made.index[v])
        made.corners.push_back(static_cast<std::uint32_t>(corner.value));
      made.first.push_back(static_cast<std::uint32_t>(made.corners.size()));
    }
    return made;
  });
}

/// Times both loops in turn; each returns the sum of what it visits, which has to be the same.
template <class Ours, class Flat>
void compare(benchmark::State& state, const std::string& name, std::size_t items, Ours ours,
             Flat flat) {
  Turns turns;
  for (auto _ : state) {
    std::uint64_t sum = 0, flat_sum = 0;
    turns.ours.push_back(seconds([&] { benchmark::DoNotOptimize(sum = ours()); }));
    turns.flat.push_back(seconds([&] { benchmark::DoNotOptimize(flat_sum = flat()); }));
    if (sum != flat_sum) throw std::logic_error("the plain loop disagrees");
    state.SetIterationTime(turns.ours.back());
  }
  report_ns(state, name, turns, static_cast<double>(items));
}

constexpr std::uint32_t kNone = FlatMesh<3>::kNone;

/// The neighbours of each cell, one cell after the other.
void range_neighbours(benchmark::State& state) {
  const Complex<3>& k = indexed(state).body->complex;
  const FlatMesh<3>& flat = indexed(state).body->flat;
  compare(
      state, "ns/tet", k.cell_count(),
      [&] {
        std::uint64_t sum = 0;
        for (const CellId cell : cells(k))
          for (const HalfFacetId mate : mates(k, cell))
            if (!is_boundary(mate)) sum += cell_of<3>(mate).value;
        return sum;
      },
      [&] {
        std::uint64_t sum = 0;
        for (std::size_t c = 0; c < flat.cells.size(); ++c)
          for (std::size_t h = 4 * c; h < 4 * c + 4; ++h)
            if (flat.mates[h] != kNone) sum += flat.mates[h] / 4;
        return sum;
      });
}

/// The same with a range that leaves the boundary out.
void range_neighbours_alone(benchmark::State& state) {
  const Complex<3>& k = indexed(state).body->complex;
  const FlatMesh<3>& flat = indexed(state).body->flat;
  compare(
      state, "ns/tet", k.cell_count(),
      [&] {
        std::uint64_t sum = 0;
        for (const CellId cell : cells(k))
          for (const CellId neighbour : neighbours(k, cell)) sum += neighbour.value;
        return sum;
      },
      [&] {
        std::uint64_t sum = 0;
        for (std::size_t c = 0; c < flat.cells.size(); ++c)
          for (std::size_t h = 4 * c; h < 4 * c + 4; ++h)
            if (flat.mates[h] != kNone) sum += flat.mates[h] / 4;
        return sum;
      });
}

/// The same as one stream of plain numbers, without a branch, so that compilers use vectors: the
/// highest bit of an entry that is no mate is set.
void range_mates(benchmark::State& state) {
  const Complex<3>& k = indexed(state).body->complex;
  const FlatMesh<3>& flat = indexed(state).body->flat;
  compare(
      state, "ns/tet", k.cell_count(),
      [&] {
        constexpr int kHighest = 8 * sizeof(Index) - 1;
        std::uint64_t sum = 0;
        for (const Index mate : as_numbers(k.mates())) sum += mate / 4 & ((mate >> kHighest) - 1);
        return sum;
      },
      [&] {
        std::uint64_t sum = 0;
        for (const std::uint32_t mate : flat.mates) sum += mate != kNone ? mate / 4 : 0;
        return sum;
      });
}

void range_boundary(benchmark::State& state) {
  const Complex<3>& k = indexed(state).body->complex;
  const FlatMesh<3>& flat = indexed(state).body->flat;
  compare(
      state, "ns/tet", k.cell_count(),
      [&] {
        std::uint64_t sum = 0;
        for (const HalfFacetId h : boundary_facets(k)) sum += h.value;
        return sum;
      },
      [&] {
        std::uint64_t sum = 0;
        for (std::size_t h = 0; h < flat.mates.size(); ++h)
          if (flat.mates[h] == kNone) sum += h;
        return sum;
      });
}

void range_interior(benchmark::State& state) {
  const Complex<3>& k = indexed(state).body->complex;
  const FlatMesh<3>& flat = indexed(state).body->flat;
  compare(
      state, "ns/tet", k.cell_count(),
      [&] {
        std::uint64_t sum = 0;
        for (const HalfFacetId h : interior_facets(k)) sum += h.value;
        return sum;
      },
      [&] {
        std::uint64_t sum = 0;
        for (std::size_t h = 0; h < flat.mates.size(); ++h)
          if (h < flat.mates[h] && flat.mates[h] != kNone) sum += h;
        return sum;
      });
}

/// Adds something of each corner to its vertex, as who assembles does.
void range_corners(benchmark::State& state) {
  const Complex<3>& k = indexed(state).body->complex;
  const FlatMesh<3>& flat = indexed(state).body->flat;
  std::vector<std::uint32_t> to(k.vertex_count()), flat_to(k.vertex_count());
  compare(
      state, "ns/tet", k.cell_count(),
      [&] {
        for (const CellId cell : cells(k))
          for (const CornerId corner : corners(k, cell))
            to[k.vertex(corner).value] += static_cast<std::uint32_t>(corner.value);
        return to[0];
      },
      [&] {
        for (std::size_t c = 0; c < flat.cells.size(); ++c)
          for (std::size_t i = 0; i < 4; ++i)
            flat_to[flat.cells[c][i]] += static_cast<std::uint32_t>(4 * c + i);
        return flat_to[0];
      });
}

/// All stars by the vertex-to-cell index; of each cell around a vertex something is read.
void range_stars(benchmark::State& state) {
  const Indexed& all = indexed(state);
  const Complex<3>& k = all.body->complex;
  const FlatMesh<3>& flat = all.body->flat;
  compare(
      state, "ns/incidence", k.half_facet_count(),
      [&] {
        std::uint64_t sum = 0;
        for (const VertexId v : vertices(k))
          for (const CornerId corner : all.index[v]) sum += k.vertices(cell_of<3>(corner))[0].value;
        return sum;
      },
      [&] {
        std::uint64_t sum = 0;
        for (std::uint32_t v = 0; v < flat.vertices; ++v)
          for (std::uint32_t n = all.first[v]; n < all.first[v + 1]; ++n)
            sum += flat.cells[all.corners[n] / 4][0];
        return sum;
      });
}

/// All stars through the mates: the walker beside a flood with a mark per cell.
void compare_walks(benchmark::State& state, const Complex<3>& k, const FlatMesh<3>& flat) {
  compare(
      state, "ns/incidence", k.half_facet_count(),
      [&] {
        std::uint64_t sum = 0;
        StarWalker walker(k);
        for (const VertexId v : vertices(k))
          for (const CornerId corner : walker.around(v)) sum += corner.value;
        return sum;
      },
      [&] {
        std::uint64_t sum = 0;
        for_each_star(flat, [&](std::uint32_t, const auto& star) {
          for (const std::uint32_t corner : star) sum += corner;
        });
        return sum;
      });
}

void range_walks(benchmark::State& state) {
  const Indexed& all = indexed(state);
  compare_walks(state, all.body->complex, all.body->flat);
}

/// The same where the tuples of cells are in no order, so that no branch on them can be foreseen.
void range_walks_of_turned_tuples(benchmark::State& state) {
  CellSoup<3> soup = kuhn_soup<3>(static_cast<int>(state.range(0)));
  support::Rng rng(3);
  for (Cell<3>& cell : soup.cells) rng.shuffle(cell);
  soup.signs = std::get<std::vector<std::int8_t>>(orient(soup));
  FlatMesh<3> flat = flat_mesh(soup);
  flat.match();
  const Complex<3> k = assemble(std::move(soup));
  compare_walks(state, k, flat);
}

/// All links, by the index.
void range_links(benchmark::State& state) {
  const Indexed& all = indexed(state);
  const Complex<3>& k = all.body->complex;
  const FlatMesh<3>& flat = all.body->flat;
  compare(
      state, "ns/incidence", k.half_facet_count(),
      [&] {
        std::uint64_t sum = 0;
        for (const VertexId v : vertices(k))
          for (const Facet<3>& facet : link(k, all.index[v]))
            sum += facet[0].value ^ facet[1].value ^ facet[2].value;
        return sum;
      },
      [&] {
        std::uint64_t sum = 0;
        for (std::uint32_t v = 0; v < flat.vertices; ++v)
          for (std::uint32_t n = all.first[v]; n < all.first[v + 1]; ++n) {
            const auto& cell = flat.cells[all.corners[n] / 4];
            std::array<std::uint32_t, 3> facet{};
            for (std::uint32_t i = 0, to = 0; i < 4; ++i)
              if (i != all.corners[n] % 4) facet[to++] = cell[i];
            sum += facet[0] ^ facet[1] ^ facet[2];
          }
        return sum;
      });
}

/// Around one edge of each cell.
void range_ridges(benchmark::State& state) {
  const Complex<3>& k = indexed(state).body->complex;
  const FlatMesh<3>& flat = indexed(state).body->flat;
  const auto next = [&](std::uint32_t& enter, std::uint32_t& leave) {
    const std::uint32_t mate = flat.mates[leave];
    if (mate == kNone) return false;
    const std::uint32_t kept = flat.cells[enter / 4][enter % 4], base = mate - mate % 4;
    std::uint32_t i = 0;
    while (flat.cells[mate / 4][i] != kept) ++i;
    enter = mate;
    leave = base + i;
    return true;
  };
  compare(
      state, "ns/tet", k.cell_count(),
      [&] {
        std::uint64_t sum = 0;
        for (const CellId cell : cells(k))
          for (const AtRidge at : around_ridge(k, corners(k, cell)[0], corners(k, cell)[1]))
            sum += at.enter.value;
        return sum;
      },
      [&] {
        std::uint64_t sum = 0;
        for (std::uint32_t c = 0; c < flat.cells.size(); ++c) {
          std::uint32_t back = 4 * c, back_leave = 4 * c + 1;
          while (next(back, back_leave) && back != 4 * c) {
          }
          const bool closed = back == 4 * c && flat.mates[back_leave] != kNone;
          std::uint32_t enter = closed ? 4 * c + 1 : back_leave, leave = closed ? 4 * c : back;
          const std::uint32_t first = enter;
          do sum += enter;
          while (next(enter, leave) && enter != first);
        }
        return sum;
      });
}

/// The edges, listed once, as spans; something is looked up for one end.
void range_simplices(benchmark::State& state) {
  const Simplices<3> edges(indexed(state).body->complex, 1);
  std::vector<std::uint32_t> flat;
  for (const auto edge : edges)
    for (const VertexId v : edge) flat.push_back(static_cast<std::uint32_t>(v.value));
  std::vector<std::uint32_t> of_vertex(indexed(state).body->flat.vertices, 3);
  compare(
      state, "ns/edge", edges.count(),
      [&] {
        std::uint64_t sum = 0;
        for (const std::span<const VertexId> edge : edges)
          sum += of_vertex[edge[0].value] ^ edge[1].value;
        return sum;
      },
      [&] {
        std::uint64_t sum = 0;
        for (std::size_t n = 0; n < flat.size(); n += 2) sum += of_vertex[flat[n]] ^ flat[n + 1];
        return sum;
      });
}

void bodies(benchmark::internal::Benchmark* b) {
  b->Args({40, 0})->Args({40, 1})->Args({100, 0});
  b->ArgNames({"cubes", "shuffled"})->Iterations(7)->UseManualTime()->Unit(benchmark::kMillisecond);
}

BENCHMARK(range_neighbours)->Apply(bodies);
BENCHMARK(range_neighbours_alone)->Apply(bodies);
BENCHMARK(range_mates)->Apply(bodies);
BENCHMARK(range_boundary)->Apply(bodies);
BENCHMARK(range_interior)->Apply(bodies);
BENCHMARK(range_corners)->Apply(bodies);
BENCHMARK(range_stars)->Apply(bodies)->Args({100, 1});
BENCHMARK(range_walks)->Apply(bodies);
BENCHMARK(range_walks_of_turned_tuples)
    ->Arg(40)
    ->ArgName("cubes")
    ->Iterations(7)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(range_links)->Apply(bodies);
BENCHMARK(range_ridges)->Apply(bodies);
BENCHMARK(range_simplices)
    ->Args({40, 0})
    ->ArgNames({"cubes", "shuffled"})
    ->Iterations(7)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cleave::bench
