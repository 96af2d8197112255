#pragma once
#include <span>
#include <unordered_map>
#include <vector>

#include "cleave/topology/complex.hpp"
#include "cleave/topology/facet_set.hpp"
#include "cleave/topology/relabelling.hpp"
#include "cleave/topology/unglue.hpp"

namespace cleave::topology {

/// A complex with its scored facets: all facets asked for and not taken back. Those that opened are
/// boundary now, those that are shut open later when their rim is released. The state is a function
/// of the original complex and the scored set alone (T8, T12).
template <int D>
class Incision {
 public:
  explicit Incision(Complex<D> original);

  /// The complex as it is now.
  const Complex<D>& complex() const { return complex_; }

  /// The vertices of the complex at the start have the ids below this number, now and always.
  std::size_t original_vertex_count() const { return original_vertex_count_; }

  /// The vertex of the original complex that `vertex`, one of complex(), is or is a copy of.
  VertexId original(VertexId vertex) const;

  /// The opened facets, ascending, each with its former mates; `by` is a vertex of the original
  /// complex. Time: linear in them, and sorting.
  std::vector<OpenedFacet> opened() const;

  /// Scored facets that are interior still.
  const FacetSet& shut() const { return shut_; }

  /// All scored facets: opened and shut.
  FacetSet scored() const;

  /// The facets of these half-facets, which may be interior now or opened by this incision. Throws
  /// NotInterior for any other.
  FacetSet facets(std::span<const HalfFacetId> half_facets) const;

  /// Scores `facets` as well, and opens what can be opened (T8: cutting in stages equals cutting at
  /// once). Facets scored before may be named again; that changes nothing. Of the result, `opened`
  /// lists what opened now (facets scored earlier among them), `shut` every scored facet that is
  /// shut now. Throws NotInterior for a facet that is neither interior nor opened by this incision;
  /// else as unglue. After an exception the incision is as it was. Time: as unglue of `facets` and
  /// the shut facets together.
  Relabelling cut(const FacetSet& facets, Verify verify = Verify::touched);

  /// Takes shut facets back: they are scored no longer. Nothing opens or closes. Facets of `facets`
  /// that are not shut are left alone.
  void forget_shut(const FacetSet& facets);

 private:
  void make_room_for_copies(std::size_t copies);
  void forget_sides(HalfFacetId half_facet);  // does not throw

  Complex<D> complex_;
  std::size_t original_vertex_count_ = 0;
  std::vector<VertexId> original_of_copy_;  // of vertex original_vertex_count_ + i
  struct Side {
    HalfFacetId former_mate;
    VertexId by;
  };
  std::unordered_map<HalfFacetId, Side>
      sides_;  // of opened facets, both; with the mates to restore
  FacetSet shut_;
};

/// The numbering every writer uses: result[v] is the number of vertex v. Original vertices keep
/// their numbers, copies follow by (original vertex, least corner). It depends on the scored set
/// alone, so the same set gives the same bytes. Unused ids get the largest value of uint32. Time:
/// linear in the number of copies and vertices, and in the stars of copies.
template <int D>
std::vector<VertexId> canonical(const Incision<D>& incision);

}  // namespace cleave::topology
