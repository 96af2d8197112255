#include "files_support.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <tuple>

#include "error.hpp"
#include "mesh_file.hpp"

namespace cleave::app::test {
namespace {

void write_plainly(const std::filesystem::path& path, std::string_view content) {
  std::ofstream file(path, std::ios::binary);
  file.write(content.data(), static_cast<std::streamsize>(content.size()));
  ASSERT_TRUE(file.good()) << path;
}

std::vector<std::uint64_t> counted(std::uint64_t first, std::size_t count) {
  std::vector<std::uint64_t> numbers;
  for (std::size_t i = 0; i < count; ++i) numbers.push_back(first + i);
  return numbers;
}

}  // namespace

Files::Files() {
  std::string name = (std::filesystem::temp_directory_path() / "cleave-files-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  folder_ = name;
  std::filesystem::permissions(folder_, std::filesystem::perms(0755));
}

Files::~Files() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

std::filesystem::path Files::put(const std::string& name, std::string_view content) const {
  write_plainly(path(name), content);
  return path(name);
}

std::string Files::bytes(const std::string& name) const {
  std::ifstream file(path(name), std::ios::binary);
  EXPECT_TRUE(file.good()) << name;
  std::ostringstream all;
  all << file.rdbuf();
  return all.str();
}

std::vector<std::string> Files::names() const {
  std::vector<std::string> all;
  for (const auto& entry : std::filesystem::directory_iterator(folder_))
    all.push_back(entry.path().filename().string());
  std::sort(all.begin(), all.end());
  return all;
}

std::string reading_error(const std::filesystem::path& path) {
  try {
    read_mesh(path);
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << path << " was read without an error";
  return {};
}

void expect_reading_error(const std::filesystem::path& path,
                          const std::vector<std::string>& parts) {
  const std::string message = reading_error(path);
  for (const std::string& part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in: " << message;
}

Mesh grouped_mesh() {
  Mesh mesh;
  mesh.dimension = 3;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.1}, {1. / 3, 1, 1e-300}, {-2, 2, 1e20}};
  mesh.vertex_numbers = counted(1, 6);
  mesh.elements[0] = {{2, 5}, counted(1, 2)};
  mesh.elements[1] = {{0, 1, 1, 3, 0, 3}, counted(3, 3)};
  mesh.elements[2] = {{1, 2, 3, 0, 2, 1}, counted(6, 2)};
  mesh.elements[3] = {{0, 1, 2, 3, 4, 2, 1, 3, 4, 3, 2, 5}, counted(8, 3)};
  mesh.groups = {{"nail", 0, 7, {0, 1}}, {"rim", 1, 3, {0, 2}},    {"5", 1, 5, {1}},
                 {"cut", 2, 4, {0}},     {"unused", 2, 8, {}},     {"skin", 2, 9, {0, 1}},
                 {"1", 3, 1, {0, 2}},    {"left lobe", 3, 2, {1}}, {"all", 3, 6, {0, 1}}};
  return mesh;
}

Mesh second_order(Mesh mesh) {
  std::map<std::pair<Index, Index>, Index> middles;
  for (std::size_t d = 1; d <= 3; ++d) {
    Elements& elements = mesh.elements[d];
    for (std::size_t e = 0; e < elements.size(); ++e) {
      for (std::size_t i = 0; i < d; ++i) {
        for (std::size_t k = i + 1; k <= d; ++k) {
          const Index from = elements.vertices[(d + 1) * e + i];
          const Index to = elements.vertices[(d + 1) * e + k];
          const auto [known, is_new] =
              middles.try_emplace(std::minmax(from, to), static_cast<Index>(mesh.points.size()));
          if (is_new) {
            const auto a = mesh.points[from], b = mesh.points[to];
            const auto middle = [&](std::size_t x) {  // gmsh writes 16 digits
              return std::round(512 * (a[x] + b[x])) / 1024;
            };
            mesh.points.push_back({middle(0), middle(1), middle(2)});
            mesh.vertex_numbers.push_back(mesh.points.size());
          }
          elements.midside.push_back(known->second);
        }
      }
    }
  }
  return mesh;
}

Mesh cohesive_mesh() {
  Mesh mesh;
  mesh.dimension = 3;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0},
                 {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.vertex_numbers = counted(1, 8);
  mesh.elements[3] = {{0, 2, 1, 7, 3, 4, 5, 6}, counted(1, 2)};
  mesh.cohesive = {{0, 1, 2, 3, 4, 5}, {3}, {"glue"}};
  mesh.groups = {{"body", 3, 4, {0, 1}}};
  return mesh;
}

void expect_same_content(const Mesh& a, const Mesh& b) {
  EXPECT_EQ(a.dimension, b.dimension);
  ASSERT_EQ(a.points.size(), b.points.size());
  EXPECT_EQ(std::memcmp(a.points.data(), b.points.data(), a.points.size() * sizeof a.points[0]), 0);
  for (std::size_t d = 0; d <= 3; ++d)
    EXPECT_EQ(a.elements[d].vertices, b.elements[d].vertices) << "dimension " << d;
  for (std::size_t d = 0; d <= 3; ++d)
    EXPECT_EQ(a.elements[d].midside, b.elements[d].midside) << "dimension " << d;
  EXPECT_EQ(a.cohesive.vertices, b.cohesive.vertices);
  EXPECT_EQ(a.cohesive.names, b.cohesive.names);
  ASSERT_EQ(a.periodic.size(), b.periodic.size());
  for (std::size_t i = 0; i < a.periodic.size(); ++i) {
    const Periodicity &p = a.periodic[i], &q = b.periodic[i];
    EXPECT_EQ(std::tie(p.dimension, p.entity, p.master, p.affine),
              std::tie(q.dimension, q.entity, q.master, q.affine));
    const auto same = [](auto x, auto y) { return x.vertex == y.vertex && x.master == y.master; };
    EXPECT_TRUE(std::equal(p.pairs.begin(), p.pairs.end(), q.pairs.begin(), q.pairs.end(), same));
  }
  ASSERT_EQ(a.groups.size(), b.groups.size());
  for (std::size_t g = 0; g < a.groups.size(); ++g) {
    EXPECT_EQ(a.groups[g].name, b.groups[g].name);
    EXPECT_EQ(a.groups[g].dimension, b.groups[g].dimension) << a.groups[g].name;
    EXPECT_EQ(a.groups[g].tag, b.groups[g].tag) << a.groups[g].name;
    EXPECT_EQ(a.groups[g].elements, b.groups[g].elements) << a.groups[g].name;
  }
}

void expect_same_numbers(const Mesh& a, const Mesh& b) {
  EXPECT_EQ(a.vertex_numbers, b.vertex_numbers);
  for (std::size_t d = 0; d <= 3; ++d)
    EXPECT_EQ(a.elements[d].numbers, b.elements[d].numbers) << "dimension " << d;
  EXPECT_EQ(a.cohesive.numbers, b.cohesive.numbers);
}

void expect_same_fields(const std::vector<Field>& a, const std::vector<Field>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t f = 0; f < a.size(); ++f) {
    EXPECT_EQ(a[f].name, b[f].name);
    EXPECT_EQ(a[f].components, b[f].components) << a[f].name;
    EXPECT_EQ(a[f].values, b[f].values) << a[f].name;
    EXPECT_EQ(a[f].integer, b[f].integer) << a[f].name;
  }
}

void expect_valid_places(const Mesh& mesh) {
  EXPECT_EQ(mesh.vertex_numbers.size(), mesh.points.size());
  for (std::size_t d = 0; d <= 3; ++d) {
    const Elements& elements = mesh.elements[d];
    EXPECT_EQ(elements.vertices.size(), (d + 1) * elements.size());
    for (const Index v : elements.vertices) EXPECT_LT(v, mesh.points.size());
    if (elements.second_order()) {
      EXPECT_EQ(elements.midside.size(), d * (d + 1) / 2 * elements.size());
    }
    for (const Index v : elements.midside) EXPECT_LT(v, mesh.points.size());
  }
  for (const Index v : mesh.cohesive.vertices) EXPECT_LT(v, mesh.points.size());
  for (const Periodicity& periodic : mesh.periodic)
    for (const auto& pair : periodic.pairs)
      EXPECT_LT(std::max(pair.vertex, pair.master), mesh.points.size());
  for (const Group& group : mesh.groups) {
    ASSERT_GE(group.dimension, 0);
    ASSERT_LE(group.dimension, 3);
    const auto count = mesh.elements[static_cast<std::size_t>(group.dimension)].size();
    for (const Index e : group.elements) EXPECT_LT(e, count);
  }
}

void expect_prefixes_are_refused(ReadText read, const std::string& content) {
  const Mesh whole = read({"whole", content});
  std::size_t refused = 0;
  for (std::size_t size = 0; size < content.size(); ++size) {
    SCOPED_TRACE("the first " + std::to_string(size) + " bytes");
    try {
      const Mesh part = read({"part", std::string_view(content).substr(0, size)});
      expect_same_content(part, whole);
      expect_same_numbers(part, whole);
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GE(refused + 2, content.size()) << "only the last line end may be missing";
}

void expect_defects_are_noticed(ReadText read, const std::string& content) {
  std::size_t refused = 0;
  for (std::size_t at = 0; at < content.size(); ++at) {
    for (const char c : {'0', '9', '-', '.', 'e', ' ', '\n', '$', '"', '#', '\0'}) {
      std::string changed = content;
      changed[at] = c;
      try {
        expect_valid_places(read({"changed", changed}));
      } catch (const InputError&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, content.size());
}

}  // namespace cleave::app::test
