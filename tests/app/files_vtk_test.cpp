// VTK files: what is refused, and that nothing is printed.
#include "error.hpp"
#include "files_support.hpp"
#include "mesh_file.hpp"

/// VTK 9.1 forgets the arrays it has begun when vtkUnstructuredGridReader::ReadMeshSimple meets an
/// error in a damaged legacy file. Its stack frames cannot be walked further than the allocation.
extern "C" const char* __lsan_default_suppressions() {  // NOLINT(bugprone-reserved-identifier)
  return "leak:vtkUnstructuredGridReader::ReadMeshSimple\n"
         "leak:vtkCellArray::New\n"
         "leak:vtkTypeInt64Array::New\n";
}

namespace cleave::app::test {
namespace {

/// Reading may not print anything, whatever the file: VTK would, to stderr.
class Vtk : public Files {
 protected:
  Vtk() { ::testing::internal::CaptureStderr(); }
  ~Vtk() override { EXPECT_EQ(::testing::internal::GetCapturedStderr(), ""); }
};

std::string vtu(const std::string& connectivity, const std::string& offsets,
                const std::string& types, const std::string& more = "") {
  return "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
         "<UnstructuredGrid><Piece NumberOfPoints=\"4\" NumberOfCells=\"1\">\n"
         "<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n"
         "0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points>\n"
         "<Cells><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">" +
         connectivity +
         "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">" + offsets +
         "</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">" + types +
         "</DataArray></Cells>\n" + more + "</Piece></UnstructuredGrid></VTKFile>\n";
}

std::string vtk(const std::string& cells, const std::string& types) {
  return "# vtk DataFile Version 3.0\na tetrahedron\nASCII\nDATASET UNSTRUCTURED_GRID\n"
         "POINTS 4 double\n0 0 0 1 0 0 0 1 0 0 0 1\n" +
         cells + types;
}

const std::string kTetraVtk = vtk("CELLS 1 5\n4 0 1 2 3\n", "CELL_TYPES 1\n10\n");

TEST_F(Vtk, ReadsPlainFiles) {
  for (const auto& file : {put("a.vtu", vtu("0 1 2 3", "4", "10")), put("a.vtk", kTetraVtk)}) {
    const Mesh mesh = read_mesh(file);
    EXPECT_EQ(mesh.cells().vertices, (std::vector<Index>{0, 1, 2, 3}));
    EXPECT_EQ(mesh.points[3], (std::array<double, 3>{0, 0, 1}));
    EXPECT_EQ(mesh.vertex_numbers, (std::vector<std::uint64_t>{0, 1, 2, 3}));
    EXPECT_TRUE(mesh.groups.empty());
  }
}

TEST_F(Vtk, GroupsComeFromTheArraysOfOtherTools) {
  for (const char* name : {"group", "medit:ref", "gmsh:physical", "CellEntityIds"}) {
    const std::string data = "<CellData><DataArray type=\"Int32\" Name=\"" + std::string(name) +
                             "\" format=\"ascii\">17</DataArray></CellData>";
    const Mesh mesh = read_mesh(put("a.vtu", vtu("0 1 2 3", "4", "10", data)));
    ASSERT_EQ(mesh.groups.size(), 1u) << name;
    EXPECT_EQ(mesh.groups[0].tag, 17);
    EXPECT_TRUE(mesh.cell_fields.empty());
  }
}

TEST_F(Vtk, NamesTheCellOfEveryDefect) {
  const struct {
    std::string text;
    std::vector<std::string> parts;
  } cases[] = {
      {vtu("0 1 2 3", "4", "9"), {"cell 0", "vtkQuad", "type 9"}},
      {vtu("0 1 2 3", "4", "24"), {"cell 0", "type 24"}},
      {vtu("0 1 2", "3", "10"), {"cell 0", "3 points instead of 4"}},
      {vtu("0 1 2 4", "4", "10"), {"cell 0 uses point 4", "4 points, from 0 on"}},
      {vtu("0 1 2 -1", "4", "10"), {"cell 0 uses point -1"}},
      {vtu("0 1 2 3", "400", "10"), {"a.vtu"}},
      {vtu("0 1 2 3", "4", "10",
           "<CellData><DataArray type=\"Int64\" Name=\"group\" format=\"ascii\">3000000000"
           "</DataArray></CellData>"),
       {"'group' of cell 0", "32 bits"}},
      {vtu("0 1 2 3", "4", "10",
           "<PointData><DataArray type=\"Int64\" Name=\"id\" format=\"ascii\">1 2 3 "
           "9007199254740993</DataArray></PointData>"),
       {"data 'id'", "53 bits", "entry 3"}},
      {vtu("", "", "10"), {"a.vtu"}},
      {"<VTKFile type=\"PolyData\"></VTKFile>", {"VTK says", "UnstructuredGrid"}},
      {"<html><body></body></html>", {"VTK says"}},
      {"<VTKFile", {"VTK says", "line 1"}},
  };
  for (const auto& one : cases) expect_reading_error(put("a.vtu", one.text), one.parts);
  expect_reading_error(put("a.vtk", vtk("CELLS 1 5\n4 0 1 2 3\n", "CELL_TYPES 1\n12\n")),
                       {"cell 0", "vtkHexahedron"});
  expect_reading_error(put("a.vtk", vtk("CELLS 1 5\n4 0 1 2 9\n", "CELL_TYPES 1\n10\n")),
                       {"cell 0", "point 9"});
  expect_reading_error(put("a.vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\n"),
                       {"no line DATASET UNSTRUCTURED_GRID"});
}

TEST_F(Vtk, CountsThatLieDoNotTakeMemory) {
  std::string text = vtu("0 1 2 3", "4", "10");
  text.replace(text.find("NumberOfPoints=\"4\""), 18, "NumberOfPoints=\"9000000000000\"");
  expect_reading_error(put("a.vtu", text), {"a.vtu:2:", "9000000000000 is not possible"});
  text = kTetraVtk;
  text.replace(text.find("POINTS 4"), 8, "POINTS 4000000000");
  expect_reading_error(put("a.vtk", text), {"a.vtk:5:", "POINTS 4000000000 is not possible"});
  expect_reading_error(put("a.vtk", vtk("CELLS -1 5\n4 0 1 2 3\n", "")), {"a.vtk:7:", "CELLS -1"});
}

TEST_F(Vtk, WhatVtkWouldBelieveIsCheckedBefore) {
  const auto refuse = [&](const std::string& from, const std::string& to,
                          const std::vector<std::string>& parts) {
    std::string text = kTetraVtk;
    text.replace(text.find(from), from.size(), to);
    expect_reading_error(put("a.vtk", text), parts);
  };
  refuse("\n4 0 1", "\n9 0 1", {"a.vtk:7:", "cell 0 claims 9 points"});
  refuse("\n4 0 1", "\n-4 0 1", {"a.vtk:7:", "cell 0 claims -4 points"});
  refuse("\n4 0 1", "\n3 0 1", {"a.vtk:7:", "fill 4 numbers of the CELLS section, not 5"});
  refuse("1 2 3\n", "1 x 3\n", {"a.vtk:8:", "expected a number of the CELLS section"});
  refuse("CELLS", "CELLX", {"no line CELLS"});
  refuse("CELL_TYPES", "CELLS 2 5\nCELL_TYPES", {"a.vtk:9:", "a second section CELLS"});
  refuse("CELL_TYPES", "cells 2 5\nCELL_TYPES", {"a.vtk:9:", "a second section CELLS"});
  refuse("CELL_TYPES 1", "CELL_TYPES 2", {"a.vtk:9:", "CELL_TYPES has 2 entries for 1 cells"});
  write_mesh(path("b.vtk"), grouped_mesh());
  std::string binary = bytes("b.vtk");
  const auto first = binary.find('\n', binary.find("\nCELLS ") + 1) + 1;
  binary[first + 2] = 1;  // 256 points more, in the first cell
  expect_reading_error(put("c.vtk", binary), {"cell 0 claims 260 points"});
}

TEST_F(Vtk, DamagedBlockCountsDoNotTakeTimeOrMemory) {
  std::string text = vtu("\nAQD/9ACAAAAMAAAAEQAAAA==eJxjYWBgYARiJiAGAABMAAg=\n", "4", "10");
  text.replace(text.find("format=\"ascii\">\nAQD"), 14, "format=\"binary\"");
  text.replace(text.find(" byte_order"), 1, " compressor=\"vtkZLibDataCompressor\" ");
  expect_reading_error(put("a.vtu", text), {"a.vtu:6:", "compressed blocks", "damaged"});
}

TEST_F(Vtk, DamagedBlockSizesDoNotTakeMemory) {
  // Of one block: its number, size when unpacked, size of the last one, size as it is here.
  const std::pair<const char*, const char*> headers[] = {
      {"AQAAAP///38AAAAAEQAAAA==", "2147483647"},
      {"AQAAACAAAAD///9/EQAAAA==", "2147483647"},
      {"AQAAACAAAAAAAAAA////fw==", "2147483647"}};
  for (const auto& [header, size] : headers) {
    std::string text = vtu("\n" + std::string(header) + "eJxjYWBgYARiJiAGAABMAAg=\n", "4", "10");
    text.replace(text.find("format=\"ascii\">\nAQ"), 14, "format=\"binary\"");
    text.replace(text.find(" byte_order"), 1, " compressor=\"vtkZLibDataCompressor\" ");
    expect_reading_error(put("a.vtu", text),
                         {"a.vtu:6:", "a block of " + std::string(size), "damaged"});
  }
}

// VTK 9.1 believes these headers: a block of 0 bytes ended the process by a division by zero.
TEST_F(Vtk, DamagedHeadersOfArraysAreRefusedOrHarmless) {
  for (const VtuEncoding encoding : {VtuEncoding::kBase64, VtuEncoding::kZlib, VtuEncoding::kRaw}) {
    write_mesh(path("whole.vtu"), grouped_mesh(), {{}, {}, encoding});
    const std::string whole = bytes("whole.vtu");
    std::vector<std::size_t> starts;
    for (auto at = whole.find("<DataArray"); at != whole.npos;
         at = whole.find("<DataArray", at + 1))
      starts.push_back(whole.find_first_not_of(" \n", whole.find('>', at) + 1));
    if (encoding == VtuEncoding::kRaw) starts = {whole.find('_', whole.find("<AppendedData")) + 1};
    std::size_t refused = 0;
    for (const std::size_t start : starts) {
      for (std::size_t at = start; at < start + 24; ++at) {
        for (const char c : {'A', 'z', '/'}) {
          std::string changed = whole;
          changed.replace(at, 4, 4, c);
          try {
            expect_valid_places(read_mesh(put("changed.vtu", changed)));
          } catch (const InputError&) {
            ++refused;
          }
        }
      }
    }
    EXPECT_GT(refused, starts.size());
  }
}

TEST_F(Vtk, DataArraysMustSayWhereTheirDataIs) {
  const std::string good = vtu("0 1 2 3", "4", "10");
  for (const char* format : {"formal=\"ascii\"", "format=\"text\"", "format=\"appended\"",
                             "format=\"appended\" offset=\"0\""}) {
    std::string text = good;
    text.replace(text.find("format=\"ascii\""), 14, format);
    expect_reading_error(put("a.vtu", text), {"a.vtu:3:", "data array"});
  }
  std::string quoted = good;
  quoted.replace(quoted.find("format=\"ascii\""), 14, "format='ascii'");
  EXPECT_EQ(read_mesh(put("a.vtu", quoted)).points.size(), 4u);
}

TEST_F(Vtk, TruncatedFilesAreRefusedOrWhole) {
  write_mesh(path("whole.vtu"), grouped_mesh());
  write_mesh(path("whole.vtk"), grouped_mesh());
  for (const char* extension : {".vtu", ".vtk"}) {
    const std::string whole = bytes(std::string("whole") + extension);
    for (std::size_t size = 1; size < whole.size(); size += 7) {
      const auto part = put(std::string("part") + extension, whole.substr(0, size));
      try {
        expect_valid_places(read_mesh(part));
      } catch (const InputError&) {
      }
    }
  }
  const std::string whole = bytes("whole.vtu");
  expect_reading_error(put("half.vtu", whole.substr(0, whole.size() / 2)), {"VTK says", "line"});
}

}  // namespace
}  // namespace cleave::app::test
