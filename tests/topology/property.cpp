#include "property.hpp"

#include <stdexcept>
#include <utility>

#include "cleave/support/dimensions.hpp"
#include "cleave/topology/assemble.hpp"

namespace cleave::topology {
namespace {

/// What is drawn; a Trial adds what follows from it.
template <int D>
struct Draw {
  support::MeshClass mesh_class{};
  support::CutClass cut_class{};
  std::uint64_t seed = 0;
  Mesh<D> mesh;
  std::vector<HalfFacetId> cut;
};

template <int D>
std::vector<support::CutClass> possible_cuts() {
  std::vector<support::CutClass> result;
  for (const auto cut_class : support::kCutClasses)
    if (support::can_occur(cut_class, D)) result.push_back(cut_class);
  return result;
}

/// A mesh and a cut of the classes that `size` stands for. Not every mesh has a cut of every class;
/// after thirty meshes the next class of meshes is tried.
template <int D>
Draw<D> draw(Rng rng, std::size_t size) {
  const auto cuts = possible_cuts<D>();
  Draw<D> result;
  result.cut_class = cuts[size % cuts.size()];
  const std::size_t first = size / cuts.size() + size % cuts.size();
  for (std::size_t attempt = 0; attempt < 30 * support::kMeshClasses.size(); ++attempt) {
    result.mesh_class =
        support::kMeshClasses[(first + attempt / 30) % support::kMeshClasses.size()];
    result.mesh = support::random_mesh<D>(result.mesh_class, rng);
    auto cut = support::random_cut<D>(result.mesh, result.cut_class, rng);
    if (!cut) continue;
    result.cut = std::move(*cut);
    result.seed = rng.next();
    return result;
  }
  throw std::logic_error("no mesh has a cut of class " + std::string(name(result.cut_class)));
}

/// The same with the given cells only; facets that are not interior any more leave the cut.
template <int D>
Draw<D> with_cells(const Draw<D>& from, const std::vector<std::size_t>& cells) {
  Draw<D> result = from;
  result.mesh.cells.clear();
  result.cut.clear();
  std::vector<std::size_t> number(from.mesh.cells.size(), cells.size());
  for (const std::size_t c : cells) {
    number[c] = result.mesh.cells.size();
    result.mesh.cells.push_back(from.mesh.cells[c]);
  }
  const auto mates = support::mates_of<D>(result.mesh.cells);
  for (const HalfFacetId h : from.cut) {
    const std::size_t c = number[cell_of<D>(h).value];
    if (c == cells.size()) continue;
    const auto moved = half_facet<D>({static_cast<Index>(c)}, local_index<D>(h));
    if (mates[moved.value]) result.cut.push_back(moved);
  }
  return result;
}

/// Smaller draws: without some cells (but never without all), or without some of the cut.
template <int D>
rc::Seq<Draw<D>> shrink(const Draw<D>& from) {
  std::vector<std::size_t> cells(from.mesh.cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) cells[c] = c;
  const auto fewer_cells =
      rc::seq::filter(rc::shrink::removeChunks(cells),
                      [](const std::vector<std::size_t>& some) { return !some.empty(); });
  return rc::seq::concat(
      rc::seq::map(fewer_cells,
                   [=](const std::vector<std::size_t>& some) { return with_cells<D>(from, some); }),
      rc::seq::map(rc::shrink::removeChunks(from.cut), [=](std::vector<HalfFacetId> some) {
        Draw<D> result = from;
        result.cut = std::move(some);
        return result;
      }));
}

template <int D>
Trial<D> judge(Draw<D> drawn) {
  Trial<D> trial;
  trial.mesh_class = drawn.mesh_class;
  trial.cut_class = drawn.cut_class;
  trial.seed = drawn.seed;
  trial.signs = support::coherent_signs<D>(drawn.mesh.cells).value();
  trial.regularized = support::algorithm_3<D>(drawn.mesh.cells, {});
  trial.expected = support::algorithm_3<D>(drawn.mesh.cells, drawn.cut);
  trial.mesh = std::move(drawn.mesh);
  trial.cut = std::move(drawn.cut);
  return trial;
}

/// FNV-1a: the same on every platform.
std::uint64_t hash(const std::string& text) {
  std::uint64_t value = 0xcbf29ce484222325U;
  for (const char c : text) value = (value ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return value;
}

/// RapidCheck starts every property from the same seed; `salt` gives each its own cases.
template <int D>
rc::Gen<Trial<D>> trials(std::uint64_t salt) {
  const rc::Gen<Draw<D>> draws([salt](const rc::Random& random, int size) {
    rc::Random source = random;
    return rc::shrinkable::shrinkRecur(
        draw<D>(Rng(source.next() ^ salt), static_cast<std::size_t>(size)),
        [](const Draw<D>& drawn) { return shrink<D>(drawn); });
  });
  return rc::gen::map(draws, judge<D>);
}

template <int D>
Coverage::Marks marks_of(const Trial<D>& trial) {
  const auto opened = support::opened_facets<D>(trial.regularized, trial.expected);
  std::set<Facet<D>> facets;
  for (const HalfFacetId h : trial.cut)
    facets.insert(support::sorted_facet<D>(trial.mesh.cells, h));
  bool branching = false;
  for (const auto& [ridge, degree] : support::ridge_degrees<D>(trial.mesh.cells, trial.cut))
    branching = branching || degree >= 3;
  const auto mates = support::mates_of<D>(trial.mesh.cells);
  const bool closed = std::all_of(mates.begin(), mates.end(), [](const auto& m) { return m; });
  const auto components = support::components<D>(trial.mesh.cells);
  const bool pieces =
      std::any_of(components.begin(), components.end(), [](std::size_t c) { return c > 0; });
  const std::size_t vertices = support::used_vertices<D>(trial.regularized);
  return {support::used_vertices<D>(trial.expected) > vertices,
          opened.size() < facets.size(),
          branching,
          vertices > support::used_vertices<D>(trial.mesh.cells),
          closed,
          pieces};
}

/// "T1/D3" -> "T1".
std::string suite_name() {
  const std::string suite =
      ::testing::UnitTest::GetInstance()->current_test_info()->test_suite_name();
  return suite.substr(0, suite.find('/'));
}

}  // namespace

template <int D>
Complex<D> Trial<D>::complex() const {
  return assemble_regularized<D>({mesh.cells, mesh.vertex_count, signs}).complex;
}

template <int D>
std::ostream& operator<<(std::ostream& out, const Trial<D>& trial) {
  out << name(trial.mesh_class) << " mesh, " << name(trial.cut_class) << " cut, seed " << trial.seed
      << "\ncells:";
  for (const Cell<D>& cell : trial.mesh.cells) {
    out << " (";
    for (std::size_t i = 0; i < cell.size(); ++i) out << (i == 0 ? "" : " ") << cell[i].value;
    out << ')';
  }
  out << "\ncut half-facets:";
  for (const HalfFacetId h : trial.cut) out << ' ' << h.value;
  return out << '\n';
}

template <int D>
void for_all(const std::function<void(const Trial<D>&)>& property) {
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  const std::string test = std::string(info->test_suite_name()) + "." + info->name();
  const std::string suite = suite_name();
  const auto gen = trials<D>(hash(test));
  EXPECT_TRUE(rc::check(test, [&] {
    const Trial<D> trial = *gen;
    coverage().record(suite, D, trial.mesh_class, trial.cut_class, marks_of<D>(trial));
    property(trial);
  })) << "see the counterexample above";
}

#define CLEAVE_INSTANTIATE(D)                                            \
  template struct Trial<D>;                                              \
  template std::ostream& operator<< <D>(std::ostream&, const Trial<D>&); \
  template void for_all<D>(const std::function<void(const Trial<D>&)>&);
CLEAVE_FOR_EACH_DIMENSION(CLEAVE_INSTANTIATE)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::topology
