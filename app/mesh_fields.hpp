#pragma once
#include <vector>

#include "mesh.hpp"

namespace cleave::app {

/// Adds a field, or replaces the one of that name.
void set_field(std::vector<Field>& fields, Field field);

/// For each cell the least tag of the groups it is in; 0: none.
std::vector<double> cell_tags(const Mesh& mesh);

}  // namespace cleave::app
