#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "mesh.hpp"

/// Shrinking a mesh that shows something to a small one that still shows it.
namespace cleave::app {

/// What is left of a mesh, and of a request to cut it. All ascending.
struct Candidate {
  std::vector<Index> cells;   // places among the cells; never empty
  std::vector<Index> loose;   // vertices that no cell of the whole mesh uses
  std::vector<Index> facets;  // places in the request
};

/// Whether a candidate still shows it; if not, which vertices (places in mesh.points) stand in the
/// way, if any: the cells around them may help.
struct Judgement {
  bool holds = false;
  std::vector<Index> blame;
};

/// Something that a mesh shows.
struct Property {
  std::string what;  // one line, in the numbers of the mesh
  std::function<Judgement(const Candidate&)> judge;
  std::vector<Index> seed;         // cells where it shows, ascending; empty: nobody knows
  std::vector<Index> kept;         // of these, the cells that it is about: they stay, ascending
  std::size_t facets = 0;          // size of the request
  std::vector<Index> kept_facets;  // places in the request that stay
};

struct Reduction {
  Candidate rest;
  std::size_t tries = 0;  // how often `judge` was asked
};

/// A small candidate of `mesh` that has the property, which the whole mesh must have. Where the
/// place is known it starts with the cells there and takes more around them until the property
/// holds; then delta debugging (ddmin.hpp) over pieces, over cells, over loose vertices and over
/// the request. The result is 1-minimal: without any single cell (but the kept ones), loose vertex
/// or facet of the request it would not have the property. Deterministic. `progress` is told of
/// every candidate that has the property. Time: mostly that of `judge`, whose candidates are small
/// from the start if the place is known; else as ddmin.
Reduction reduce(const Mesh& mesh, const Property& property,
                 const std::function<void(const Reduction&)>& progress);

}  // namespace cleave::app
