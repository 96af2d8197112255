#include "cleave/topology/facet_set.hpp"
#include "dimensions.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <string>
#include <utility>

namespace cleave::topology {

NotInterior::NotInterior(HalfFacetId h)
    : std::invalid_argument("half-facet " + std::to_string(h.value) +
                            " has no mate: it is not an interior facet"),
      half_facet(h) {}

template <int D>
FacetSet FacetSet::of(const Complex<D>& k, std::span<const HalfFacetId> half_facets) {
  std::vector<HalfFacetId> lesser;
  lesser.reserve(half_facets.size());
  for (const HalfFacetId h : half_facets) {
    if (h.value >= k.half_facet_count()) throw NotInterior(h);
    const auto mate = k.mate(h);
    if (!mate) throw NotInterior(h);
    lesser.push_back(std::min(h, *mate));
  }
  return of_lesser(std::move(lesser));
}

template <int D>
FacetSet FacetSet::all(const Complex<D>& k) {
  FacetSet result;
  for (Index h = 0; h < k.half_facet_count(); ++h) {
    const auto mate = k.mate(HalfFacetId{h});
    if (mate && h < mate->value) result.facets_.push_back(HalfFacetId{h});
  }
  return result;
}

FacetSet FacetSet::of_lesser(std::vector<HalfFacetId> lesser) {
  const auto disorder = std::adjacent_find(lesser.begin(), lesser.end(), std::greater_equal<>());
  if (disorder != lesser.end()) {
    std::sort(lesser.begin(), lesser.end());
    lesser.erase(std::unique(lesser.begin(), lesser.end()), lesser.end());
  }
  FacetSet result;
  result.facets_ = std::move(lesser);
  return result;
}

bool FacetSet::contains(HalfFacetId h) const {
  return std::binary_search(facets_.begin(), facets_.end(), h);
}

FacetSet operator|(const FacetSet& a, const FacetSet& b) {
  FacetSet result;
  std::set_union(a.facets_.begin(), a.facets_.end(), b.facets_.begin(), b.facets_.end(),
                 std::back_inserter(result.facets_));
  return result;
}

FacetSet operator-(const FacetSet& a, const FacetSet& b) {
  FacetSet result;
  std::set_difference(a.facets_.begin(), a.facets_.end(), b.facets_.begin(), b.facets_.end(),
                      std::back_inserter(result.facets_));
  return result;
}

FacetSet operator&(const FacetSet& a, const FacetSet& b) {
  FacetSet result;
  std::set_intersection(a.facets_.begin(), a.facets_.end(), b.facets_.begin(), b.facets_.end(),
                        std::back_inserter(result.facets_));
  return result;
}

FacetSet operator^(const FacetSet& a, const FacetSet& b) {
  FacetSet result;
  std::set_symmetric_difference(a.facets_.begin(), a.facets_.end(), b.facets_.begin(),
                                b.facets_.end(), std::back_inserter(result.facets_));
  return result;
}

#define CLEAVE_INSTANTIATE(D)                                                         \
  template FacetSet FacetSet::of<D>(const Complex<D>&, std::span<const HalfFacetId>); \
  template FacetSet FacetSet::all<D>(const Complex<D>&);
CLEAVE_FOR_EACH_DIMENSION(CLEAVE_INSTANTIATE)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::topology
