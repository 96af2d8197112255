// Every format into every other one and back: what differs is what the conversion said is lost.
#include <cmath>
#include <map>
#include <set>

#include "error.hpp"
#include "files_support.hpp"
#include "losses.hpp"
#include "mesh_file.hpp"

namespace cleave::app::test {
namespace {

struct Kind {
  const char* name;
  const char* extension;
  WriteOptions options;
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{{"medit", ".mesh", {}},
                                     {"msh22", ".msh", {MshVersion::k22, false, {}}},
                                     {"msh22-binary", ".msh", {MshVersion::k22, true, {}}},
                                     {"msh41", ".msh", {MshVersion::k41, false, {}}},
                                     {"msh41-binary", ".msh", {MshVersion::k41, true, {}}},
                                     {"tetgen", ".node", {}},
                                     {"abaqus", ".inp", {}},
                                     {"vtu-text", ".vtu", {{}, {}, VtuEncoding::kText}},
                                     {"vtu-raw", ".vtu", {{}, {}, VtuEncoding::kRaw}},
                                     {"vtu-base64", ".vtu", {{}, {}, VtuEncoding::kBase64}},
                                     {"vtu-zlib", ".vtu", {{}, {}, VtuEncoding::kZlib}},
                                     {"vtk-text", ".vtk", {{}, false, {}}},
                                     {"vtk-binary", ".vtk", {{}, true, {}}}};
  return all;
}

using Counts = std::map<std::string, std::size_t>;

void count(Counts& counts, const std::string& kind, std::size_t more) {
  if (more > 0) counts[kind] += more;
}

bool are_places(const std::vector<std::uint64_t>& numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (numbers[0] > 1 || numbers[i] != numbers[0] + i) return false;
  return true;
}

std::size_t differing(const std::vector<std::uint64_t>& a, const std::vector<std::uint64_t>& b) {
  if (are_places(a) && are_places(b)) return 0;
  std::size_t number = 0;
  for (std::size_t i = 0; i < a.size(); ++i) number += a[i] == b.at(i) ? 0 : 1;
  return number;
}

/// Whether points are marks on vertices, without numbers of their own.
bool are_marks(const Mesh& mesh) {
  const Elements& points = mesh.elements[0];
  for (std::size_t e = 0; e < points.size(); ++e)
    if (points.numbers[e] != mesh.vertex_numbers[points.vertices[e]]) return false;
  return true;
}

bool same_values(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

/// One list per component, which is all that attributes without names keep of fields.
std::vector<std::vector<double>> columns(const std::vector<Field>& fields) {
  std::vector<std::vector<double>> all;
  for (const Field& field : fields)
    for (int k = 0; k < field.components; ++k) {
      all.emplace_back();
      for (std::size_t i = static_cast<std::size_t>(k); i < field.values.size();
           i += static_cast<std::size_t>(field.components))
        all.back().push_back(field.values[i]);
    }
  return all;
}

void count_fields(Counts& counts, const std::string& lost, const std::vector<Field>& before,
                  const std::vector<Field>& after) {
  const bool same_columns = columns(before) == columns(after);
  for (const Field& field : before) {
    const Field* found = nullptr;
    for (const Field& other : after)
      if (other.name == field.name && other.components == field.components &&
          same_values(other.values, field.values))
        found = &other;
    count(
        counts, "field-types",
        (found != nullptr || same_columns) && field.integer && (found == nullptr || !found->integer)
            ? 1
            : 0);
    if (found == nullptr) count(counts, same_columns ? "field-names" : lost, 1);
  }
}

/// Elements of a group; of dimension 0, their vertices.
std::vector<Index> content(const Mesh& mesh, const Group& group) {
  if (group.dimension > 0) return group.elements;
  std::vector<Index> vertices;
  for (const Index e : group.elements) vertices.push_back(mesh.elements[0].vertices[e]);
  return vertices;
}

void count_groups(Counts& counts, const Mesh& before, const Mesh& after) {
  for (const Group& group : before.groups) {
    const Group* found = nullptr;
    for (const Group& other : after.groups)
      if (other.dimension == group.dimension && other.name == group.name &&
          content(after, other) == content(before, group))
        found = &other;
    if (found == nullptr)
      count(counts, group.elements.empty() ? "empty-groups" : "group '" + group.name + "'", 1);
    else
      count(counts, "group-numbers", found->tag == group.tag ? 0 : 1);
  }
}

/// What `after` has lost of `before`, in the words of losses_of.
Counts differences(const Mesh& before, const Mesh& after) {
  Counts counts;
  EXPECT_EQ(before.dimension, after.dimension);
  EXPECT_EQ(before.points, after.points);
  std::size_t numbers = 0;
  for (std::size_t d = 0; d <= 3; ++d) {
    const Elements &a = before.elements[d], &b = after.elements[d];
    if (d > 0 || a.size() == b.size()) {
      EXPECT_EQ(a.vertices, b.vertices) << d;
      EXPECT_TRUE(!b.second_order() || a.midside == b.midside) << d;
      if (d > 0 || !are_marks(before)) numbers += differing(a.numbers, b.numbers);
    }
    if (a.second_order() && !b.second_order()) count(counts, "second-order", a.size());
  }
  const std::size_t cohesive = before.cohesive.size();
  if (after.cohesive.size() == cohesive) {
    EXPECT_EQ(before.cohesive.vertices, after.cohesive.vertices);
    EXPECT_EQ(before.cohesive.names, after.cohesive.names);
    numbers += differing(before.cohesive.numbers, after.cohesive.numbers);
  }
  count(counts, "cohesive-elements", cohesive - after.cohesive.size());
  count(counts, "vertex-elements", before.elements[0].size() - after.elements[0].size());
  count(counts, "vertex-numbers", differing(before.vertex_numbers, after.vertex_numbers));
  count(counts, "element-numbers", numbers);
  count_fields(counts, "point-fields", before.point_fields, after.point_fields);
  count_fields(counts, "cell-fields", before.cell_fields, after.cell_fields);
  count_fields(counts, "facet-fields", before.facet_fields, after.facet_fields);
  count_groups(counts, before, after);
  return counts;
}

Counts announced(const std::vector<Loss>& losses) {
  Counts counts;
  for (const Loss& loss : losses) counts[loss.kind] = loss.count;
  return counts;
}

class Pairs : public Files {
 protected:
  std::filesystem::path write(const std::string& stem, const Kind& kind, const Mesh& mesh) const {
    const auto file = path(stem + "-" + kind.name + kind.extension);
    write_mesh(file, mesh, kind.options);
    return file;
  }

  /// Between all formats, or those that are named.
  void expect_every_pair_loses_what_it_says(const Mesh& mesh,
                                            const std::set<std::string>& only = {}) const {
    const auto passed_over = [&](const Kind& kind) {
      return !only.empty() && only.count(kind.name) == 0;
    };
    for (const Kind& from : kinds()) {
      if (passed_over(from)) continue;
      const auto first = write("first", from, mesh);
      const Mesh source = read_mesh(first);
      for (const Kind& to : kinds()) {
        if (passed_over(to)) continue;
        SCOPED_TRACE(std::string(from.name) + " -> " + to.name);
        const auto losses = announced(losses_of(source, path("x") += to.extension, to.options));
        const Mesh other = read_mesh(write("other", to, source));
        Counts found = differences(source, other);
        EXPECT_EQ(found, losses);
        const Mesh back = read_mesh(write("back", from, other));
        for (const auto& [kind, number] : differences(source, back))
          EXPECT_TRUE(losses.count(kind) > 0) << kind << " is lost on the way back: " << number;
      }
    }
  }
};

TEST_F(Pairs, LoseOfGroupsWhatTheySay) { expect_every_pair_loses_what_it_says(grouped_mesh()); }

TEST_F(Pairs, LoseOfNumbersWhatTheySay) {
  Mesh mesh = grouped_mesh();
  mesh.vertex_numbers = {7, 50, 3, 1000000000, 12, 11};
  mesh.elements[1].numbers = {4, 3, 5};
  mesh.elements[3].numbers = {30, 20, 10};
  expect_every_pair_loses_what_it_says(
      mesh, {"medit", "msh22", "msh41", "tetgen", "abaqus", "vtu-raw", "vtk-text"});
}

/// Two triangles apart, with a cohesive element in between.
Mesh opened_square() {
  Mesh mesh;
  mesh.dimension = 2;
  mesh.points = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}};
  mesh.vertex_numbers = {1, 2, 3, 4, 5, 6};
  mesh.elements[1] = {{1, 2, 4, 5, 0, 1}, {1, 2, 3}};
  mesh.elements[2] = {{0, 1, 2, 4, 3, 5}, {4, 5}};
  mesh.cohesive = {{2, 1, 5, 4}, {6}, {"crack_cohesive"}};
  mesh.groups = {{"crack_minus", 1, 1, {0}}, {"crack_plus", 1, 2, {1}}, {"7", 2, 7, {0, 1}}};
  return mesh;
}

/// The same with tetrahedra.
Mesh opened_body() {
  Mesh mesh;
  mesh.dimension = 3;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                 {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  mesh.vertex_numbers = {1, 2, 3, 4, 5, 6, 7, 8};
  mesh.elements[2] = {{1, 2, 3, 4, 6, 5}, {1, 2}};
  mesh.elements[3] = {{0, 1, 2, 3, 4, 5, 6, 7}, {3, 4}};
  mesh.cohesive = {{1, 2, 3, 4, 5, 6}, {5}, {"fault_cohesive"}};
  mesh.groups = {{"fault_minus", 2, 1, {0}}, {"fault_plus", 2, 2, {1}}, {"body", 3, 3, {0, 1}}};
  return mesh;
}

std::vector<double> some_values(std::size_t count) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(0.1 * static_cast<double>(i * i) - 3);
  return values;
}

Mesh with_fields(Mesh mesh) {
  const std::size_t points = mesh.points.size(), cells = mesh.cells().size();
  mesh.point_fields = {{"displacement", 3, some_values(3 * points)},
                       {"parent", 1, std::vector<double>(points, 8), true}};
  mesh.cell_fields = {{"stress", 1, some_values(cells)}, {"two words", 2, some_values(2 * cells)}};
  mesh.facet_fields = {{"stress", 1, some_values(mesh.facets().size())},
                       {"side", 1, std::vector<double>(mesh.facets().size(), 2), true}};
  return mesh;
}

}  // namespace

// VTK cannot read what is not finite from text, such as "no value" on an edge.
TEST_F(Pairs, LoseOfEverythingElseWhatTheySay) {
  const std::set<std::string> kOneEach{"medit",    "tetgen",   "abaqus",
                                       "vtu-text", "vtu-zlib", "vtk-binary"};
  for (const Mesh& mesh : {opened_square(), opened_body()}) {
    SCOPED_TRACE(mesh.dimension);
    expect_every_pair_loses_what_it_says(with_fields(mesh), kOneEach);
    expect_every_pair_loses_what_it_says(second_order(mesh), kOneEach);
  }
}

TEST_F(Pairs, WhatIsNotFiniteIsRefusedInTextVtk) {
  const Kind text{"vtk-text", ".vtk", {{}, false, {}}};
  EXPECT_THROW(write("a", text, with_fields(opened_body())), OutputError);
  EXPECT_TRUE(names().empty());
  write_mesh(path("a.vtk"), opened_body(), text.options);
  std::string content = bytes("a.vtk");
  content.replace(content.find("\n1 0 0\n"), 7, "\n1 nan 0\n");
  expect_reading_error(put("b.vtk", content), {"b.vtk:7:", "not finite", "binary form"});
}

TEST_F(Pairs, GivesTheSameBytesTwice) {
  for (const Kind& kind : kinds()) {
    const bool text = kind.name == std::string("vtk-text");
    const Mesh mesh = text ? opened_body() : with_fields(opened_body());
    const auto a = write("a", kind, mesh), b = write("b", kind, mesh);
    EXPECT_EQ(bytes(a.filename()), bytes(b.filename())) << kind.name;
  }
}

}  // namespace cleave::app::test
