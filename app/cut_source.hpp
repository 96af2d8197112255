#pragma once
#include <optional>
#include <string>

#include "mesh.hpp"
#include "progress.hpp"
#include "record.hpp"

namespace cleave::app {

/// A mesh file to cut, or to stitch: the mesh in it and, if it was cut before and the record of
/// that lies beside it, the mesh that was cut then.
struct CutSource {
  Mesh mesh;  // MESH: its numbers are those that requests and reports use
  std::optional<IncisionRecord> record;  // MESH.cleave.json
  std::optional<Mesh> restored;

  /// The mesh that cuts start from. Refers to this object.
  const Mesh& original() const { return restored ? *restored : mesh; }
};

/// Reads MESH and, unless `forget`, the record beside it. Throws InputError if either cannot be
/// read, or if the record was not written for these bytes. `how_far`: as for read_mesh.
CutSource read_source(const std::string& path, bool forget, const HowFar& how_far = {});

/// Whether the groups of the mesh are those that a cut leaves: facets NAME_minus and NAME_plus.
bool looks_cut(const Mesh& mesh);

/// What to warn of a mesh without a record that looks cut.
std::string warning_of_lost_record(const Mesh& mesh);

/// "m.msh: was cut before: 12 facets are opened and 3 shut, says m.msh.cleave.json"
std::string note_on(const CutSource& source);

}  // namespace cleave::app
