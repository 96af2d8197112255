#pragma once
#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "cleave/topology/complex.hpp"
#include "cleave/topology/facet_set.hpp"
#include "cleave/topology/relabelling.hpp"
#include "cleave/topology/step_stack.hpp"
#include "cleave/topology/unglue.hpp"

namespace cleave::topology {

namespace detail {

/// What the calls of an incision work with and use again. It is made when first needed; a copy
/// starts with none, so that copies of an incision share nothing.
template <class Memory>
class Reused {
 public:
  Reused() = default;
  Reused(const Reused&) noexcept {}
  Reused(Reused&& other) noexcept = default;
  Reused& operator=(const Reused&) noexcept { return *this; }
  Reused& operator=(Reused&& other) noexcept = default;

  Memory& get() {
    if (!memory_) memory_ = std::make_shared<Memory>();
    return *memory_;
  }

 private:
  std::shared_ptr<Memory> memory_;  // shared by nobody: Memory may be incomplete here
};

template <int D>
struct IncisionMemory;

}  // namespace detail

/// A complex with its scored facets: all facets asked for and not taken back. Those that opened are
/// boundary now, those that are shut open later when their rim is released. The state is a function
/// of the original complex and the scored set alone (T8, T12), up to the ids of copies.
///
/// Ids of copies are handles, stable as long as their corners keep together: of the corners at a
/// vertex that a cut separates, or a stitch joins, those with the least corner keep their id. A new
/// copy gets the least id that is free, and unused ids at the end are dropped. So the bound on ids
/// never exceeds the most that were in use at one time, and taking the latest cut back gives the
/// very ids from before it.
///
/// Memory: cut, stitch, undo and redo keep what they work with for the next call. Those that fill a
/// Relabelling of the caller's allocate nothing once as large a call has been made, with the same
/// `verify` (not Verify::all), the same Relabelling, and as many copies and free ids; steps take
/// memory until forget_steps, or at most what keep_steps allows.
template <int D>
class Incision {
 public:
  explicit Incision(Complex<D> original);

  /// The complex as it is now.
  const Complex<D>& complex() const { return complex_; }

  /// The vertices of the complex at the start have the ids below this number, now and always.
  std::size_t original_vertex_count() const { return original_vertex_count_; }

  /// The vertex of the original complex that `vertex`, one of complex(), is or is a copy of.
  /// Without meaning for an unused id.
  VertexId original(VertexId vertex) const {
    return vertex.value < original_vertex_count_
               ? vertex
               : original_of_copy_[vertex.value - original_vertex_count_];
  }

  /// The opened facets, ascending, each with its former mates; `by` is the least vertex of the
  /// original complex that separates them now. Time: linear in the stars of all copies, since each
  /// opened facet has a copy on one side at least, and sorting.
  std::vector<OpenedFacet> opened() const;

  /// Scored facets that are interior still.
  const FacetSet& shut() const { return shut_; }

  /// All scored facets: opened and shut. Time: as opened().
  FacetSet scored() const;

  /// The facets of these half-facets, which may be interior now or opened by this incision. Throws
  /// NotInterior for any other.
  FacetSet facets(std::span<const HalfFacetId> half_facets) const;

  /// The same in the memory of `facets`, which is unchanged if this throws NotInterior.
  void facets(std::span<const HalfFacetId> half_facets, FacetSet& facets) const;

  /// Scores `facets` as well, and opens what can be opened (T8: cutting in stages equals cutting at
  /// once). Facets scored before may be named again; that changes nothing. Of the result, `opened`
  /// lists what opened now (facets scored earlier among them), `shut` every scored facet that is
  /// shut now. Throws NotInterior for a facet that is neither interior nor opened by this incision;
  /// else as unglue. After an exception the incision is as it was. Time: as unglue of `facets` and
  /// the shut facets together.
  Relabelling cut(const FacetSet& facets, Verify verify = Verify::touched);

  /// The same in the memory of `change`, whatever it said before; if this throws, it says nothing
  /// of use.
  void cut(const FacetSet& facets, Relabelling& change, Verify verify = Verify::touched);

  /// Takes facets back, opened or shut: they are scored no longer, and the state is the one that
  /// cutting the others from the start gives (T12). Facets of `facets` that are not scored are left
  /// alone. Of the result, `merges` lists the copies that ceased to exist, `closed` the facets that
  /// are interior again: those taken back that were opened, and others that no vertex separates any
  /// more, which are scored still and are listed as `shut`, too. Throws std::bad_alloc,
  /// InvariantBroken if the verification fails (a defect of ours); the incision is as it was then.
  /// Time: linear in the stars of the vertices of `facets` before and after (and sorting), and a
  /// pass over shut() if that changes; independent of the size of the complex and of other cuts.
  Relabelling stitch(const FacetSet& facets, Verify verify = Verify::touched);
  void stitch(const FacetSet& facets, Relabelling& change, Verify verify = Verify::touched);

  /// The merges that stitch(facets) would report, so that whoever holds data that cannot be merged
  /// can refuse before anything has changed. Time: linear in `facets`, and sorting.
  std::vector<Merge> planned_merges(const FacetSet& facets) const;

  /// Takes shut facets back: as stitch(facets & shut()). Nothing opens or closes.
  void forget_shut(const FacetSet& facets);

  /// Whether a step can be taken back, or done again. A step is a call of cut, stitch or
  /// forget_shut that changed the scored set; a new one ends what can be done again.
  bool can_undo() const { return !done_.empty(); }
  bool can_redo() const { return !undone_.empty(); }

  /// Takes the latest step back, or does the step again that was taken back last, with its facets
  /// alone: a step is kept as the facets by which it changed the scored set. Throw std::logic_error
  /// if there is none; else as cut and stitch, whose cost they have.
  Relabelling undo(Verify verify = Verify::touched);
  Relabelling redo(Verify verify = Verify::touched);
  void undo(Relabelling& change, Verify verify = Verify::touched);
  void redo(Relabelling& change, Verify verify = Verify::touched);

  /// Drops all steps, to be taken back or done again. The state stays, and so does the memory of
  /// the steps, for later ones.
  void forget_steps();

  /// From now on at most the latest `most` steps are kept, so that memory is bounded however long
  /// the history. At first, all are kept.
  void keep_steps(std::size_t most);

 private:
  using Memory = detail::IncisionMemory<D>;

  void score(std::span<const HalfFacetId> facets, Relabelling& change, Verify verify);
  void take_back(std::span<const HalfFacetId> facets, Relabelling& change, Verify verify);
  void record(std::span<const HalfFacetId> facets, bool scored);  // requires room; does not throw
  void repeat(detail::StepStack& from, detail::StepStack& to, bool forwards, Relabelling& change,
              Verify verify);

  Complex<D> complex_;  // which remembers the former mates of opened facets
  std::size_t original_vertex_count_ = 0;
  std::vector<VertexId> original_of_copy_;  // of vertex original_vertex_count_ + i
  std::vector<VertexId> free_;              // heap of unused ids, see free_ids.hpp
  FacetSet shut_;
  detail::StepStack done_, undone_;
  std::size_t most_steps_ = std::numeric_limits<std::size_t>::max();
  detail::Reused<Memory> memory_;
};

/// The numbering every writer uses: result[v] is the number of vertex v. Original vertices keep
/// their numbers, copies follow by (original vertex, least corner). It depends on the scored set
/// alone, so the same set gives the same bytes. Unused ids get kNoIndex. Time:
/// linear in the number of copies and vertices, and in the stars of copies.
template <int D>
std::vector<VertexId> canonical(const Incision<D>& incision);

}  // namespace cleave::topology
