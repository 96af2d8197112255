#include <optional>
#include <variant>

#include "arrays.hpp"
#include "cleave/topology/certify.hpp"
#include "cleave/topology/check.hpp"
#include "cleave/topology/locate.hpp"
#include "cleave/topology/summary.hpp"
#include "findings.hpp"
#include "incision.hpp"
#include "signs.hpp"

/// The extension module behind python/cleave: arrays in, arrays out. Its functions take what the
/// Python side has made sure of: uint32 in C order, one sign per cell or none.
namespace cleave::python {
namespace {

using topology::HalfFacetId;

template <int D>
topology::CellView<D> view(const Numbers& cells, std::size_t vertex_count, const Signs& signs) {
  return topology::CellView<D>::of(rows<topology::Cell<D>>(cells), vertex_count, signs_of(signs));
}

topology::Level level_of(const std::string& name) {
  using topology::Level;
  for (const Level level :
       {Level::pseudo_manifold, Level::cut_regular, Level::edge_regular, Level::manifold})
    if (topology::name(level) == name) return level;
  throw std::invalid_argument(
      "a level is 'pseudo-manifold', 'cut-regular', 'edge-regular' or "
      "'manifold', not '" +
      name + "'");
}

py::tuple check(const Numbers& cells, std::size_t vertex_count, const Signs& signs,
                const std::string& level) {
  const topology::Level asked = level_of(level);
  return with_dimension(cells, [&](auto d) {
    const auto soup = view<d.value>(cells, vertex_count, signs);
    std::vector<topology::Violation> found;
    {
      const py::gil_scoped_release others_may_run;
      found = topology::check<d.value>(soup, asked);
    }
    const std::string_view reached = topology::name(topology::level_reached(d.value, found));
    return py::make_tuple(findings(found), py::str(reached.data(), reached.size()));
  });
}

py::object orient(const Numbers& cells, std::size_t vertex_count) {
  return with_dimension(cells, [&](auto d) -> py::object {
    const auto signs = topology::orient<d.value>(view<d.value>(cells, vertex_count, Signs{}));
    if (const auto* found = std::get_if<std::vector<std::int8_t>>(&signs))
      return py::array_t<std::int8_t>(static_cast<py::ssize_t>(found->size()), found->data());
    throw topology::InvalidComplex({std::get<topology::NonOrientable>(signs)});
  });
}

py::tuple summarize(const Numbers& cells, std::size_t vertex_count) {
  return with_dimension(cells, [&](auto d) {
    const auto summary = topology::summarize<d.value>(view<d.value>(cells, vertex_count, Signs{}));
    return py::make_tuple(summary.pieces, summary.boundary_components,
                          summary.euler_characteristic);
  });
}

py::object certify(const Numbers& before, const Numbers& cut, const Numbers& after) {
  return with_dimension(before, [&](auto d) -> py::object {
    using Cell = topology::Cell<d.value>;
    if (after.ndim() != 2 || after.shape(1) != before.shape(1))
      throw std::invalid_argument("the cells after the cut have another number of vertices");
    std::optional<topology::Rejection> rejection;
    {
      const py::gil_scoped_release others_may_run;
      rejection =
          topology::certify<d.value>(rows<Cell>(before), rows<HalfFacetId>(cut), rows<Cell>(after));
    }
    if (!rejection) return py::none();
    return py::make_tuple(static_cast<int>(rejection->clause), rejection->one.value,
                          rejection->other.value, topology::describe(*rejection));
  });
}

py::array locate(const Numbers& cells, const Numbers& facets) {
  return with_dimension(cells, [&](auto d) {
    using Cell = topology::Cell<d.value>;
    using Facet = topology::Facet<d.value>;
    if (facets.ndim() != 2 || facets.shape(1) != d.value)
      throw std::invalid_argument("a facet of these cells has " + std::to_string(d.value) +
                                  " vertices");
    py::array_t<std::int64_t> found(facets.shape(0));
    auto out = found.mutable_unchecked<1>();
    py::ssize_t i = 0;
    for (const auto& h : topology::locate_facets<d.value>(rows<Cell>(cells), rows<Facet>(facets)))
      out(i++) = h ? std::int64_t{h->value} : -1;
    return py::array(found);
  });
}

}  // namespace
}  // namespace cleave::python

PYBIND11_MODULE(_core, module) {
  using namespace cleave::python;
  translate_exceptions(py::module_::import("cleave.errors"));
  module.def("check", &check);
  module.def("orient", &orient);
  module.def("summarize", &summarize);
  module.def("certify", &certify);
  module.def("locate", &locate);
  bind_incisions(module);
}
