#include "facet_groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "cleave/topology/locate.hpp"
#include "edge_nodes.hpp"
#include "element_builder.hpp"
#include "mesh_fields.hpp"
#include "sides.hpp"

namespace cleave::app {

using topology::CellId;
using topology::FacetSet;
using topology::HalfFacetId;

namespace {

using Handle = ElementBuilder::Handle;

// The groups of one dimension of the output: those of the file first, then those that a cut adds.
class GroupTable {
 public:
  GroupTable(const Mesh& mesh, int dimension) : dimension_(dimension) {
    for (const Group& group : mesh.groups) {
      if (group.dimension != dimension) continue;
      groups.push_back(group);
      groups.back().elements.clear();
      tags_.insert(group.tag);
    }
  }

  // The place of the group with this name; a new one gets the tag after the largest, or the least
  // free one.
  std::size_t named(const std::string& name) {
    for (std::size_t i = 0; i < groups.size(); ++i)
      if (groups[i].name == name) return i;
    const std::int32_t largest = tags_.empty() ? 0 : std::max(0, *tags_.rbegin());
    std::int32_t tag = largest < std::numeric_limits<std::int32_t>::max() ? largest + 1 : 1;
    while (tags_.count(tag) != 0) ++tag;
    tags_.insert(tag);
    groups.push_back({name, dimension_, tag, {}});
    return groups.size() - 1;
  }

  std::vector<Group> groups;

 private:
  int dimension_;
  std::set<std::int32_t> tags_;
};

// What became of facets that were asked for.
template <int D>
class CutFacets {
 public:
  CutFacets(const Renaming<D>& renaming, const topology::Incision<D>& incision)
      : before_(renaming.body->complex), shut_(incision.shut()) {
    std::vector<HalfFacetId> opened;
    for (const auto& facet : incision.opened()) opened.push_back(facet.half_facet);
    opened_ = FacetSet::of_lesser(std::move(opened));
  }

  HalfFacetId lesser(HalfFacetId h) const { return std::min(h, before_.mate(h).value_or(h)); }
  bool opened(HalfFacetId h) const { return opened_.contains(lesser(h)); }
  bool shut(HalfFacetId h) const { return shut_.contains(lesser(h)); }
  bool scored(HalfFacetId h) const { return opened(h) || shut(h); }

 private:
  const topology::Complex<D>& before_;
  FacetSet opened_;
  const FacetSet& shut_;
};

// The half-facet of the facet of `h` whose outward orientation is that of `tuple`: its cell lies on
// the side that the normal of the tuple points away from.
template <int D>
HalfFacetId outward(const Body<D>& body, HalfFacetId h, std::span<const Index> tuple) {
  const CellId cell = topology::cell_of<D>(h);
  const Index* vertices =
      &body.mesh->cells().vertices[static_cast<std::size_t>(D + 1) * cell.value];
  std::array<std::ptrdiff_t, static_cast<std::size_t>(D)> order{};
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = std::find(vertices, vertices + D, tuple[i]) - vertices;
  int sign = body.complex.facet_sign(h);
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size(); ++j)
      if (order[j] < order[i]) sign = -sign;
  return sign > 0 ? h : *body.complex.mate(h);
}

// The places in the file of the vertices of half-facet `h`, in its outward orientation.
template <int D>
std::array<Index, static_cast<std::size_t>(D)> outward_tuple(const Body<D>& body, HalfFacetId h) {
  const auto facet = body.complex.facet(h);
  std::array<Index, static_cast<std::size_t>(D)> tuple{};
  for (std::size_t i = 0; i < tuple.size(); ++i) tuple[i] = body.place(facet[i]);
  if (D >= 2 && body.complex.facet_sign(h) < 0) std::swap(tuple[0], tuple[tuple.size() - 1]);
  return tuple;
}

// A facet to be put into the groups of one name.
template <int D>
struct Entry {
  HalfFacetId lesser;
  std::array<Index, static_cast<std::size_t>(D)> tuple;  // places in the file
  std::optional<Index> element;              // of the file, if the facet gives up its place there
  Index source = ElementBuilder::kNoSource;  // else: the element whose values it takes
};

template <int D>
class FacetCarrier {
 public:
  FacetCarrier(const Renaming<D>& renaming, const NodeImages<D>& nodes,
               const topology::Incision<D>& incision, const std::vector<NamedFacets>& asked,
               CutOutput& output)
      : renaming_(renaming),
        nodes_(nodes),
        body_(*renaming.body),
        mesh_(*body_.mesh),
        cut_(renaming, incision),
        output_(output),
        gives_way_(mesh_.facets().size()) {
    for (const NamedFacets& named : asked) asked_.push_back(&named);
    // The order of the file, not that of the request; names from elsewhere come last.
    std::stable_sort(asked_.begin(), asked_.end(), [](const auto* a, const auto* b) {
      if (a->group == nullptr || b->group == nullptr) return a->group != nullptr && !b->group;
      return std::less<>()(a->group, b->group);
    });
    const auto same = [](const auto* a, const auto* b) { return a->group && a->group == b->group; };
    asked_.erase(std::unique(asked_.begin(), asked_.end(), same), asked_.end());
    find_what_gives_way();
  }

  // Whether element `e` leaves its group altogether, to come back in others.
  bool gives_way(Index e) const { return gives_way_[e]; }

  // Whether element `e` of `group` stays in it.
  bool stays(const Group& group, Index e) const {
    const auto left = left_.find(&group);
    return left == left_.end() || !std::binary_search(left->second.begin(), left->second.end(), e);
  }

  void add_groups(ElementBuilder& builder, GroupTable& table) {
    std::vector<std::pair<HalfFacetId, const NamedFacets*>> sides;
    for (const NamedFacets* named : asked_) {
      const std::size_t minus = table.named(named->name + "_minus");
      const std::size_t plus = table.named(named->name + "_plus");
      const std::size_t shut = table.named(named->name + "_shut");
      const auto entries = entries_of(*named);
      if (!entries.empty()) warn_of_namesakes(named->name);
      const auto minus_of = choose(*named, entries);
      for (const HalfFacetId side : minus_of.minus) sides.emplace_back(side, named);
      const auto put = [&](const Entry<D>& entry, HalfFacetId seen_from, std::size_t group) {
        const CellId cell = topology::cell_of<D>(seen_from);
        auto vertices = entry.tuple;
        for (Index& place : vertices) place = renaming_.in_cell(cell, place);
        const auto midside = nodes_in(cell, entry.tuple);
        const ElementTuple tuple{vertices, midside};
        table.groups[group].elements.push_back(entry.element
                                                   ? builder.add_image(*entry.element, tuple)
                                                   : builder.add(tuple, entry.source));
      };
      for (const Entry<D>& entry : entries) {
        if (cut_.shut(entry.lesser)) {
          put(entry, entry.lesser, shut);
          continue;
        }
        const HalfFacetId side = minus_of.of(entry.lesser);
        put(entry, side, minus);
        put(entry, *body_.complex.mate(side), plus);
      }
    }
    list_sides(std::move(sides));
  }

 private:
  // The sides of every facet that opened, ascending; of several names the first counts.
  void list_sides(std::vector<std::pair<HalfFacetId, const NamedFacets*>> sides) {
    std::stable_sort(sides.begin(), sides.end(), [&](const auto& a, const auto& b) {
      return cut_.lesser(a.first) < cut_.lesser(b.first);
    });
    for (const auto& [minus, named] : sides) {
      const bool listed_already =
          !output_.sides.empty() && cut_.lesser(output_.sides.back().minus) == cut_.lesser(minus);
      if (!listed_already) output_.sides.push_back({minus, named->name});
    }
  }

  // The nodes of second order that `cell` has now on the edges between these file places.
  std::vector<Index> nodes_in(CellId cell, std::span<const Index> places) const {
    std::vector<Index> nodes;
    if (!nodes_.second_order()) return nodes;
    for (std::size_t i = 0; i < places.size(); ++i)
      for (std::size_t j = i + 1; j < places.size(); ++j)
        nodes.push_back(nodes_.in_cell(cell, places[i], places[j]));
    return nodes;
  }

  // The first element of the file on each facet (lesser half-facet), if there are fields on facets.
  std::map<HalfFacetId, Index> elements_on_facets() const {
    std::map<HalfFacetId, Index> first;
    if (mesh_.facet_fields.empty()) return first;
    std::vector<topology::Facet<D>> tuples(mesh_.facets().size());
    for (std::size_t i = 0; i < mesh_.facets().vertices.size(); ++i)
      tuples[i / D][i % D] = {mesh_.facets().vertices[i]};
    const auto soup = soup_of<D>(mesh_);
    const auto found = topology::locate_facets<D>(soup.cells, tuples);
    for (Index e = 0; e < found.size(); ++e)
      if (found[e]) first.emplace(cut_.lesser(*found[e]), e);
    return first;
  }

  // A group of the file may have the name of one that a cut adds, as after an earlier cut.
  void warn_of_namesakes(const std::string& name) {
    for (const Group& group : mesh_.groups)
      for (const char* side : {"_minus", "_plus", "_shut"})
        if (group.dimension == D - 1 && group.name == name + side && !group.elements.empty())
          output_.warnings.push_back(fmt::format(
              "there is a group {} already; what this cut makes of {} is put into it too",
              group.name, name));
  }

  void find_what_gives_way() {
    for (const NamedFacets* named : asked_) {
      if (named->group == nullptr) continue;
      auto& left = left_[named->group];
      for (std::size_t i = 0; i < named->facets.size(); ++i)
        if (cut_.scored(named->facets[i])) left.push_back(named->group->elements[i]);
      for (const Index e : left) gives_way_[e] = true;
    }
    for (const Group& group : mesh_.groups) {
      if (group.dimension != D - 1) continue;
      for (const Index e : group.elements)
        if (stays(group, e)) gives_way_[e] = false;
    }
  }

  // The scored facets of `named`: a file group's in the order of its elements, others ascending.
  std::vector<Entry<D>> entries_of(const NamedFacets& named) const {
    std::vector<Entry<D>> entries;
    if (named.group != nullptr) {
      const auto tuples = vertices_of(mesh_, *named.group);
      for (std::size_t i = 0; i < named.facets.size(); ++i) {
        if (!cut_.scored(named.facets[i])) continue;
        const Index e = named.group->elements[i];
        Entry<D> entry{cut_.lesser(named.facets[i]), {}, std::nullopt};
        std::copy_n(tuples.begin() + static_cast<std::ptrdiff_t>(D * i), D, entry.tuple.begin());
        entries.push_back(entry);
        if (gives_way_[e]) entries.back().element = e;
      }
      return entries;
    }
    std::vector<HalfFacetId> facets;
    for (const HalfFacetId h : named.facets)
      if (cut_.scored(h)) facets.push_back(cut_.lesser(h));
    const FacetSet distinct = FacetSet::of_lesser(std::move(facets));
    const auto elements = elements_on_facets();
    for (const HalfFacetId h : distinct.half_facets()) {
      entries.push_back({h, outward_tuple(body_, h), std::nullopt});
      const auto element = elements.find(h);
      if (element != elements.end()) entries.back().source = element->second;
    }
    return entries;
  }

  // Facets (lesser half-facets, ascending) and the minus side of each.
  struct MinusSides {
    std::vector<HalfFacetId> facets, minus;
    HalfFacetId of(HalfFacetId facet) const {
      const auto at = std::lower_bound(facets.begin(), facets.end(), facet);
      return minus[static_cast<std::size_t>(at - facets.begin())];
    }
  };

  // The minus sides of the opened facets among `entries`; notes sheets with one side.
  MinusSides choose(const NamedFacets& named, const std::vector<Entry<D>>& entries) {
    std::vector<std::pair<HalfFacetId, HalfFacetId>> preferred;
    for (const Entry<D>& entry : entries)
      if (cut_.opened(entry.lesser))
        preferred.emplace_back(entry.lesser, named.group != nullptr
                                                 ? outward(body_, entry.lesser, entry.tuple)
                                                 : entry.lesser);
    // Of several elements that store one facet, the first decides.
    const auto by_facet = [](const auto& a, const auto& b) { return a.first < b.first; };
    std::stable_sort(preferred.begin(), preferred.end(), by_facet);
    MinusSides sides;
    for (const auto& [facet, side] : preferred) {
      if (!sides.facets.empty() && sides.facets.back() == facet) continue;
      sides.facets.push_back(facet);
      sides.minus.push_back(side);
    }
    Sides chosen = choose_sides(body_.complex, std::span<const HalfFacetId>(sides.facets),
                                std::span<const HalfFacetId>(sides.minus));
    for (auto& loop : chosen.one_sided) output_.one_sided.push_back({named.name, std::move(loop)});
    sides.minus = std::move(chosen.minus);
    return sides;
  }

  const Renaming<D>& renaming_;
  const NodeImages<D>& nodes_;
  const Body<D>& body_;
  const Mesh& mesh_;
  CutFacets<D> cut_;
  CutOutput& output_;
  std::vector<const NamedFacets*> asked_;
  std::vector<bool> gives_way_;
  std::map<const Group*, std::vector<Index>> left_;  // elements that leave, ascending
};

// Words for an element of this dimension.
const char* plural(int dimension) {
  constexpr std::array<const char*, 3> kWords{"vertex elements", "edges", "triangles"};
  return kWords[static_cast<std::size_t>(dimension)];
}

// The images of vertex elements, some of which may be on nodes of second order.
template <int D>
Images with_nodes(const Images& on_vertices, const NodeImages<D>& nodes, const Elements& elements) {
  Images images;
  for (Index e = 0; e < elements.size(); ++e) {
    images.first.push_back(static_cast<Index>(images.vertices.size()));
    const auto first = on_vertices.vertices.begin() + on_vertices.first[e];
    const auto last = on_vertices.vertices.begin() + on_vertices.first[e + 1];
    images.vertices.insert(images.vertices.end(), first, last);
    if (first != last) continue;
    const auto places = nodes.places(elements.vertices[e]);
    images.vertices.insert(images.vertices.end(), places.begin(), places.end());
  }
  images.first.push_back(static_cast<Index>(images.vertices.size()));
  return images;
}

// The images of the elements of dimension `k`, each of which is put into `builder`, and into its
// groups. `facets` is given for the facets, where some of the groups are cut.
template <int D>
void carry(const Renaming<D>& renaming, const Carried<D>& carried, int k,
           const FacetCarrier<D>* facets, ElementBuilder& builder, GroupTable& table,
           CutOutput& output) {
  const Mesh& mesh = *renaming.body->mesh;
  const Elements& elements = mesh.elements[static_cast<std::size_t>(k)];
  const auto corners = static_cast<std::size_t>(k) + 1;
  const Images images = k == 0 && carried.nodes.second_order()
                            ? with_nodes(carried.elements[0], carried.nodes, elements)
                            : carried.elements[static_cast<std::size_t>(k)];
  const std::size_t edges = edges_of_simplex(static_cast<std::size_t>(k));
  std::vector<std::pair<Index, Handle>> further;  // element; its images but the first
  std::size_t gone = 0;
  for (Index e = 0; e < elements.size(); ++e) {
    if (images.first[e] == images.first[e + 1]) ++gone;
    if (facets != nullptr && facets->gives_way(e)) continue;
    for (Index i = images.first[e]; i < images.first[e + 1]; ++i) {
      const std::span vertices(&images.vertices[corners * i], corners);
      std::vector<Index> midside;
      if (elements.second_order())
        midside =
            carried.nodes.of_element(std::span(&elements.midside[edges * e], edges), vertices);
      const Handle handle = builder.add_image(e, {vertices, midside});
      if (i > images.first[e]) further.emplace_back(e, handle);
    }
  }
  if (gone > 0)
    output.warnings.push_back(
        fmt::format("{} of the {} {} dropped, naming a vertex that no cell uses", gone, plural(k),
                    gone == 1 ? "is" : "are"));

  for (const Group& group : mesh.groups) {
    if (group.dimension != k) continue;
    auto& members = table.groups[table.named(group.name)].elements;
    for (const Index e : group.elements) {
      if (images.first[e] == images.first[e + 1]) continue;
      if (facets != nullptr && !facets->stays(group, e)) continue;
      members.push_back(e);
      for (auto at = std::lower_bound(further.begin(), further.end(), std::pair{e, Handle{0}});
           at != further.end() && at->first == e; ++at)
        members.push_back(at->second);
    }
  }
}

}  // namespace

template <int D>
void carry_elements(const Renaming<D>& renaming, const Carried<D>& images,
                    const topology::Incision<D>& incision, const std::vector<NamedFacets>& asked,
                    CutOutput& output) {
  const Mesh& mesh = *renaming.body->mesh;
  std::uint64_t next_number = 1;
  for (const Elements& elements : mesh.elements)
    for (const std::uint64_t number : elements.numbers)
      next_number = std::max(next_number, number + 1);

  for (int k = 0; k < D; ++k) {
    const Elements& elements = mesh.elements[static_cast<std::size_t>(k)];
    ElementBuilder builder(elements, k, mesh.cells().second_order());
    GroupTable table(mesh, k);
    if (k < D - 1) {
      carry<D>(renaming, images, k, nullptr, builder, table, output);
    } else {
      FacetCarrier<D> facets(renaming, images.nodes, incision, asked, output);
      carry<D>(renaming, images, k, &facets, builder, table, output);
      facets.add_groups(builder, table);
    }
    auto built = builder.finish(next_number, table.groups);
    output.mesh.elements[static_cast<std::size_t>(k)] = std::move(built.elements);
    if (k == D - 1)
      output.mesh.facet_fields = take(mesh.facet_fields, built.source, ElementBuilder::kNoSource);
    for (Group& group : table.groups)
      if (!group.elements.empty()) output.mesh.groups.push_back(std::move(group));
  }
  for (const Group& group : mesh.groups)
    if (group.dimension == D) output.mesh.groups.push_back(group);
  std::stable_sort(output.mesh.groups.begin(), output.mesh.groups.end(),
                   [](const Group& a, const Group& b) {
                     return std::pair(a.dimension, a.tag) < std::pair(b.dimension, b.tag);
                   });
}

#define CLEAVE_INSTANTIATE(D)                                                                    \
  template void carry_elements<D>(const Renaming<D>&, const Carried<D>&,                         \
                                  const topology::Incision<D>&, const std::vector<NamedFacets>&, \
                                  CutOutput&);
CLEAVE_INSTANTIATE(1)
CLEAVE_INSTANTIATE(2)
CLEAVE_INSTANTIATE(3)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::app
