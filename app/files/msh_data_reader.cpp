#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "files/msh_content.hpp"

namespace cleave::app {
namespace {

Row next_line(RowReader& rows, const char* what) { return rows.next(what); }
Row next_line(BinaryRows& rows, const char* what) { return rows.line(what); }

template <class Rows>
std::size_t tag_count(Rows& rows, const char* what) {
  Row row = next_line(rows, what);
  const auto count = row.number<std::uint32_t>(what);
  row.finish(what);
  return count;
}

/// The lines that say what the rows of the section are.
struct Header {
  std::string name;
  double time = 0;
  std::int64_t step = 0;
  std::size_t components = 0, count = 0;
  const char* place = nullptr;  // of the count
};

template <class Rows>
Header read_header(Rows& rows) {
  Header header;
  const std::size_t strings = tag_count(rows, "the number of names of a field");
  for (std::size_t i = 0; i < strings; ++i) {
    const Row row = next_line(rows, "the name of a field");
    const std::string_view name = row.rest();
    if (name.size() < 2 || name.front() != '"' || name.back() != '"')
      row.fail("expected the name of a field in quotation marks");
    if (i == 0) header.name = name.substr(1, name.size() - 2);
  }
  const std::size_t reals = tag_count(rows, "the number of real tags");
  for (std::size_t i = 0; i < reals; ++i) {
    Row row = next_line(rows, "a real tag");
    const auto value = row.number<double>("a real tag");
    if (i == 0) header.time = value;
  }
  const std::size_t integers = tag_count(rows, "the number of integer tags");
  for (std::size_t i = 0; i < integers; ++i) {
    Row row = next_line(rows, "an integer tag");
    const char* const kNames[] = {"the step", "the number of components", "the number of values"};
    const auto value = row.number<std::int64_t>(i < 3 ? kNames[i] : "an integer tag");
    if (i == 0) header.step = value;
    if ((i == 1 && value < 1) || (i == 2 && value < 0))
      row.fail(std::string(kNames[i]) + " is " + std::to_string(value));
    if (i == 1) header.components = static_cast<std::size_t>(value);
    if (i == 2) header.count = static_cast<std::size_t>(value);
    if (i < 3) header.place = row.begin();
  }
  if (integers < 3)
    rows.text().fail(rows.position() - 1,
                     "a field needs three integer tags: step, components and number of values");
  return header;
}

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// True if one of the values of an entity is a number: rows of NaN say that there is none.
bool any_value(const double* values, std::size_t components) {
  return !std::all_of(values, values + components, [](double x) { return std::isnan(x); });
}

/// Values of all entities in the order of `places`.
template <class Rows>
std::vector<double> read_values(Rows& rows, const Header& header, const MshNodes& places,
                                std::size_t entities, const char* kind) {
  constexpr bool kBinary = std::is_same_v<Rows, BinaryRows>;
  const std::size_t size = header.components;
  check_count(rows.text(), header.place, rows.text().end(), size, 1, "the number of components");
  check_count(rows.text(), header.place, rows.text().end(), header.count,
              kBinary ? 4 + 8 * size : 2 + 2 * size, "the number of values");
  constexpr std::size_t kUsual = 9;  // components of a tensor; more must be justified by the file
  if (size > kUsual && size * entities > rows.text().bytes().size())
    rows.text().fail(header.place, "a field of " + std::to_string(size) + " components has only " +
                                       std::to_string(header.count) + " values for " +
                                       std::to_string(entities) + " entities");
  std::vector<double> values(size * entities, kNone), row_values(size);
  for (std::size_t i = 0; i < header.count; ++i) {
    auto row = rows.next("a value");
    const std::uint64_t number = msh_number<true>(row, "the number that a value is of");
    for (double& x : row_values) x = row.template number<double>("a value");
    row.finish("a value");
    const Index place = places.find(number);
    if (place == MshNodes::kNone)
      row.fail("a value of " + std::string(kind) + " " + std::to_string(number) +
               ", which the file does not hold");
    if (place >= entities) continue;
    double* slot = values.data() + size * place;
    if (any_value(slot, size))
      row.fail("a second value of " + std::string(kind) + " " + std::to_string(number));
    std::copy(row_values.begin(), row_values.end(), slot);
  }
  if (rows.more()) rows.next("a value").fail("more values than the count says");
  return values;
}

/// Adds a field, or fills what a field of this name leaves open (gmsh writes a section per
/// partition).
void add_field(std::vector<Field>& fields, Field field, const MshSection& section,
               const InputText& text) {
  const auto same = [&](const Field& other) { return other.name == field.name; };
  const auto known = std::find_if(fields.begin(), fields.end(), same);
  if (known == fields.end()) {
    fields.push_back(std::move(field));
    return;
  }
  const std::string who = "a second section $" + section.name + " of '" + field.name + "' ";
  if (known->components != field.components)
    text.fail(section.opened, who + "with another number of components");
  const auto size = static_cast<std::size_t>(field.components);
  for (std::size_t i = 0; i < field.values.size(); i += size) {
    if (!any_value(&field.values[i], size)) continue;
    if (any_value(&known->values[i], size))
      text.fail(section.opened, who + "with values where there are some already");
    std::copy_n(&field.values[i], size, &known->values[i]);
  }
}

/// The numbers of all elements by dimension, then of quadrangles and prisms, then of elements that
/// were read once more.
std::vector<std::uint64_t> all_numbers(const MshContent& content) {
  std::vector<std::uint64_t> numbers;
  for (const Elements& elements : content.mesh.elements)
    numbers.insert(numbers.end(), elements.numbers.begin(), elements.numbers.end());
  for (const MshCohesive& list : content.cohesive)
    numbers.insert(numbers.end(), list.numbers.begin(), list.numbers.end());
  for (const MshRepeated& repeated : content.repeated) numbers.push_back(repeated.number);
  return numbers;
}

/// Gives the values of all elements to the cells and facets; says what is left over.
void split(const std::vector<double>& values, Field field, const MshSection& section,
           MshContent& content) {
  Mesh& mesh = content.mesh;
  const auto size = static_cast<std::size_t>(field.components);
  const int cells = content.dimension();
  std::array<std::size_t, 5> first{};  // of each dimension's elements among the values
  for (std::size_t d = 0; d <= 3; ++d) first[d + 1] = first[d] + mesh.elements[d].size();
  const auto part = [&](int d) {
    const auto from = static_cast<std::size_t>(d);
    Field of_dimension = field;
    of_dimension.values.assign(values.data() + size * first[from],
                               values.data() + size * first[from + 1]);
    return of_dimension;
  };
  const auto filled = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i)
      if (any_value(values.data() + size * i, size)) return true;
    return false;
  };
  const auto c = static_cast<std::size_t>(cells);
  const bool on_facets = filled(first[c - 1], first[c]);
  if (!on_facets || filled(first[c], first[c + 1]))
    add_field(mesh.cell_fields, part(cells), section, *content.text);
  if (on_facets) add_field(mesh.facet_fields, part(cells - 1), section, *content.text);
  if (filled(0, first[c - 1]) || filled(first[4], values.size() / size))
    content.drop(section.opened, "values of '" + field.name +
                                     "' on elements that are neither cells nor facets are dropped");
}

}  // namespace

template <class Rows>
void read_msh_data(Rows& rows, const MshSection& section, MshContent& content) {
  const Header header = read_header(rows);
  Field field{header.name, static_cast<int>(header.components), {}, false};
  if (header.step != 0) field.name += " (step " + std::to_string(header.step) + ")";
  if (header.time != 0)
    content.drop(section.opened, "the time of the field '" + field.name + "' is dropped");
  if (section.name == "NodeData") {
    field.values = read_values(rows, header, content.nodes, content.mesh.points.size(), "node");
    add_field(content.mesh.point_fields, std::move(field), section, *content.text);
    return;
  }
  if (content.dimension() == 0)
    content.text->fail(section.opened, "values on elements, but there are no cells");
  const std::vector<std::uint64_t> numbers = all_numbers(content);
  MshNodes places;
  places.index(numbers);
  const std::vector<double> values =
      read_values(rows, header, places, numbers.size() - content.repeated.size(), "element");
  split(values, std::move(field), section, content);
}

template void read_msh_data(RowReader&, const MshSection&, MshContent&);
template void read_msh_data(BinaryRows&, const MshSection&, MshContent&);

}  // namespace cleave::app
