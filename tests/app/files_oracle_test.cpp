// gmsh and meshio must read what we write, and we what they write. Both must be installed.
#include <algorithm>
#include <bit>
#include <cstdio>
#include <cstdlib>
#include <map>
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
        for (const Index e : group.elements) tags[e] = group.tag;
    for (std::size_t e = 0; e < elements.size(); ++e) {
      out << d;
      for (std::size_t k = 0; k <= d; ++k) out << ' ' << elements.vertices[(d + 1) * e + k];
      const std::size_t edges = d * (d + 1) / 2;
      // VTK's order: (0,1) (1,2) (2,0) (0,3) (1,3) (2,3).
      const std::size_t order[] = {0, d == 3 ? 3u : 2u, 1, 2, 4, 5};
      for (std::size_t k = 0; elements.second_order() && k < edges; ++k)
        out << ' ' << elements.midside[edges * e + order[k]];
      out << ' ' << tags[e] << '\n';
    }
  }
  for (std::size_t e = 0; e < mesh.cohesive.size(); ++e) {
    out << 4;
    for (std::size_t k = 0; k < 6; ++k) out << ' ' << mesh.cohesive.vertices[6 * e + k];
    out << " 1\n";
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
        const Index v = elements.vertices[(d + 1) * e + k];
        const auto& point = mesh.points[v];
        if (numbers) text << ' ' << mesh.vertex_numbers[v];
        text << " (" << point[0] << ' ' << point[1] << ' ' << point[2] << ')';
      }
      const std::size_t edges = elements.second_order() ? d * (d + 1) / 2 : 0;
      for (std::size_t k = 0; k < edges; ++k) {
        const auto& point = mesh.points[elements.midside[edges * e + k]];
        text << " [" << point[0] << ' ' << point[1] << ' ' << point[2] << ']';
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
  void tetgen(const std::string& arguments) const {
    run("tetgen -Q " + arguments + " > " + at("chatter"));
  }
  std::string at(const std::string& name) const { return path(name).string(); }
};

TEST_F(Oracle, MeshioReadsWhatWeWrite) {
  Mesh mesh = plainly_grouped_mesh();
  mesh.point_fields = {{"parent", 1, std::vector<double>(mesh.points.size(), 5e9), true}};
  mesh.cell_fields = {{"piece", 1, std::vector<double>(mesh.cells().size(), 1.0), true}};
  for (const std::string name :
       {"a.mesh", "22.msh", "22b.msh", "41.msh", "41b.msh", "a.vtu", "a.vtk"}) {
    SCOPED_TRACE(name);
    Mesh written = mesh;
    written.msh_version = name[0] == '2' ? MshVersion::k22 : MshVersion::k41;
    written.msh_binary = name.find('b') == 2;
    // meshio 5.0 takes every block of a 2.2 file to have two elements when it reads $ElementData.
    if (name[0] == '2') written.cell_fields.clear();
    write_mesh(path(name), written);
    ASSERT_NO_FATAL_FAILURE(meshio("dump " + at(name) + " > " + at("dump")));
    EXPECT_EQ(bytes("dump"), dump(mesh));
  }
}

TEST_F(Oracle, MeshioReadsSecondOrderAndCohesiveElements) {
  for (const Mesh& mesh : {second_order(plainly_grouped_mesh()), cohesive_mesh()}) {
    for (const MshVersion version : {MshVersion::k22, MshVersion::k41}) {
      for (const bool binary : {false, true}) {
        SCOPED_TRACE(std::string(version == MshVersion::k22 ? "2.2" : "4.1") +
                     (binary ? " binary" : " text"));
        write_mesh(path("a.msh"), mesh, {version, binary});
        ASSERT_NO_FATAL_FAILURE(meshio("dump " + at("a.msh") + " > " + at("dump")));
        EXPECT_EQ(bytes("dump"), dump(mesh));
      }
    }
  }
}

/// What files_oracle.py prints of gmsh's periodic nodes and fields.
std::string dump_for_gmsh(const Mesh& mesh) {
  std::ostringstream out;
  for (const Periodicity& periodic : mesh.periodic) {
    out << "periodic " << periodic.dimension << ' ' << periodic.entity << ' ' << periodic.master
        << ' ' << periodic.affine.size() << '\n';
    for (const auto& pair : periodic.pairs)
      out << mesh.vertex_numbers[pair.vertex] << ' ' << mesh.vertex_numbers[pair.master] << '\n';
  }
  const auto values = [&](const Field& field, const std::vector<std::uint64_t>& numbers) {
    const auto size = static_cast<std::size_t>(field.components);
    for (std::size_t i = 0; i < field.values.size(); ++i)
      out << (i % size == 0 ? std::to_string(numbers[i / size]) : "") << ' ' << field.values[i]
          << (i % size == size - 1 ? "\n" : "");
  };
  for (const Field& field : mesh.point_fields) {
    out << "NodeData " << field.name << ' ' << field.components << '\n';
    values(field, mesh.vertex_numbers);
  }
  for (const Field& field : mesh.cell_fields) {
    out << "ElementData " << field.name << ' ' << field.components << '\n';
    values(mesh.facet_fields[0], mesh.facets().numbers);
    values(field, mesh.cells().numbers);
  }
  return out.str();
}

TEST_F(Oracle, GmshReadsOurPeriodicPairsAndFields) {
  Mesh mesh = plainly_grouped_mesh();
  mesh.periodic = {
      {1, 9, 3, {}, {{0, 1}, {3, 3}}},
      {2, 12, 4, {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, {{0, 3}, {1, 4}, {2, 5}}}};
  mesh.point_fields = {{"u", 3, std::vector<double>(18, 0.5)}, {"p q", 1, {1, 2, 3, 4, 5, 6}}};
  mesh.cell_fields = {{"piece", 1, {1, 2, 7}}};
  mesh.facet_fields = {{"piece", 1, {8, 9}}};
  for (const bool binary : {false, true}) {
    write_mesh(path("a.msh"), mesh, {MshVersion::k41, binary});
    ASSERT_NO_FATAL_FAILURE(meshio("gmsh " + at("a.msh") + " > " + at("dump")));
    EXPECT_EQ(bytes("dump"), dump_for_gmsh(mesh)) << binary;
  }
  // Of a 2.2 file gmsh knows the entities that have elements only.
  mesh.periodic = {{2, 12, 4, {}, {{0, 3}, {1, 1}, {2, 2}, {3, 0}}}};
  for (const bool binary : {false, true}) {
    write_mesh(path("a.msh"), mesh, {MshVersion::k22, binary});
    EXPECT_EQ(read_mesh(path("a.msh")).periodic.size(), 1u);
    ASSERT_NO_FATAL_FAILURE(meshio("gmsh " + at("a.msh") + " > " + at("dump")));
    mesh.periodic.clear();
    EXPECT_NE(bytes("dump").find(dump_for_gmsh(mesh)), std::string::npos) << binary;
    mesh.periodic = {{2, 12, 4, {}, {{0, 3}, {1, 1}, {2, 2}, {3, 0}}}};
  }
}

TEST_F(Oracle, WeReadGmshsPeriodicBoxOfSecondOrder) {
  ASSERT_NO_FATAL_FAILURE(meshio("box " + at("")));
  const Mesh text = read_mesh(path("4.1-0.msh"));
  EXPECT_TRUE(text.cells().second_order() && text.facets().second_order());
  ASSERT_EQ(text.periodic.size(), 9u);
  for (const Periodicity& periodic : text.periodic) {
    ASSERT_EQ(periodic.affine.size(), 16u);
    for (const auto& pair : periodic.pairs)
      EXPECT_NEAR(text.points[pair.vertex][2], text.points[pair.master][2] + 1, 1e-14);
  }
  const auto expect_same_up_to_digits = [](Mesh binary, const Mesh& other) {
    ASSERT_EQ(binary.points.size(), other.points.size());
    for (std::size_t v = 0; v < other.points.size(); ++v)
      for (std::size_t x = 0; x < 3; ++x)  // gmsh writes 16 digits in text
        EXPECT_NEAR(binary.points[v][x], other.points[v][x], 1e-15);
    binary.points = other.points;
    expect_same_content(binary, other);
  };
  expect_same_up_to_digits(read_mesh(path("4.1-1.msh")), text);
  const Mesh text22 = read_mesh(path("2.2-0.msh"));
  expect_same_up_to_digits(read_mesh(path("2.2-1.msh")), text22);
  EXPECT_EQ(text22.cells().midside, text.cells().midside);
  ASSERT_EQ(text22.periodic.size(), 1u);
  const Mesh medit = read_mesh(path("box.mesh"));
  EXPECT_EQ(medit.cells().midside, text.cells().midside);
  for (std::size_t e = 0; e < text.cells().size(); ++e) {  // midside nodes are in the middle
    std::size_t edge = 6 * e;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = i + 1; k < 4; ++k, ++edge)
        for (std::size_t x = 0; x < 3; ++x)
          EXPECT_NEAR(text.points[text.cells().midside[edge]][x],
                      (text.points[text.cells().vertices[4 * e + i]][x] +
                       text.points[text.cells().vertices[4 * e + k]][x]) /
                          2,
                      1e-12);
  }
  // There and back: gmsh finds our entities and reads the same pairs.
  write_mesh(path("ours.msh"), text);
  for (const char* name : {"4.1-0.msh", "ours.msh"})
    ASSERT_NO_FATAL_FAILURE(meshio("gmsh " + at(name) + " > " + at(name) + ".dump"));
  EXPECT_EQ(bytes("ours.msh.dump"), bytes("4.1-0.msh.dump"));
}

TEST_F(Oracle, GmshReadsOurMeditFileOfSecondOrder) {
  ASSERT_NO_FATAL_FAILURE(meshio("box " + at("")));
  Mesh mesh = read_mesh(path("4.1-0.msh"));
  mesh.periodic.clear();
  mesh.groups.clear();
  write_mesh(path("ours.mesh"), mesh);
  ASSERT_NO_FATAL_FAILURE(
      gmsh(at("ours.mesh") + " -save -save_all -format msh41 -bin -o " + at("theirs.msh")));
  Mesh theirs = read_mesh(path("theirs.msh"));
  EXPECT_TRUE(theirs.msh_binary);
  theirs.groups.clear();
  EXPECT_EQ(elements_of(theirs, false), elements_of(mesh, false));
}

TEST_F(Oracle, WeReadWhatMeshioWrites) {
  ASSERT_NO_FATAL_FAILURE(meshio("make " + at("")));
  for (const char* name :
       {"a.mesh", "22.msh", "22b.msh", "zlib.vtu", "raw.vtu", "42.vtk", "text.vtk", "51.vtk"}) {
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
  EXPECT_EQ(dump(read_mesh(path("41b.msh"))), dump(read_mesh(path("41.msh"))));
}

TEST_F(Oracle, GmshKeepsWhatWeWrite) {
  for (const MshVersion version : {MshVersion::k22, MshVersion::k41}) {
    // gmsh reads the 2.2 rows of an element in two groups as two elements, its own files' too.
    Mesh mesh = second_order(version == MshVersion::k41 ? grouped_mesh() : plainly_grouped_mesh());
    const std::vector<std::uint64_t> numbers_of_corners = {10, 2, 35, 4, 50, 60};
    std::copy(numbers_of_corners.begin(), numbers_of_corners.end(), mesh.vertex_numbers.begin());
    for (std::size_t v = 6; v < mesh.points.size(); ++v) mesh.vertex_numbers[v] = 100 + v;
    mesh.msh_version = version;
    mesh.msh_binary = version == MshVersion::k22;
    write_mesh(path("ours.msh"), mesh);
    for (const std::string format : {"msh41", "msh22", "msh41 -bin", "msh22 -bin"}) {
      SCOPED_TRACE(format);
      ASSERT_NO_FATAL_FAILURE(
          gmsh(at("ours.msh") + " -save -format " + format + " -o " + at("theirs.msh")));
      // gmsh renumbers when it writes version 2.2.
      const bool numbers = format.substr(0, 5) == "msh41";
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

/// Expects every node of second order in the middle of its edge.
void expect_midside_in_the_middle(const Mesh& mesh) {
  for (std::size_t d = 1; d <= 3; ++d) {
    const Elements& elements = mesh.elements[d];
    if (!elements.second_order()) continue;
    auto node = elements.midside.begin();
    for (std::size_t e = 0; e < elements.size(); ++e)
      for (std::size_t i = 0; i <= d; ++i)
        for (std::size_t j = i + 1; j <= d; ++j, ++node)
          for (std::size_t x = 0; x < 3; ++x)
            ASSERT_NEAR(mesh.points[*node][x],
                        (mesh.points[elements.vertices[(d + 1) * e + i]][x] +
                         mesh.points[elements.vertices[(d + 1) * e + j]][x]) /
                            2,
                        1e-9)
                << "dimension " << d << ", element " << e;
  }
}

/// Cells as sets of vertices, with their groups.
std::vector<std::string> cells_of(Mesh mesh) {
  for (std::size_t c = 0; c < mesh.cells().size(); ++c)
    std::sort(mesh.elements[3].vertices.begin() + static_cast<std::ptrdiff_t>(4 * c),
              mesh.elements[3].vertices.begin() + static_cast<std::ptrdiff_t>(4 * c + 4));
  mesh.elements[0] = mesh.elements[1] = mesh.elements[2] = {};
  return elements_of(mesh, false);
}

const std::string kBoxGeo =
    "Point(1) = {0, 0, 0, 0.9};\na[] = Extrude {1, 0, 0} { Point{1}; };\n"
    "b[] = Extrude {0, 1, 0} { Line{a[1]}; };\nc[] = Extrude {0, 0, 1} { Surface{b[1]}; };\n"
    "Physical Volume(\"body\", 1) = {c[1]};\nPhysical Surface(\"floor\", 3) = {b[1]};\n"
    "Physical Curve(\"edge\", 4) = {a[1]};\n";

TEST_F(Oracle, MeshioReadsOurTetgenFiles) {
  Mesh mesh = plainly_grouped_mesh();
  mesh.elements[1] = mesh.elements[2] = {};  // meshio reads points and cells only
  mesh.groups = {{"7", 0, 7, {0, 1}}, {"1", 3, 1, {0, 2}}, {"2", 3, 2, {1}}};
  write_mesh(path("a.node"), mesh);
  ASSERT_NO_FATAL_FAILURE(meshio("dump " + at("a.node") + " > " + at("dump")));
  EXPECT_EQ(bytes("dump"), dump(mesh));
}

TEST_F(Oracle, TetgenKeepsWhatWeWrite) {
  Mesh mesh = grouped_mesh();
  mesh.points[4] = {1, 1, 1};
  mesh.points[5] = {0.1, 1.5, 1};
  mesh.elements[1] = {};
  mesh.elements[2] = {};
  mesh.groups = {{"1", 3, 1, {0, 2}}, {"2", 3, 2, {1}}};
  for (const std::uint64_t first : {0, 1}) {
    for (std::size_t v = 0; v < mesh.points.size(); ++v) mesh.vertex_numbers[v] = first + v;
    write_mesh(path("a.node"), mesh);
    ASSERT_NO_FATAL_FAILURE(tetgen("-r " + at("a.node")));
    EXPECT_EQ(cells_of(read_mesh(path("a.1.ele"))), cells_of(mesh));
  }
}

TEST_F(Oracle, WeReadWhatTetgenWrites) {
  put("a.poly",
      "8 3 1 1\n1 0 0 0 0.5 3\n2 1 0 0 0.5 3\n3 1 1 0 1.5 0\n4 0 1 0 2 0\n5 0 0 1 2 0\n"
      "6 1 0 1 2 0\n7 1 1 1 2 0\n8 0 1 1 2 9\n6 1\n1 0 2\n4 1 2 3 4\n1 0 4\n4 5 6 7 8\n"
      "1 0 0\n4 1 2 6 5\n1 0 0\n4 2 3 7 6\n1 0 0\n4 3 4 8 7\n1 0 -5\n4 4 1 5 8\n0\n1\n"
      "1 0.5 0.5 0.5 7 0.2\n");
  for (const std::string order : {"", "o2"}) {
    for (const std::string neighbours : {"", "nn"}) {
      SCOPED_TRACE(order + neighbours);
      ASSERT_NO_FATAL_FAILURE(tetgen("-pqAef" + order + neighbours + " " + at("a.poly")));
      const Mesh mesh = read_mesh(path("a.1.node"));
      for (std::size_t d = 1; d <= 3; ++d)
        EXPECT_EQ(mesh.elements[d].second_order(), order == "o2") << d;
      expect_midside_in_the_middle(mesh);
      std::vector<std::string> groups;
      for (const Group& group : mesh.groups)
        if (group.dimension != 1) groups.push_back(group.name);
      EXPECT_EQ(groups, (std::vector<std::string>{"3", "9", "-5", "2", "4", "7"}));
      EXPECT_EQ(mesh.groups.back().elements.size(), mesh.cells().size());
    }
  }
}

TEST_F(Oracle, MeshioReadsOurAbaqusFiles) {
  Mesh mesh = plainly_grouped_mesh();
  write_mesh(path("a.inp"), mesh);
  ASSERT_NO_FATAL_FAILURE(meshio("dump " + at("a.inp") + " > " + at("dump")));
  mesh.groups.clear();
  mesh.elements[0] = {};
  EXPECT_EQ(bytes("dump"), dump(mesh) +
                               "nodes nail 2 5\nelements \"1\" 3 0 2\nelements \"5\" 1 1\n"
                               "elements \"left lobe\" 3 1\nelements cut 2 0\n"
                               "elements rim 1 0 2\nelements skin 2 1\n");
}

TEST_F(Oracle, MeshioReadsOurSecondOrder) {
  Mesh mesh = plainly_grouped_mesh();
  mesh.elements[1] = {};  // meshio takes Abaqus's end, middle, end as end, end, middle
  mesh = second_order(mesh);
  for (const char* name : {"a.inp", "a.vtu", "a.vtk"}) {
    SCOPED_TRACE(name);
    mesh.groups.clear();
    if (name == std::string("a.inp")) mesh.elements[0] = {};
    write_mesh(path(name), mesh);
    ASSERT_NO_FATAL_FAILURE(meshio("dump " + at(name) + " > " + at("dump")));
    EXPECT_EQ(bytes("dump"), dump(mesh));
  }
}

TEST_F(Oracle, WeReadTetgenAndAbaqusFilesOfMeshio) {
  ASSERT_NO_FATAL_FAILURE(meshio("make " + at("")));
  const Mesh mesh = read_mesh(path("22.msh"));
  const Mesh tetgen = read_mesh(path("a.ele"));
  EXPECT_EQ(tetgen.points, mesh.points);
  EXPECT_EQ(tetgen.cells().vertices, mesh.cells().vertices);
  ASSERT_EQ(tetgen.groups.size(), 2u);
  EXPECT_EQ(tetgen.groups[1].elements, mesh.groups.back().elements);
  const Mesh abaqus = read_mesh(path("a.inp"));
  EXPECT_EQ(abaqus.points, mesh.points);
  for (std::size_t d = 1; d <= 3; ++d)
    EXPECT_EQ(abaqus.elements[d].vertices, mesh.elements[d].vertices);
  ASSERT_EQ(abaqus.groups.size(), 3u);
  EXPECT_EQ(abaqus.groups[0].name, "ends");
  EXPECT_EQ(abaqus.elements[0].vertices, (std::vector<Index>{0, 11}));
  EXPECT_EQ(abaqus.groups[1].elements, (std::vector<Index>{1, 3}));
  EXPECT_EQ(abaqus.groups[2].elements, (std::vector<Index>{0, 8}));
}

TEST_F(Oracle, WeReadAbaqusFilesOfGmsh) {
  put("box.geo", kBoxGeo);
  for (const std::string order : {"1", "2"}) {
    SCOPED_TRACE(order);
    ASSERT_NO_FATAL_FAILURE(
        gmsh("-3 -order " + order + " -format inp " + at("box.geo") + " -o " + at("a.inp")));
    const Mesh mesh = read_mesh(path("a.inp"));
    EXPECT_EQ(mesh.cells().second_order(), order == "2");
    EXPECT_EQ(mesh.elements[1].second_order(), order == "2");
    expect_midside_in_the_middle(mesh);
    std::map<std::string, std::size_t> sizes;
    for (const Group& group : mesh.groups) sizes[group.name] = group.elements.size();
    EXPECT_EQ(sizes["body"], mesh.cells().size());
    EXPECT_EQ(sizes["floor"], mesh.elements[2].size());
    EXPECT_EQ(sizes["edge"], mesh.elements[1].size());
    EXPECT_TRUE(mesh.dropped.empty());
  }
}

}  // namespace
}  // namespace cleave::app::test
