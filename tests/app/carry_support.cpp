#include "carry_support.hpp"

#include <algorithm>
#include <map>

namespace cleave::app::test {

using support::Rng;
using topology::HalfFacetId;

template <int D>
Mesh mesh_of(const support::Mesh<D>& cells, Rng& rng) {
  Mesh mesh;
  mesh.source = "test";
  mesh.dimension = D;
  for (std::size_t v = 0; v < cells.vertex_count; ++v) {
    mesh.points.push_back({rng.unit(), D > 1 ? rng.unit() : 0, D > 2 ? rng.unit() : 0});
    mesh.vertex_numbers.push_back(10 + 3 * v);
  }
  auto& elements = mesh.elements[static_cast<std::size_t>(D)];
  for (const auto& cell : cells.cells) {
    for (const auto v : cell) elements.vertices.push_back(v.value);
    elements.numbers.push_back(elements.numbers.size() + 1);
  }
  return mesh;
}

template <int D>
Mesh grid_mesh(const support::KuhnGrid<D>& grid, Rng& rng) {
  auto cells = static_cast<const support::Mesh<D>&>(grid);
  for (auto& cell : cells.cells) rng.shuffle(cell);
  Mesh mesh = mesh_of(cells, rng);
  for (Index v = 0; v < mesh.points.size(); ++v) {
    const auto p = grid.point({v});
    mesh.points[v] = {};
    std::copy(p.begin(), p.end(), mesh.points[v].begin());
  }
  return mesh;
}

template <int D>
void add_facets(Mesh& mesh, const std::string& name, const std::vector<HalfFacetId>& facets,
                Rng& rng) {
  Elements& elements = mesh.elements[static_cast<std::size_t>(D - 1)];
  Group group{name, D - 1, static_cast<std::int32_t>(mesh.groups.size() + 1), {}};
  const std::uint64_t number = 1000 + elements.size();
  for (const HalfFacetId h : facets) {
    const Index* cell =
        &mesh.cells().vertices[static_cast<std::size_t>(D + 1) * topology::cell_of<D>(h).value];
    std::vector<Index> tuple;
    for (int i = 0; i <= D; ++i)
      if (i != topology::local_index<D>(h)) tuple.push_back(cell[i]);
    rng.shuffle(tuple);
    group.elements.push_back(static_cast<Index>(elements.size()));
    elements.vertices.insert(elements.vertices.end(), tuple.begin(), tuple.end());
    elements.numbers.push_back(number + group.elements.size());
  }
  mesh.groups.push_back(group);
}

void add_nodes(Mesh& mesh, Rng& rng) {
  std::map<std::pair<Index, Index>, Index> node_on;
  for (int k = mesh.dimension; k >= 1; --k) {
    Elements& elements = mesh.elements[static_cast<std::size_t>(k)];
    const auto corners = static_cast<std::size_t>(k) + 1;
    for (std::size_t e = 0; e < elements.size(); ++e)
      for (std::size_t i = 0; i < corners; ++i)
        for (std::size_t j = i + 1; j < corners; ++j) {
          const auto a = elements.vertices[corners * e + i], b = elements.vertices[corners * e + j];
          const auto [at, is_new] =
              node_on.emplace(std::minmax(a, b), static_cast<Index>(mesh.points.size()));
          if (is_new) {
            auto middle = mesh.points[a];
            for (std::size_t x = 0; x < 3; ++x) middle[x] = (middle[x] + mesh.points[b][x]) / 2;
            mesh.points.push_back(middle);
            mesh.vertex_numbers.push_back(mesh.vertex_numbers.back() + 2);
          }
          elements.midside.push_back(at->second);
        }
  }
  std::vector<Index> place(mesh.points.size());
  for (Index p = 0; p < place.size(); ++p) place[p] = p;
  rng.shuffle(place);
  const auto points = mesh.points;
  for (Index p = 0; p < place.size(); ++p) mesh.points[place[p]] = points[p];
  for (Elements& elements : mesh.elements) {
    for (Index& v : elements.vertices) v = place[v];
    for (Index& n : elements.midside) n = place[n];
  }
  for (Periodicity& p : mesh.periodic)
    for (auto& pair : p.pairs) pair = {place[pair.vertex], place[pair.master]};
}

void add_places(Mesh& mesh) {
  Field& field = mesh.point_fields.emplace_back(Field{"place", 1, {}, true});
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
    field.values.push_back(static_cast<double>(p));
}

template <int D>
NamedFacets along(const Body<D>& body, const std::string& name) {
  const Group& group = facet_group(*body.mesh, name);
  return {name, locate(body, vertices_of(*body.mesh, group), name), &group};
}

template <int D>
CutMesh<D> cut(const Mesh& mesh, const std::vector<std::string>& groups,
               const std::vector<HalfFacetId>& others, Numbering numbering) {
  Body<D> body = make_body<D>(mesh);
  topology::Incision<D> incision(body.complex);
  std::vector<NamedFacets> asked;
  for (const std::string& name : groups) asked.push_back(along(body, name));
  if (!others.empty()) asked.push_back({"cut", others, nullptr});
  std::vector<HalfFacetId> facets;
  for (const NamedFacets& named : asked)
    facets.insert(facets.end(), named.facets.begin(), named.facets.end());
  incision.cut(sort_out(body.complex, std::span<const HalfFacetId>(facets)).interior);
  CutOutput output = cut_output(body, incision, asked, numbering);
  return {std::move(body), std::move(incision), std::move(output)};
}

Group group(const Mesh& mesh, const std::string& name) {
  for (const Group& g : mesh.groups)
    if (g.name == name) return g;
  return {};
}

#define CLEAVE_INSTANTIATE(D)                                                                    \
  template Mesh mesh_of<D>(const support::Mesh<D>&, Rng&);                                       \
  template Mesh grid_mesh<D>(const support::KuhnGrid<D>&, Rng&);                                 \
  template void add_facets<D>(Mesh&, const std::string&, const std::vector<HalfFacetId>&, Rng&); \
  template NamedFacets along<D>(const Body<D>&, const std::string&);                             \
  template CutMesh<D> cut<D>(const Mesh&, const std::vector<std::string>&,                       \
                             const std::vector<HalfFacetId>&, Numbering);
CLEAVE_INSTANTIATE(1)
CLEAVE_INSTANTIATE(2)
CLEAVE_INSTANTIATE(3)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::app::test
