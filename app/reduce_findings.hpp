#pragma once
#include <cstdint>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "check_report.hpp"
#include "sub_mesh.hpp"

namespace cleave::app {

/// The findings of a mesh, to compare those of its parts with. Parts keep the numbers of the mesh,
/// so that witnesses can be compared; the mesh must outlive this object.
class KnownFindings {
 public:
  KnownFindings(const Mesh& mesh, topology::Level required);

  const std::vector<Finding>& all() const { return report_.findings; }

  /// The findings of a part.
  std::vector<Finding> of(const SubMesh& part) const;

  /// Whether the mesh has a finding of this rule.
  bool has_rule(const std::string& rule) const { return rules_.count(rule) != 0; }

  /// The vertices (places in the mesh) that the witness of a finding names itself.
  std::vector<Index> vertices(const Finding& finding) const;

  /// The cells (places in the mesh) that the witness names, ascending.
  std::vector<Index> cells(const Finding& finding) const;

  /// The vertices of all findings whose rule the mesh has none of; sets `any` if there are any.
  std::vector<Index> blame(const std::vector<Finding>& findings, bool& any) const;

 private:
  CheckSettings settings_;
  CheckReport report_;
  std::set<std::string> rules_;
  std::unordered_map<std::uint64_t, Index> vertex_at_, cell_at_;  // by the file's number
};

}  // namespace cleave::app
