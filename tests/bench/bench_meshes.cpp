#include "bench_meshes.hpp"

#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <variant>

#include "bodies.hpp"
#include "cleave/topology/assemble.hpp"
#include "cleave/topology/check.hpp"

namespace cleave::bench {

namespace {

using topology::CellSoup;
using topology::Index;

std::string path_of(const std::string& name) {
  if (name == "mesh") {
    const char* path = std::getenv("CLEAVE_BENCH_MESH");
    return path == nullptr ? "" : path;
  }
  return std::string(CLEAVE_BENCH_MESHES) + "/" + name + ".mesh";
}

/// The numbers of a text, one after the other.
class Numbers {
 public:
  explicit Numbers(std::string_view text) : at_(text.data()), end_(at_ + text.size()) {}
  Index next() {
    while (at_ != end_ && (*at_ < '0' || *at_ > '9')) ++at_;
    Index value = 0;
    const auto [after, error] = std::from_chars(at_, end_, value);
    if (error != std::errc()) throw std::runtime_error("a number is missing");
    at_ = after;
    return value;
  }

 private:
  const char *at_, *end_;
};

/// The tetrahedra of a Medit file (.mesh, text).
CellSoup<3> read_medit(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream buffer;
  buffer << file.rdbuf();
  const std::string text = std::move(buffer).str();
  const auto section = [&](const char* name) {
    const std::size_t at = text.find(name);
    if (at == std::string::npos) throw std::runtime_error(path + " has no section" + name);
    return Numbers(std::string_view(text).substr(at));
  };
  CellSoup<3> soup;
  soup.vertex_count = section("\nVertices").next();
  Numbers numbers = section("\nTetrahedra");
  soup.cells.resize(numbers.next());
  for (auto& cell : soup.cells) {
    for (auto& v : cell) v = {numbers.next() - 1};
    numbers.next();  // the reference
  }
  soup.signs = std::get<std::vector<std::int8_t>>(topology::orient(soup));
  std::vector<std::int8_t> signs = soup.signs;
  auto complex = topology::assemble_regularized(std::move(soup)).complex;
  const std::size_t vertex_count = complex.vertex_count();
  return {std::move(complex).cells(), vertex_count, std::move(signs)};
}

}  // namespace

std::vector<std::string> mesh_files() {
  std::vector<std::string> names;
  for (const char* name : {"liver", "points", "mesh"})
    if (std::filesystem::exists(path_of(name))) names.emplace_back(name);
  return names;
}

topology::CellSoup<3> named_mesh(std::string name) {
  constexpr std::string_view kShuffled = "-shuffled", kCube = "cube-";
  if (name.ends_with(kShuffled)) {
    name.resize(name.size() - kShuffled.size());
    return shuffled(named_mesh(name));
  }
  if (name.starts_with(kCube)) return kuhn_soup<3>(std::stoi(name.substr(kCube.size())));
  return read_medit(path_of(name));
}

}  // namespace cleave::bench
