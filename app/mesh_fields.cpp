#include "mesh_fields.hpp"

#include <algorithm>
#include <limits>
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

std::vector<Field> take(const std::vector<Field>& fields, const std::vector<Index>& source,
                        Index none) {
  std::vector<Field> taken;
  for (const Field& field : fields) {
    Field& next = taken.emplace_back(Field{field.name, field.components, {}, field.integer});
    const auto width = static_cast<std::size_t>(field.components);
    next.values.reserve(width * source.size());
    for (const Index from : source)
      for (std::size_t i = 0; i < width; ++i)
        next.values.push_back(from != none    ? field.values[width * from + i]
                              : field.integer ? -1
                                              : std::numeric_limits<double>::quiet_NaN());
  }
  return taken;
}

std::vector<double> cell_tags(const Mesh& mesh) {
  std::vector<double> tags(mesh.cells().size());
  for (auto group = mesh.groups.rbegin(); group != mesh.groups.rend(); ++group)  // by falling tag
    if (group->dimension == mesh.dimension)
      for (const Index c : group->elements) tags[c] = group->tag;
  return tags;
}

}  // namespace cleave::app
