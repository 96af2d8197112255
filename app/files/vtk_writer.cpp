#include <algorithm>
#include <array>
#include <limits>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkLongArray.h>
#include <vtkLongLongArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include "error.hpp"
#include "files/group_sets.hpp"
#include "files/midside.hpp"
#include "files/vtk_cohesive.hpp"
#include "files/vtk_files.hpp"
#include "files/vtk_messages.hpp"
#include "files/vtk_text.hpp"

namespace cleave::app {
namespace {

constexpr std::size_t kCohesive = 4;

/// An element: its dimension, or kCohesive, and its place.
struct Place {
  std::size_t kind;
  std::size_t element;
};

const std::vector<std::uint64_t>& numbers_of(const Mesh& mesh, std::size_t kind) {
  return kind == kCohesive ? mesh.cohesive.numbers : mesh.elements[kind].numbers;
}

/// The order of cells in the file: as the numbers say if they are all those from 0 on, which is
/// how a VTK file numbers; else the highest dimension first, so that cell i is cell i of the mesh.
std::vector<Place> file_order(const Mesh& mesh) {
  constexpr std::array<std::size_t, 5> kKinds = {3, 2, 1, 0, kCohesive};
  std::size_t count = 0;
  for (const std::size_t kind : kKinds) count += numbers_of(mesh, kind).size();
  std::vector<Place> by_kind;
  by_kind.reserve(count);
  std::vector<bool> taken(count, false);
  bool numbered = true;
  for (const std::size_t kind : kKinds) {
    const auto& numbers = numbers_of(mesh, kind);
    numbered = numbered && std::is_sorted(numbers.begin(), numbers.end());
    for (std::size_t e = 0; e < numbers.size(); ++e) {
      by_kind.push_back({kind, e});
      numbered = numbered && numbers[e] < count && !taken[numbers[e]];
      if (numbered) taken[numbers[e]] = true;
    }
  }
  if (!numbered) return by_kind;
  std::vector<Place> by_number(count);
  for (const Place& place : by_kind) by_number[numbers_of(mesh, place.kind)[place.element]] = place;
  return by_number;
}

/// A data array of `name` with `count` entries, to be filled by the caller.
template <class Array>
vtkSmartPointer<Array> make_array(const std::string& name, int components, std::size_t count) {
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  return array;
}

/// Of 64 bits. A legacy file calls such a long array "long", as every reader knows; a long long one
/// "vtktypeint64", which version 4.2 of the format does not have.
using IntegerArray = std::conditional_t<sizeof(long) == 8, vtkLongArray, vtkLongLongArray>;

/// Fills an array by `value(entry, component)`.
template <class Array, class Value>
vtkSmartPointer<vtkDataArray> filled(const Field& field, std::size_t count, Value value) {
  using Number = typename Array::ValueType;
  auto array = make_array<Array>(field.name, field.components, count);
  for (std::size_t i = 0; i < count; ++i)
    for (int k = 0; k < field.components; ++k)
      array->SetTypedComponent(static_cast<vtkIdType>(i), k, static_cast<Number>(value(i, k)));
  return array;
}

template <class Value>
vtkSmartPointer<vtkDataArray> field_array(const Field& field, std::size_t count, Value value) {
  if (field.integer) return filled<IntegerArray>(field, count, value);
  return filled<vtkDoubleArray>(field, count, value);
}

void add_points(vtkUnstructuredGrid& grid, const Mesh& mesh) {
  const vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.points.size()));
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    points->SetPoint(static_cast<vtkIdType>(v), mesh.points[v].data());
  grid.SetPoints(points);
  for (const Field& field : mesh.point_fields)
    grid.GetPointData()->AddArray(field_array(field, mesh.points.size(), [&](auto i, int k) {
      return field
          .values[i * static_cast<std::size_t>(field.components) + static_cast<std::size_t>(k)];
    }));
}

/// The type of an element and its nodes in VTK's order.
int cell_of(const Mesh& mesh, const Place& place, std::vector<vtkIdType>& nodes) {
  nodes.clear();
  if (place.kind == kCohesive) {
    const std::size_t count = 2 * static_cast<std::size_t>(mesh.dimension);
    for (std::size_t k = 0; k < count; ++k)
      nodes.push_back(mesh.cohesive.vertices[count * place.element + vtk_cohesive_node(count, k)]);
    return mesh.dimension == 3 ? VTK_WEDGE : VTK_QUAD;
  }
  constexpr std::array kFirst = {VTK_VERTEX, VTK_LINE, VTK_TRIANGLE, VTK_TETRA};
  constexpr std::array kSecond = {VTK_VERTEX, VTK_QUADRATIC_EDGE, VTK_QUADRATIC_TRIANGLE,
                                  VTK_QUADRATIC_TETRA};
  const std::size_t d = place.kind;
  const Elements& elements = mesh.elements[d];
  for (std::size_t k = 0; k <= d; ++k)
    nodes.push_back(elements.vertices[(d + 1) * place.element + k]);
  if (!elements.second_order()) return kFirst[d];
  for (std::size_t k = 0; k < edges_of_simplex(d); ++k)
    nodes.push_back(midside_node(elements, d, kCyclicMidside, place.element, k));
  return kSecond[d];
}

void add_cells(vtkUnstructuredGrid& grid, const Mesh& mesh, const std::vector<Place>& order) {
  const vtkNew<vtkCellArray> cells;
  auto types = make_array<vtkUnsignedCharArray>("types", 1, order.size());
  std::vector<vtkIdType> nodes;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const int type = cell_of(mesh, order[i], nodes);
    cells->InsertNextCell(static_cast<vtkIdType>(nodes.size()), nodes.data());
    types->SetValue(static_cast<vtkIdType>(i), static_cast<unsigned char>(type));
  }
  grid.SetCells(types, cells);
}

/// An array with the values of a field of cells and of one of facets; either may be null.
void add_element_field(vtkUnstructuredGrid& grid, const Mesh& mesh, const std::vector<Place>& order,
                       const Field* cells, const Field* facets) {
  const Field& field = cells != nullptr ? *cells : *facets;
  if (field.name == "group") return;  // said by the groups already
  const double none = field.integer ? -1.0 : std::numeric_limits<double>::quiet_NaN();
  const auto components = static_cast<std::size_t>(field.components);
  const auto dimension = static_cast<std::size_t>(mesh.dimension);
  grid.GetCellData()->AddArray(field_array(field, order.size(), [&](auto i, int k) {
    const Field* own = order[i].kind == dimension       ? cells
                       : order[i].kind + 1 == dimension ? facets
                                                        : nullptr;
    return own == nullptr
               ? none
               : own->values[order[i].element * components + static_cast<std::size_t>(k)];
  }));
}

const Field* find_like(const std::vector<Field>& fields, const Field& field) {
  for (const Field& other : fields)
    if (other.name == field.name && other.components == field.components &&
        other.integer == field.integer)
      return &other;
  return nullptr;
}

bool has_name(const std::vector<Field>& fields, const std::string& name) {
  return std::any_of(fields.begin(), fields.end(),
                     [&](const Field& field) { return field.name == name; });
}

void add_cell_data(vtkUnstructuredGrid& grid, const Mesh& mesh, const std::vector<Place>& order,
                   const GroupIntegers& integers) {
  auto groups = make_array<vtkIntArray>("group", 1, order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    groups->SetValue(static_cast<vtkIdType>(i),
                     order[i].kind == kCohesive
                         ? integers.of_cohesive[order[i].element]
                         : integers.of_element[order[i].kind][order[i].element]);
  grid.GetCellData()->AddArray(groups);
  for (const Field& field : mesh.cell_fields)
    add_element_field(grid, mesh, order, &field, find_like(mesh.facet_fields, field));
  for (const Field& field : mesh.facet_fields)
    if (!has_name(mesh.cell_fields, field.name))  // one array per name
      add_element_field(grid, mesh, order, nullptr, &field);
}

std::string xml_bytes(vtkUnstructuredGrid& grid, VtuEncoding encoding) {
  const vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(&grid);
  if (encoding == VtuEncoding::kText)
    writer->SetDataModeToAscii();
  else if (encoding == VtuEncoding::kRaw)
    writer->SetDataModeToAppended();
  else
    writer->SetDataModeToBinary();
  writer->EncodeAppendedDataOff();
  if (encoding == VtuEncoding::kZlib)
    writer->SetCompressorTypeToZLib();
  else
    writer->SetCompressorTypeToNone();
  writer->SetHeaderTypeToUInt64();
  writer->WriteToOutputStringOn();
  writer->Write();
  return writer->GetOutputString();
}

std::string legacy_bytes(vtkUnstructuredGrid& grid) {
  const vtkNew<vtkUnstructuredGridWriter> writer;
  writer->SetInputData(&grid);
  writer->SetFileTypeToBinary();
  writer->SetHeader("unstructured grid");
  writer->SetFileVersion(vtkUnstructuredGridWriter::VTK_LEGACY_READER_VERSION_4_2);
  writer->WriteToOutputStringOn();
  writer->Write();
  return writer->GetOutputStdString();
}

template <class Write>
std::string write_grid(const Mesh& mesh, GroupIntegers& integers, const Write& write) {
  for (int dimension = 0; dimension <= 3; ++dimension)
    integers.encode(dimension, mesh.elements[static_cast<std::size_t>(dimension)].size(),
                    groups_of(mesh, dimension));
  integers.encode_cohesive(mesh.cohesive.names);
  const std::vector<Place> order = file_order(mesh);
  const VtkMessages messages;
  const vtkNew<vtkUnstructuredGrid> grid;
  add_points(*grid, mesh);
  add_cells(*grid, mesh, order);
  add_cell_data(*grid, mesh, order, integers);
  std::string bytes = write(*grid);
  if (messages.any() || bytes.empty())
    throw OutputError("VTK cannot write the mesh: " + messages.first());
  return bytes;
}

}  // namespace

std::string write_vtu(const Mesh& mesh, VtuEncoding encoding, GroupIntegers& integers) {
  return write_grid(mesh, integers, [&](auto& grid) { return xml_bytes(grid, encoding); });
}

std::string write_vtk(const Mesh& mesh, bool binary, GroupIntegers& integers) {
  return write_grid(mesh, integers,
                    [&](auto& grid) { return binary ? legacy_bytes(grid) : legacy_text(grid); });
}

}  // namespace cleave::app
