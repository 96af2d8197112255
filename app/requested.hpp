#pragma once
#include <string>
#include <vector>

#include "cut_state.hpp"

/// From what a command line asks for, in the numbers and names of MESH, to half-facets.
namespace cleave::app {

/// What "--facets FILE" names.
template <int D>
std::vector<topology::HalfFacetId> facets_in(const CutSource& source, const std::string& file);

/// The facets of a group: of the original, if it has one with this name, else of MESH.
template <int D>
std::vector<topology::HalfFacetId> facets_of_group(const CutSource& source,
                                                   const std::string& name);

/// Whether `name` is a facet group of MESH that an earlier cut made, such as fault_minus.
bool made_by_cut(const CutSource& source, const std::string& name);

/// The name NAME if `name` is NAME_minus, NAME_plus or NAME_shut and NAME was asked for; else
/// `name`.
template <int D>
std::string sheet_name(const CutState<D>& state, const std::string& name);

}  // namespace cleave::app
