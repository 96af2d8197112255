#include "cut_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "cleave/topology/pieces.hpp"
#include "error.hpp"
#include "facet_groups.hpp"
#include "file_words.hpp"
#include "mesh_fields.hpp"
#include "mesh_file.hpp"

namespace cleave::app {

using topology::Incision;
using topology::VertexId;

Numbering numbering_of(const std::filesystem::path& path) {
  const MeshFormat format = format_of(path);
  if (format == MeshFormat::kMedit) return Numbering::from_one;
  return format == MeshFormat::kGmsh ? Numbering::kept : Numbering::from_zero;
}

namespace {

// The vertices of the complex that cells use, in canonical order.
template <int D>
std::vector<VertexId> used_in_order(const Incision<D>& incision) {
  const auto number = topology::canonical(incision);
  std::vector<VertexId> order(number.size(), {kNoPlace});
  for (std::uint32_t v = 0; v < number.size(); ++v)
    if (number[v].value != kNoPlace && incision.complex().a_corner({v}))
      order[number[v].value] = {v};
  order.erase(std::remove(order.begin(), order.end(), VertexId{kNoPlace}), order.end());
  return order;
}

// The numbers of the output's vertices: those of the file and, for copies, the ones after the
// largest; or by place.
template <int D>
void number_vertices(const Body<D>& body, Numbering numbering, CutOutput& output) {
  const auto& file = body.mesh->vertex_numbers;
  const bool zero_taken = std::find(file.begin(), file.end(), 0) != file.end();
  if (numbering == Numbering::kept && zero_taken) numbering = Numbering::from_one;
  const std::uint64_t largest = file.empty() ? 0 : *std::max_element(file.begin(), file.end());
  std::uint64_t next = largest;
  for (std::uint64_t i = 0; i < output.vertex_at.size(); ++i) {
    const std::uint32_t vertex = output.vertex_at[i].value;
    std::uint64_t& number = output.mesh.vertex_numbers.emplace_back(i);
    if (numbering == Numbering::from_one) number = i + 1;
    if (numbering != Numbering::kept) continue;
    if (vertex >= file.size() && next == std::numeric_limits<std::uint64_t>::max())
      throw InputError(body.mesh->source +
                       ": its largest vertex number leaves none for copies; "
                       "renumber the vertices");
    number = vertex < file.size() ? file[vertex] : ++next;
  }
}

void warn_of_dropped(const Mesh& mesh, const std::vector<VertexId>& used, Numbering numbering,
                     CutOutput& output) {
  std::vector<bool> in_use(mesh.points.size());
  for (const VertexId v : used)
    if (v.value < in_use.size()) in_use[v.value] = true;
  const auto dropped = static_cast<std::size_t>(std::count(in_use.begin(), in_use.end(), false));
  if (dropped == 0) return;
  const auto first =
      static_cast<std::size_t>(std::find(in_use.begin(), in_use.end(), false) - in_use.begin());
  output.warnings.push_back(fmt::format(
      "{} dropped, being in no cell (the first is vertex {}){}",
      counted(dropped, "vertex is", "vertices are"), mesh.vertex_numbers[first],
      numbering == Numbering::kept ? ""
                                   : "; vertices behind it are renumbered, since this format "
                                     "numbers them by place"));
}

template <int D>
void carry_fields(const Body<D>& body, const Incision<D>& incision, Numbering numbering,
                  CutOutput& output) {
  const Mesh& mesh = *body.mesh;
  Field parent{"parent", 1, {}, true};
  for (const Field& field : mesh.point_fields) {
    Field& carried = output.mesh.point_fields.emplace_back(
        Field{field.name, field.components, {}, field.integer});
    const auto width = static_cast<std::size_t>(field.components);
    for (const VertexId v : output.vertex_at) {
      const auto from = field.values.begin() +
                        static_cast<std::ptrdiff_t>(width * body.place(incision.original(v)));
      carried.values.insert(carried.values.end(), from, from + field.components);
    }
  }
  output.mesh.cell_fields = mesh.cell_fields;
  if (numbering != Numbering::from_zero) return;
  for (const VertexId v : output.vertex_at)
    parent.values.push_back(static_cast<double>(body.number(incision.original(v))));
  set_field(output.mesh.point_fields, std::move(parent));
  const auto pieces = topology::pieces(incision.complex());
  set_field(output.mesh.cell_fields,
            {"piece", 1, {pieces.of_cell.begin(), pieces.of_cell.end()}, true});
}

}  // namespace

template <int D>
CutOutput cut_output(const Body<D>& body, const Incision<D>& incision,
                     const std::vector<NamedFacets>& asked, Numbering numbering) {
  const Mesh& mesh = *body.mesh;
  CutOutput output;
  output.mesh.source = mesh.source;
  output.mesh.dimension = mesh.dimension;
  output.mesh.two_dimensional_points = mesh.two_dimensional_points;
  output.mesh.msh_version = mesh.msh_version;
  output.mesh.msh_binary = mesh.msh_binary;
  output.vertex_at = used_in_order(incision);
  warn_of_dropped(mesh, output.vertex_at, numbering, output);
  number_vertices(body, numbering, output);

  Renaming<D> renaming{&body, &incision.complex(),
                       std::vector<std::uint32_t>(incision.complex().vertex_count(), kNoPlace)};
  output.number_of.assign(renaming.place_of.size(), 0);
  for (std::uint32_t place = 0; place < output.vertex_at.size(); ++place) {
    const VertexId v = output.vertex_at[place];
    renaming.place_of[v.value] = place;
    output.number_of[v.value] = output.mesh.vertex_numbers[place];
    output.origin.push_back(body.place(incision.original(v)));
    output.mesh.points.push_back(mesh.points[output.origin.back()]);
  }

  Elements& cells = output.mesh.elements[static_cast<std::size_t>(D)];
  cells = mesh.cells();
  auto vertex = cells.vertices.begin();
  for (const auto& cell : incision.complex().cells())
    for (const VertexId v : cell) *vertex++ = renaming.place_of[v.value];

  carry_elements(renaming, incision, asked, output);
  carry_fields(body, incision, numbering, output);
  return output;
}

template CutOutput cut_output<1>(const Body<1>&, const Incision<1>&,
                                 const std::vector<NamedFacets>&, Numbering);
template CutOutput cut_output<2>(const Body<2>&, const Incision<2>&,
                                 const std::vector<NamedFacets>&, Numbering);
template CutOutput cut_output<3>(const Body<3>&, const Incision<3>&,
                                 const std::vector<NamedFacets>&, Numbering);

}  // namespace cleave::app
