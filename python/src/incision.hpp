#pragma once
#include <pybind11/pybind11.h>

namespace cleave::python {

/// Registers Incision1 .. Incision4 and make_incision(cells, vertex_count, signs, regularize),
/// which makes the one that fits the cells: (incision, splits of the regularisation).
void bind_incisions(pybind11::module_& module);

}  // namespace cleave::python
