// The forms of gmsh's formats: binary in both orders of bytes, second order, periodic pairs,
// cohesive elements and fields.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "error.hpp"
#include "files/msh_format.hpp"
#include "files_support.hpp"
#include "mesh_file.hpp"

namespace cleave::app::test {
namespace {

struct Form {
  const char* name;
  WriteOptions options;
};

const Form kForms[] = {{"22 text", {MshVersion::k22, false, {}}},
                       {"22 binary", {MshVersion::k22, true, {}}},
                       {"41 text", {MshVersion::k41, false, {}}},
                       {"41 binary", {MshVersion::k41, true, {}}}};

/// A square of two triangles whose left and right sides are periodic.
Mesh periodic_mesh() {
  Mesh mesh;
  mesh.dimension = 2;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.vertex_numbers = {1, 2, 3, 4};
  mesh.elements[1] = {{0, 3, 1, 2}, {1, 2}};
  mesh.elements[2] = {{0, 1, 2, 0, 2, 3}, {3, 4}};
  mesh.groups = {{"left", 1, 1, {0}}, {"right", 1, 2, {1}}, {"body", 2, 3, {0, 1}}};
  mesh.periodic = {{0, 12, 11, {}, {{1, 0}}},
                   {1, 7, 5, {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, {{1, 0}, {2, 3}}}};
  return mesh;
}

/// A mesh with fields on vertices, cells and facets.
Mesh mesh_with_fields() {
  Mesh mesh = grouped_mesh();
  mesh.point_fields = {{"displacement", 3, std::vector<double>(18, 0.1)},
                       {"p", 1, {1, -2, 3e300, 4, 5, 6e-310}}};
  mesh.cell_fields = {{"both", 1, {1, 2, 3}}, {"stress", 9, std::vector<double>(27, -1. / 3)}};
  mesh.facet_fields = {{"both", 1, {4, 5}}, {"flux", 2, {1, 2, 3, 4}}};
  return mesh;
}

class MshForms : public Files {
 protected:
  Mesh round_trip(const Mesh& mesh, const Form& form) const {
    write_mesh(path("a.msh"), mesh, form.options);
    Mesh read = read_mesh(path("a.msh"));
    EXPECT_EQ(read.msh_version, *form.options.msh_version);
    EXPECT_EQ(read.msh_binary, *form.options.binary);
    EXPECT_EQ(read.dropped, std::vector<std::string>{});
    return read;
  }
};

TEST_F(MshForms, EveryFormHoldsEverything) {
  for (const Mesh& mesh : {grouped_mesh(), second_order(grouped_mesh()), cohesive_mesh(),
                           periodic_mesh(), mesh_with_fields()}) {
    for (const Form& form : kForms) {
      SCOPED_TRACE(form.name);
      const Mesh read = round_trip(mesh, form);
      expect_same_content(read, mesh);
      expect_same_numbers(read, mesh);
      expect_same_fields(read.point_fields, mesh.point_fields);
      expect_same_fields(read.cell_fields, mesh.cell_fields);
      expect_same_fields(read.facet_fields, mesh.facet_fields);
      const std::string first = bytes("a.msh");
      write_mesh(path("b.msh"), read);  // in the version and form that were read
      EXPECT_EQ(bytes("b.msh"), first);
    }
  }
}

TEST_F(MshForms, TruncatedBinaryFilesAreRefused) {
  for (const Mesh& mesh : {second_order(grouped_mesh()), cohesive_mesh()}) {
    for (const Form& form : kForms) {
      SCOPED_TRACE(form.name);
      write_mesh(path("a.msh"), mesh, form.options);
      expect_prefixes_are_refused(read_msh, bytes("a.msh"));
    }
  }
}

// The format has no mark at its end: one section less is a file without that section.
TEST_F(MshForms, TruncatedSectionsAfterTheElementsAreRefusedOrMissing) {
  Mesh mesh = periodic_mesh();
  mesh.point_fields = {{"p", 1, {1, 2, 3, 4}}};
  for (const Form& form : kForms) {
    SCOPED_TRACE(form.name);
    write_mesh(path("a.msh"), mesh, form.options);
    const std::string content = bytes("a.msh");
    std::size_t read = 0;
    for (std::size_t size = 0; size < content.size(); ++size) {
      try {
        Mesh part = read_msh({"part", std::string_view(content).substr(0, size)});
        ++read;
        if (!part.periodic.empty()) continue;
        EXPECT_TRUE(part.point_fields.empty());
        part.periodic = mesh.periodic;
        part.dimension = mesh.dimension;
        expect_same_content(part, mesh);
      } catch (const InputError&) {
      }
    }
    EXPECT_EQ(read, 5u) << "after each section, with and without its line end, but the last";
  }
}

TEST_F(MshForms, DefectsInBinaryFilesAreNoticedOrHarmless) {
  Mesh mesh = cohesive_mesh();
  mesh.point_fields = {{"p", 1, std::vector<double>(8, 1.5)}};
  mesh.periodic = {{2, 1, 2, {}, {{0, 3}}}};
  for (const Form& form : kForms) {
    SCOPED_TRACE(form.name);
    write_mesh(path("a.msh"), mesh, form.options);
    const std::string content = bytes("a.msh");
    std::size_t refused = 0;
    for (std::size_t at = 0; at < content.size(); ++at) {
      for (const char c : {'\0', '\1', '\7', '\x7f', '\xff', '9'}) {
        std::string changed = content;
        changed[at] = c;
        try {
          expect_valid_places(read_msh({"changed", changed}));
        } catch (const InputError&) {
          ++refused;
        }
      }
    }
    EXPECT_GT(refused, content.size());
  }
}

/// Binary data in either order of bytes, independent of what is under test.
class Bytes {
 public:
  explicit Bytes(bool big) : big_(big) {}
  Bytes& text(const std::string& text) {
    content += text;
    return *this;
  }
  template <class Number>
  Bytes& put(std::initializer_list<Number> numbers) {
    for (const Number number : numbers) {
      std::string bytes(sizeof number, '\0');
      std::memcpy(bytes.data(), &number, sizeof number);
      if (big_) std::reverse(bytes.begin(), bytes.end());
      content += bytes;
    }
    return *this;
  }
  std::string content;

 private:
  bool big_;
};

using Int = std::int32_t;
using Long = std::uint64_t;

std::string binary_22(bool big) {
  Bytes file(big);
  file.text("$MeshFormat\n2.2 1 8\n").put<Int>({1}).text("\n$EndMeshFormat\n$Nodes\n3\n");
  file.put<Int>({7}).put<double>({0, 0, 0}).put<Int>({9}).put<double>({1, 0, 0});
  file.put<Int>({8}).put<double>({0, 0.1, 0}).text("\n$EndNodes\n$Elements\n2\n");
  file.put<Int>({2, 1, 2, 5, 3, 1, 7, 9, 8}).put<Int>({1, 1, 3, 6, -4, 1, 0, 8, 9});
  file.text("\n$EndElements\n$NodeData\n1\n\"t\"\n1\n0.5\n3\n2\n1\n1\n");
  return file.put<Int>({9}).put<double>({2.5}).text("\n$EndNodeData\n").content;
}

std::string binary_41(bool big) {
  Bytes file(big);
  file.text("$MeshFormat\n4.1 1 8\n").put<Int>({1}).text("\n$EndMeshFormat\n$Entities\n");
  file.put<Long>({0, 1, 1, 0});
  file.put<Int>({1}).put<double>({0, 0, 0, 1, 1, 0}).put<Long>({1}).put<Int>({-4});
  file.put<Long>({2}).put<Int>({1, -2});
  file.put<Int>({1}).put<double>({0, 0, 0, 1, 1, 0}).put<Long>({1}).put<Int>({3}).put<Long>({0});
  file.text("\n$EndEntities\n$Nodes\n").put<Long>({2, 3, 7, 9});
  file.put<Int>({1, 1, 1}).put<Long>({1, 7}).put<double>({0, 0, 0, 0.25});
  file.put<Int>({2, 1, 0}).put<Long>({2, 9, 8}).put<double>({1, 0, 0, 0, 0.1, 0});
  file.text("\n$EndNodes\n$Elements\n").put<Long>({2, 2, 5, 6});
  file.put<Int>({1, 1, 1}).put<Long>({1, 6, 8, 9}).put<Int>({2, 1, 2}).put<Long>({1, 5, 7, 9, 8});
  file.text("\n$EndElements\n$NodeData\n1\n\"t\"\n1\n0.5\n3\n2\n1\n1\n");
  return file.put<Int>({9}).put<double>({2.5}).text("\n$EndNodeData\n").content;
}

TEST_F(MshForms, BothOrdersOfBytesAreRead) {
  for (const bool big : {false, true}) {
    for (const std::string& content : {binary_22(big), binary_41(big)}) {
      const Mesh mesh = read_mesh(put("a.msh", content));
      EXPECT_EQ(mesh.vertex_numbers, (std::vector<std::uint64_t>{7, 9, 8}));
      EXPECT_EQ(mesh.points[2], (std::array<double, 3>{0, 0.1, 0}));
      EXPECT_EQ(mesh.elements[1].vertices, (std::vector<Index>{2, 1}));
      EXPECT_EQ(mesh.elements[2].vertices, (std::vector<Index>{0, 1, 2}));
      EXPECT_EQ(mesh.elements[2].numbers, std::vector<std::uint64_t>{5});
      ASSERT_EQ(mesh.groups.size(), 2u);
      EXPECT_EQ(mesh.groups[0].tag, 4);
      EXPECT_EQ(mesh.groups[1].tag, 3);
      ASSERT_EQ(mesh.point_fields.size(), 1u);
      EXPECT_EQ(mesh.point_fields[0].name, "t (step 2)");
      EXPECT_TRUE(std::isnan(mesh.point_fields[0].values[0]));
      EXPECT_EQ(mesh.point_fields[0].values[1], 2.5);
      ASSERT_EQ(mesh.dropped.size(), 1u);
      EXPECT_NE(mesh.dropped[0].find("the time of the field 't (step 2)'"), std::string::npos);
    }
  }
}

TEST_F(MshForms, PlacesInBinaryFilesAreBytes) {
  const std::string good = binary_41(false);
  const Long totals_of_nodes[] = {2, 3, 7, 9};
  const std::string_view key(reinterpret_cast<const char*>(totals_of_nodes), 32);
  const std::string at = ": byte " + std::to_string(good.find(key)) + ": ";
  std::string other = good;
  other.replace(good.find(key) + 8, 2, "\xe8\x03");
  expect_reading_error(put("a.msh", other),
                       {at, "the number of nodes is 1000, but only", "bytes follow"});
  other.replace(good.find(key) + 8, 2, std::string("\2\0", 2));
  expect_reading_error(put("a.msh", other), {at, "is 2, but the blocks hold 3"});
  const std::string element = Bytes(false).put<Long>({5, 7, 9, 8}).content;
  other = good;
  other.replace(good.find(element), 32, Bytes(false).put<Long>({6, 7, 9, 8}).content);
  expect_reading_error(put("a.msh", other), {": byte " + std::to_string(good.find(element)),
                                             "element number 6 is used a second time"});
  other = good;
  other.replace(good.find(element), 32, Bytes(false).put<Long>({5, 7, 9, 80}).content);
  expect_reading_error(put("a.msh", other), {"element 5 uses node 80"});
  other = good;
  other.insert(good.find("\n$EndNodes"), "12345678");
  expect_reading_error(put("a.msh", other), {"expected $EndNodes"});
  const auto entities = good.find("$Entities"), nodes = good.find("$Nodes");
  other = good.substr(0, entities) + good.substr(nodes) + good.substr(entities, nodes - entities);
  expect_reading_error(put("a.msh", other), {"$Entities must come before $Elements"});
}

TEST_F(MshForms, NumbersOf64BitsNeedTextOrVersion41) {
  Mesh mesh = grouped_mesh();
  mesh.vertex_numbers = {7, 5000000000, 3, 18446744073709551615u, 12, 11};
  expect_same_numbers(round_trip(mesh, kForms[3]), mesh);
  EXPECT_EQ(round_trip(mesh, kForms[1]).vertex_numbers, grouped_mesh().vertex_numbers);
  mesh.point_fields = {{"p", 1, std::vector<double>(6, 1)}};
  EXPECT_THROW(write_mesh(path("b.msh"), mesh, kForms[3].options), OutputError);
  expect_same_fields(round_trip(mesh, kForms[2]).point_fields, mesh.point_fields);
}

TEST_F(MshForms, OptionsAreForGmshAlone) {
  EXPECT_THROW(write_mesh(path("a.mesh"), grouped_mesh(), {{}, true, {}}), InputError);
  EXPECT_THROW(write_mesh(path("a.vtk"), grouped_mesh(), {MshVersion::k22, {}}), InputError);
  EXPECT_TRUE(names().empty());
}

TEST_F(MshForms, CohesiveElementsAreCheckedByTheirThickness) {
  Mesh mesh = cohesive_mesh();
  mesh.points[4][2] = 1e-9;
  write_mesh(path("a.msh"), mesh, kForms[0].options);
  expect_reading_error(path("a.msh"),
                       {"a.msh:", "element 3 is a 6-node prism", "at the same place"});
  Mesh flat = periodic_mesh();
  flat.points.insert(flat.points.end(), {{0, 0, 0}, {1, 1, 0}});
  flat.vertex_numbers = {1, 2, 3, 4, 5, 6};
  flat.elements[2].vertices = {0, 1, 2, 4, 5, 3};
  flat.cohesive = {{0, 2, 4, 5}, {5}, {"glue"}};
  for (const Form& form : kForms) expect_same_content(round_trip(flat, form), flat);
  write_mesh(path("a.msh"), flat, kForms[0].options);
  EXPECT_NE(bytes("a.msh").find(" 1 3 6 5\n$EndElements"), std::string::npos) << bytes("a.msh");
}

TEST_F(MshForms, FieldsMustFitTheMesh) {
  Mesh mesh = grouped_mesh();
  mesh.cell_fields = {{"c", 1, {1, 2, 3}}};
  write_mesh(path("a.msh"), mesh, kForms[0].options);
  const std::string good = bytes("a.msh");
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    return text.replace(text.rfind(from), from.size(), to);
  };
  const struct {
    std::string text;
    std::vector<std::string> parts;
  } cases[] = {
      {with("\n8 1\n", "\n88 1\n"), {"a value of element 88", "does not hold"}},
      {with("\n9 2\n", "\n8 2\n"), {"a second value of element 8"}},
      {with("\n9 2\n", "\n9 2 3\n"), {"goes on with '3'"}},
      {with("3\n0\n1\n10\n", "3\n0\n1\n11\n"), {"expected a value"}},
      {with("3\n0\n1\n10\n", "3\n0\n1\n9\n"), {"more values than the count"}},
      {with("3\n0\n1\n10\n", "3\n0\n0\n10\n"), {"the number of components is 0"}},
      {with("3\n0\n1\n10\n", "2\n0\n1\n"), {"needs three integer tags"}},
      {with("3\n0\n1\n10\n", "3\n0\n90000000\n10\n"), {"the number of components", "bytes follow"}},
      {with("\"c\"", "c"), {"quotation marks"}},
      {good + good.substr(good.find("$ElementData")), {"a second section $ElementData of 'c'"}},
  };
  for (const auto& one : cases) expect_reading_error(put("a.msh", one.text), one.parts);
}

TEST_F(MshForms, ValuesOnEdgesOfASolidAreDroppedAndSaid) {
  write_mesh(path("a.msh"), grouped_mesh(), kForms[2].options);
  const Mesh mesh = read_mesh(put(
      "a.msh",
      bytes("a.msh") + "$ElementData\n1\n\"e\"\n1\n0\n3\n0\n1\n2\n3 1\n8 2\n$EndElementData\n"));
  ASSERT_EQ(mesh.cell_fields.size(), 1u);
  EXPECT_EQ(mesh.cell_fields[0].values[0], 2);
  ASSERT_EQ(mesh.dropped.size(), 1u);
  EXPECT_NE(mesh.dropped[0].find("neither cells nor facets"), std::string::npos);
}

TEST_F(MshForms, PeriodicPairsMustFitTheMesh) {
  for (const int form : {0, 2}) {
    write_mesh(path("a.msh"), periodic_mesh(), kForms[form].options);
    const std::string good = bytes("a.msh");
    const auto refuse = [&](const std::string& from, const std::string& to,
                            const std::string& part) {
      std::string text = good;
      text.replace(text.rfind(from), from.size(), to);
      expect_reading_error(put("b.msh", text), {"b.msh:", part});
    };
    refuse("\n3 4\n", "\n3 5\n", "periodic entity 7 uses node 5");
    refuse("\n3 4\n", "\n", "expected a pair of nodes");
    refuse("\n1 7 5\n", "\n3 7 5\n", "must be 0, 1 or 2");
    refuse(" 0 0 0 0 1\n", " 0 0 0 1\n", "of an affine map");
  }
}

}  // namespace
}  // namespace cleave::app::test
