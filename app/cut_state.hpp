#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

#include "body.hpp"
#include "certificate.hpp"
#include "cleave/topology/incision.hpp"
#include "cut_output.hpp"
#include "cut_source.hpp"

namespace cleave::app {

/// A mesh with all that has been asked for in it, now and by earlier cuts. What a cut writes, the
/// mesh and its record, depends on the original, the scored facets and the names below alone.
template <int D>
struct CutState {
  /// Nothing asked for yet. `original` must outlive the state.
  explicit CutState(const Mesh& original, const HowFar& how_far = {});
  CutState(const CutState&) = delete;
  CutState& operator=(const CutState&) = delete;

  /// Adds the facet group of the original with this name; does not score its facets. Throws
  /// InputError for an unknown name.
  void name(const std::string& group);

  /// What of these names are scored: a group without scored facets is none that was asked for.
  std::vector<NamedFacets> asked() const;

  /// The scored facets that only the names in `leaving` ask for; "cut" stands for `others` as well
  /// as for a group that has that name.
  topology::FacetSet only_in(const std::set<std::string>& leaving) const;

  Body<D> body;
  topology::Incision<D> incision;
  std::map<std::string, std::vector<topology::HalfFacetId>>
      groups;                 // by name: the facets of the group's elements
  topology::FacetSet others;  // asked for by number, a sweep or --all
  bool cohesive = false;      // put cohesive elements between the sides
  double offset = 0;          // move the sides apart
};

/// Takes the record of `source` up, if it has one: scores its facets. Throws InputError if the
/// record does not fit the original or MESH does not have the cells that such a cut makes.
template <int D>
void resume(CutState<D>& state, const CutSource& source);

/// The mesh of a state: see cut_output, cohesive.hpp and offset.hpp.
template <int D>
CutOutput output_of(const CutState<D>& state, Numbering numbering);

/// Certifies that the cells of `out` are those of the original unglued along the scored facets and
/// nothing else (T11: from the file as it was, regularisation included). Throws InvariantBroken.
template <int D>
void certify(const CutState<D>& state, const Mesh& out);

/// The state as a certificate: the original, the scored facets and `out`, in the numbers that these
/// have in their files; `out` is to be written to `path`. Throws InputError for numbers that a
/// certificate cannot hold.
template <int D>
Certificate certificate_of(const CutState<D>& state, const Mesh& out,
                           const std::filesystem::path& path);

/// The record of a state whose mesh is `output`, to be written to `path`. The hashes are left
/// empty.
template <int D>
IncisionRecord record_of(const CutState<D>& state, const CutOutput& output,
                         const std::filesystem::path& path);

/// The numbers that MESH has for what the complex of a body speaks of.
template <int D>
class Shown {
 public:
  /// Refers to both. `mesh` has the cells of the body's complex, perhaps cut.
  Shown(const Body<D>& body, const Mesh& mesh) : body_(body), mesh_(mesh) {}

  const Mesh& mesh() const { return mesh_; }

  /// Of the vertex at a corner.
  std::uint64_t corner(topology::CornerId corner) const;

  /// Of the vertex of half-facet `h` that is `vertex` in the body's complex, or a copy of it.
  std::uint64_t vertex(topology::HalfFacetId h, topology::VertexId vertex) const;

  /// For each place of the original, the vertex of MESH that kept its number; 0 if no cell has it.
  /// Time: linear.
  std::vector<std::uint64_t> by_place() const;

 private:
  const Body<D>& body_;
  const Mesh& mesh_;
};

}  // namespace cleave::app
