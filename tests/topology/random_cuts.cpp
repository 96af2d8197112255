// Counts what goes wrong in random cuts of random meshes, in dimensions 1 to 4, against Algorithm 3
// word for word (support/reference.hpp). Usage: random_cuts CUTS [SEED [THREADS]]. The table does
// not depend on THREADS. Exit status 1 if anything is wrong.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "cleave/support/cuts.hpp"
#include "cleave/support/random_meshes.hpp"
#include "cleave/support/reference.hpp"
#include "cleave/topology/assemble.hpp"
#include "cleave/topology/certify.hpp"
#include "cleave/topology/unglue.hpp"

namespace cleave::topology {
namespace {

using support::kCutClasses;
using support::kMeshClasses;
using support::Mesh;
using support::Rng;

template <int D>
using Cells = std::vector<Cell<D>>;

/// What is counted. Facets are counted once, not per side.
enum Count {
  kCuts,
  kFacets,    // asked for
  kOpened,    // boundary after the cut
  kShut,      // asked for and interior still
  kWrong,     // opened without having been asked for
  kMissed,    // opened by Algorithm 3 and not by unglue
  kPinched,   // vertices that Algorithm 3 would add to the result with an empty cut
  kDiffer,    // results that share corners otherwise than Algorithm 3's
  kMisnamed,  // facets that the relabelling calls opened and are not, or the other way round
  kRefused,   // results that certify rejects
  kMutants,   // results spoiled on purpose
  kCaught,    // those of them that certify rejects
  kMisjudged  // accepted though unlike Algorithm 3's result, or rejected though like it
};
constexpr std::array<const char*, 13> kColumns{
    "cuts",   "facets",   "opened",  "shut",    "wrong",  "missed",   "pinched",
    "differ", "misnamed", "refused", "mutants", "caught", "misjudged"};
constexpr std::array kErrors{kWrong, kMissed, kPinched, kDiffer, kMisnamed, kRefused, kMisjudged};

using Tally = std::array<std::uint64_t, kColumns.size()>;

Tally& operator+=(Tally& sum, const Tally& more) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += more[i];
  return sum;
}

struct Table {
  /// By dimension - 1, class of meshes, class of cuts.
  std::array<std::array<std::array<Tally, kCutClasses.size()>, kMeshClasses.size()>, 4> at{};

  Table& operator+=(const Table& more) {
    for (std::size_t d = 0; d < at.size(); ++d)
      for (std::size_t m = 0; m < kMeshClasses.size(); ++m)
        for (std::size_t c = 0; c < kCutClasses.size(); ++c) at[d][m][c] += more.at[d][m][c];
    return *this;
  }
  Tally total() const {
    Tally sum{};
    for (const auto& dimension : at)
      for (const auto& meshes : dimension)
        for (const Tally& tally : meshes) sum += tally;
    return sum;
  }
};

/// Spoils a result: renames one corner, takes a copy back, or splits a vertex at random.
template <int D>
Cells<D> mutant_of(Cells<D> cells, const Relabelling& change, Rng& rng) {
  const std::size_t kind = rng.below(3);
  if (kind == 1 && !change.splits.empty()) {
    const Split& split = rng.pick(change.splits);
    for (Cell<D>& cell : cells) std::replace(cell.begin(), cell.end(), split.vertex, split.parent);
    return cells;
  }
  Cell<D>& one = cells[rng.below(cells.size())];
  VertexId& corner = one[rng.below(one.size())];
  if (kind == 0) {
    corner = {static_cast<Index>(rng.below(change.vertices_after))};
    return cells;
  }
  const VertexId old = corner;
  const VertexId copy{static_cast<Index>(change.vertices_after)};
  for (Cell<D>& cell : cells)
    if (rng.chance(0.5)) std::replace(cell.begin(), cell.end(), old, copy);
  return cells;
}

template <int D>
struct Ground {
  Mesh<D> mesh;
  Complex<D> complex;  // of it, made cut-regular
  std::vector<HalfFacetId> interior;
  std::vector<std::optional<HalfFacetId>> mates;

  explicit Ground(Mesh<D> drawn)
      : mesh(std::move(drawn)),
        complex(assemble_regularized<D>(
                    {mesh.cells, mesh.vertex_count, support::coherent_signs<D>(mesh.cells).value()})
                    .complex),
        interior(support::interior_facets<D>(mesh.cells)),
        mates(support::mates_of<D>(mesh.cells)) {}

  bool is_open(const Cells<D>& after, HalfFacetId h) const {
    return support::sorted_facet<D>(after, h) != support::sorted_facet<D>(after, *mates[h.value]);
  }
};

/// Cuts and judges by sets of vertices alone; `cut` may repeat facets, by either half.
template <int D>
Tally judge(const Ground<D>& ground, const std::vector<HalfFacetId>& cut, Rng& rng) {
  Complex<D> k = ground.complex;
  const Relabelling change = unglue(k, FacetSet::of(k, cut));
  const Cells<D> after = std::move(k).cells();
  const Cells<D> expected = support::algorithm_3<D>(ground.mesh.cells, cut);

  std::vector<bool> asked(ground.mates.size()), named(ground.mates.size());
  for (const HalfFacetId h : cut) asked[std::min(h, *ground.mates[h.value]).value] = true;
  for (const OpenedFacet& opened : change.opened) named[opened.half_facet.value] = true;

  Tally tally{};
  tally[kCuts] = 1;
  for (const HalfFacetId h : ground.interior) {
    const bool open = ground.is_open(after, h);
    tally[kFacets] += asked[h.value];
    tally[kOpened] += open;
    tally[kShut] += asked[h.value] && !open;
    tally[kWrong] += open && !asked[h.value];
    tally[kMissed] += !open && ground.is_open(expected, h);
    tally[kMisnamed] += open != named[h.value];
  }
  for (const auto& [vertex, parts] : support::parts_of_stars<D>(after))
    tally[kPinched] += parts - 1;
  tally[kDiffer] += !support::same_partition<D>(after, expected);
  tally[kRefused] += certify<D>(ground.mesh.cells, cut, after).has_value();

  const Cells<D> mutant = mutant_of<D>(after, change, rng);
  const bool rejected = certify<D>(ground.mesh.cells, cut, mutant).has_value();
  tally[kMutants] = 1;
  tally[kCaught] = rejected;
  tally[kMisjudged] = rejected == support::same_partition<D>(mutant, expected);
  return tally;
}

/// One mesh of the class and one cut of every class that chance finds in it.
template <int D>
void cut_one_mesh(std::size_t mesh_class, Rng& rng, Table& table) {
  const Mesh<D> mesh = support::random_mesh<D>(kMeshClasses[mesh_class], rng);
  const Ground<D> ground(mesh);
  for (std::size_t c = 0; c < kCutClasses.size(); ++c)
    if (const auto cut = support::random_cut<D>(mesh, kCutClasses[c], rng))
      table.at[D - 1][mesh_class][c] += judge<D>(ground, *cut, rng);
}

/// Rounds are independent of each other: a round is one mesh of a class in dimensions 1 and 4, two
/// in dimension 3, three in dimension 2.
constexpr std::uint64_t kRoundsPerBlock = 12;

Table block(std::uint64_t seed, std::uint64_t number) {
  Table table;
  for (std::uint64_t i = 0; i < kRoundsPerBlock; ++i) {
    const std::uint64_t round = number * kRoundsPerBlock + i;
    Rng rng(Rng(seed).next() ^ Rng(round).next());
    const std::size_t mesh_class = round % kMeshClasses.size();
    cut_one_mesh<1>(mesh_class, rng, table);
    for (int n = 0; n < 3; ++n) cut_one_mesh<2>(mesh_class, rng, table);
    for (int n = 0; n < 2; ++n) cut_one_mesh<3>(mesh_class, rng, table);
    cut_one_mesh<4>(mesh_class, rng, table);
  }
  return table;
}

/// Blocks in order until there are `wanted` cuts; `threads` of them at a time.
Table run(std::uint64_t wanted, std::uint64_t seed, std::size_t threads) {
  Table sum;
  for (std::uint64_t first = 0;; first += threads) {
    std::vector<Table> tables(threads);
    std::vector<std::thread> running;
    for (std::size_t t = 0; t < threads; ++t)
      running.emplace_back([&tables, seed, first, t] { tables[t] = block(seed, first + t); });
    for (std::thread& thread : running) thread.join();
    for (const Table& table : tables) {
      sum += table;
      if (sum.total()[kCuts] >= wanted) return sum;
    }
    if (first / threads % 50 == 49) std::cerr << sum.total()[kCuts] << " cuts\n";
  }
}

void print_line(const std::string& dimension, std::string_view input, const Tally& tally) {
  std::cout << std::left << std::setw(4) << dimension << std::setw(18) << input << std::right;
  for (std::size_t i = 0; i < tally.size(); ++i)
    std::cout << std::setw(i == kFacets || i == kOpened || i == kShut ? 11 : 10) << tally[i];
  std::cout << '\n';
}

void print(const Table& table) {
  std::cout << std::left << std::setw(22) << "D   input" << std::right;
  for (std::size_t i = 0; i < kColumns.size(); ++i)
    std::cout << std::setw(i == kFacets || i == kOpened || i == kShut ? 11 : 10) << kColumns[i];
  std::cout << '\n';
  for (std::size_t d = 0; d < table.at.size(); ++d) {
    const std::string dimension = std::to_string(d + 1);
    Tally all{};
    std::array<Tally, kCutClasses.size()> by_cut{};
    for (std::size_t m = 0; m < kMeshClasses.size(); ++m) {
      Tally by_mesh{};
      for (std::size_t c = 0; c < kCutClasses.size(); ++c) {
        by_mesh += table.at[d][m][c];
        by_cut[c] += table.at[d][m][c];
      }
      print_line(dimension, std::string(name(kMeshClasses[m])) + " mesh", by_mesh);
      all += by_mesh;
    }
    for (std::size_t c = 0; c < kCutClasses.size(); ++c)
      if (by_cut[c][kCuts] > 0)
        print_line(dimension, std::string(name(kCutClasses[c])) + " cut", by_cut[c]);
    print_line(dimension, "all", all);
  }
  print_line("all", "", table.total());
}

}  // namespace
}  // namespace cleave::topology

int main(int argc, char** argv) {
  using namespace cleave::topology;
  const auto number = [&](int i, std::uint64_t otherwise) {
    return i < argc ? std::strtoull(argv[i], nullptr, 10) : otherwise;
  };
  const std::uint64_t cuts = number(1, 0), threads = number(3, 1);
  if (cuts == 0 || threads == 0 || argc > 4) {
    std::cerr << "usage: random_cuts CUTS [SEED [THREADS]]\n";
    return 2;
  }
  const Table table = run(cuts, number(2, 20001126), threads);
  print(table);
  const Tally total = table.total();
  const bool clean =
      std::all_of(kErrors.begin(), kErrors.end(), [&](Count error) { return total[error] == 0; });
  return clean && total[kCaught] > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
