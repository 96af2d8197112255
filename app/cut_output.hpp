#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "body.hpp"
#include "cleave/topology/incision.hpp"

/// From a cut complex back to a mesh that a file can hold.
namespace cleave::app {

/// Facets asked for under one name, which names their groups in the output.
struct NamedFacets {
  std::string name = "cut";
  std::vector<topology::HalfFacetId> facets;  // any half-facet of each, in any order; interior ones
                                              // are scored in the incision, others are left alone
  const Group* group = nullptr;  // the group of body.mesh that `name` is, `facets` parallel to its
                                 // elements; none: facets from elsewhere
};

constexpr topology::VertexId kNoVertex{topology::kNoIndex};

/// How a file numbers vertices: by place from 0 or 1, or with numbers of its own.
enum class Numbering { from_zero, from_one, kept };

/// By the extension: .vtu and .vtk from 0, .mesh from 1, .msh kept.
Numbering numbering_of(const std::filesystem::path& path);

/// A sheet of opened facets that has only one side, such as a Moebius band.
struct OneSidedSheet {
  std::string name;  // of its NamedFacets
  std::vector<topology::HalfFacetId>
      loop;  // facets (lesser half-facets), each next to the one before
};

/// A facet asked for that opened: the half-facet of its minus side, and the name it has its groups
/// by (of several, the first in the file).
struct SidedFacet {
  topology::HalfFacetId minus;
  std::string name;
};

/// A point that was moved away from where the body has it.
struct MovedPoint {
  Index place;  // in the output's points
  std::array<double, 3> before;
};

struct CutOutput {
  Mesh mesh;
  std::vector<topology::VertexId> vertex_at;  // of incision.complex(), for each of mesh.points;
                                              // kNoVertex: the point is a node of second order
  std::vector<Index> origin;                  // place in body.mesh of each of mesh.points; where a
                              // point has several copies, the first one keeps its number
  std::vector<std::uint64_t> number_of;  // in `mesh`, of each vertex of incision.complex(); 0 if
                                         // it is not in use
  std::vector<SidedFacet> sides;         // ascending by facet
  std::vector<MovedPoint> moved;         // ascending; cut_output moves none
  std::vector<OneSidedSheet> one_sided;
  std::vector<std::string> warnings;  // what was dropped or renumbered, one sentence each
};

/// The mesh of `incision`, made from `body`, as a file with this numbering holds it.
/// - Cells keep their order, tuples, numbers and groups. Vertices keep their numbers (by place
///   where the format numbers so); copies come last, in canonical order, numbered after the
///   largest; copies of nodes of second order (see node_images.hpp) after those of vertices.
///   Vertices that no cell uses are dropped.
/// - Edges, vertices and facets of groups that were not asked for are there once for each copy.
/// - A facet asked for that opened is there twice, in groups NAME_minus and NAME_plus; one that is
///   shut in NAME_shut. These replace the group NAME, which keeps only facets on the old boundary.
///   Which side is minus: see sides.hpp.
/// - Point fields follow `parent`, facet fields the facets' elements (both images of an opened
///   facet keep its values), cell fields stay. Periodic pairs: see periodic_pairs.hpp. Point data
///   `parent` (number in body.mesh) and cell data `piece` (from 0, by least cell) are added for
///   Numbering::from_zero.
/// Throws InputError where periodic pairs cannot follow the cut.
/// The result is a function of the body and of what was asked for, not of the order of requests.
/// Time: linear in the mesh.
template <int D>
CutOutput cut_output(const Body<D>& body, const topology::Incision<D>& incision,
                     const std::vector<NamedFacets>& asked, Numbering numbering);

}  // namespace cleave::app
