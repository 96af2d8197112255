// Every format into every other one and back.
#include <cmath>
#include <limits>

#include "error.hpp"
#include "files_support.hpp"
#include "mesh_file.hpp"

namespace cleave::app::test {
namespace {

struct Kind {
  const char* name;
  const char* extension;
  MshVersion version;
};

constexpr Kind kKinds[] = {{"medit", ".mesh", MshVersion::k41},
                           {"msh22", ".msh", MshVersion::k22},
                           {"msh41", ".msh", MshVersion::k41},
                           {"vtu", ".vtu", MshVersion::k41},
                           {"vtk", ".vtk", MshVersion::k41}};

class RoundTrip : public Files {
 protected:
  std::string write(const std::string& stem, const Kind& kind, Mesh mesh) const {
    const std::string name = stem + "-" + kind.name + kind.extension;
    mesh.msh_version = kind.version;
    write_mesh(path(name), mesh);
    return name;
  }
};

TEST_F(RoundTrip, EveryPairOfFormatsKeepsTheMeshAndGivesBackTheBytes) {
  const Mesh mesh = grouped_mesh();
  for (const Kind& from : kKinds) {
    for (const Kind& to : kKinds) {
      SCOPED_TRACE(std::string(from.name) + " -> " + to.name);
      const std::string first = write("first", from, mesh);
      const Mesh read = read_mesh(path(first));
      expect_same_content(read, mesh);
      const std::string other = write("other", to, read);
      const Mesh reread = read_mesh(path(other));
      expect_same_content(reread, mesh);
      const std::string back = write("back", from, reread);
      EXPECT_EQ(bytes(back), bytes(first));
    }
  }
}

TEST_F(RoundTrip, TheSameMeshGivesTheSameBytesTwice) {
  for (const Kind& kind : kKinds) {
    const std::string a = write("a", kind, grouped_mesh());
    const std::string b = write("b", kind, grouped_mesh());
    EXPECT_EQ(bytes(a), bytes(b)) << kind.name;
  }
  EXPECT_EQ(bytes("a-medit.mesh.groups.json"), bytes("b-medit.mesh.groups.json"));
  EXPECT_EQ(bytes("a-vtu.vtu.groups.json"), bytes("b-vtu.vtu.groups.json"));
}

TEST_F(RoundTrip, NumbersOfGmshFilesAreKept) {
  Mesh mesh = grouped_mesh();
  mesh.vertex_numbers = {7, 5000000000, 3, 18446744073709551615u, 12, 11};
  mesh.elements[0].numbers = {100, 90};
  mesh.elements[1].numbers = {8589934592, 1, 2};
  mesh.elements[2].numbers = {51, 50};
  mesh.elements[3].numbers = {1000, 999, 4};
  for (const MshVersion version : {MshVersion::k22, MshVersion::k41}) {
    mesh.msh_version = version;
    write_mesh(path("a.msh"), mesh);
    const Mesh read = read_mesh(path("a.msh"));
    expect_same_content(read, mesh);
    expect_same_numbers(read, mesh);
    EXPECT_EQ(read.msh_version, version);
  }
}

TEST_F(RoundTrip, NumbersThatGmshCannotHoldAreCounted) {
  Mesh mesh = grouped_mesh();
  mesh.vertex_numbers = {0, 1, 2, 3, 4, 5};
  mesh.elements[3].numbers = {1, 2, 3};  // also numbers of lower elements
  write_mesh(path("a.msh"), mesh);
  const Mesh read = read_mesh(path("a.msh"));
  expect_same_content(read, mesh);
  expect_same_numbers(read, grouped_mesh());
}

TEST_F(RoundTrip, OrderOfVtkCellsIsKept) {
  Mesh mesh = grouped_mesh();
  mesh.elements[0].numbers = {3, 4};
  mesh.elements[1].numbers = {0, 5, 9};
  mesh.elements[2].numbers = {1, 2};
  mesh.elements[3].numbers = {6, 7, 8};
  for (const char* name : {"a.vtu", "a.vtk"}) {
    write_mesh(path(name), mesh);
    const Mesh read = read_mesh(path(name));
    expect_same_content(read, mesh);
    for (std::size_t d = 0; d <= 3; ++d)
      EXPECT_EQ(read.elements[d].numbers, mesh.elements[d].numbers);
    EXPECT_EQ(read.vertex_numbers, (std::vector<std::uint64_t>{0, 1, 2, 3, 4, 5}));
  }
}

TEST_F(RoundTrip, FieldsOfVtkFilesAreKept) {
  Mesh mesh = grouped_mesh();
  mesh.point_fields = {{"displacement", 3, std::vector<double>(18, 0.1)},
                       {"parent", 1, {1, 2, 3, 4, 5, 5}, true}};
  mesh.cell_fields = {{"piece", 1, {0, 0, 1}, true}, {"two words", 2, {1, 2, 3, 4, 5, 6e-310}}};
  for (const char* name : {"a.vtu", "a.vtk"}) {
    write_mesh(path(name), mesh);
    const Mesh read = read_mesh(path(name));
    expect_same_content(read, mesh);
    expect_same_fields(read.point_fields, mesh.point_fields);
    expect_same_fields(read.cell_fields, mesh.cell_fields);
  }
}

TEST_F(RoundTrip, CoordinatesThatAreNotFiniteAreKept) {
  Mesh mesh = grouped_mesh();
  const double infinity = std::numeric_limits<double>::infinity();
  mesh.points[1] = {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity};
  for (const Kind& kind : kKinds) {
    const Mesh read = read_mesh(path(write("a", kind, mesh)));
    EXPECT_TRUE(std::isnan(read.points[1][0])) << kind.name;
    EXPECT_EQ(read.points[1][1], infinity) << kind.name;
    EXPECT_EQ(read.points[1][2], -infinity) << kind.name;
  }
}

TEST_F(RoundTrip, MeshesInThePlaneAndOnALine) {
  Mesh mesh = grouped_mesh();
  mesh.elements[3] = {};
  mesh.dimension = 2;
  mesh.groups.resize(6);
  for (const Kind& kind : kKinds) {
    SCOPED_TRACE(kind.name);
    expect_same_content(read_mesh(path(write("a", kind, mesh))), mesh);
  }
  mesh.elements[2] = {};
  mesh.dimension = 1;
  mesh.groups.resize(3);
  for (const Kind& kind : kKinds) {
    SCOPED_TRACE(kind.name);
    expect_same_content(read_mesh(path(write("a", kind, mesh))), mesh);
  }
}

TEST_F(RoundTrip, MeditKeepsTwoDimensions) {
  const auto name = put("a.mesh",
                        "MeshVersionFormatted 2\nDimension 2\nVertices\n3\n0 0 0\n1 0 0\n0 1 4\n"
                        "Triangles\n1\n1 2 3 7\nEnd\n");
  const Mesh mesh = read_mesh(name);
  EXPECT_TRUE(mesh.two_dimensional_points);
  write_mesh(path("b.mesh"), mesh);
  EXPECT_EQ(bytes("b.mesh"), bytes("a.mesh"));
}

TEST_F(RoundTrip, NamesThatAreNoLongerNeededAreRemoved) {
  Mesh mesh = grouped_mesh();
  write_mesh(path("a.vtu"), mesh);
  EXPECT_EQ(names(), (std::vector<std::string>{"a.vtu", "a.vtu.groups.json"}));
  mesh.groups = {{"1", 3, 1, {0, 2}}};
  write_mesh(path("a.vtu"), mesh);
  EXPECT_EQ(names(), std::vector<std::string>{"a.vtu"});
  expect_same_content(read_mesh(path("a.vtu")), mesh);
}

TEST_F(RoundTrip, TagsThatCannotBeWrittenAreReplacedAndTheNameStays) {
  Mesh mesh = grouped_mesh();
  mesh.groups = {{"minus", 3, 0, {0}}, {"plus", 3, 0, {1}}, {"-5", 3, -5, {2}}};
  for (const Kind& kind : kKinds) {
    const Mesh read = read_mesh(path(write("a", kind, mesh)));
    ASSERT_EQ(read.groups.size(), 3u) << kind.name;
    for (const Group& group : read.groups) {
      const Index cell = group.name == "minus" ? 0 : group.name == "plus" ? 1 : 2;
      EXPECT_EQ(group.elements, std::vector<Index>{cell}) << kind.name << group.name;
    }
  }
}

TEST_F(RoundTrip, ANameThatGmshCannotHoldIsRefused) {
  Mesh mesh = grouped_mesh();
  mesh.groups[0].name = "a \"quoted\" name";
  EXPECT_THROW(write_mesh(path("a.msh"), mesh), OutputError);
  EXPECT_TRUE(names().empty());
  write_mesh(path("a.mesh"), mesh);
  expect_same_content(read_mesh(path("a.mesh")), mesh);
}

TEST_F(RoundTrip, AWrongFileOfNamesIsRefused) {
  write_mesh(path("a.mesh"), grouped_mesh());
  const std::string good = bytes("a.mesh.groups.json");
  const auto refuse = [&](const std::string& json, const std::vector<std::string>& parts) {
    put("a.mesh.groups.json", json);
    expect_reading_error(path("a.mesh"), parts);
  };
  refuse("{\n\"format\": ", {"a.mesh.groups.json:2:", "not JSON"});
  refuse("[1]", {"a.mesh.groups.json", "cleave-groups/1"});
  refuse(R"({"format": "cleave-groups/1", "overlaps": []})", {"needs the list 'groups'"});
  refuse(R"({"format": "cleave-groups/1", "overlaps": [],
             "groups": [{"dimension": 4, "tag": 1, "name": "a"}]})",
         {"groups[0]", "'dimension' must be 0, 1, 2 or 3"});
  refuse(R"({"format": "cleave-groups/1", "overlaps": [],
             "groups": [{"dimension": 3, "tag": 99999999999, "name": "a"}]})",
         {"groups[0]", "32 bits"});
  refuse(R"({"format": "cleave-groups/1", "overlaps": [], "groups": [7]})",
         {"groups[0]", "needs the"});
  refuse(R"({"format": "cleave-groups/1", "groups": [],
             "overlaps": [{"dimension": 3, "integer": 3, "groups": ["x"]}]})",
         {"overlaps[0]", "integers"});
  refuse(R"({"format": "cleave-groups/1", "overlaps": [],
             "groups": [{"dimension": 3, "tag": 4, "name": "a"},
                        {"dimension": 3, "tag": 4, "name": "b"}]})",
         {"groups[1]: dimension 3 has tag 4 already, 'a'"});
  refuse(R"({"format": "cleave-groups/1", "overlaps": [], "groups": [],
             "cohesive": [{"tag": 4, "name": "a"}, {"tag": 4, "name": "b"}]})",
         {"cohesive[1]: tag 4 is there already, 'a'"});
  refuse(R"({"format": "cleave-groups/1", "overlaps": [],
             "groups": [{"dimension": 1, "tag": 0, "name": "a"}]})",
         {"groups[0]", "must not be 0, which means no group"});
  refuse(R"({"format": "cleave-groups/1", "overlaps": [],
             "groups": [{"dimension": 1, "tag": 18446744073709551615, "name": "a"}]})",
         {"groups[0]", "32 bits"});
  refuse(R"({"format": "cleave-groups/1", "overlaps": [], "groups": [1e400]})",
         {"number that is too large"});
  put("a.mesh.groups.json", good);
  expect_same_content(read_mesh(path("a.mesh")), grouped_mesh());
}

}  // namespace
}  // namespace cleave::app::test
