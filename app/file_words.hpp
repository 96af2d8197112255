#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "cleave/topology/facet_set.hpp"
#include "cleave/topology/violation.hpp"
#include "mesh.hpp"

/// Violations in the file's own numbers: what a reader of a message can look up in the file.
namespace cleave::app {

/// The file's number of the vertex at place `vertex` of mesh.points.
std::uint64_t vertex_number(const Mesh& mesh, topology::VertexId vertex);

/// The file's number of a cell.
std::uint64_t cell_number(const Mesh& mesh, topology::CellId cell);

/// The file's numbers of the vertices of `cell`, in the order of its tuple.
std::vector<std::uint64_t> cell_vertices(const Mesh& mesh, topology::CellId cell);

/// The file's numbers of the vertices of half-facet `h`, ascending; mesh.dimension gives its cell.
std::vector<std::uint64_t> facet_vertices(const Mesh& mesh, topology::HalfFacetId h);

/// The same for each facet of a set.
std::vector<std::vector<std::uint64_t>> facets_vertices(const Mesh& mesh,
                                                        const topology::FacetSet& facets);

/// The cell that half-facet `h` belongs to, in a mesh of this dimension.
topology::CellId cell_of(const Mesh& mesh, topology::HalfFacetId h);

/// "3 17 24"
std::string listed(const std::vector<std::uint64_t>& numbers);

/// "(3 17 24), (3 17 29)"
std::string facets_listed(const std::vector<std::vector<std::uint64_t>>& facets);

/// "1 vertex", "3 vertices": a count with its word in the right number. `plural` is given where it
/// is not the word and an s.
std::string counted(std::size_t count, const std::string& word, const std::string& plural = {});

/// One line: what is wrong and where, in the numbers of `mesh`, whose cells the violation is about.
std::string describe_in_file(const topology::Violation& violation, const Mesh& mesh);

}  // namespace cleave::app
