#include "run_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "cleave/topology/check.hpp"

namespace cleave::app {
namespace {

std::string describe_flaw(const fem::BodyFlaw& flaw, const Mesh& mesh) {
  const auto cell = [&](topology::CellId c) { return mesh.cells().numbers[c.value]; };
  if (const auto* flat = std::get_if<fem::FlatCell>(&flaw))
    return fmt::format("cell {} is flat: its volume is zero", cell(flat->cell));
  if (const auto* inverted = std::get_if<fem::InvertedCell>(&flaw))
    return fmt::format("cell {} is turned inside out against its neighbours", cell(inverted->cell));
  if (const auto* point = std::get_if<fem::PointNotFinite>(&flaw))
    return fmt::format("a vertex of cell {} has a coordinate that is not finite",
                       cell(point->cell));
  return fem::describe(flaw);
}

std::vector<topology::PinchedSimplex> pinched_in(const topology::CellSoup<3>& soup) {
  std::vector<topology::PinchedSimplex> found;
  for (const auto& violation : topology::check(soup, topology::Level::edge_regular))
    if (const auto* pinched = std::get_if<topology::PinchedSimplex>(&violation))
      found.push_back(*pinched);
  return found;
}

}  // namespace

std::size_t used_vertices(const Mesh& mesh) {
  std::vector<bool> used(mesh.points.size(), false);
  for (const Index place : mesh.cells().vertices) used[place] = true;
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
}

std::size_t used_vertices(const topology::Complex<3>& k) {
  std::size_t count = 0;
  for (Index v = 0; v < k.vertex_count(); ++v)
    if (k.a_corner({v})) ++count;
  return count;
}

std::vector<PinchedEdge> pinched_edges(const Mesh& mesh) {
  const auto cell_number = [&](topology::CellId c) { return mesh.cells().numbers[c.value]; };
  std::vector<PinchedEdge> edges;
  for (const auto& pinched : pinched_in(soup_of<3>(mesh)))
    edges.push_back({{mesh.vertex_numbers[pinched.simplex[0].value],
                      mesh.vertex_numbers[pinched.simplex[1].value]},
                     cell_number(pinched.one_part),
                     cell_number(pinched.other_part)});
  return edges;
}

std::size_t count_pinched_edges(const topology::Complex<3>& k) {
  topology::CellSoup<3> soup;
  soup.cells.assign(k.cells().begin(), k.cells().end());
  soup.vertex_count = k.vertex_count();
  for (Index c = 0; c < k.cell_count(); ++c)
    soup.signs.push_back(static_cast<std::int8_t>(k.sign({c})));
  return pinched_in(soup).size();
}

std::vector<RegularizedVertex> regularized_vertices(const Body<3>& body) {
  std::vector<RegularizedVertex> list;
  std::uint64_t place = used_vertices(*body.mesh);
  for (const auto& split : body.regularized)
    list.push_back({place++, body.mesh->vertex_numbers[split.parent.value]});
  return list;
}

std::string describe_flaws(const fem::InvalidBody& invalid, const Mesh& mesh) {
  constexpr std::size_t kShown = 5;
  std::string text = mesh.source + ": cannot be solved on: ";
  for (std::size_t i = 0; i < std::min(kShown, invalid.flaws.size()); ++i)
    text += (i == 0 ? "" : "; ") + describe_flaw(invalid.flaws[i], mesh);
  if (invalid.flaws.size() > kShown)
    text += fmt::format("; and {} more", invalid.flaws.size() - kShown);
  return text + ". Mend the mesh first";
}

}  // namespace cleave::app
