#include <algorithm>
#include <limits>

#include "error.hpp"
#include "files/msh_output.hpp"

namespace cleave::app {
namespace {

/// Values for a row of entities; a field that is null has none there.
struct Part {
  const Field* field;
  std::size_t count;
};

void write_part(MshRows& rows, const Part& part, std::size_t components,
                const std::uint64_t* number) {
  for (std::size_t i = 0; i < part.count; ++i, ++number) {
    rows.binary() ? rows.put(static_cast<std::int32_t>(*number)) : rows.put(*number);
    for (std::size_t k = 0; k < components; ++k)
      rows.put(part.field != nullptr ? part.field->values[components * i + k]
                                     : std::numeric_limits<double>::quiet_NaN());
    rows.end_row();
  }
}

/// One section with the values of all `parts`, fields like `field` or null; `numbers` are those of
/// all their entities.
void write_section(MshRows& rows, std::string_view section, const Field& field,
                   const std::vector<Part>& parts, const std::vector<std::uint64_t>& numbers) {
  if (field.name.find_first_of("\"\r\n") != std::string::npos)
    throw OutputError("the field '" + field.name +
                      "' cannot be named in a .msh file: no quotation mark or line break is "
                      "allowed; rename it");
  const bool too_great =
      std::any_of(numbers.begin(), numbers.end(), [](auto number) { return number > INT32_MAX; });
  if (rows.binary() && too_great)
    throw OutputError("the field '" + field.name +
                      "' lies on an entity whose number has more than the 32 bits that a binary "
                      ".msh file has there; write the text form");
  rows.open(section);
  rows.text() << "1\n\"" << field.name << "\"\n1\n0\n3\n0\n"
              << field.components << '\n'
              << numbers.size() << '\n';
  const std::uint64_t* number = numbers.data();
  for (const Part& part : parts) {
    write_part(rows, part, static_cast<std::size_t>(field.components), number);
    number += part.count;
  }
  rows.close(section);
}

const Field* find_like(const std::vector<Field>& fields, const Field& field) {
  for (const Field& other : fields)
    if (other.name == field.name && other.components == field.components) return &other;
  return nullptr;
}

}  // namespace

void write_msh_data(MshRows& rows, const Mesh& mesh, const MshNumbers& numbers) {
  for (const Field& field : mesh.point_fields)
    write_section(rows, "NodeData", field, {{&field, mesh.points.size()}}, numbers.nodes);
  const auto on_elements = [&](const Field& field, const Field* cells, const Field* facets) {
    std::vector<Part> parts;
    for (int d = 0; d <= 3; ++d) {
      const Field* own = d == mesh.dimension ? cells : d + 1 == mesh.dimension ? facets : nullptr;
      parts.push_back({own, mesh.elements[static_cast<std::size_t>(d)].size()});
    }
    parts.push_back({nullptr, mesh.cohesive.size()});
    write_section(rows, "ElementData", field, parts, numbers.elements);
  };
  for (const Field& field : mesh.cell_fields)
    on_elements(field, &field, find_like(mesh.facet_fields, field));
  for (const Field& field : mesh.facet_fields)
    if (find_like(mesh.cell_fields, field) == nullptr) on_elements(field, nullptr, &field);
}

}  // namespace cleave::app
