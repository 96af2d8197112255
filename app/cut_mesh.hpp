#pragma once
#include <optional>
#include <string>
#include <vector>

#include "certificate.hpp"
#include "cleave/cutting/select.hpp"
#include "cleave/topology/unglue.hpp"
#include "cleave/topology/violation.hpp"
#include "cut_report.hpp"
#include "cut_source.hpp"
#include "progress.hpp"

namespace cleave::app {

/// A request to cut, as the command line makes it: facets, groups, a sweep and all may be given
/// together; the sweep comes last.
struct CutOptions {
  std::string mesh, out;  // out may be empty for a dry run
  std::string sweep;
  std::vector<std::string> facets, groups, keep;  // files; names
  bool all = false;
  cutting::SelectOptions select;
  topology::Verify verify = topology::Verify::touched;
  bool cohesive = false;
  std::optional<double> offset;  // none: as the record says
  bool dry_run = false, explain = false, require_open = false, strict = false, quiet = false;
  bool forget = false;                     // the record beside the mesh
  std::optional<topology::Level> require;  // of the result
  bool require_by_cutting = false;         // further facets; else refuse
  std::string json, fix_it, certificate;
};

/// What a cut made: the mesh for OUT, its record without the hashes, the certificate if it is asked
/// for, and the report.
struct CutResult {
  Mesh mesh;
  IncisionRecord record;
  std::optional<Certificate> certificate;
  CutReport report;
  std::vector<std::string> warnings;
};

/// Cuts the mesh of `source` as asked, after what its record says; nothing is written but, when a
/// verification fails, a reproducer. Verified as options.verify says; Verify::all also certifies
/// the cells of the output as a whole. Throws InputError for a mesh or request that cannot be,
/// InvariantBroken when a verification fails: its message names the reproducer.
CutResult cut_mesh(const CutSource& source, const CutOptions& options, Progress& progress);

}  // namespace cleave::app
