#include "cut_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cleave/topology/certify.hpp"
#include "cohesive.hpp"
#include "error.hpp"
#include "file_numbers.hpp"
#include "offset.hpp"

namespace cleave::app {

using topology::CornerId;
using topology::FacetSet;
using topology::HalfFacetId;
using topology::VertexId;

template <int D>
CutState<D>::CutState(const Mesh& original, const HowFar& how_far)
    : body(make_body<D>(original, how_far)), incision(body.complex) {}

template <int D>
void CutState<D>::name(const std::string& group) {
  if (groups.count(group) != 0) return;
  const Mesh& mesh = *body.mesh;
  groups[group] =
      locate<D>(mesh, vertices_of(mesh, facet_group(mesh, group)), "group \"" + group + "\"");
}

namespace {

// Those of `facets`, half-facets of a body at rest, that are in `scored`.
template <int D>
FacetSet scored_among(const topology::Complex<D>& k, const FacetSet& scored,
                      const std::vector<HalfFacetId>& facets) {
  return sort_out(k, std::span<const HalfFacetId>(facets)).interior & scored;
}

}  // namespace

template <int D>
std::vector<NamedFacets> CutState<D>::asked() const {
  const FacetSet scored = incision.scored();
  std::vector<NamedFacets> asked;
  for (const auto& [name, facets] : groups)
    if (!scored_among(body.complex, scored, facets).empty())
      asked.push_back({name, facets, &facet_group(*body.mesh, name)});
  if (!others.empty())
    asked.push_back({"cut", {others.half_facets().begin(), others.half_facets().end()}, nullptr});
  return asked;
}

template <int D>
FacetSet CutState<D>::only_in(const std::set<std::string>& leaving) const {
  const FacetSet scored = incision.scored();
  FacetSet staying = leaving.count("cut") != 0 ? FacetSet() : others;
  for (const auto& [name, facets] : groups)
    if (leaving.count(name) == 0) staying = staying | scored_among(body.complex, scored, facets);
  return scored - staying;
}

template <int D>
void resume(CutState<D>& state, const CutSource& source) {
  if (!source.record) return;
  const IncisionRecord& record = *source.record;
  const topology::Complex<D>& k = state.body.complex;
  state.cohesive = record.cohesive;
  state.offset = record.offset;
  const auto refuse = [&](const std::string& what) {
    throw InputError(fmt::format(
        "{}: this record does not fit {}: {}; restore both files, or give --forget (or remove the "
        "record) to start anew from the mesh as it is",
        record_path(source.mesh.source).string(), source.mesh.source, what));
  };
  std::vector<HalfFacetId> scored;
  for (const auto* sides : {&record.opened, &record.shut})
    for (const auto& [lesser, mate] : *sides) {
      const HalfFacetId h{lesser};
      if (lesser >= k.half_facet_count() || k.mate(h) != HalfFacetId{mate})
        refuse(fmt::format("half-facets {} and {} are no mates", lesser, mate));
      scored.push_back(h);
    }
  const FacetSet all = FacetSet::of_lesser(std::move(scored));
  state.incision.cut(all);
  for (const std::string& name : record.groups) state.name(name);
  std::vector<HalfFacetId> others;
  for (const Index h : record.others) others.push_back({h});
  state.others = FacetSet::of_lesser(std::move(others));
  FacetSet named = state.others;
  for (const auto& [name, facets] : state.groups) named = named | scored_among(k, all, facets);
  if (state.incision.shut().size() != record.shut.size() || named != all)
    refuse("the facets that are scored are not those that it names");

  const CutOutput output =
      cut_output(state.body, state.incision, state.asked(), numbering_of(source.mesh.source));
  if (output.mesh.cells().vertices != source.mesh.cells().vertices ||
      output.mesh.vertex_numbers != source.mesh.vertex_numbers)
    refuse("its facets, cut, do not make this mesh");
}

template <int D>
CutOutput output_of(const CutState<D>& state, Numbering numbering) {
  CutOutput output = cut_output(state.body, state.incision, state.asked(), numbering);
  if constexpr (D >= 2)
    if (state.cohesive) add_cohesive(state.body, output);
  if (state.offset > 0) move_sides(state.body, state.incision, state.offset, output);
  return output;
}

template <int D>
void certify(const CutState<D>& state, const Mesh& out) {
  const auto before = soup_of<D>(*state.body.mesh), after = soup_of<D>(out);
  const FacetSet scored = state.incision.scored();
  const auto rejection = topology::certify<D>(before.cells, scored.half_facets(), after.cells);
  if (rejection) throw topology::InvariantBroken("not certified: " + describe(*rejection));
}

namespace {

// The `numbers` of these vertices, as a certificate holds them.
std::vector<std::uint32_t> numbered(const std::vector<Index>& vertices,
                                    const std::vector<std::uint64_t>& numbers,
                                    const std::string& source) {
  std::vector<std::uint32_t> result;
  result.reserve(vertices.size());
  for (const Index v : vertices) {
    if (numbers[v] > Certificate::kGreatest)
      throw InputError(
          fmt::format("{}: there is a vertex number {}, and a certificate holds numbers up to {} "
                      "only; renumber the vertices, or leave out --certificate",
                      source, numbers[v], Certificate::kGreatest));
    result.push_back(static_cast<std::uint32_t>(numbers[v]));
  }
  return result;
}

}  // namespace

template <int D>
Certificate certificate_of(const CutState<D>& state, const Mesh& out,
                           const std::filesystem::path& path) {
  const Mesh& original = *state.body.mesh;
  std::vector<Index> facets;
  for (const HalfFacetId h : state.incision.scored().half_facets())
    for (int i = 0; i <= D; ++i) {
      const CornerId corner = topology::half_facet<D>(topology::cell_of<D>(h), i);
      if (corner != h) facets.push_back(original.cells().vertices[corner.value]);
    }
  Certificate certificate;
  certificate.dimension = D;
  certificate.before =
      numbered(original.cells().vertices, original.vertex_numbers, original.source);
  certificate.cut = numbered(facets, original.vertex_numbers, original.source);
  certificate.after =
      numbered(out.cells().vertices, numbers_in(out, format_of(path), {}).vertices, path.string());
  return certificate;
}

template <int D>
IncisionRecord record_of(const CutState<D>& state, const CutOutput& output,
                         const std::filesystem::path& path) {
  IncisionRecord record;
  record.dimension = D;
  record.cells = state.body.complex.cell_count();
  record.original =
      describe_original(*state.body.mesh, output.mesh, output.origin, held_by(path, output.mesh));
  for (const auto& facet : state.incision.opened())
    record.opened.emplace_back(facet.half_facet.value, facet.former_mate.value);
  for (const HalfFacetId h : state.incision.shut().half_facets())
    record.shut.emplace_back(h.value, state.body.complex.mate(h)->value);
  for (const NamedFacets& named : state.asked())
    if (named.group != nullptr) record.groups.push_back(named.name);
  for (const HalfFacetId h : state.others.half_facets()) record.others.push_back(h.value);
  record.cohesive = state.cohesive;
  record.offset = state.offset;
  return record;
}

template <int D>
std::uint64_t Shown<D>::corner(CornerId corner) const {
  return mesh_.vertex_numbers[mesh_.cells().vertices[corner.value]];
}

template <int D>
std::uint64_t Shown<D>::vertex(HalfFacetId h, VertexId vertex) const {
  const auto cell = topology::cell_of<D>(h);
  const auto& tuple = body_.complex.vertices(cell);
  const auto i = std::find(tuple.begin(), tuple.end(), vertex) - tuple.begin();
  return corner(topology::half_facet<D>(cell, static_cast<int>(i)));
}

template <int D>
std::vector<std::uint64_t> Shown<D>::by_place() const {
  const auto& places = body_.mesh->cells().vertices;
  std::vector<std::uint64_t> numbers(body_.mesh->points.size());
  std::vector<bool> known(numbers.size());
  for (Index c = 0; c < places.size(); ++c) {
    if (known[places[c]]) continue;
    known[places[c]] = true;
    numbers[places[c]] = corner({c});
  }
  return numbers;
}

#define CLEAVE_INSTANTIATE(D)                                                \
  template struct CutState<D>;                                               \
  template void resume<D>(CutState<D>&, const CutSource&);                   \
  template CutOutput output_of<D>(const CutState<D>&, Numbering);            \
  template void certify<D>(const CutState<D>&, const Mesh&);                 \
  template Certificate certificate_of<D>(const CutState<D>&, const Mesh&,    \
                                         const std::filesystem::path&);      \
  template IncisionRecord record_of<D>(const CutState<D>&, const CutOutput&, \
                                       const std::filesystem::path&);        \
  template class Shown<D>;
CLEAVE_INSTANTIATE(1)
CLEAVE_INSTANTIATE(2)
CLEAVE_INSTANTIATE(3)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::app
