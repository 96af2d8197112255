#pragma once
#include <cstdint>
#include <vector>

#include "mesh.hpp"

namespace cleave::app {

/// Adds a field, or replaces the one of that name.
void set_field(std::vector<Field>& fields, Field field);

/// The fields of entities of which the i-th takes the values of entity `source[i]` of `fields`;
/// where that is `none`, NaN, or -1 if the field is of integers.
std::vector<Field> take(const std::vector<Field>& fields, const std::vector<Index>& source,
                        Index none);

/// For each cell the least tag of the groups it is in; 0: none.
std::vector<double> cell_tags(const Mesh& mesh);

}  // namespace cleave::app
