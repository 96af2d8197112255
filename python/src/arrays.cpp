#include "arrays.hpp"

namespace cleave::python {

py::array view_of(const void* data, std::size_t rows, std::size_t columns,
                  const py::object& owner) {
  py::array view(py::dtype::of<std::uint32_t>(),
                 {static_cast<py::ssize_t>(rows), static_cast<py::ssize_t>(columns)}, data, owner);
  view.attr("flags").attr("writeable") = false;
  return view;
}

}  // namespace cleave::python
