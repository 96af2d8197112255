#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "cleave/support/meshes.hpp"

/// Slow and plain on purpose: sets, maps and Boost Graph, straight from the definitions.
namespace cleave::support {

/// The half-facets of each facet (its vertices ascending), ascending.
template <int D>
std::map<Facet<D>, std::vector<HalfFacetId>> facets_of(std::span<const Cell<D>> cells);

/// Whether no facet is in three cells.
template <int D>
bool is_pseudo_manifold(std::span<const Cell<D>> cells);

/// For each half-facet the other one with the same vertices. Requires a pseudo-manifold.
template <int D>
std::vector<std::optional<HalfFacetId>> mates_of(std::span<const Cell<D>> cells);

/// The lesser half-facet of every interior facet, ascending.
template <int D>
std::vector<HalfFacetId> interior_facets(std::span<const Cell<D>> cells);

/// The cells around each vertex that some cell uses.
template <int D>
std::map<VertexId, std::set<std::size_t>> stars_of(std::span<const Cell<D>> cells);

/// Into how many facet-connected parts the star of each used vertex falls (Definition 4:
/// cut-regular iff one each), when the facets in `cut` do not connect.
template <int D>
std::map<VertexId, std::size_t> parts_of_stars(std::span<const Cell<D>> cells,
                                               std::span<const HalfFacetId> cut = {});

/// Algorithm 3, word for word: for each node in `order`, its star is divided into components by the
/// cut, and each component gets a copy of the node of its own. The cut follows its facets while the
/// mesh changes. A node that comes again in `order` means all its copies. Returns the cells; equal
/// numbers are equal vertices, and else the numbers mean nothing.
template <int D>
std::vector<Cell<D>> algorithm_3(std::span<const Cell<D>> cells, std::span<const HalfFacetId> cut,
                                 std::span<const VertexId> order);

/// The same for all nodes in ascending order.
template <int D>
std::vector<Cell<D>> algorithm_3(std::span<const Cell<D>> cells, std::span<const HalfFacetId> cut);

/// Algorithm 5 and the flood it drives: the cells reached from `start` through neighbours that
/// contain `node`, looked up by oriented facets. `signs` must be coherent.
template <int D>
std::set<std::size_t> flood(std::span<const Cell<D>> cells, std::span<const std::int8_t> signs,
                            VertexId node, std::size_t start);

/// +1 or -1: the orientation that a cell of this sign induces on half-facet `h`, relative to the
/// ascending order of the facet's vertices.
template <int D>
int induced_sign(std::span<const Cell<D>> cells, std::span<const std::int8_t> signs, HalfFacetId h);

/// Whether mates have opposite orientations.
template <int D>
bool is_coherent(std::span<const Cell<D>> cells, std::span<const std::int8_t> signs);

/// Signs that are coherent, +1 for the first cell of each piece; none if there are none.
template <int D>
std::optional<std::vector<std::int8_t>> coherent_signs(std::span<const Cell<D>> cells);

/// The component of each cell in the dual graph without the facets of `cut`, by Boost Graph.
template <int D>
std::vector<std::size_t> components(std::span<const Cell<D>> cells,
                                    std::span<const HalfFacetId> cut = {});

/// Whether corners with the same vertex in `fine` have the same vertex in `coarse`.
template <int D>
bool refines(std::span<const Cell<D>> fine, std::span<const Cell<D>> coarse);

/// Whether both share corners in the same way: equal up to the names of vertices.
template <int D>
bool same_partition(std::span<const Cell<D>> a, std::span<const Cell<D>> b);

/// The facets of `before` (lesser half-facets, ascending) that are interior there and boundary in
/// `after`, which has the same cells with other vertices.
template <int D>
std::vector<HalfFacetId> opened_facets(std::span<const Cell<D>> before,
                                       std::span<const Cell<D>> after);

/// The number of vertices that cells use.
template <int D>
std::size_t used_vertices(std::span<const Cell<D>> cells);

/// How many facets of `cut` contain each ridge (vertices ascending) that is in any of them.
template <int D>
std::map<std::vector<VertexId>, std::size_t> ridge_degrees(std::span<const Cell<D>> cells,
                                                           std::span<const HalfFacetId> cut);

/// `facet` without its ordering.
template <int D>
Facet<D> sorted_facet(std::span<const Cell<D>> cells, HalfFacetId h);

/// +1 if sorting `tuple` takes an even permutation, -1 if odd. Distinct entries.
int parity(std::span<const VertexId> tuple);

}  // namespace cleave::support
