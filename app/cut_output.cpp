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
#include "periodic_pairs.hpp"

namespace cleave::app {

using topology::Incision;
using topology::VertexId;

Numbering numbering_of(const std::filesystem::path& path) {
  const MeshFormat format = format_of(path);
  if (format == MeshFormat::kMedit || format == MeshFormat::kTetgen) return Numbering::from_one;
  const bool kept = format == MeshFormat::kGmsh || format == MeshFormat::kAbaqus;
  return kept ? Numbering::kept : Numbering::from_zero;
}

namespace {

// The vertices of the complex that cells use, in canonical order.
template <int D>
std::vector<VertexId> used_in_order(const Incision<D>& incision) {
  const auto number = topology::canonical(incision);
  std::vector<VertexId> order(number.size(), {kNoPlace});
  for (Index v = 0; v < number.size(); ++v)
    if (number[v].value != kNoPlace && incision.complex().a_corner({v}))
      order[number[v].value] = {v};
  order.erase(std::remove(order.begin(), order.end(), VertexId{kNoPlace}), order.end());
  return order;
}

// The numbers of the output's points: those of the file and, for copies, the ones after the
// largest; or by place. The first `originals` points are no copies.
void number_points(const Mesh& mesh, Numbering numbering, std::size_t originals,
                   CutOutput& output) {
  const auto& file = mesh.vertex_numbers;
  const bool zero_taken = std::find(file.begin(), file.end(), 0) != file.end();
  if (numbering == Numbering::kept && zero_taken) numbering = Numbering::from_one;
  const std::uint64_t largest = file.empty() ? 0 : *std::max_element(file.begin(), file.end());
  std::uint64_t next = largest;
  for (std::uint64_t i = 0; i < output.origin.size(); ++i) {
    std::uint64_t& number = output.mesh.vertex_numbers.emplace_back(i);
    if (numbering == Numbering::from_one) number = i + 1;
    if (numbering != Numbering::kept) continue;
    if (i >= originals && next == std::numeric_limits<std::uint64_t>::max())
      throw InputError(mesh.source +
                       ": its largest vertex number leaves none for copies; "
                       "renumber the vertices");
    number = i < originals ? file[output.origin[i]] : ++next;
  }
}

void warn_of_dropped(const Mesh& mesh, const std::vector<bool>& in_use, Numbering numbering,
                     CutOutput& output) {
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

// Lists the points of the output: the file's vertices and nodes in use, then the copies of
// vertices, then, from the place returned on, there is room for copies of nodes. Fills vertex_at
// and origin, and the places of vertices and of nodes.
template <int D>
Index list_points(const Body<D>& body, const Incision<D>& incision, Numbering numbering,
                  Renaming<D>& renaming, std::vector<Index>& place_of_node, std::size_t& originals,
                  CutOutput& output) {
  const Mesh& mesh = *body.mesh;
  const auto used = used_in_order(incision);
  std::vector<bool> in_use(mesh.points.size());
  for (const VertexId v : used)
    if (v.value < in_use.size()) in_use[v.value] = true;
  const std::vector<bool> node = nodes_in_use(mesh, in_use);

  const auto add = [&](VertexId vertex, Index origin) {
    output.vertex_at.push_back(vertex);
    output.origin.push_back(origin);
  };
  place_of_node.assign(mesh.points.size(), kNoPlace);
  for (Index place = 0; place < mesh.points.size(); ++place) {
    if (!in_use[place] && !node[place]) continue;
    if (node[place]) place_of_node[place] = static_cast<Index>(output.origin.size());
    add(in_use[place] ? VertexId{place} : kNoVertex, place);
    in_use[place] = true;
  }
  originals = output.origin.size();
  for (const VertexId v : used)
    if (v.value >= mesh.points.size()) add(v, body.place(incision.original(v)));
  for (Index place = 0; place < output.vertex_at.size(); ++place)
    if (output.vertex_at[place] != kNoVertex)
      renaming.place_of[output.vertex_at[place].value] = place;
  warn_of_dropped(mesh, in_use, numbering, output);
  return static_cast<Index>(output.origin.size());
}

// The cells on the places of the output.
template <int D>
void carry_cells(const Renaming<D>& renaming, const NodeImages<D>& nodes, CutOutput& output) {
  Elements& cells = output.mesh.elements[static_cast<std::size_t>(D)];
  cells = renaming.body->mesh->cells();
  auto vertex = cells.vertices.begin();
  for (const auto& cell : renaming.after->cells())
    for (const VertexId v : cell) *vertex++ = renaming.place_of[v.value];
  if (!cells.second_order()) return;
  auto node = cells.midside.begin();
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const Index* now = &cells.vertices[static_cast<std::size_t>(D + 1) * c];
    for (int i = 0; i <= D; ++i)
      for (int j = i + 1; j <= D; ++j, ++node) *node = nodes.on_edge(*node, now[i], now[j]);
  }
}

template <int D>
void carry_fields(const Body<D>& body, const Incision<D>& incision, Numbering numbering,
                  CutOutput& output) {
  const Mesh& mesh = *body.mesh;
  output.mesh.point_fields = take(mesh.point_fields, output.origin, kNoPlace);
  output.mesh.cell_fields = mesh.cell_fields;
  if (numbering != Numbering::from_zero) return;
  Field parent{"parent", 1, {}, true};
  for (const Index place : output.origin)
    parent.values.push_back(static_cast<double>(mesh.vertex_numbers[place]));
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

  Renaming<D> renaming{&body, &incision.complex(),
                       std::vector<Index>(incision.complex().vertex_count(), kNoPlace)};
  std::vector<Index> place_of_node;
  std::size_t originals = 0;
  const Index first_node_copy =
      list_points(body, incision, numbering, renaming, place_of_node, originals, output);
  std::array<Images, 3> images;
  for (int k = 0; k < D; ++k)
    images[static_cast<std::size_t>(k)] =
        images_of(renaming, k, mesh.elements[static_cast<std::size_t>(k)]);
  NodeImages<D> nodes(renaming, images, std::move(place_of_node), first_node_copy);
  for (const Index node : nodes.parents()) {
    output.vertex_at.push_back(kNoVertex);
    output.origin.push_back(node);
  }
  number_points(mesh, numbering, originals, output);
  output.number_of.assign(renaming.place_of.size(), 0);
  for (Index place = 0; place < output.origin.size(); ++place) {
    output.mesh.points.push_back(mesh.points[output.origin[place]]);
    if (output.vertex_at[place] != kNoVertex)
      output.number_of[output.vertex_at[place].value] = output.mesh.vertex_numbers[place];
  }

  carry_cells(renaming, nodes, output);
  carry_elements(renaming, {std::move(images), std::move(nodes)}, incision, asked, output);
  carry_fields(body, incision, numbering, output);
  carry_periodic(body, incision, output);
  return output;
}

template CutOutput cut_output<1>(const Body<1>&, const Incision<1>&,
                                 const std::vector<NamedFacets>&, Numbering);
template CutOutput cut_output<2>(const Body<2>&, const Incision<2>&,
                                 const std::vector<NamedFacets>&, Numbering);
template CutOutput cut_output<3>(const Body<3>&, const Incision<3>&,
                                 const std::vector<NamedFacets>&, Numbering);

}  // namespace cleave::app
