#include <algorithm>
#include <map>
#include <set>

#include "error.hpp"
#include "files/abaqus.hpp"
#include "files/abaqus_content.hpp"
#include "files/group_integers.hpp"
#include "files/group_sets.hpp"

namespace cleave::app {
namespace {

using Kind = AbaqusSet::Kind;
using Facet = std::array<Index, 3>;  // vertices, ascending; unused ones are 0

/// An element of any kind: dimension 1 to 3, or 4 for a cohesive one, and its place.
struct Found {
  std::size_t kind;
  Index place;
};

class SetResolver {
 public:
  SetResolver(AbaqusContent& content, const MshNodes& nodes)
      : content_(content), mesh_(content.mesh), nodes_(nodes) {
    std::vector<std::uint64_t> numbers;
    for (std::size_t d = 1; d <= 3; ++d) {
      starts_[d] = numbers.size();
      numbers.insert(numbers.end(), mesh_.elements[d].numbers.begin(),
                     mesh_.elements[d].numbers.end());
    }
    starts_[4] = numbers.size();
    numbers.insert(numbers.end(), mesh_.cohesive.numbers.begin(), mesh_.cohesive.numbers.end());
    elements_.index(numbers);
    next_number_ = *std::max_element(numbers.begin(), numbers.end()) + 1;
  }

  void resolve() {
    for (std::size_t s = 0; s < content_.sets.size(); ++s) {
      const AbaqusSet& set = content_.sets[s];
      if (set.internal) continue;
      if (set.kind == Kind::nodes) {
        for (const std::uint64_t v : places(set)) group(0, set).push_back(static_cast<Index>(v));
      } else if (set.kind == Kind::elements) {
        for (const std::uint64_t e : places(set)) add_element(set, found(e));
      } else {
        add_surface(set);
      }
    }
    make_vertex_elements();
    finish_groups();
  }

 private:
  std::vector<Index>& group(std::size_t dimension, const AbaqusSet& set) {
    auto& entry = groups_[dimension][set.name.key];
    if (entry.order == 0) {
      entry.order = ++groups_made_;
      entry.name = set.name.shown;
    }
    return entry.elements;
  }

  Found found(std::uint64_t index) const {
    std::size_t kind = 4;
    while (index < starts_[kind]) --kind;
    return {kind, static_cast<Index>(index - starts_[kind])};
  }

  /// The places (of vertices, or of elements in elements_) that a set lists, ascending.
  std::vector<std::uint64_t> places(const AbaqusSet& set) const {
    std::vector<std::uint64_t> all;
    std::vector<const AbaqusSet*> waiting{&set};
    std::set<const AbaqusSet*> entered{&set};
    while (!waiting.empty()) {
      const AbaqusSet& one = *waiting.back();
      waiting.pop_back();
      for (std::size_t i = 0; i < one.labels.size(); ++i) {
        if (one.labels[i].number != 0) {
          all.push_back(place(one, i));
        } else if (const AbaqusSet& other = named_set(one, i, one.kind);
                   entered.insert(&other).second) {
          waiting.push_back(&other);
        }
      }
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  const AbaqusSet& named_set(const AbaqusSet& set, std::size_t label, Kind kind) const {
    const std::string& key = set.words[set.labels[label].set];
    const AbaqusSet* found = content_.find(kind, key);
    if (found == nullptr)
      fail(set, label, "there is no set of this name: '" + printable(key, 40) + "'");
    return *found;
  }

  /// The place of the node or element that a label numbers.
  Index place(const AbaqusSet& set, std::size_t label) const {
    const bool is_node = set.kind == Kind::nodes;
    const Index number = set.labels[label].number;
    const Index place = (is_node ? nodes_ : elements_).find(number);
    if (place == MshNodes::kNone)
      fail(set, label,
           (is_node ? "there is no node " : "there is no element ") + std::to_string(number));
    return place;
  }

  [[noreturn]] static void fail(const AbaqusSet& set, std::size_t label, const std::string& what) {
    auto line = set.lines.end();
    while (std::prev(line)->first > label) --line;
    std::prev(line)->second.fail(what);
  }

  void add_element(const AbaqusSet& set, Found element) {
    if (element.kind < 4)
      group(element.kind, set).push_back(element.place);
    else if (mesh_.cohesive.names[element.place].empty())
      mesh_.cohesive.names[element.place] = set.name.shown;
  }

  void add_surface(const AbaqusSet& set) {
    const auto facet_dimension = static_cast<std::size_t>(mesh_.dimension - 1);
    for (std::size_t i = 0; i < set.labels.size(); ++i) {
      std::vector<std::uint64_t> elements;
      if (set.labels[i].number != 0)
        elements.push_back(place(set, i));
      else
        elements = places(named_set(set, i, Kind::elements));
      for (const std::uint64_t e : elements)
        group(facet_dimension, set).push_back(facet(set, i, found(e)));
    }
  }

  /// The place among the facets of the side of an element that a surface names.
  Index facet(const AbaqusSet& set, std::size_t label, Found element) {
    const std::string& side = set.words[set.labels[label].side];
    const auto d = static_cast<std::size_t>(mesh_.dimension);
    if (element.kind == d - 1 && (side == "SPOS" || side == "SNEG")) return element.place;
    const bool counted = side.size() == 2 && (side[0] == 'S' || (side[0] == 'E' && d == 2)) &&
                         side[1] >= '1' && side[1] <= static_cast<char>('1' + d);
    if (element.kind != d || d < 2 || !counted)
      fail(set, label, "there is no side '" + printable(side, 40) + "' of such an element");
    const auto* corners = &mesh_.elements[d].vertices[(d + 1) * element.place];
    Facet facet{};
    for (std::size_t k = 0; k < d; ++k) facet[k] = corners[kAbaqusSides[d][side[1] - '1'][k]];
    std::swap(facet[0], facet[1]);  // the normal points away from the element
    return find_or_add(facet);
  }

  Index find_or_add(const Facet& facet) {
    const auto d = static_cast<std::size_t>(mesh_.dimension);
    Elements& facets = mesh_.elements[d - 1];
    if (!facets_known_) {
      facets_known_ = true;
      for (Index f = 0; f < facets.size(); ++f) {
        Facet known{};
        std::copy_n(&facets.vertices[d * f], d, known.begin());
        facets_.emplace(sorted(known), f);
      }
    }
    const auto [at, is_new] = facets_.emplace(sorted(facet), static_cast<Index>(facets.size()));
    if (!is_new) return at->second;
    if (facets.second_order())
      throw InputError(mesh_.source +
                       ": a surface has a facet that is no element, beside facets of "
                       "second order; list it as an element too");
    facets.vertices.insert(facets.vertices.end(), facet.begin(),
                           facet.begin() + static_cast<std::ptrdiff_t>(d));
    facets.numbers.push_back(next_number_++);
    return at->second;
  }

  static Facet sorted(Facet facet) {
    std::sort(facet.begin(), facet.end());
    return facet;
  }

  /// Vertices of node sets become elements of dimension 0, ascending.
  void make_vertex_elements() {
    std::vector<std::int32_t> in_a_set(mesh_.points.size(), 0);
    for (const auto& [key, entry] : groups_[0])
      for (const Index v : entry.elements) in_a_set[v] = 1;
    mark_vertices(mesh_, in_a_set);
    const std::vector<Index>& marked = mesh_.elements[0].vertices;
    for (auto& [key, entry] : groups_[0])
      for (Index& v : entry.elements)
        v = static_cast<Index>(std::lower_bound(marked.begin(), marked.end(), v) - marked.begin());
  }

  void finish_groups() {
    for (int d = 0; d <= 3; ++d) {
      std::vector<Entry> entries;
      for (auto& [key, entry] : groups_[static_cast<std::size_t>(d)])
        entries.push_back(std::move(entry));
      std::sort(entries.begin(), entries.end(),
                [](const Entry& a, const Entry& b) { return a.order < b.order; });
      std::vector<Group> groups;
      for (Entry& entry : entries) {
        auto& elements = entry.elements;
        std::sort(elements.begin(), elements.end());
        elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
        groups.push_back({entry.name, d, tag_of_name(entry.name), std::move(elements)});
      }
      const auto tags = distinct_tags(groups, INT32_MIN);
      for (std::size_t g = 0; g < groups.size(); ++g) groups[g].tag = tags[g];
      std::sort(groups.begin(), groups.end(),
                [](const Group& a, const Group& b) { return a.tag < b.tag; });
      for (Group& group : groups) mesh_.groups.push_back(std::move(group));
    }
  }

  struct Entry {
    std::size_t order = 0;  // of first appearance, from 1 on
    std::string name;
    std::vector<Index> elements;
  };

  AbaqusContent& content_;
  Mesh& mesh_;
  const MshNodes& nodes_;
  MshNodes elements_;  // from numbers to places in all elements, by kind
  std::array<std::size_t, 5> starts_{};
  std::uint64_t next_number_ = 1;
  std::array<std::map<std::string, Entry>, 4> groups_;  // by dimension, then key
  std::size_t groups_made_ = 0;
  bool facets_known_ = false;
  std::map<Facet, Index> facets_;
};

}  // namespace

void resolve_abaqus_sets(AbaqusContent& content, const MshNodes& nodes) {
  SetResolver(content, nodes).resolve();
}

}  // namespace cleave::app
