#include "star_cut.hpp"

#include <algorithm>
#include <deque>
#include <map>
#include <optional>

namespace cleave::app {

using topology::CellId;
using topology::Complex;
using topology::FacetSet;
using topology::HalfFacetId;
using topology::VertexId;

namespace {

// Maximum flow in the dual graph of a star, each facet that holds it together having capacity 1.
template <int D>
class StarFlow {
 public:
  StarFlow(const Complex<D>& k, const FacetSet& scored, VertexId vertex)
      : k_(k), scored_(scored), vertex_(vertex) {}

  // Sends one more unit from one of `from` to one of `to`; false if none can be sent.
  bool augment(const std::vector<CellId>& from, const std::vector<CellId>& to) {
    reach(from);
    for (const CellId end : to) {
      if (reached_.count(end) == 0) continue;
      for (auto by = reached_.at(end); by; by = reached_.at(topology::cell_of<D>(*by))) {
        ++flow_[*by];
        --flow_[*k_.mate(*by)];
      }
      return true;
    }
    return false;
  }

  // The facets between the cells that can still be reached from the start and the others.
  std::vector<HalfFacetId> cut() const {
    std::vector<HalfFacetId> facets;
    for (const auto& [cell, by] : reached_)
      for (const HalfFacetId h : ways_out(cell)) {
        const HalfFacetId mate = *k_.mate(h);
        if (reached_.count(topology::cell_of<D>(mate)) == 0) facets.push_back(std::min(h, mate));
      }
    std::sort(facets.begin(), facets.end());
    return facets;
  }

 private:
  // The half-facets of `cell` through which the star hangs together.
  std::vector<HalfFacetId> ways_out(CellId cell) const {
    std::vector<HalfFacetId> ways;
    for (topology::Index i = 0; i <= static_cast<topology::Index>(D); ++i) {
      const HalfFacetId h{static_cast<topology::Index>(D + 1) * cell.value + i};
      if (k_.vertices(cell)[i] == vertex_) continue;  // the facet opposite it does not have it
      const auto mate = k_.mate(h);
      if (mate && !scored_.contains(std::min(h, *mate))) ways.push_back(h);
    }
    return ways;
  }

  void reach(const std::vector<CellId>& from) {
    reached_.clear();
    for (const CellId cell : from) reached_.emplace(cell, std::nullopt);
    for (std::deque<CellId> flood(from.begin(), from.end()); !flood.empty(); flood.pop_front())
      for (const HalfFacetId h : ways_out(flood.front())) {
        const CellId next = topology::cell_of<D>(*k_.mate(h));
        const auto flow = flow_.find(h);
        if (flow != flow_.end() && flow->second > 0) continue;
        if (reached_.emplace(next, h).second) flood.push_back(next);
      }
  }

  const Complex<D>& k_;
  const FacetSet& scored_;
  VertexId vertex_;
  std::map<HalfFacetId, int> flow_;                       // out of the half-facet's cell
  std::map<CellId, std::optional<HalfFacetId>> reached_;  // through which half-facet; none: start
};

}  // namespace

template <int D>
std::vector<HalfFacetId> star_cut(const Complex<D>& k, const FacetSet& scored, VertexId vertex,
                                  const std::vector<CellId>& from, const std::vector<CellId>& to) {
  for (const CellId cell : from)
    if (std::find(to.begin(), to.end(), cell) != to.end()) return {};
  StarFlow<D> flow(k, scored, vertex);
  while (flow.augment(from, to)) {
  }
  return flow.cut();
}

#define CLEAVE_INSTANTIATE(D)                                                                 \
  template std::vector<HalfFacetId> star_cut<D>(const Complex<D>&, const FacetSet&, VertexId, \
                                                const std::vector<CellId>&,                   \
                                                const std::vector<CellId>&);
CLEAVE_INSTANTIATE(1)
CLEAVE_INSTANTIATE(2)
CLEAVE_INSTANTIATE(3)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::app
