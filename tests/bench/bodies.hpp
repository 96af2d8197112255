#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <span>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include "cleave/support/meshes.hpp"
#include "cleave/support/rng.hpp"
#include "cleave/topology/assemble.hpp"
#include "cleave/topology/check.hpp"
#include "flat_yardstick.hpp"

/// The bodies that the benchmarks work on: Kuhn grids of cubes^D cubes with D! cells each, as soup,
/// as complex and as flat arrays.
namespace cleave::bench {

/// How cells and vertices are numbered: as the grid is walked through, or at random.
enum class Order { mesh, random };

/// A grid of cubes^D cubes, coherently oriented.
template <int D>
topology::CellSoup<D> kuhn_soup(int cubes) {
  std::array<int, D> nodes{};
  nodes.fill(2);
  support::KuhnGrid<D> one(nodes);  // the cubes are alike, and so are their signs
  const auto signs = std::get<std::vector<std::int8_t>>(
      topology::orient(topology::CellSoup<D>{std::move(one.cells), one.vertex_count, {}}));
  nodes.fill(cubes + 1);
  support::KuhnGrid<D> grid(nodes);
  topology::CellSoup<D> soup{std::move(grid.cells), grid.vertex_count, {}};
  soup.signs.reserve(soup.cells.size());
  while (soup.signs.size() < soup.cells.size())
    soup.signs.insert(soup.signs.end(), signs.begin(), signs.end());
  return soup;
}

/// The same complex with its cells and vertices numbered at random.
template <int D>
topology::CellSoup<D> shuffled(const topology::CellSoup<D>& soup) {
  support::Rng rng(1);
  std::vector<topology::Index> vertex(soup.vertex_count), order(soup.cells.size());
  std::iota(vertex.begin(), vertex.end(), topology::Index{0});
  std::iota(order.begin(), order.end(), topology::Index{0});
  rng.shuffle(vertex);
  rng.shuffle(order);
  topology::CellSoup<D> result{{}, soup.vertex_count, {}};
  result.cells.reserve(order.size());
  result.signs.reserve(order.size());
  for (const topology::Index c : order) {
    topology::Cell<D> cell = soup.cells[c];
    for (topology::VertexId& v : cell) v = {vertex[v.value]};
    result.cells.push_back(cell);
    result.signs.push_back(soup.signs[c]);
  }
  return result;
}

template <int D>
topology::CellSoup<D> kuhn_soup(int cubes, Order order) {
  topology::CellSoup<D> soup = kuhn_soup<D>(cubes);
  return order == Order::mesh ? soup : shuffled(soup);
}

/// The yardstick's arrays, without mates; its numbers have 32 bits whatever ours have.
template <int D>
FlatMesh<D> flat_mesh(std::span<const topology::Cell<D>> cells, std::size_t vertex_count,
                      std::span<const std::int8_t> signs) {
  FlatMesh<D> flat;
  flat.cells.resize(cells.size());
  flat.reversed.resize(cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (std::size_t i = 0; i <= D; ++i)
      flat.cells[c][i] = static_cast<std::uint32_t>(cells[c][i].value);
    flat.reversed[c] = signs[c] < 0;
  }
  flat.vertices = static_cast<std::uint32_t>(vertex_count);
  return flat;
}

template <int D>
FlatMesh<D> flat_mesh(const topology::CellSoup<D>& soup) {
  return flat_mesh<D>(soup.cells, soup.vertex_count, soup.signs);
}

template <int D>
FlatMesh<D> matched_flat_mesh(const topology::CellSoup<D>& soup) {
  FlatMesh<D> flat = flat_mesh(soup);
  if (!flat.match()) throw std::logic_error("the yardstick finds the cells not coherent");
  return flat;
}

/// What was made last by `make(key..)`, so that benchmarks in a row make it once. One of each kind
/// of key is kept.
template <class Value, class Key, class Make>
const Value& last_made(const Key& key, Make make) {
  static std::unique_ptr<std::pair<Key, Value>> last;
  if (!last || last->first != key) {
    last.reset();
    last = std::make_unique<std::pair<Key, Value>>(key, make());
  }
  return last->second;
}

/// A grid that is assembled.
template <int D>
struct Body {
  int cubes = 0;
  topology::Complex<D> complex;
  FlatMesh<D> flat;
};

template <int D>
const Body<D>& body(int cubes, Order order = Order::mesh) {
  return last_made<Body<D>>(std::pair(cubes, order), [&] {
    topology::CellSoup<D> soup = kuhn_soup<D>(cubes, order);
    FlatMesh<D> flat = matched_flat_mesh(soup);
    return Body<D>{cubes, topology::assemble(std::move(soup)), std::move(flat)};
  });
}

}  // namespace cleave::bench
