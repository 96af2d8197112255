#pragma once
#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "cleave/support/meshes.hpp"
#include "cleave/support/rng.hpp"

namespace cleave::support {

/// The classes of cuts that every property meets. A ridge or a vertex is inner when every facet
/// around it is interior; the degree of a ridge is the number of cut facets that contain it.
enum class CutClass {
  single,      // one facet
  isolated,    // facets without common vertices, some with inner vertices only: these stay shut
  sheet,       // the facets between a set of cells and the rest
  rim,         // part of a sheet: some inner ridge has degree 1
  tee,         // three sectors of cells meet in an inner ridge of degree 3
  cross,       // four sectors, degree 4
  star,        // five or more sectors
  book,        // facets around one ridge and no others, three or more
  shell,       // closed: the facets around cells that have no boundary facet
  everything,  // all interior facets
  nearly,      // all of them but one to four
  random       // each interior facet with some probability
};

inline constexpr std::array<CutClass, 12> kCutClasses{
    CutClass::single, CutClass::isolated,   CutClass::sheet,  CutClass::rim,
    CutClass::tee,    CutClass::cross,      CutClass::star,   CutClass::book,
    CutClass::shell,  CutClass::everything, CutClass::nearly, CutClass::random};

std::string_view name(CutClass cut_class);

/// Whether the class exists in this dimension: for D = 1 facets are vertices and there are no
/// ridges, so a cut has neither rims nor junctions.
bool can_occur(CutClass cut_class, int dimension);

/// A cut of the class, in random order, each facet by a random one of its half-facets, some of them
/// twice; none if this mesh has no such cut, or chance did not find it.
template <int D>
std::optional<std::vector<HalfFacetId>> random_cut(const Mesh<D>& mesh, CutClass cut_class,
                                                   Rng& rng);

}  // namespace cleave::support
