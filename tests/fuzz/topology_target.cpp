// From a soup to check to assemble to cuts and stitches to certify, in dimensions 1 to 4. Each step
// is compared with the plain references of tests/support, which share no code with the library.
#include <algorithm>
#include <optional>
#include <set>

#include "../topology/witness.hpp"
#include "cleave/support/reference.hpp"
#include "cleave/topology/assemble.hpp"
#include "cleave/topology/certify.hpp"
#include "cleave/topology/check.hpp"
#include "cleave/topology/incision.hpp"
#include "soups.hpp"
#include "targets.hpp"

namespace cleave::fuzz {
namespace {

using namespace topology;

template <class Kind>
std::size_t count(const std::vector<Violation>& violations) {
  return static_cast<std::size_t>(
      std::count_if(violations.begin(), violations.end(),
                    [](const Violation& v) { return std::holds_alternative<Kind>(v); }));
}

/// What keeps `assemble` from a complex: all but orphans.
std::size_t grave(const std::vector<Violation>& violations) {
  return violations.size() - count<OrphanVertex>(violations);
}

/// Every violation stands by its witness alone, and each kind is found as often as it is there.
template <int D>
std::vector<Violation> check_and_compare(const CellSoup<D>& soup) {
  const auto found = check(soup);
  for (const Violation& violation : found) {
    const std::string why = refute<D>(violation, soup);
    if (!why.empty())
      violated("a violation stands", __FILE__, __LINE__, describe(violation) + ": " + why);
  }
  std::size_t unsound = 0;
  std::set<std::set<VertexId>> distinct;
  for (const Cell<D>& cell : soup.cells) {
    const std::set<VertexId> vertices(cell.begin(), cell.end());
    if (vertices.size() < cell.size() || vertices.rbegin()->value >= soup.vertex_count) ++unsound;
    distinct.insert(vertices);
  }
  FUZZ_REQUIRE((unsound == 0) ==
               (count<DegenerateCell>(found) + count<VertexOutOfRange>(found) == 0));
  if (unsound > 0) return found;
  FUZZ_REQUIRE(count<DuplicateCell>(found) == soup.cells.size() - distinct.size());
  std::size_t crowded = 0;
  for (const auto& [facet, sides] : support::facets_of<D>(soup.cells))
    if (sides.size() >= 3) ++crowded;
  FUZZ_REQUIRE(count<FacetInThreeCells>(found) == crowded);
  if (crowded > 0 || distinct.size() < soup.cells.size()) return found;
  std::size_t irregular = 0;
  for (const auto& [vertex, parts] : support::parts_of_stars<D>(soup.cells))
    if (parts > 1) ++irregular;
  FUZZ_REQUIRE(count<NotCutRegular>(found) == irregular);
  const auto signs = support::coherent_signs<D>(soup.cells);
  FUZZ_REQUIRE(signs.has_value() == (count<NonOrientable>(found) == 0));
  const auto oriented = orient(soup);
  FUZZ_REQUIRE(signs.has_value() == std::holds_alternative<std::vector<std::int8_t>>(oriented));
  if (signs) FUZZ_REQUIRE(std::get<0>(oriented) == *signs);
  return found;
}

/// The complex, or nothing if `make` throws; then it must throw violations that check has found.
template <class Make>
auto made_unless(bool refused, const Make& make) -> std::optional<decltype(make())> {
  try {
    auto result = make();
    FUZZ_REQUIRE(!refused);
    return result;
  } catch (const InvalidComplex& error) {
    FUZZ_REQUIRE(refused && grave(error.violations) > 0);
    return std::nullopt;
  }
}

/// certify accepts `after` with any one corner renamed iff the partition is the same still.
template <int D>
void certify_disturbed(std::span<const Cell<D>> before, std::span<const HalfFacetId> cut,
                       std::vector<Cell<D>> after, Choices& choices) {
  if (after.empty()) return;
  const std::vector<Cell<D>> expected = after;
  const Cell<D>& from = expected[choices.below(std::min<std::size_t>(after.size(), 256))];
  Cell<D>& into = after[choices.below(std::min<std::size_t>(after.size(), 256))];
  into[choices.below(into.size())] = from[choices.below(from.size())];
  FUZZ_REQUIRE(!certify<D>(before, cut, after).has_value() ==
               support::same_partition<D>(expected, after));
}

/// The state after some cuts is what Algorithm 3 makes of all scored facets at once (T8), sound,
/// and certified; and what the incision says about it is true (T3).
template <int D>
void require_state(const Incision<D>& incision, const std::vector<Cell<D>>& original,
                   const std::set<HalfFacetId>& scored) {
  const Complex<D>& k = incision.complex();
  const std::vector<HalfFacetId> cut(scored.begin(), scored.end());
  const std::span<const Cell<D>> before(original);
  FUZZ_REQUIRE(support::same_partition<D>(k.cells(), support::algorithm_3<D>(before, cut)));
  FUZZ_REQUIRE(!certify<D>(before, cut, k.cells()).has_value());
  std::vector<std::int8_t> signs;
  for (std::uint32_t c = 0; c < k.cell_count(); ++c)
    signs.push_back(static_cast<std::int8_t>(k.sign({c})));
  FUZZ_REQUIRE(
      grave(check(CellSoup<D>{{k.cells().begin(), k.cells().end()}, k.vertex_count(), signs},
                  Level::cut_regular)) == 0);
  const auto mates = support::mates_of<D>(k.cells());
  for (std::uint32_t h = 0; h < mates.size(); ++h) FUZZ_REQUIRE(k.mate({h}) == mates[h]);
  std::vector<HalfFacetId> opened;
  for (const OpenedFacet& facet : incision.opened()) opened.push_back(facet.half_facet);
  FUZZ_REQUIRE(opened == support::opened_facets<D>(before, k.cells()));
  FUZZ_REQUIRE((incision.scored() == FacetSet::of_lesser(cut)));
  FUZZ_REQUIRE(opened.size() + incision.shut().size() == scored.size());
}

/// Some interior facets of the original, each by either of its half-facets.
std::vector<HalfFacetId> some_facets(const std::vector<HalfFacetId>& interior,
                                     const std::vector<std::optional<HalfFacetId>>& mates,
                                     Choices& choices) {
  const bool everything = choices.below(8) == 0;
  std::vector<HalfFacetId> chosen;
  for (const HalfFacetId h : interior)
    if (everything || choices.bit()) chosen.push_back(choices.bit() ? h : *mates[h.value]);
  return chosen;
}

/// The scored sets that undo and redo walk along.
class History {
 public:
  const std::set<HalfFacetId>& now() const { return states_[at_]; }

  /// A step that changes nothing is none.
  void go_to(const std::set<HalfFacetId>& scored) {
    if (scored == now()) return;
    states_.resize(at_ + 1);
    states_.push_back(scored);
    ++at_;
  }
  bool can_undo() const { return at_ > 0; }
  bool can_redo() const { return at_ + 1 < states_.size(); }
  void undo() { --at_; }
  void redo() { ++at_; }

 private:
  std::vector<std::set<HalfFacetId>> states_{{}};
  std::size_t at_ = 0;
};

/// Cuts, stitches, undoes and redoes; each state is what its scored set says (T8, T12). At the end
/// all is stitched, which gives back the start.
template <int D>
void cut_and_stitch(const Complex<D>& k, Choices& choices) {
  const std::vector<Cell<D>> original(k.cells().begin(), k.cells().end());
  const auto interior = support::interior_facets<D>(original);
  const auto mates = support::mates_of<D>(original);
  Incision<D> incision(k);
  History history;
  for (std::size_t step = 2 + choices.below(4); step > 0; --step) {
    const std::size_t what = choices.below(5);
    FUZZ_REQUIRE(incision.can_undo() == history.can_undo());
    FUZZ_REQUIRE(incision.can_redo() == history.can_redo());
    if (what == 3 && history.can_undo()) {
      incision.undo(Verify::all);
      history.undo();
    } else if (what == 4 && history.can_redo()) {
      incision.redo(Verify::all);
      history.redo();
    } else {
      const auto chosen = some_facets(interior, mates, choices);
      const bool stitches = what == 2;
      auto scored = history.now();
      for (const HalfFacetId h : chosen) {
        const HalfFacetId facet = std::min(h, *mates[h.value]);
        if (stitches)
          scored.erase(facet);
        else
          scored.insert(facet);
      }
      if (stitches)
        incision.stitch(incision.facets(chosen), Verify::all);
      else
        incision.cut(incision.facets(chosen), Verify::all);
      history.go_to(scored);
    }
    require_state(incision, original, history.now());
  }
  const std::vector<HalfFacetId> cut(history.now().begin(), history.now().end());
  const auto cells = incision.complex().cells();
  certify_disturbed<D>(original, cut, {cells.begin(), cells.end()}, choices);
  incision.stitch(incision.scored(), Verify::all);
  FUZZ_REQUIRE(std::equal(original.begin(), original.end(), incision.complex().cells().begin()));
}

template <int D>
void run(Choices& choices) {
  CellSoup<D> soup = soup_of<D>(choices);
  const auto found = check_and_compare(soup);
  // Levels above cut-regular keep nobody from a complex.
  const std::size_t above = count<PinchedSimplex>(found) + count<BadVertexLink>(found);
  made_unless(grave(found) > above, [&] { return assemble(soup); });
  if (count<OrientationConflict>(found) > 0) {
    auto oriented = orient(soup);
    if (auto* signs = std::get_if<std::vector<std::int8_t>>(&oriented)) soup.signs = *signs;
  }
  const bool refused =
      grave(found) > above + count<NotCutRegular>(found) + count<OrientationConflict>(found);
  const auto made = made_unless(refused, [&] { return assemble_regularized(soup); });
  if (!made) return;
  FUZZ_REQUIRE(
      support::same_partition<D>(made->complex.cells(), support::algorithm_3<D>(soup.cells, {})));
  FUZZ_REQUIRE(!certify<D>(soup.cells, {}, made->complex.cells()).has_value());
  FUZZ_REQUIRE(made->complex.vertex_count() == soup.vertex_count + made->splits.size());
  cut_and_stitch(made->complex, choices);
}

}  // namespace

void fuzz_topology(Bytes bytes) {
  Choices choices(bytes);
  switch (choices.below(4)) {
    case 0:
      return run<1>(choices);
    case 1:
      return run<2>(choices);
    case 2:
      return run<3>(choices);
    default:
      return run<4>(choices);
  }
}

}  // namespace cleave::fuzz
