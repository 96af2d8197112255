#pragma once
#include <pybind11/numpy.h>

#include <cstdint>
#include <span>

namespace cleave::python {

/// One sign per cell, +1 or -1, or no entry: all as written.
using Signs = pybind11::array_t<std::int8_t, pybind11::array::c_style>;

inline std::span<const std::int8_t> signs_of(const Signs& signs) {
  return {signs.data(), static_cast<std::size_t>(signs.size())};
}

}  // namespace cleave::python
