#include <algorithm>
#include <cleave/support/reference.hpp>
#include <set>

#include "bodies.hpp"
#include "cleave/cutting/stroke.hpp"
#include "properties.hpp"
#include "rational.hpp"

namespace cleave::cutting {
namespace {

using bodies::Body;
using bodies::Rng;
using topology::HalfFacetId;

template <int D>
using Cells = std::vector<topology::Cell<D>>;

/// Strokes as their definition says, on plain sets: after every step the original cells are cut
/// anew along all scored facets, by Algorithm 3.
template <int D>
class Model {
 public:
  Model(const Body<D>& body, SelectOptions options)
      : original_(body.k.cells().begin(), body.k.cells().end()),
        now_(original_),
        points_(body.points),
        duals_(bodies::duals(body)),
        options_(options) {}

  void stroke(const Sweep<D>& sweep) {
    const std::set<HalfFacetId> by_others = scored_;
    std::set<HalfFacetId> own;
    rational::ClosestEnds ends;
    for (std::size_t k = 0; k < sweep.step_count(); ++k) {
      const auto chosen = choice(sweep, k, ends);
      for (const HalfFacetId h : support::interior_facets<D>(now_))
        if (options_.rule == Rule::dual_edge ? chosen.count(h) > 0
                                             : chosen.count(h) != own.count(h))
          if (!own.insert(h).second) own.erase(h);
      scored_ = by_others;
      scored_.insert(own.begin(), own.end());
      const std::vector<HalfFacetId> cut(scored_.begin(), scored_.end());
      now_ = support::algorithm_3<D>(original_, cut);
    }
    last_own_ = own;
  }

  const Cells<D>& cells() const { return now_; }
  std::vector<HalfFacetId> scored() const { return {scored_.begin(), scored_.end()}; }
  std::vector<HalfFacetId> last_own() const { return {last_own_.begin(), last_own_.end()}; }
  std::vector<HalfFacetId> opened() const { return support::opened_facets<D>(original_, now_); }

 private:
  /// dual_edge: what step k chooses; nearest_vertex: what the steps up to k choose, whose closest
  /// vertices `ends` are.
  std::set<HalfFacetId> choice(const Sweep<D>& sweep, std::size_t k,
                               rational::ClosestEnds& ends) const {
    const auto [first, last] = sweep.step(k);
    const auto step =
        std::span<const rational::Simplex<D>>(sweep.simplices).subspan(first, last - first);
    std::vector<HalfFacetId> chosen;
    if (options_.rule == Rule::dual_edge) {
      chosen = rational::dual_edge<D>(original_, duals_, step);
    } else {
      ends.merge(rational::closest_ends<D>(original_, points_, step, options_.ties));
      chosen = rational::nearest_vertex<D>(original_, ends);
    }
    return {chosen.begin(), chosen.end()};
  }

  Cells<D> original_, now_;
  std::vector<Point<D>> points_, duals_;
  SelectOptions options_;
  std::set<HalfFacetId> scored_, last_own_;
};

std::vector<HalfFacetId> list(const topology::FacetSet& set) {
  return {set.half_facets().begin(), set.half_facets().end()};
}

template <int D>
std::vector<HalfFacetId> list(std::span<const topology::OpenedFacet> opened) {
  std::vector<HalfFacetId> result;
  for (const topology::OpenedFacet& facet : opened) result.push_back(facet.half_facet);
  return result;
}

template <int D>
Sweep<D> any_stroke(const Body<D>& body, Rng& rng) {
  const Sweep<D> sweep = rng.chance(0.3)   ? bodies::full_crossing(body, rng)
                         : rng.chance(0.4) ? bodies::short_path(body, rng)
                                           : bodies::any_sweep(body, rng);
  return rng.chance(0.3) ? bodies::there_and_back(sweep) : sweep;
}

// Two strokes, step by step: the same facets scored and opened, the same partition of the corners.
template <int D>
void strokes_follow_the_model() {
  Rng rng = any_rng();
  Body<D> body = bodies::any_small<D>(rng);
  const SelectOptions options{rng.chance(0.6) ? Rule::dual_edge : Rule::nearest_vertex,
                              rng.chance(0.5) ? Ties::by_id : Ties::both};
  Model<D> model(body, options);
  topology::Incision<D> incision(body.k);
  for (int n = 0; n < 2; ++n) {
    const Sweep<D> sweep = any_stroke(body, rng);
    const StrokeResult result = cut_along(incision, body.points, sweep, options);
    model.stroke(sweep);
    RC_ASSERT(list(result.scored) == model.last_own());
    RC_ASSERT(list(incision.scored()) == model.scored());
    RC_ASSERT(list<D>(incision.opened()) == model.opened());
    RC_ASSERT(support::same_partition<D>(incision.complex().cells(), model.cells()));
  }
  RC_CLASSIFY(incision.scored().empty(), "nothing scored");
  RC_CLASSIFY(!incision.opened().empty(), "something opened");
  RC_CLASSIFY(!incision.shut().empty(), "something shut");
}

RC_GTEST_PROP(StrokeProperty, StrokesFollowTheModelInThePlane, ()) {
  strokes_follow_the_model<2>();
}
RC_GTEST_PROP(StrokeProperty, StrokesFollowTheModelInSpace, ()) { strokes_follow_the_model<3>(); }

/// Whether no facet is chosen by two steps.
template <int D>
bool steps_choose_apart(const Body<D>& body, const Sweep<D>& sweep) {
  const Selector<D> selector(body.k, body.points, {});
  topology::FacetSet chosen;
  for (std::size_t k = 0; k < sweep.step_count(); ++k) {
    const topology::FacetSet now = selector.select_step(sweep, k);
    if (!(chosen & now).empty()) return false;
    chosen = chosen | now;
  }
  return true;
}

// A blade drawn back along its path, within the stroke, changes nothing that is open, and scores
// nothing that was not scored on the way there. (dual_edge: if no facet was met twice on that way.)
template <int D>
void retrace_adds_nothing() {
  Rng rng = any_rng();
  Body<D> body = bodies::any_small<D>(rng);
  const SelectOptions options{rng.chance(0.5) ? Rule::dual_edge : Rule::nearest_vertex,
                              rng.chance(0.5) ? Ties::by_id : Ties::both};
  const Sweep<D> sweep =
      rng.chance(0.5) ? bodies::any_path(body, rng) : bodies::full_crossing(body, rng);
  if (options.rule == Rule::dual_edge && !steps_choose_apart(body, sweep)) {
    RC_TAG("a facet is met twice");
    return;
  }
  topology::Incision<D> there(body.k), both(body.k);
  std::vector<Point<D>> points = body.points;
  cut_along(there, points, sweep, options);
  cut_along(both, body.points, bodies::there_and_back(sweep), options);
  RC_TAG(there.opened().empty() ? "nothing opened" : "something opened");
  RC_ASSERT(list<D>(both.opened()) == list<D>(there.opened()));
  RC_ASSERT((both.shut() - there.shut()).empty());
}

RC_GTEST_PROP(StrokeProperty, RetraceAddsNothingInThePlane, ()) { retrace_adds_nothing<2>(); }
RC_GTEST_PROP(StrokeProperty, RetraceAddsNothingInSpace, ()) { retrace_adds_nothing<3>(); }

}  // namespace
}  // namespace cleave::cutting
