#pragma once
#include <string>
#include <vector>

#include "mesh.hpp"

namespace cleave::app::test {

/// A mesh as small as can be that breaks a rule, for pictures and tests.
struct RuleExample {
  std::string rule;
  Mesh mesh;            // vertices and cells are numbered from 1
  std::string caption;  // what it is
};

/// One example per rule, in the order of `rules()`.
std::vector<RuleExample> rule_examples();

}  // namespace cleave::app::test
