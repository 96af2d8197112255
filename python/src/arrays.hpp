#pragma once
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "cleave/topology/ids.hpp"

/// NumPy arrays as what the library works on, and back, without copying where nothing has to move.
namespace cleave::python {

namespace py = pybind11;

/// Rows of numbers: uint32, C order. Other arrays are converted in Python, where that is seen.
using Numbers = py::array_t<std::uint32_t, py::array::c_style>;

/// Calls `f(std::integral_constant<int, D>)` for cells of D+1 vertices. Throws
/// std::invalid_argument for an array that is not two-dimensional with 2 to 5 columns.
template <class F>
auto with_dimension(const Numbers& cells, F&& f) {
  const py::ssize_t columns = cells.ndim() == 2 ? cells.shape(1) : 0;
  switch (columns) {
    case 2:
      return f(std::integral_constant<int, 1>{});
    case 3:
      return f(std::integral_constant<int, 2>{});
    case 4:
      return f(std::integral_constant<int, 3>{});
    case 5:
      return f(std::integral_constant<int, 4>{});
    default:
      throw std::invalid_argument(
          "cells are rows of 2 (edges), 3 (triangles), 4 (tetrahedra) or 5 vertices");
  }
}

/// The rows of `numbers` as tuples of ids: a view, valid as long as the array.
template <class Row>
std::span<const Row> rows(const Numbers& numbers) {
  static_assert(sizeof(Row) % sizeof(std::uint32_t) == 0 && std::is_trivially_copyable_v<Row>);
  return {reinterpret_cast<const Row*>(numbers.data()),
          static_cast<std::size_t>(numbers.size()) * sizeof(std::uint32_t) / sizeof(Row)};
}

/// `count` ids per row at `data` as a read-only array that shares their memory; `owner` keeps it.
py::array view_of(const void* data, std::size_t rows, std::size_t columns, const py::object& owner);

/// `values` as an array of their own, one row of Row's numbers each; of a single number, flat.
template <class Row>
py::array copy_of(const std::vector<Row>& values) {
  constexpr std::size_t columns = sizeof(Row) / sizeof(std::uint32_t);
  static_assert(sizeof(Row) == columns * sizeof(std::uint32_t));
  static_assert(std::is_trivially_copyable_v<Row>);
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(values.size())};
  if (columns > 1) shape.push_back(static_cast<py::ssize_t>(columns));
  return py::array_t<std::uint32_t>(shape, reinterpret_cast<const std::uint32_t*>(values.data()));
}

}  // namespace cleave::python
