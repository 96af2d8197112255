#include "reduce_findings.hpp"

#include <algorithm>

namespace cleave::app {
namespace {

std::vector<std::uint64_t> numbers_in(const WitnessValue& value) {
  if (const auto* one = std::get_if<std::uint64_t>(&value)) return {*one};
  if (const auto* several = std::get_if<std::vector<std::uint64_t>>(&value)) return *several;
  return {};
}

// The places of the numbers that the witness has under one of these keys.
std::vector<Index> places(const Finding& finding, const std::set<std::string>& keys,
                          const std::unordered_map<std::uint64_t, Index>& at) {
  std::vector<Index> result;
  for (const auto& [key, value] : finding.witness) {
    if (keys.count(key) == 0) continue;
    for (const std::uint64_t number : numbers_in(value)) {
      const auto found = at.find(number);
      if (found != at.end()) result.push_back(found->second);
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace

KnownFindings::KnownFindings(const Mesh& mesh, topology::Level required) {
  settings_.required = required;
  settings_.betti = CountHoles::never;
  report_ = check_mesh(mesh, settings_);
  for (const Finding& finding : report_.findings) rules_.insert(finding.rule);
  for (Index v = 0; v < mesh.vertex_numbers.size(); ++v)
    vertex_at_.emplace(mesh.vertex_numbers[v], v);
  for (Index c = 0; c < mesh.cells().size(); ++c) cell_at_.emplace(mesh.cells().numbers[c], c);
}

std::vector<Finding> KnownFindings::of(const SubMesh& part) const {
  return check_mesh(part.mesh, settings_).findings;
}

std::vector<Index> KnownFindings::vertices(const Finding& finding) const {
  return places(finding, {"vertex", "vertices", "edge", "facet"}, vertex_at_);
}

std::vector<Index> KnownFindings::cells(const Finding& finding) const {
  return places(finding, {"cell", "cells"}, cell_at_);
}

std::vector<Index> KnownFindings::blame(const std::vector<Finding>& findings, bool& any) const {
  any = false;
  std::vector<Index> all;
  for (const Finding& finding : findings) {
    if (has_rule(finding.rule)) continue;
    any = true;
    const auto some = vertices(finding);
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

}  // namespace cleave::app
