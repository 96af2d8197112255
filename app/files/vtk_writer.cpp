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
#include "files/vtk_files.hpp"
#include "files/vtk_messages.hpp"

namespace cleave::app {
namespace {

constexpr std::array<unsigned char, 4> kCellType = {VTK_VERTEX, VTK_LINE, VTK_TRIANGLE, VTK_TETRA};

struct Place {
  std::size_t dimension;
  std::size_t element;
};

/// The order of cells in the file: as the numbers say if they are all those from 0 on, which is
/// how a VTK file numbers; else the highest dimension first, so that cell i is cell i of the mesh.
std::vector<Place> file_order(const Mesh& mesh) {
  std::size_t count = 0;
  for (const Elements& elements : mesh.elements) count += elements.size();
  std::vector<Place> by_dimension;
  by_dimension.reserve(count);
  std::vector<bool> taken(count, false);
  bool numbered = true;
  for (std::size_t d = 4; d-- > 0;) {
    const auto& numbers = mesh.elements[d].numbers;
    numbered = numbered && std::is_sorted(numbers.begin(), numbers.end());
    for (std::size_t e = 0; e < numbers.size(); ++e) {
      by_dimension.push_back({d, e});
      numbered = numbered && numbers[e] < count && !taken[numbers[e]];
      if (numbered) taken[numbers[e]] = true;
    }
  }
  if (!numbered) return by_dimension;
  std::vector<Place> by_number(count);
  for (const Place& place : by_dimension)
    by_number[mesh.elements[place.dimension].numbers[place.element]] = place;
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

void add_cells(vtkUnstructuredGrid& grid, const Mesh& mesh, const std::vector<Place>& order) {
  const vtkNew<vtkCellArray> cells;
  auto types = make_array<vtkUnsignedCharArray>("types", 1, order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t corners = order[i].dimension + 1;
    const auto* vertices = &mesh.elements[order[i].dimension].vertices[corners * order[i].element];
    std::array<vtkIdType, 4> ids{};
    std::copy(vertices, vertices + corners, ids.begin());
    cells->InsertNextCell(static_cast<vtkIdType>(corners), ids.data());
    types->SetValue(static_cast<vtkIdType>(i), kCellType[order[i].dimension]);
  }
  grid.SetCells(types, cells);
}

void add_cell_data(vtkUnstructuredGrid& grid, const Mesh& mesh, const std::vector<Place>& order,
                   const GroupIntegers& integers) {
  auto groups = make_array<vtkIntArray>("group", 1, order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    groups->SetValue(static_cast<vtkIdType>(i),
                     integers.of_element[order[i].dimension][order[i].element]);
  grid.GetCellData()->AddArray(groups);
  for (const Field& field : mesh.cell_fields) {
    if (field.name == "group") continue;  // said by the groups already
    const double none = field.integer ? -1.0 : std::numeric_limits<double>::quiet_NaN();
    grid.GetCellData()->AddArray(field_array(field, order.size(), [&](auto i, int k) {
      if (order[i].dimension != static_cast<std::size_t>(mesh.dimension)) return none;
      return field.values[order[i].element * static_cast<std::size_t>(field.components) +
                          static_cast<std::size_t>(k)];
    }));
  }
}

std::string xml_bytes(vtkUnstructuredGrid& grid) {
  const vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(&grid);
  writer->SetDataModeToBinary();
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

}  // namespace

std::string write_vtk(const Mesh& mesh, VtkFormat format, GroupIntegers& integers) {
  for (int dimension = 0; dimension <= 3; ++dimension)
    integers.encode(dimension, mesh.elements[static_cast<std::size_t>(dimension)].size(),
                    groups_of(mesh, dimension));
  const std::vector<Place> order = file_order(mesh);
  const VtkMessages messages;
  const vtkNew<vtkUnstructuredGrid> grid;
  add_points(*grid, mesh);
  add_cells(*grid, mesh, order);
  add_cell_data(*grid, mesh, order, integers);
  std::string bytes = format == VtkFormat::kXml ? xml_bytes(*grid) : legacy_bytes(*grid);
  if (messages.any() || bytes.empty())
    throw OutputError("VTK cannot write the mesh: " + messages.first());
  return bytes;
}

}  // namespace cleave::app
