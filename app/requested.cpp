#include "requested.hpp"

#include <algorithm>
#include <string_view>

#include "cut_request.hpp"

namespace cleave::app {

using topology::HalfFacetId;

namespace {

bool has_facet_group(const Mesh& mesh, const std::string& name) {
  return std::any_of(mesh.groups.begin(), mesh.groups.end(), [&](const Group& group) {
    return group.dimension == mesh.dimension - 1 && group.name == name;
  });
}

}  // namespace

bool made_by_cut(const CutSource& source, const std::string& name) {
  return source.restored && !has_facet_group(*source.restored, name) &&
         has_facet_group(source.mesh, name);
}

template <int D>
std::vector<HalfFacetId> facets_in(const CutSource& source, const std::string& file) {
  return locate<D>(source.mesh, read_facets(file, source.mesh),
                   file == "-" ? "standard input" : file);
}

template <int D>
std::vector<HalfFacetId> facets_of_group(const CutSource& source, const std::string& name) {
  const Mesh& mesh = has_facet_group(source.original(), name) ? source.original() : source.mesh;
  return locate<D>(mesh, vertices_of(mesh, facet_group(mesh, name)), "group \"" + name + "\"");
}

template <int D>
std::string sheet_name(const CutState<D>& state, const std::string& name) {
  if (state.groups.count(name) != 0) return name;
  for (const std::string_view side : {"_minus", "_plus", "_shut"}) {
    if (name.size() <= side.size() || name.substr(name.size() - side.size()) != side) continue;
    std::string sheet = name.substr(0, name.size() - side.size());
    if (sheet == "cut" || state.groups.count(sheet) != 0) return sheet;
  }
  return name;
}

#define CLEAVE_INSTANTIATE(D)                                                                 \
  template std::vector<HalfFacetId> facets_in<D>(const CutSource&, const std::string&);       \
  template std::vector<HalfFacetId> facets_of_group<D>(const CutSource&, const std::string&); \
  template std::string sheet_name<D>(const CutState<D>&, const std::string&);
CLEAVE_INSTANTIATE(1)
CLEAVE_INSTANTIATE(2)
CLEAVE_INSTANTIATE(3)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::app
