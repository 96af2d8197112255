#include <algorithm>
#include <cstring>
#include <new>
#include <optional>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellTypes.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "error.hpp"
#include "files/input_text.hpp"
#include "files/vtk_files.hpp"
#include "files/vtk_messages.hpp"
#include "files/vtk_precheck.hpp"

namespace cleave::app {
namespace {

/// Integer cell data that name groups, in order of preference.
constexpr const char* kGroupArrays[] = {"group", "medit:ref", "gmsh:physical", "CellEntityIds"};

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& message) {
  throw InputError(path.string() + ": " + message);
}

vtkSmartPointer<vtkUnstructuredGrid> read_grid(const std::filesystem::path& path,
                                               VtkFormat format) {
  const VtkMessages messages;
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  try {
    if (format == VtkFormat::kXml) {
      const vtkNew<vtkXMLUnstructuredGridReader> reader;
      reader->SetFileName(path.c_str());
      reader->Update();
      grid = reader->GetOutput();
    } else {
      const vtkNew<vtkUnstructuredGridReader> reader;
      reader->SetFileName(path.c_str());
      reader->ReadAllScalarsOn();
      reader->ReadAllVectorsOn();
      reader->ReadAllNormalsOn();
      reader->ReadAllTensorsOn();
      reader->ReadAllTCoordsOn();
      reader->ReadAllFieldsOn();
      reader->Update();
      grid = reader->GetOutput();
    }
  } catch (const std::bad_alloc&) {
    fail(path, "the file asks for more memory than there is; its counts may be wrong");
  }
  if (messages.any())
    fail(path, "not a complete VTK unstructured grid; VTK says: " + messages.first());
  if (grid == nullptr) fail(path, "VTK reads no unstructured grid from it");
  return grid;
}

/// The dimension of a cell of one of the four types that are read.
std::optional<int> dimension_of(int type) {
  switch (type) {
    case VTK_VERTEX:
      return 0;
    case VTK_LINE:
      return 1;
    case VTK_TRIANGLE:
      return 2;
    case VTK_TETRA:
      return 3;
    default:
      return std::nullopt;
  }
}

[[noreturn]] void fail_cell_type(const std::filesystem::path& path, vtkIdType cell, int type) {
  const char* name = vtkCellTypes::GetClassNameFromTypeId(type);
  fail(path, "cell " + std::to_string(cell) + " is a " + (name != nullptr ? name : "cell") +
                 " (VTK type " + std::to_string(type) +
                 "); Cleave works on vertices, lines, triangles and tetrahedra of order 1: split "
                 "it first, e.g. by vtkDataSetTriangleFilter (ParaView: Tetrahedralize)");
}

class GridReader {
 public:
  GridReader(const std::filesystem::path& path, vtkUnstructuredGrid& grid)
      : path_(path), grid_(grid) {}

  Mesh read() {
    mesh_.source = path_.string();
    read_points();
    read_cells();
    for (int d = 3; d > 0 && mesh_.dimension == 0; --d)
      if (mesh_.elements[static_cast<std::size_t>(d)].size() > 0) mesh_.dimension = d;
    read_point_data();
    read_cell_data();
    return std::move(mesh_);
  }

 private:
  void read_points() {
    const vtkIdType count = grid_.GetNumberOfPoints();
    if (count > std::numeric_limits<std::uint32_t>::max())
      fail(path_, std::to_string(count) + " points are more than 32-bit ids can number");
    mesh_.points.resize(static_cast<std::size_t>(count));
    mesh_.vertex_numbers.resize(mesh_.points.size());
    for (vtkIdType i = 0; i < count; ++i) {
      grid_.GetPoint(i, mesh_.points[static_cast<std::size_t>(i)].data());
      mesh_.vertex_numbers[static_cast<std::size_t>(i)] = static_cast<std::uint64_t>(i);
    }
  }

  void read_cells() {
    const vtkIdType count = grid_.GetNumberOfCells();
    if (count == 0) return;
    vtkCellArray& cells = *grid_.GetCells();
    check_offsets(cells, count);
    place_.reserve(static_cast<std::size_t>(count));
    for (vtkIdType cell = 0; cell < count; ++cell) {
      const int type = grid_.GetCellType(cell);
      const auto dimension = dimension_of(type);
      if (!dimension) fail_cell_type(path_, cell, type);
      vtkIdType corners = 0;
      const vtkIdType* vertices = nullptr;
      cells.GetCellAtId(cell, corners, vertices);
      if (corners != *dimension + 1)
        fail(path_, "cell " + std::to_string(cell) + " (VTK type " + std::to_string(type) +
                        ") has " + std::to_string(corners) + " points instead of " +
                        std::to_string(*dimension + 1));
      Elements& elements = mesh_.elements[static_cast<std::size_t>(*dimension)];
      for (vtkIdType k = 0; k < corners; ++k) {
        if (vertices[k] < 0 || vertices[k] >= grid_.GetNumberOfPoints())
          fail(path_, "cell " + std::to_string(cell) + " uses point " +
                          std::to_string(vertices[k]) + ", but the file has " +
                          std::to_string(grid_.GetNumberOfPoints()) + " points, from 0 on");
        elements.vertices.push_back(static_cast<std::uint32_t>(vertices[k]));
      }
      place_.push_back({*dimension, static_cast<std::uint32_t>(elements.size())});
      elements.numbers.push_back(static_cast<std::uint64_t>(cell));
    }
  }

  /// VTK takes offsets as they are; a wrong one would read outside of the connectivity.
  void check_offsets(vtkCellArray& cells, vtkIdType count) const {
    vtkDataArray& offsets = *cells.GetOffsetsArray();
    bool good = cells.GetNumberOfCells() == count && offsets.GetNumberOfTuples() == count + 1 &&
                offsets.GetTuple1(0) == 0 &&
                offsets.GetTuple1(count) == static_cast<double>(cells.GetNumberOfConnectivityIds());
    for (vtkIdType i = 0; good && i < count; ++i)
      good = offsets.GetTuple1(i) <= offsets.GetTuple1(i + 1);
    if (!good) fail(path_, "the offsets of the cells do not fit their connectivity");
  }

  void read_point_data() {
    vtkPointData& data = *grid_.GetPointData();
    for (int a = 0; a < data.GetNumberOfArrays(); ++a) {
      vtkDataArray* array = data.GetArray(a);
      if (array == nullptr) continue;  // text
      Field field = start_field(*array, grid_.GetNumberOfPoints());
      for (vtkIdType i = 0; i < grid_.GetNumberOfPoints(); ++i) append(field, *array, i);
      mesh_.point_fields.push_back(std::move(field));
    }
  }

  void read_cell_data() {
    vtkCellData& data = *grid_.GetCellData();
    vtkDataArray* groups = nullptr;
    for (const char* name : kGroupArrays) {
      vtkDataArray* array = data.GetArray(name);
      if (groups == nullptr && array != nullptr && is_integer(*array) &&
          array->GetNumberOfComponents() == 1)
        groups = array;
    }
    for (int a = 0; a < data.GetNumberOfArrays(); ++a) {
      vtkDataArray* array = data.GetArray(a);
      if (array == nullptr || array == groups) continue;
      Field field = start_field(*array, grid_.GetNumberOfCells());
      for (vtkIdType i = 0; i < grid_.GetNumberOfCells(); ++i)
        if (place_[static_cast<std::size_t>(i)].dimension == mesh_.dimension)
          append(field, *array, i);
      mesh_.cell_fields.push_back(std::move(field));
    }
    if (groups != nullptr) read_groups(*groups);
  }

  void read_groups(vtkDataArray& array) {
    start_field(array, grid_.GetNumberOfCells());
    std::array<std::vector<std::int32_t>, 4> integers;
    for (vtkIdType i = 0; i < grid_.GetNumberOfCells(); ++i) {
      const double value = array.GetTuple1(i);
      if (std::abs(value) > INT32_MAX)
        fail(path_, "cell data '" + std::string(array.GetName()) + "' of cell " +
                        std::to_string(i) + " has more than 32 bits; it numbers groups");
      const int dimension = place_[static_cast<std::size_t>(i)].dimension;
      integers[static_cast<std::size_t>(dimension)].push_back(static_cast<std::int32_t>(value));
    }
    for (int dimension = 0; dimension <= 3; ++dimension)
      for (Group& group :
           groups_from_integers(dimension, integers[static_cast<std::size_t>(dimension)]))
        mesh_.groups.push_back(std::move(group));
  }

  static bool is_integer(vtkDataArray& array) {
    return array.GetDataType() != VTK_FLOAT && array.GetDataType() != VTK_DOUBLE;
  }

  Field start_field(vtkDataArray& array, vtkIdType expected) const {
    Field field;
    field.name = array.GetName() != nullptr ? array.GetName() : "";
    field.components = array.GetNumberOfComponents();
    field.integer = is_integer(array);
    if (array.GetNumberOfTuples() != expected)
      fail(path_, "data '" + field.name + "' has " + std::to_string(array.GetNumberOfTuples()) +
                      " entries instead of " + std::to_string(expected));
    field.values.reserve(static_cast<std::size_t>(array.GetNumberOfValues()));
    return field;
  }

  void append(Field& field, vtkDataArray& array, vtkIdType entry) const {
    constexpr double kExact = 9007199254740992.0;  // integers above 2^53 would be rounded
    for (int k = 0; k < field.components; ++k) {
      const double value = array.GetComponent(entry, k);
      if (field.integer && std::abs(value) >= kExact)
        fail(path_, "data '" + field.name + "' has integers of more than 53 bits (entry " +
                        std::to_string(entry) + "), which would be rounded; remove that array");
      field.values.push_back(value);
    }
  }

  struct Place {
    int dimension;
    std::uint32_t element;
  };
  const std::filesystem::path& path_;
  vtkUnstructuredGrid& grid_;
  Mesh mesh_;
  std::vector<Place> place_;  // per cell of the grid
};

}  // namespace

Mesh read_vtk(const std::filesystem::path& path, VtkFormat format) {
  precheck_vtk(path, format);
  const auto grid = read_grid(path, format);
  return GridReader(path, *grid).read();
}

}  // namespace cleave::app
