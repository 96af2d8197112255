#include "cleave/cutting/stroke.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "cleave/topology/carry_over.hpp"

namespace cleave::cutting {

using topology::FacetSet;

namespace {

/// Room for `more` elements; it doubles as a rule, so that it costs little in the long run.
template <class T>
void make_room(std::vector<T>& elements, std::size_t more) {
  const std::size_t needed = elements.size() + more;
  if (elements.capacity() < needed) elements.reserve(std::max(needed, 2 * elements.capacity()));
}

}  // namespace

template <int D>
StrokeResult cut_along(topology::Incision<D>& incision, std::vector<Point<D>>& points,
                       const Sweep<D>& sweep, SelectOptions options, topology::Verify verify,
                       const FacetSet& except) {
  require_valid(sweep);
  const Selector<D> selector(incision, points, options);
  const FacetSet left_by_others = incision.shut();
  StrokeResult result;
  ClosestSets sets;
  FacetSet pending;                            // scored by this stroke and shut still
  std::vector<topology::HalfFacetId> settled;  // scored by this stroke and opened
  for (std::size_t first = 0, last = 0; first < sweep.simplices.size(); first = last) {
    last = sweep.step(sweep.step_of[first]).second;
    const FacetSet chosen =
        selector.toggle(std::span(sweep.simplices).subspan(first, last - first), sets);
    const FacetSet toggled = chosen - except;
    if (toggled.size() != chosen.size()) result.excepted = result.excepted | (chosen & except);
    if (toggled.empty()) continue;
    incision.forget_shut((pending & toggled) - left_by_others);
    const FacetSet scored = pending ^ toggled;
    result.changes.emplace_back();
    make_room(points, 2 * static_cast<std::size_t>(D) * (scored | incision.shut()).size());
    result.changes.back() = incision.cut(scored, verify);
    topology::carry_over(points, result.changes.back());  // there is room, so it does not throw
    pending = scored & incision.shut();
    const auto opened = (scored - pending).half_facets();
    settled.insert(settled.end(), opened.begin(), opened.end());
  }
  result.scored = FacetSet::of_lesser(std::move(settled)) | pending;
  return result;
}

template StrokeResult cut_along(topology::Incision<2>&, std::vector<Point<2>>&, const Sweep<2>&,
                                SelectOptions, topology::Verify, const FacetSet&);
template StrokeResult cut_along(topology::Incision<3>&, std::vector<Point<3>>&, const Sweep<3>&,
                                SelectOptions, topology::Verify, const FacetSet&);

}  // namespace cleave::cutting
