// gmsh and meshio must read what we write, and we what they write. Both must be installed.
#include <algorithm>
#include <bit>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "files_support.hpp"
#include "mesh_file.hpp"

namespace cleave::app::test {
namespace {

/// The mesh as files_oracle.py prints it.
std::string dump(const Mesh& mesh) {
  std::ostringstream out;
  for (const auto& point : mesh.points) {
    out << "point";
    for (const double x : point) {
      char bits[17];
      std::snprintf(bits, sizeof bits, "%016llx",
                    static_cast<unsigned long long>(std::bit_cast<std::uint64_t>(x)));
      out << ' ' << bits;
    }
    out << '\n';
  }
  for (std::size_t d = 0; d <= 3; ++d) {
    const Elements& elements = mesh.elements[d];
    std::vector<std::int32_t> tags(elements.size(), 0);
    for (const Group& group : mesh.groups)
      if (group.dimension == static_cast<int>(d))
        for (const std::uint32_t e : group.elements) tags[e] = group.tag;
    for (std::size_t e = 0; e < elements.size(); ++e) {
      out << d;
      for (std::size_t k = 0; k <= d; ++k) out << ' ' << elements.vertices[(d + 1) * e + k];
      out << ' ' << tags[e] << '\n';
    }
  }
  return out.str();
}

/// The grouped mesh without overlapping groups, which meshio does not know.
Mesh plainly_grouped_mesh() {
  Mesh mesh = grouped_mesh();
  mesh.groups = {{"nail", 0, 7, {0, 1}},  {"rim", 1, 3, {0, 2}}, {"5", 1, 5, {1}},
                 {"cut", 2, 4, {0}},      {"skin", 2, 9, {1}},   {"1", 3, 1, {0, 2}},
                 {"left lobe", 3, 2, {1}}};
  return mesh;
}

/// Elements with their vertices and the names of their groups, sorted: what a tool may not change
/// when it only converts a file. With `numbers` as the file's, else vertices by their coordinates.
std::vector<std::string> elements_of(const Mesh& mesh, bool numbers) {
  std::vector<std::string> all;
  for (std::size_t d = 0; d <= 3; ++d) {
    const Elements& elements = mesh.elements[d];
    for (std::size_t e = 0; e < elements.size(); ++e) {
      std::ostringstream text;
      text << std::hexfloat;
      if (numbers) text << elements.numbers[e] << ':';
      for (std::size_t k = 0; k <= d; ++k) {
        const std::uint32_t v = elements.vertices[(d + 1) * e + k];
        const auto& point = mesh.points[v];
        if (numbers) text << ' ' << mesh.vertex_numbers[v];
        text << " (" << point[0] << ' ' << point[1] << ' ' << point[2] << ')';
      }
      for (const Group& group : mesh.groups)
        if (group.dimension == static_cast<int>(d) &&
            std::count(group.elements.begin(), group.elements.end(), e) > 0)
          text << " '" << group.name << "'";
      all.push_back(text.str());
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

class Oracle : public Files {
 protected:
  void run(const std::string& command) const {
    const std::string log = path("log").string();
    ASSERT_EQ(std::system((command + " 2> " + log).c_str()), 0) << command << "\n" << bytes("log");
  }
  void meshio(const std::string& arguments) const {
    run("/usr/bin/python3 " CLEAVE_MESH_ORACLE " " + arguments);
  }
  void gmsh(const std::string& arguments) const { run("gmsh -v 2 " + arguments); }
  std::string at(const std::string& name) const { return path(name).string(); }
};

TEST_F(Oracle, MeshioReadsWhatWeWrite) {
  Mesh mesh = plainly_grouped_mesh();
  mesh.point_fields = {{"parent", 1, std::vector<double>(mesh.points.size(), 5e9), true}};
  mesh.cell_fields = {{"piece", 1, std::vector<double>(mesh.cells().size(), 1.0), true}};
  for (const std::string name : {"a.mesh", "22.msh", "41.msh", "a.vtu", "a.vtk"}) {
    SCOPED_TRACE(name);
    Mesh written = mesh;
    written.msh_version = name == "22.msh" ? MshVersion::k22 : MshVersion::k41;
    // meshio 5.0 takes every block of a 2.2 file to have two elements when it reads $ElementData.
    if (name == "22.msh") written.cell_fields.clear();
    write_mesh(path(name), written);
    ASSERT_NO_FATAL_FAILURE(meshio("dump " + at(name) + " > " + at("dump")));
    EXPECT_EQ(bytes("dump"), dump(mesh));
  }
}

TEST_F(Oracle, WeReadWhatMeshioWrites) {
  ASSERT_NO_FATAL_FAILURE(meshio("make " + at("")));
  for (const char* name :
       {"a.mesh", "22.msh", "zlib.vtu", "raw.vtu", "42.vtk", "text.vtk", "51.vtk"}) {
    SCOPED_TRACE(name);
    Mesh mesh = read_mesh(path(name));
    if (name == std::string("a.mesh")) {  // meshio gives every vertex the reference 1
      EXPECT_EQ(mesh.elements[0].size(), mesh.points.size());
      mesh.elements[0] = {};
      ASSERT_EQ(mesh.groups.front().dimension, 0);
      mesh.groups.erase(mesh.groups.begin());
    }
    EXPECT_EQ(dump(mesh), bytes("expected"));
  }
  // meshio describes only some entities of a 4.1 file, and loses groups with the others.
  Mesh mesh = read_mesh(path("22.msh"));
  Mesh without_groups = read_mesh(path("41.msh"));
  mesh.groups.clear();
  without_groups.groups.clear();
  EXPECT_EQ(dump(without_groups), dump(mesh));
}

TEST_F(Oracle, GmshKeepsWhatWeWrite) {
  for (const MshVersion version : {MshVersion::k22, MshVersion::k41}) {
    // gmsh reads the 2.2 rows of an element in two groups as two elements, its own files' too.
    Mesh mesh = version == MshVersion::k41 ? grouped_mesh() : plainly_grouped_mesh();
    mesh.vertex_numbers = {10, 2, 35, 4, 50, 6};
    mesh.msh_version = version;
    write_mesh(path("ours.msh"), mesh);
    for (const std::string format : {"msh41", "msh22"}) {
      SCOPED_TRACE(format);
      ASSERT_NO_FATAL_FAILURE(
          gmsh(at("ours.msh") + " -save -format " + format + " -o " + at("theirs.msh")));
      // gmsh renumbers when it writes version 2.2.
      const bool numbers = format == "msh41";
      EXPECT_EQ(elements_of(read_mesh(path("theirs.msh")), numbers), elements_of(mesh, numbers));
    }
  }
}

TEST_F(Oracle, GmshReadsOurMeditFile) {
  Mesh mesh = plainly_grouped_mesh();
  write_mesh(path("ours.mesh"), mesh);
  ASSERT_NO_FATAL_FAILURE(
      gmsh(at("ours.mesh") + " -save -save_all -format msh41 -o " + at("theirs.msh")));
  Mesh theirs = read_mesh(path("theirs.msh"));
  for (Mesh* one : {&mesh, &theirs}) {  // gmsh makes entities of references, and marks no vertices
    one->groups.clear();
    one->elements[0] = {};
  }
  EXPECT_EQ(elements_of(theirs, false), elements_of(mesh, false));
}

TEST_F(Oracle, WeReadWhatGmshWrites) {
  put("box.geo",
      "SetFactory(\"Built-in\");\n"
      "Point(1) = {0, 0, 0, 0.6};\n"
      "a[] = Extrude {1, 0, 0} { Point{1}; };\n"
      "b[] = Extrude {0, 1, 0} { Line{a[1]}; };\n"
      "c[] = Extrude {0, 0, 1} { Surface{b[1]}; };\n"
      "Physical Volume(\"body\", 1) = {c[1]};\n"
      "Physical Volume(\"again\", 2) = {c[1]};\n"
      "Physical Surface(\"floor\", 3) = {b[1]};\n"
      "Physical Curve(\"edge\", 4) = {a[1]};\n"
      "Physical Point(\"corner\", 5) = {1};\n");
  ASSERT_NO_FATAL_FAILURE(gmsh("-3 -format msh41 " + at("box.geo") + " -o " + at("41.msh")));
  const Mesh mesh = read_mesh(path("41.msh"));
  ASSERT_EQ(mesh.groups.size(), 5u);
  EXPECT_EQ(mesh.groups[0].name, "corner");
  EXPECT_EQ(mesh.groups[0].elements.size(), 1u);
  EXPECT_EQ(mesh.groups[2].name, "floor");
  EXPECT_EQ(mesh.groups[2].elements.size(), mesh.elements[2].size());
  EXPECT_EQ(mesh.groups[3].elements.size(), mesh.cells().size());
  EXPECT_EQ(mesh.groups[4].elements, mesh.groups[3].elements);
  EXPECT_GT(mesh.cells().size(), 20u);
  for (const char* format : {"msh22", "mesh", "vtk"}) {
    SCOPED_TRACE(format);
    const std::string name = format == std::string("msh22") ? "22.msh" : std::string("a.") + format;
    ASSERT_NO_FATAL_FAILURE(gmsh(at("41.msh") + " -save -format " + format + " -o " + at(name)));
    const Mesh other = read_mesh(path(name));
    ASSERT_EQ(other.points.size(), mesh.points.size());
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      for (std::size_t k = 0; k < 3; ++k)  // gmsh writes 14 digits in .mesh
        EXPECT_NEAR(other.points[v][k], mesh.points[v][k], 1e-14);
    EXPECT_EQ(other.cells().vertices, mesh.cells().vertices);
    EXPECT_EQ(other.facets().vertices, mesh.facets().vertices);
    if (name == "22.msh") expect_same_content(other, mesh);
  }
}

}  // namespace
}  // namespace cleave::app::test
