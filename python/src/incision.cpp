#include "incision.hpp"

#include <pybind11/stl.h>

#include <utility>

#include "arrays.hpp"
#include "cleave/topology/assemble.hpp"
#include "cleave/topology/explain.hpp"
#include "cleave/topology/incision.hpp"
#include "cleave/topology/pieces.hpp"
#include "signs.hpp"

namespace cleave::python {
namespace {

using topology::FacetSet;
using topology::HalfFacetId;
using topology::Incision;
using topology::Relabelling;
using topology::VertexId;

py::dict to_python(const Relabelling& change) {
  py::dict result;
  result["vertices_before"] = change.vertices_before;
  result["vertices_after"] = change.vertices_after;
  result["corners"] = copy_of(change.corners);
  result["splits"] = copy_of(change.splits);
  result["merges"] = copy_of(change.merges);
  result["opened"] = copy_of(change.opened);
  result["closed"] = copy_of(change.closed);
  result["shut"] = copy_of(change.shut);
  return result;
}

topology::Verify verify_of(const std::string& name) {
  if (name == "none") return topology::Verify::none;
  if (name == "touched") return topology::Verify::touched;
  if (name == "all") return topology::Verify::all;
  throw std::invalid_argument("verify is 'none', 'touched' or 'all', not '" + name + "'");
}

template <int D>
FacetSet facets_of(const Incision<D>& incision, const Numbers& half_facets) {
  return incision.facets(rows<HalfFacetId>(half_facets));
}

template <int D>
py::list explain(const Incision<D>& incision, std::uint32_t half_facet) {
  if (half_facet >= incision.complex().half_facet_count())
    throw topology::NotInterior(HalfFacetId{half_facet});
  py::list chains;
  for (const auto& because :
       topology::explain(incision.complex(), incision.shut(), HalfFacetId{half_facet})) {
    py::list through;
    for (const auto cell : because.through) through.append(cell.value);
    chains.append(py::make_tuple(incision.original(because.vertex).value, through));
  }
  return chains;
}

template <int D>
py::array originals(const Incision<D>& incision) {
  std::vector<VertexId> originals(incision.complex().vertex_count());
  for (std::uint32_t v = 0; v < originals.size(); ++v)
    originals[v] = incision.original(VertexId{v});
  return copy_of(originals);
}

template <int D>
void bind(py::module_& module, const char* name) {
  using I = Incision<D>;
  py::class_<I>(module, name)
      .def_property_readonly("cells",
                             [](const py::object& self) {
                               const auto& k = self.cast<const I&>().complex();
                               return view_of(k.cells().data(), k.cell_count(), D + 1, self);
                             })
      .def_property_readonly("vertex_count", [](const I& i) { return i.complex().vertex_count(); })
      .def_property_readonly("original_vertex_count", &I::original_vertex_count)
      .def_property_readonly("opened", [](const I& i) { return copy_of(i.opened()); })
      .def_property_readonly("shut",
                             [](const I& i) { return copy_of(FacetSet(i.shut()).half_facets()); })
      .def_property_readonly("scored", [](const I& i) { return copy_of(i.scored().half_facets()); })
      .def_property_readonly("can_undo", &I::can_undo)
      .def_property_readonly("can_redo", &I::can_redo)
      .def("originals", &originals<D>)
      .def("canonical", [](const I& i) { return copy_of(canonical(i)); })
      .def("pieces", [](const I& i) { return copy_of(topology::pieces(i.complex()).of_cell); })
      .def("explain", &explain<D>)
      .def("cut",
           [](I& i, const Numbers& half_facets, const std::string& verify) {
             return to_python(i.cut(facets_of(i, half_facets), verify_of(verify)));
           })
      .def("stitch",
           [](I& i, const Numbers& half_facets, const std::string& verify) {
             return to_python(i.stitch(facets_of(i, half_facets), verify_of(verify)));
           })
      .def("undo", [](I& i) { return to_python(i.undo()); })
      .def("redo", [](I& i) { return to_python(i.redo()); });
}

template <int D>
py::tuple make(const Numbers& cells, std::size_t vertex_count, const Signs& signs,
               bool regularize) {
  const auto given = rows<topology::Cell<D>>(cells);
  const auto sign = signs_of(signs);
  topology::CellSoup<D> soup{
      {given.begin(), given.end()}, vertex_count, {sign.begin(), sign.end()}};
  if (!regularize)
    return py::make_tuple(Incision<D>(topology::assemble(std::move(soup))),
                          copy_of(std::vector<topology::Split>{}));
  auto regularized = topology::assemble_regularized(std::move(soup));
  return py::make_tuple(Incision<D>(std::move(regularized.complex)), copy_of(regularized.splits));
}

}  // namespace

void bind_incisions(py::module_& module) {
  bind<1>(module, "Incision1");
  bind<2>(module, "Incision2");
  bind<3>(module, "Incision3");
  bind<4>(module, "Incision4");
  module.def("make_incision", [](const Numbers& cells, std::size_t vertex_count, const Signs& signs,
                                 bool regularize) {
    return with_dimension(
        cells, [&](auto d) { return make<d.value>(cells, vertex_count, signs, regularize); });
  });
}

}  // namespace cleave::python
