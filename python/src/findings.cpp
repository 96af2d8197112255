#include "findings.hpp"

#include "cleave/topology/facet_set.hpp"

namespace cleave::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

template <class Tag>
py::int_ number(topology::Id<Tag> id) {
  return py::int_(id.value);
}

template <class Tag>
py::list numbers(const std::vector<topology::Id<Tag>>& ids) {
  py::list list;
  for (const auto id : ids) list.append(number(id));
  return list;
}

struct Witness {
  py::dict operator()(const topology::DegenerateCell& v) const {
    return py::dict("cell"_a = number(v.cell), "repeated"_a = number(v.repeated));
  }
  py::dict operator()(const topology::VertexOutOfRange& v) const {
    return py::dict("cell"_a = number(v.cell), "vertex"_a = number(v.vertex));
  }
  py::dict operator()(const topology::DuplicateCell& v) const {
    return py::dict("first"_a = number(v.first), "second"_a = number(v.second));
  }
  py::dict operator()(const topology::FacetInThreeCells& v) const {
    return py::dict("half_facets"_a = numbers(v.half_facets));
  }
  py::dict operator()(const topology::OrientationConflict& v) const {
    return py::dict("one"_a = number(v.one), "other"_a = number(v.other));
  }
  py::dict operator()(const topology::NonOrientable& v) const {
    return py::dict("loop"_a = numbers(v.loop));
  }
  py::dict operator()(const topology::NotCutRegular& v) const {
    return py::dict("vertex"_a = number(v.vertex), "one_part"_a = number(v.one_part),
                    "other_part"_a = number(v.other_part), "parts"_a = v.parts);
  }
  py::dict operator()(const topology::PinchedSimplex& v) const {
    return py::dict("simplex"_a = numbers(v.simplex), "one_part"_a = number(v.one_part),
                    "other_part"_a = number(v.other_part), "parts"_a = v.parts);
  }
  py::dict operator()(const topology::BadVertexLink& v) const {
    return py::dict("vertex"_a = number(v.vertex),
                    "euler_characteristic"_a = v.euler_characteristic,
                    "boundary_components"_a = v.boundary_components);
  }
  py::dict operator()(const topology::OrphanVertex& v) const {
    return py::dict("vertex"_a = number(v.vertex));
  }
};

// Kept for the life of the interpreter: the exceptions' classes outlive every call.
py::handle invalid_complex, not_interior, invariant_broken;

void raise(const py::handle& type, const char* message, const char* key, py::object value) {
  py::object error = type(message);
  error.attr(key) = std::move(value);
  PyErr_SetObject(type.ptr(), error.ptr());
}

}  // namespace

py::list findings(const std::vector<topology::Violation>& violations) {
  py::list list;
  for (const topology::Violation& violation : violations) {
    const std::string_view rule = topology::rule(violation);
    const std::string_view level = topology::name(topology::breaks(violation));
    list.append(py::make_tuple(py::str(rule.data(), rule.size()),
                               py::str(level.data(), level.size()), topology::describe(violation),
                               std::visit(Witness{}, violation)));
  }
  return list;
}

void translate_exceptions(const py::module_& errors) {
  invalid_complex = py::object(errors.attr("InvalidComplex")).release();
  not_interior = py::object(errors.attr("NotInterior")).release();
  invariant_broken = py::object(errors.attr("InvariantBroken")).release();
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const topology::InvalidComplex& e) {
      raise(invalid_complex, e.what(), "raw_findings", findings(e.violations));
    } catch (const topology::NotInterior& e) {
      raise(not_interior, e.what(), "half_facet", number(e.half_facet));
    } catch (const topology::InvariantBroken& e) {
      PyErr_SetString(invariant_broken.ptr(), e.what());
    }
  });
}

}  // namespace cleave::python
