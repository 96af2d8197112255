#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "files/input_text.hpp"
#include "mesh.hpp"

namespace cleave::app::test {

/// A folder of its own for each test, removed at its end.
class Files : public ::testing::Test {
 protected:
  Files();
  ~Files() override;

  std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  std::filesystem::path put(const std::string& name, std::string_view content) const;
  std::string bytes(const std::string& name) const;
  /// The names in the folder, sorted.
  std::vector<std::string> names() const;

 private:
  std::filesystem::path folder_;
};

/// The message of the InputError that reading `path` throws; a failure if it throws none.
std::string reading_error(const std::filesystem::path& path);

/// Expects reading `path` to fail with a message that holds all of `parts`.
void expect_reading_error(const std::filesystem::path& path, const std::vector<std::string>& parts);

/// Three tetrahedra with groups of every dimension: overlapping ones, one whose name is its number,
/// one without elements. Numbers as a .msh file may have them, consecutive from 1 on.
Mesh grouped_mesh();

/// The mesh with a node near the middle of each edge of its elements.
Mesh second_order(Mesh mesh);

/// Two tetrahedra with a prism of no thickness between them, in the group "glue".
Mesh cohesive_mesh();

/// Expects the same points (bit for bit), elements, order, groups, cohesive elements and periodic
/// pairs; numbers and fields are not compared.
void expect_same_content(const Mesh& a, const Mesh& b);
void expect_same_numbers(const Mesh& a, const Mesh& b);
void expect_same_fields(const std::vector<Field>& a, const std::vector<Field>& b);

/// Expects that places in the mesh are places: no reader may let a file say otherwise.
void expect_valid_places(const Mesh& mesh);

/// A reader of one of the text formats.
using ReadText = Mesh (*)(const InputText&);

/// Reads `content` cut off after each byte: what is read without an error must be the whole.
void expect_prefixes_are_refused(ReadText read, const std::string& content);

/// Reads `content` with each byte replaced by characters that mean something in mesh files: an
/// InputError or a mesh with valid places, nothing else.
void expect_defects_are_noticed(ReadText read, const std::string& content);

}  // namespace cleave::app::test
