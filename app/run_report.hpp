#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cleave/fem/solve.hpp"
#include "parts.hpp"

/// What a run did, as plain values; ids are the mesh file's own unless said otherwise.
namespace cleave::app {

/// How far the two copies of what a stroke opened have moved apart: over the facets that it opened,
/// the distance of displaced vertex pairs that coincided at rest (0 for a pair that is one vertex
/// still). mean: of the facets' means of three; max: of all pairs.
struct Gap {
  double mean = 0.0, max = 0.0;
};

struct StrokeReport {
  std::string name;
  std::string selected_by;       // "dual-edge", "nearest-vertex", "facets", "group"
  std::size_t steps = 0;         // of a blade
  std::size_t requested = 0;     // distinct interior facets asked for or selected
  std::size_t opened = 0;        // of those, open after the stroke
  std::size_t shut = 0;          // of those, shut after the stroke
  std::size_t newly_opened = 0;  // facets that opened in this stroke, some scored by earlier ones
  std::size_t not_interior = 0;  // asked for, but on the boundary of the body
  std::size_t new_vertices = 0;
  std::size_t pieces_before = 0, pieces_after = 0;
  std::size_t pinched_edges = 0;  // after the stroke
  double cut_milliseconds = 0.0;  // select and open
  double follow_milliseconds =
      0.0;                       // operator, supports, loads and displacement brought up to date
  std::optional<Gap> gap;        // by the solve right after the stroke
  std::optional<Gap> final_gap;  // by the last solve
};

struct SolveReport {
  std::string after;  // the stroke's name; empty: at rest
  fem::Outcome outcome{};
  std::size_t iterations = 0;
  bool warm_start = false;  // from the displacement of the solve before
  std::string preconditioner;
  double residual = 0.0;
  std::optional<double> energy_error;
  double energy_norm = 0.0;
  std::vector<fem::Sample> samples;  // thinned: first and last are kept
  struct Floating {
    std::size_t piece = 0;
    std::uint64_t a_cell = 0;
    std::size_t cells = 0, free_modes = 0;
    std::array<double, 3> removed_force{}, removed_moment{};
  };
  std::vector<Floating> floating;  // pieces with free rigid modes
  std::size_t pieces = 0;
  bool has_displacement = false;
  double largest_displacement = 0.0;    // length of the longest one
  std::array<double, 3> low{}, high{};  // per axis
  double milliseconds = 0.0;
};

/// A vertex that regularisation made, and the one it copies.
struct RegularizedVertex {
  std::uint64_t vertex = 0;  // in the .vtu files
  std::uint64_t parent = 0;
};

struct PinchedEdge {
  std::array<std::uint64_t, 2> vertices{};
  std::uint64_t one_part = 0, other_part = 0;  // cells
};

/// One state of the body: at rest first, then after each stroke.
struct StateReport {
  std::string label;
  std::string vtu;                           // file name; empty: none
  std::optional<std::size_t> stroke, solve;  // places in the lists of the run
};

struct RunReport {
  std::string title;
  std::size_t cells = 0;
  std::size_t vertices_before = 0;  // used vertices of the mesh
  std::size_t vertices_after = 0;   // in the end
  bool has_complex = false;         // else: nothing below it was asked for
  bool cut_regular = false;         // the mesh, before regularisation
  std::size_t pieces = 0;           // at rest
  std::vector<RegularizedVertex> regularized;
  std::vector<PinchedEdge> pinched_edges;  // of the file, before regularisation
  std::vector<StrokeReport> strokes;
  std::vector<SolveReport> solves;
  std::vector<StateReport> states;
  std::vector<std::string> warnings;
  std::string final_vtu, page;  // file names; empty: none
  Parts parts;

  bool every_solve_converged() const {
    for (const SolveReport& solve : solves)
      if (solve.outcome != fem::Outcome::converged) return false;
    return true;
  }
};

/// At most `limit` (3 or more) of `samples`, evenly over the iterations, with the first and the
/// last one and the last one that has an estimate of the energy error.
std::vector<fem::Sample> thinned(const std::vector<fem::Sample>& samples, std::size_t limit);

/// The report as summary.json (`cleave-run/1`; docs/schemas/cleave-run-1.schema.json).
std::string summary_json(const RunReport& report);

/// The report for people: states, strokes, solves, then what was built and what it cost.
std::string summary_text(const RunReport& report);

}  // namespace cleave::app
