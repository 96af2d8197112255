#pragma once
#include <string_view>

namespace cleave::app {

/// What an element type of Abaqus is to a mesh.
struct AbaqusType {
  int dimension = 0;  // of the simplex; of the body that a cohesive element is in
  bool second_order = false;
  bool cohesive = false;
  int nodes = 0;
};

/// The type of this name (upper case); null if its elements are no simplices or not known.
const AbaqusType* abaqus_type(std::string_view name);

}  // namespace cleave::app
