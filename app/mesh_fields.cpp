#include "mesh_fields.hpp"

#include <algorithm>
#include <utility>

namespace cleave::app {

void set_field(std::vector<Field>& fields, Field field) {
  const auto same = [&](const Field& other) { return other.name == field.name; };
  const auto at = std::find_if(fields.begin(), fields.end(), same);
  if (at == fields.end())
    fields.push_back(std::move(field));
  else
    *at = std::move(field);
}

std::vector<double> cell_tags(const Mesh& mesh) {
  std::vector<double> tags(mesh.cells().size());
  for (auto group = mesh.groups.rbegin(); group != mesh.groups.rend(); ++group)  // by falling tag
    if (group->dimension == mesh.dimension)
      for (const std::uint32_t c : group->elements) tags[c] = group->tag;
  return tags;
}

}  // namespace cleave::app
