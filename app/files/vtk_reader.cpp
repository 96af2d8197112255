#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <new>
#include <optional>
#include <span>

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
#include "files/midside.hpp"
#include "files/vtk_cohesive.hpp"
#include "files/vtk_files.hpp"
#include "files/vtk_messages.hpp"
#include "files/vtk_precheck.hpp"
#include "files/vtk_text.hpp"

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
  if (messages.any() && format == VtkFormat::kLegacy) explain_not_finite(path);
  if (messages.any())
    fail(path, "not a complete VTK unstructured grid; VTK says: " + messages.first());
  if (grid == nullptr) fail(path, "VTK reads no unstructured grid from it");
  return grid;
}

/// What is read of a type of cells.
struct CellType {
  std::size_t dimension;
  vtkIdType nodes;
  bool second_order = false, cohesive = false;
};

std::optional<CellType> cell_type(int type) {
  switch (type) {
    case VTK_VERTEX:
      return CellType{0, 1};
    case VTK_LINE:
      return CellType{1, 2};
    case VTK_TRIANGLE:
      return CellType{2, 3};
    case VTK_TETRA:
      return CellType{3, 4};
    case VTK_QUADRATIC_EDGE:
      return CellType{1, 3, true};
    case VTK_QUADRATIC_TRIANGLE:
      return CellType{2, 6, true};
    case VTK_QUADRATIC_TETRA:
      return CellType{3, 10, true};
    case VTK_QUAD:
      return CellType{2, 4, false, true};
    case VTK_WEDGE:
      return CellType{3, 6, false, true};
    default:
      return std::nullopt;
  }
}

[[noreturn]] void fail_cell_type(const std::filesystem::path& path, vtkIdType cell, int type) {
  const char* name = vtkCellTypes::GetClassNameFromTypeId(type);
  fail(path, "cell " + std::to_string(cell) + " is a " + (name != nullptr ? name : "cell") +
                 " (VTK type " + std::to_string(type) +
                 "); Cleave works on vertices, lines, triangles and tetrahedra, and knows "
                 "wedges (among tetrahedra) and quadrangles (among triangles) without thickness "
                 "as cohesive elements: split it first, e.g. by vtkDataSetTriangleFilter "
                 "(ParaView: Tetrahedralize)");
}

class GridReader {
 public:
  GridReader(const std::filesystem::path& path, vtkUnstructuredGrid& grid)
      : path_(path), grid_(grid) {}

  Mesh read() {
    mesh_.source = path_.string();
    read_points();
    read_cells();
    read_point_data();
    read_cell_data();
    return std::move(mesh_);
  }

 private:
  void read_points() {
    const vtkIdType count = grid_.GetNumberOfPoints();
    if (static_cast<std::uint64_t>(count) >= topology::kNoIndex)
      fail(path_, std::to_string(count) + " points are more than " +
                      std::to_string(topology::kIdBits) + "-bit ids can number");
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
      const auto type = cell_type(grid_.GetCellType(cell));
      if (!type) fail_cell_type(path_, cell, grid_.GetCellType(cell));
      read_cell(cells, cell, *type);
      if (!type->cohesive)
        mesh_.dimension = std::max(mesh_.dimension, static_cast<int>(type->dimension));
    }
    for (std::size_t i = 0; i < place_.size(); ++i)
      if (place_[i].kind == kCohesive) check_cohesive(static_cast<vtkIdType>(i));
  }

  void read_cell(vtkCellArray& cells, vtkIdType cell, const CellType& type) {
    vtkIdType count = 0;
    const vtkIdType* nodes = nullptr;
    cells.GetCellAtId(cell, count, nodes);
    if (count != type.nodes)
      fail(path_, "cell " + std::to_string(cell) + " (VTK type " +
                      std::to_string(grid_.GetCellType(cell)) + ") has " + std::to_string(count) +
                      " points instead of " + std::to_string(type.nodes));
    std::array<Index, 10> vertices{};
    for (vtkIdType k = 0; k < count; ++k) {
      if (nodes[k] < 0 || nodes[k] >= grid_.GetNumberOfPoints())
        fail(path_, "cell " + std::to_string(cell) + " uses point " + std::to_string(nodes[k]) +
                        ", but the file has " + std::to_string(grid_.GetNumberOfPoints()) +
                        " points, from 0 on");
      vertices[static_cast<std::size_t>(k)] = static_cast<Index>(nodes[k]);
    }
    type.cohesive ? add_cohesive(vertices, static_cast<std::size_t>(count), cell)
                  : add_simplex(vertices, type, cell);
  }

  void add_cohesive(const std::array<Index, 10>& vertices, std::size_t count, vtkIdType cell) {
    CohesiveElements& cohesive = mesh_.cohesive;
    place_.push_back({kCohesive, static_cast<Index>(cohesive.size())});
    const std::size_t first = cohesive.vertices.size();
    cohesive.vertices.resize(first + count);
    for (std::size_t k = 0; k < count; ++k)
      cohesive.vertices[first + vtk_cohesive_node(count, k)] = vertices[k];
    cohesive.numbers.push_back(static_cast<std::uint64_t>(cell));
    cohesive.names.emplace_back();
  }

  void add_simplex(const std::array<Index, 10>& vertices, const CellType& type, vtkIdType cell) {
    const std::size_t d = type.dimension;
    Elements& elements = mesh_.elements[d];
    if (elements.size() > 0 && elements.second_order() != type.second_order)
      fail(path_, "cell " + std::to_string(cell) +
                      " is of another order than the cells of its dimension before it; convert "
                      "the mesh to one order");
    place_.push_back({d, static_cast<Index>(elements.size())});
    elements.vertices.insert(elements.vertices.end(), vertices.begin(),
                             vertices.begin() + static_cast<std::ptrdiff_t>(d + 1));
    if (type.second_order)
      add_midside(elements, d, kCyclicMidside,
                  std::span(vertices).subspan(d + 1, edges_of_simplex(d)));
    elements.numbers.push_back(static_cast<std::uint64_t>(cell));
  }

  /// A wedge or quadrangle must lie between cells of its dimension, without thickness.
  void check_cohesive(vtkIdType cell) const {
    const auto d = static_cast<std::size_t>(mesh_.dimension);
    const std::size_t element = place_[static_cast<std::size_t>(cell)].element;
    bool good = d > 1 && grid_.GetCellType(cell) == (d == 3 ? VTK_WEDGE : VTK_QUAD);
    for (std::size_t k = 0; good && k < d; ++k) {
      const auto* vertices = &mesh_.cohesive.vertices[2 * d * element];
      good = mesh_.points[vertices[k]] == mesh_.points[vertices[d + k]];
    }
    if (!good) fail_cell_type(path_, cell, grid_.GetCellType(cell));
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
      read_element_field(*array);
    }
    if (groups != nullptr) read_groups(*groups);
  }

  /// Values on cells make a field, and values on facets one of theirs, unless there are none (NaN,
  /// or -1 in integers): then the array is about the others.
  void read_element_field(vtkDataArray& array) {
    Field cells = start_field(array, grid_.GetNumberOfCells()), facets = cells;
    const auto dimension = static_cast<std::size_t>(mesh_.dimension);
    bool elsewhere = false;
    for (vtkIdType i = 0; i < grid_.GetNumberOfCells(); ++i) {
      const std::size_t kind = place_[static_cast<std::size_t>(i)].kind;
      if (kind == dimension)
        append(cells, array, i);
      else if (kind + 1 == dimension)
        append(facets, array, i);
      else
        elsewhere = elsewhere || !is_none(array, i);
    }
    if (elsewhere)
      mesh_.dropped.push_back(path_.string() + ": the values of cell data '" + cells.name +
                              "' on elements that are neither cells nor facets");
    const bool on_facets = has_values(facets);
    if (has_values(cells) || !on_facets) mesh_.cell_fields.push_back(std::move(cells));
    if (on_facets) mesh_.facet_fields.push_back(std::move(facets));
  }

  static bool is_none(bool integer, double value) {
    return integer ? value == -1 : std::isnan(value);
  }

  static bool is_none(vtkDataArray& array, vtkIdType entry) {
    for (int k = 0; k < array.GetNumberOfComponents(); ++k)
      if (!is_none(is_integer(array), array.GetComponent(entry, k))) return false;
    return true;
  }

  static bool has_values(const Field& field) {
    return std::any_of(field.values.begin(), field.values.end(),
                       [&](double value) { return !is_none(field.integer, value); });
  }

  void read_groups(vtkDataArray& array) {
    start_field(array, grid_.GetNumberOfCells());
    std::array<std::vector<std::int32_t>, 4> integers;
    for (vtkIdType i = 0; i < grid_.GetNumberOfCells(); ++i) {
      const double value = array.GetTuple1(i);
      if (std::abs(value) > INT32_MAX)
        fail(path_, "cell data '" + std::string(array.GetName()) + "' of cell " +
                        std::to_string(i) + " has more than 32 bits; it numbers groups");
      const Place& place = place_[static_cast<std::size_t>(i)];
      const auto integer = static_cast<std::int32_t>(value);
      if (place.kind != kCohesive)
        integers[place.kind].push_back(integer);
      else if (integer != 0)
        mesh_.cohesive.names[place.element] = std::to_string(integer);
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

  static constexpr std::size_t kCohesive = 4;

  /// An element: its dimension, or kCohesive, and its place.
  struct Place {
    std::size_t kind;
    Index element;
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
