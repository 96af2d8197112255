#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <thread>

#include "cleave/topology/arrays.hpp"
#include "cleave/topology/betti.hpp"
#include "cleave/topology/boundary.hpp"
#include "cleave/topology/certify.hpp"
#include "cleave/topology/check.hpp"
#include "cleave/topology/dual_graph.hpp"
#include "cleave/topology/explain.hpp"
#include "cleave/topology/fix_it.hpp"
#include "cleave/topology/incision.hpp"
#include "cleave/topology/link_view.hpp"
#include "cleave/topology/locate.hpp"
#include "cleave/topology/pieces.hpp"
#include "cleave/topology/ranges.hpp"
#include "cleave/topology/ridge_walk.hpp"
#include "cleave/topology/simplices.hpp"
#include "cleave/topology/star_walker.hpp"
#include "cleave/topology/summary.hpp"
#include "cleave/topology/vertex_graph.hpp"
#include "cleave/topology/vertex_index.hpp"
#include "view_laws.hpp"

/// What several threads may do at once. The preset `tsan` builds this under the thread sanitizer,
/// which is what judges it; elsewhere it checks that the answers are those of one thread.
namespace cleave::views {
namespace {

constexpr int kThreads = 4;

/// Calls work(0), work(1), .. each on a thread of its own, all at once.
void at_once(const std::function<void(int)>& work) {
  std::vector<std::thread> threads;
  for (int n = 0; n < kThreads; ++n) threads.emplace_back(work, n);
  for (std::thread& thread : threads) thread.join();
}

/// Takes in numbers; two answers with the same digest are taken for the same.
class Digest {
 public:
  void add(std::uint64_t number) { value_ = (value_ ^ number) * 0x100000001b3u; }
  template <class Tag>
  void add(Id<Tag> id) {
    add(id.value);
  }
  template <class Values>
  requires requires(const Values& values) { values.begin(); }
  void add(const Values& values) {
    for (const auto& value : values) add(value);
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

/// Everything that can be asked of a complex, and of its cells as a soup.
template <int D>
std::uint64_t all_answers(const Complex<D>& k, const VertexIndex<D>& index,
                          const CellSoup<D>& soup) {
  Digest digest;
  digest.add(k.cells());
  StarWalker walker(k);
  for (const CornerId h : corners(k)) {
    digest.add(k.mate(h).value_or(HalfFacetId{kNoIndex}));
    digest.add(k.vertex(h));
    digest.add(k.facet(h));
    digest.add(static_cast<std::uint64_t>(k.facet_sign(h)));
    if (const auto found = find_half_facet(k, k.facet(h))) digest.add(found->half_facet);
  }
  for (const CellId cell : cells(k)) {
    digest.add(neighbours(k, cell));
    if constexpr (D >= 2)
      for (const AtRidge at : around_ridge(k, half_facet<D>(cell, 0), half_facet<D>(cell, 1)))
        digest.add(at.enter);
  }
  for (const VertexId v : vertices(k)) {
    digest.add(k.a_corner(v).value_or(CornerId{kNoIndex}));
    digest.add(star(k, v));
    digest.add(index[v]);
    digest.add(link(k, walker.around(v)));
    digest.add(link(k, std::span(&v, 1)));
  }
  digest.add(boundary(k));
  digest.add(boundary_facets(k));
  digest.add(pieces(k).of_cell);
  const FacetSet every = FacetSet::all(k);
  digest.add(every.half_facets());
  if (!every.empty()) {
    const HalfFacetId one = every.half_facets()[every.size() / 2];
    digest.add(explain(k, every, one).size());
    digest.add(separating_facets(k, FacetSet(), one).half_facets());
  }
  for (int dimension = 0; dimension <= D; ++dimension)
    for (const auto simplex : Simplices<D>(k, dimension)) digest.add(simplex);
  digest.add(num_edges(DualGraph<D>(k)));
  digest.add(VertexGraph(k).edge_count());
  if constexpr (D >= 2) digest.add(boundary_complex(k).index());

  const CellView<D> view(soup);
  digest.add(check(view).size());
  digest.add(orient(view).index());
  digest.add(summarize(view).pieces);
  digest.add(betti_numbers(soup).value());
  digest.add(as_numbers(view.cells));
  const std::array<Facet<D>, 1> facet = {k.facet({0})};
  digest.add(locate_facets<D>(view.cells, facet)[0].value());
  digest.add(certify<D>(view.cells, every.half_facets(), k.cells()).has_value() ? 1 : 0);
  return digest.value();
}

template <int D>
void expect_const_is_concurrent(const Complex<D>& k) {
  const VertexIndex<D> index(k);
  CellSoup<D> soup{{k.cells().begin(), k.cells().end()}, k.vertex_count(), {}};
  const std::uint64_t expected = all_answers(k, index, soup);
  at_once([&](int) { EXPECT_EQ(all_answers(k, index, soup), expected); });
}

TEST(Threads, AskOneComplexAtOnce) {
  expect_const_is_concurrent(complex_of<1>(kuhn_cube<1>(20)));
  expect_const_is_concurrent(complex_of<2>(kuhn_cube<2>(5)));
  expect_const_is_concurrent(complex_of<3>(kuhn_cube<3>(4)));
  expect_const_is_concurrent(complex_of<4>(kuhn_cube<4>(3)));
}

std::uint64_t all_answers(const Incision<3>& incision, const FacetSet& cut) {
  Digest digest;
  digest.add(incision.complex().cells());
  digest.add(incision.original_vertex_count());
  for (const VertexId v : vertices(incision.complex())) digest.add(incision.original(v));
  for (const OpenedFacet& facet : incision.opened()) digest.add(facet.former_mate);
  digest.add(incision.shut().half_facets());
  digest.add(incision.scored().half_facets());
  digest.add(incision.facets(cut.half_facets()).half_facets());
  for (const Merge& merge : incision.planned_merges(cut)) digest.add(merge.into);
  digest.add(canonical(incision));
  digest.add(incision.can_undo() ? 1 : 0);
  Incision<3> copy = incision;
  copy.forget_steps();
  digest.add(copy.complex().vertex_count());
  return digest.value();
}

TEST(Threads, AskOneIncisionAtOnce) {
  const auto k = complex_of<3>(kuhn_cube<3>(4));
  Incision<3> incision(k);
  const FacetSet cut = dense_cut(k);
  incision.cut(cut);
  const std::uint64_t expected = all_answers(incision, cut);
  at_once([&](int) { EXPECT_EQ(all_answers(incision, cut), expected); });
}

// Also from copies of one complex, and with one facet set and one index for all.
TEST(Threads, CutComplexesOfTheirOwnAtOnce) {
  const auto k = complex_of<3>(kuhn_cube<3>(4));
  const FacetSet cut = dense_cut(k);
  Complex<3> expected = k;
  unglue(expected, cut, Verify::all);
  at_once([&](int n) {
    Incision<3> incision(k);
    for (int again = 0; again < 3; ++again) {
      incision.cut(cut, n % 2 == 0 ? Verify::touched : Verify::all);
      EXPECT_TRUE(std::ranges::equal(incision.complex().cells(), expected.cells()));
      incision.stitch(cut);
      EXPECT_TRUE(std::ranges::equal(incision.complex().cells(), k.cells()));
      incision.undo();
      incision.undo();
    }
    Complex<3> own = k;
    unglue(own, cut);
    EXPECT_TRUE(std::ranges::equal(own.cells(), expected.cells()));
  });
}

template <int D>
void expect_same_with_threads(int nodes) {
  const auto grid = kuhn_cube<D>(nodes);
  const CellSoup<D> soup{grid.cells, grid.vertex_count,
                         support::coherent_signs<D>(grid.cells).value()};
  const Complex<D> expected = assemble(soup);
  for (const int threads : {2, 3}) {
    RunOptions options;
    options.threads = threads;
    const Complex<D> k = assemble(soup, options);
    EXPECT_TRUE(std::ranges::equal(k.mates(), expected.mates()));
    for (const VertexId v : vertices(k)) EXPECT_EQ(k.a_corner(v), expected.a_corner(v));
  }
}

TEST(Threads, ShareAnAssembly) {
  expect_same_with_threads<1>(20000);
  expect_same_with_threads<2>(120);
  expect_same_with_threads<3>(20);
  expect_same_with_threads<4>(8);
}

}  // namespace
}  // namespace cleave::views
