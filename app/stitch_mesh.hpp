#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "certificate.hpp"
#include "cleave/topology/unglue.hpp"
#include "cut_source.hpp"
#include "progress.hpp"

namespace cleave::app {

/// A request to take facets of an earlier cut back: facets and groups, or all.
struct StitchOptions {
  std::string mesh, out;  // out may be empty for a dry run
  std::string facets;
  std::vector<std::string> groups;  // as they were asked for, or with _minus, _plus, _shut
  bool all = false, dry_run = false, quiet = false;
  topology::Verify verify = topology::Verify::touched;
  std::string json, certificate;
};

/// All that `cleave stitch` has to say. Numbers are those of MESH unless said otherwise.
struct StitchReport {
  struct Merge {
    std::uint64_t vertex, into;  // in MESH, in OUT
  };
  std::size_t cells = 0, vertices_before = 0, vertices_after = 0;  // of MESH, of OUT
  std::size_t requested = 0;         // distinct scored facets taken back
  std::size_t closed = 0;            // those of them that were open
  std::size_t not_scored = 0;        // distinct facets asked for that nobody had asked to cut
  std::size_t opened = 0, shut = 0;  // scored still
  std::size_t pieces_before = 0, pieces_after = 0;
  std::vector<std::vector<std::uint64_t>> shut_again;  // scored still, were open, and are no more
  std::vector<Merge> merges;
};

struct StitchResult {
  Mesh mesh;
  std::optional<IncisionRecord> record;    // without the hashes; none: nothing is scored any more
  std::optional<Certificate> certificate;  // if it is asked for
  StitchReport report;
  std::vector<std::string> warnings;
};

/// Takes facets back: the result is what cutting the others from the start gives (T12), and the
/// original itself if no other is left, also an original that is not cut-regular (T12_regular:
/// that alone is no unglue of it; a warning says so, and there is no certificate). Nothing is
/// written. Verified as options.verify says; Verify::all also certifies the cells. Throws
/// InputError if MESH has no record, or for a name or a facet that is not there.
StitchResult stitch_mesh(const CutSource& source, const StitchOptions& options, Progress& progress);

/// A few lines.
std::string text_of(const StitchReport& report, const std::string& source);

/// docs/schemas/cleave-stitch-1.schema.json
std::string json_of(const StitchReport& report);

}  // namespace cleave::app
