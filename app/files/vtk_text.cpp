#include "files/vtk_text.hpp"

#include <charconv>
#include <cmath>
#include <string_view>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include "error.hpp"
#include "files/row.hpp"

namespace cleave::app {
namespace {

class LegacyText {
 public:
  std::string write(vtkUnstructuredGrid& grid) {
    text_ = "# vtk DataFile Version 4.2\nunstructured grid\nASCII\nDATASET UNSTRUCTURED_GRID\n";
    line("POINTS", grid.GetNumberOfPoints(), "double");
    write_values(*grid.GetPoints()->GetData(), "the points");
    const vtkIdType cells = grid.GetNumberOfCells();
    line("CELLS", cells, cells + grid.GetCells()->GetNumberOfConnectivityIds());
    for (vtkIdType c = 0; c < cells; ++c) {
      vtkIdType count = 0;
      const vtkIdType* nodes = nullptr;
      grid.GetCells()->GetCellAtId(c, count, nodes);
      put(count);
      for (vtkIdType k = 0; k < count; ++k) put(nodes[k]);
      end_line();
    }
    line("CELL_TYPES", cells);
    for (vtkIdType c = 0; c < cells; ++c) line(grid.GetCellType(c));
    write_data("POINT_DATA", grid.GetNumberOfPoints(), *grid.GetPointData());
    write_data("CELL_DATA", cells, *grid.GetCellData());
    return std::move(text_);
  }

 private:
  void put(std::string_view word) {
    if (in_line_) text_ += ' ';
    text_ += word;
    in_line_ = true;
  }
  void put(const char* word) { put(std::string_view(word)); }
  void put(const std::string& word) { put(std::string_view(word)); }
  template <class Number>
  void put(Number value) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    put(std::string_view(digits, static_cast<std::size_t>(end - digits)));
  }
  void end_line() {
    text_ += '\n';
    in_line_ = false;
  }
  template <class... Words>
  void line(const Words&... words) {
    (put(words), ...);
    end_line();
  }

  void write_data(const char* section, vtkIdType count, vtkDataSetAttributes& data) {
    if (data.GetNumberOfArrays() == 0) return;
    line(section, count);
    line("FIELD", "FieldData", data.GetNumberOfArrays());
    for (int a = 0; a < data.GetNumberOfArrays(); ++a) {
      vtkDataArray& array = *data.GetArray(a);
      line(encoded(array.GetName()), array.GetNumberOfComponents(), array.GetNumberOfTuples(),
           array.GetDataTypeAsString());
      write_values(array, array.GetName());
    }
  }

  void write_values(vtkDataArray& array, const char* name) {
    const bool real = array.GetDataType() == VTK_DOUBLE;
    for (vtkIdType i = 0; i < array.GetNumberOfTuples(); ++i) {
      for (int k = 0; k < array.GetNumberOfComponents(); ++k) {
        const double value = array.GetComponent(i, k);
        if (!std::isfinite(value))
          throw OutputError("'" + std::string(name) +
                            "' has a value that is not finite, or none on some elements, which VTK "
                            "cannot read from the text form of a .vtk file; write the binary form, "
                            "or .vtu");
        real ? put(value) : put(static_cast<long long>(value));
      }
      end_line();
    }
  }

  /// A name as one word: blanks and the like as percent signs and two digits.
  static std::string encoded(std::string_view name) {
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    std::string word;
    for (const char c : name) {
      const auto byte = static_cast<unsigned char>(c);
      if (byte > 32 && byte < 127 && c != '"' && c != '%')
        word += c;
      else
        (word += '%') += {kDigits[byte >> 4], kDigits[byte & 15]};
    }
    return word;
  }

  std::string text_;
  bool in_line_ = false;
};

bool has_not_finite(std::string_view line) {
  bool found = false;
  while (!line.empty()) {
    const auto blank = std::min(line.find_first_of(" \t"), line.size());
    double value = 0;
    const auto [end, error] = std::from_chars(line.data(), line.data() + blank, value);
    if (blank > 0 && (error != std::errc{} || end != line.data() + blank)) return false;
    found = found || !std::isfinite(value);
    line.remove_prefix(std::min(blank + 1, line.size()));
  }
  return found;
}

}  // namespace

std::string legacy_text(vtkUnstructuredGrid& grid) { return LegacyText().write(grid); }

void explain_not_finite(const std::filesystem::path& path) {
  const InputText text(path);
  if (text.bytes().find("\nASCII") == std::string_view::npos) return;
  RowReader rows(text, text.begin(), text.end());
  while (rows.more()) {
    const Row row = rows.next("a line");
    if (has_not_finite(row.rest()))
      row.fail(
          "a number that is not finite, which VTK cannot read from a text .vtk file; write "
          "the binary form, or .vtu");
  }
}

}  // namespace cleave::app
