#pragma once
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace cleave::app {

/// One moment of a run: a complex of the same cells, with the vertices it has by then.
struct PageState {
  std::string label;                  // "At rest", "Cut", "Under load" ..
  std::vector<std::uint32_t> cells;   // 4 vertices per cell, in this state's own numbering
  std::vector<double> displacement;   // 3 per vertex of this state's numbering; empty: none
  std::vector<std::uint32_t> opened;  // facets open by now: one half-facet 4 * cell + i of each
  std::vector<std::uint32_t> shut;    // facets scored but not open: one half-facet of each
  std::size_t pieces = 1;
  int iterations = -1;  // of the solve that led here; -1: none
  std::string outcome;  // of that solve; empty: none
};

/// One line of a solve's history. A value that is not known yet is NaN and leaves a gap.
struct PageSample {
  int iteration = 0;
  double seconds = 0;       // wall time since the solve began
  double residual = 0;      // relative
  double energy_error = 0;  // estimate, relative
};

struct PageSolve {
  std::string label, outcome;
  double tolerance = 0;  // of the residual, drawn as a line; 0: none
  std::vector<PageSample> samples;
};

/// Something to point at: a vertex (one place) or an edge (two), with what to say of it.
struct PageMark {
  std::string label;  // "vertex 1207: why"; the picture shows what stands before the colon
  std::vector<std::uint32_t> vertices;  // 1 or 2, in the numbering of the first state
};

/// Marks of one kind, switched on and off together.
struct PageFinding {
  std::string name;  // "Regularised vertices"
  std::vector<PageMark> marks;
};

/// All that the page of a run shows; it opens on the last state. Lengths are in `length_unit`,
/// nothing is converted.
struct PageData {
  std::string title;
  std::vector<std::string> summary;  // plain lines: one beside the title, the others by the states
  std::string length_unit;           // "mm"; empty: none
  std::vector<double> points;        // 3 per vertex of the first state, undeformed
  std::vector<PageState> states;  // at least one, all with the same number of cells, in time order
  std::vector<std::string> materials;           // names; each has its colour; may be empty
  std::vector<std::uint32_t> material_of_cell;  // place in `materials`; empty: all cells alike
  std::vector<std::uint64_t> cell_numbers;      // the file's own, per cell; empty: 1, 2, ..
  std::vector<PageFinding> findings;
  std::vector<PageSolve> solves;
};

/// Writes one HTML file that needs nothing beside it: no network, no server, no other file. Later
/// states only store the corners that got another vertex, coordinates are stored as 32-bit floats.
/// The same data give the same bytes. Text is escaped: no label can break out of its place.
/// Throws std::invalid_argument that names the array when arrays do not fit together (sizes,
/// vertex, half-facet or material out of range, a coordinate that is not finite); `out` is
/// untouched then. Time and memory: linear in the data.
void write_page(std::ostream& out, const PageData& data);

}  // namespace cleave::app
