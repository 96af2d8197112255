#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "cleave/topology/violation.hpp"
#include "mesh.hpp"
#include "reduce.hpp"

/// What `cleave reduce` can hold on to while it makes a mesh smaller. The properties refer to
/// `mesh`, which must outlive them.
namespace cleave::app {

/// A finding of this rule (empty: the first error) at the same place: the same cell, facet, vertex
/// or edge (any loop for non-orientable); and no finding of a rule of which `mesh` has none, so
/// that taking cells away cannot replace what is wrong by something else. Where the cells around a
/// vertex or edge fall into parts, one cell of each of two parts stays. Throws InputError if there
/// is no such finding.
Property finding_property(const Mesh& mesh, const std::string& rule, topology::Level required);

/// What a cut may leave behind.
enum class CutOutcome { shut, pinched };

/// A request to cut: exactly one of these.
struct CutRequest {
  std::string facets;               // a file, see read_facets
  std::vector<std::string> groups;  // facet groups of the mesh
  bool all = false;                 // every interior facet
};

/// A property that speaks of a request, and the request: the vertices (places in mesh.points) of
/// its interior facets.
struct CutProperty {
  Property property;
  std::vector<std::vector<Index>> request;
};

/// That a cut of the request leaves the first shut facet shut, or the first pinched edge pinched;
/// and, as above, that the mesh has no finding of a new rule. The two cells of the facet, or one
/// cell of each of two parts around the edge, stay. Throws InputError for a mesh or request that
/// cannot be cut, and if the cut leaves no such thing.
CutProperty cut_property(const Mesh& mesh, const CutRequest& request, CutOutcome outcome);

/// That the shell command `command`, its {} replaced by the name of a mesh file, ends with the same
/// exit status as for the whole mesh. The file is written beside `out`, in its format, and removed.
/// Throws InputError if that status is 0, OutputError if the file cannot be written.
Property command_property(const Mesh& mesh, const std::string& command,
                          const std::filesystem::path& out);

}  // namespace cleave::app
