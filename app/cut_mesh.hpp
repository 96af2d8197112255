#pragma once
#include <string>
#include <vector>

#include "cleave/cutting/select.hpp"
#include "cleave/topology/unglue.hpp"
#include "cut_report.hpp"
#include "progress.hpp"

namespace cleave::app {

/// A request to cut, as the command line makes it. Exactly one of facets, groups, sweep and all.
struct CutOptions {
  std::string mesh, out;  // out may be empty for a dry run
  std::string facets, sweep;
  std::vector<std::string> groups;
  bool all = false;
  cutting::SelectOptions select;
  topology::Verify verify = topology::Verify::touched;
  bool cohesive = false;
  double offset = 0;
  bool dry_run = false, explain = false, require_open = false, strict = false, quiet = false;
  std::string json;
};

/// What a cut made: the mesh for OUT, and the report.
struct CutResult {
  Mesh mesh;
  CutReport report;
  std::vector<std::string> warnings;
};

/// Cuts `mesh` as asked; nothing is written but, when a verification fails, a reproducer. Verified
/// as options.verify says; Verify::all also certifies the cells of the output as a whole. Throws
/// InputError for a mesh or request that cannot be, InvariantBroken when a verification fails: its
/// message names the reproducer.
CutResult cut_mesh(const Mesh& mesh, const CutOptions& options, Progress& progress);

}  // namespace cleave::app
