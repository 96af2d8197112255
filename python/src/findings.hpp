#pragma once
#include <pybind11/pybind11.h>

#include <vector>

#include "cleave/topology/violation.hpp"

namespace cleave::python {

/// Violations as Python has them: a list of (rule, level, message, witness), where witness is a
/// dictionary of numbers and lists of numbers under the names of the fields in violation.hpp.
pybind11::list findings(const std::vector<topology::Violation>& violations);

/// Registers the translation of the library's exceptions to those of `errors`, the module
/// cleave.errors.
void translate_exceptions(const pybind11::module_& errors);

}  // namespace cleave::python
