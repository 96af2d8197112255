#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <string>
#include <vector>

#include "error.hpp"
#include "files/abaqus.hpp"
#include "files/abaqus_lines.hpp"
#include "files/group_integers.hpp"
#include "files/midside.hpp"
#include "files/numbers.hpp"

namespace cleave::app {
namespace {

using Numbers = std::vector<std::uint64_t>;

/// Lists by name, in the order in which the names came.
template <class Value>
class NamedLists {
 public:
  std::vector<Value>& operator[](const std::string& name) {
    const auto [place, is_new] = places_.try_emplace(name, lists_.size());
    if (is_new) {
      lists_.emplace_back(name, std::vector<Value>());
      ++uppers_[upper(name)];
    }
    return lists_[place->second].second;
  }

  auto begin() const { return lists_.begin(); }
  auto end() const { return lists_.end(); }

  /// A name as Abaqus takes it: quoted unless it is a plain label that differs from all others also
  /// in upper case.
  std::string label(const std::string& name) const {
    if (name.size() > 80 || name.find_first_of("\"\r\n") != std::string::npos)
      throw OutputError("the group '" + name +
                        "' cannot be named in an Abaqus file: no quotation mark or line break is "
                        "allowed, and at most 80 bytes; rename it");
    const auto allowed = [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
    };
    const bool plain = (std::isalpha(static_cast<unsigned char>(name[0])) != 0 || name[0] == '_') &&
                       std::all_of(name.begin(), name.end(), allowed);
    return plain && uppers_.at(upper(name)) == 1 ? name : '"' + name + '"';
  }

 private:
  std::vector<std::pair<std::string, std::vector<Value>>> lists_;
  std::map<std::string, std::size_t> places_, uppers_;
};

using Sets = NamedLists<std::uint64_t>;

class AbaqusWriter {
 public:
  AbaqusWriter(TextOutput& out, const Mesh& mesh)
      : out_(out), mesh_(mesh), nodes_(kept_or_counted(mesh.vertex_numbers, kAbaqusGreatest)) {
    Numbers all;
    for (std::size_t d = 1; d <= 3; ++d) append(all, mesh.elements[d].numbers);
    append(all, mesh.cohesive.numbers);
    const Numbers numbers = kept_or_counted(all, kAbaqusGreatest);
    auto next = numbers.begin();
    const auto take = [&](Numbers& into, std::size_t count) {
      into.assign(next, next + static_cast<std::ptrdiff_t>(count));
      next += static_cast<std::ptrdiff_t>(count);
    };
    for (std::size_t d = 1; d <= 3; ++d) take(elements_[d], mesh.elements[d].size());
    take(cohesive_, mesh.cohesive.size());
    in_plane_ = mesh.dimension == 2 && std::all_of(mesh.points.begin(), mesh.points.end(),
                                                   [](const auto& point) { return point[2] == 0; });
  }

  void write() {
    out_ << "*HEADING\nmesh\n*NODE\n";
    for (std::size_t v = 0; v < nodes_.size(); ++v) {
      const auto& point = mesh_.points[v];
      out_ << nodes_[v] << ", " << point[0] << ", " << point[1];
      if (!mesh_.two_dimensional_points) out_ << ", " << point[2];
      out_ << '\n';
    }
    for (std::size_t d = 1; d <= 3; ++d) write_elements(d);
    write_cohesive();
    write_sets("*NSET, NSET=", node_sets());
    write_sets("*ELSET, ELSET=", element_sets());
    write_surfaces();
  }

 private:
  static void append(Numbers& to, const Numbers& from) {
    to.insert(to.end(), from.begin(), from.end());
  }

  const char* type(std::size_t d, bool second_order) const {
    if (d == 1) return in_plane_ ? second_order ? "T2D3" : "T2D2" : second_order ? "T3D3" : "T3D2";
    if (d == 2) return in_plane_ ? second_order ? "CPS6" : "CPS3" : second_order ? "STRI65" : "S3";
    return second_order ? "C3D10" : "C3D4";
  }

  void write_elements(std::size_t d) {
    const Elements& elements = mesh_.elements[d];
    if (elements.size() == 0) return;
    const bool second_order = elements.second_order();
    out_ << "*ELEMENT, TYPE=" << type(d, second_order) << '\n';
    for (std::size_t e = 0; e < elements.size(); ++e) {
      std::vector<Index> nodes(&elements.vertices[(d + 1) * e],
                               &elements.vertices[(d + 1) * e] + d + 1);
      for (std::size_t k = 0; second_order && k < edges_of_simplex(d); ++k)
        nodes.push_back(midside_node(elements, d, kCyclicMidside, e, k));
      if (d == 1 && second_order) std::swap(nodes[1], nodes[2]);  // end, middle, end
      write_row(elements_[d][e], nodes);
    }
  }

  void write_row(std::uint64_t number, const std::vector<Index>& nodes) {
    out_ << number;
    for (const Index v : nodes) out_ << ", " << nodes_[v];
    out_ << '\n';
  }

  void write_cohesive() {
    const CohesiveElements& cohesive = mesh_.cohesive;
    if (cohesive.size() == 0) return;
    const std::size_t count = 2 * static_cast<std::size_t>(mesh_.dimension);
    out_ << "*ELEMENT, TYPE=" << (mesh_.dimension == 3 ? "COH3D6" : "COH2D4") << '\n';
    for (std::size_t e = 0; e < cohesive.size(); ++e) {
      std::vector<Index> nodes(&cohesive.vertices[count * e],
                               &cohesive.vertices[count * e] + count);
      if (count == 4) std::swap(nodes[2], nodes[3]);  // around the quadrangle
      write_row(cohesive_[e], nodes);
    }
  }

  Sets node_sets() const {
    Sets sets;
    for (const Group& group : groups_of_vertices(mesh_))
      for (const Index v : group.elements) sets[name_of(group)].push_back(nodes_[v]);
    return sets;
  }

  Sets element_sets() const {
    Sets sets;
    for (const Group& group : mesh_.groups)
      if (group.dimension > 0)
        for (const Index e : group.elements)
          sets[name_of(group)].push_back(elements_[static_cast<std::size_t>(group.dimension)][e]);
    for (std::size_t e = 0; e < mesh_.cohesive.size(); ++e)
      if (!mesh_.cohesive.names[e].empty()) sets[mesh_.cohesive.names[e]].push_back(cohesive_[e]);
    return sets;
  }

  static std::string name_of(const Group& group) {
    return group.name.empty() ? std::to_string(group.tag) : group.name;
  }

  void write_sets(const char* keyword, const Sets& sets) {
    for (const auto& [name, numbers] : sets) {
      out_ << keyword << sets.label(name) << '\n';
      constexpr std::size_t kPerLine = 16;
      for (std::size_t i = 0; i < numbers.size(); ++i)
        out_ << numbers[i]
             << (i + 1 == numbers.size() || i % kPerLine == kPerLine - 1 ? "\n" : ", ");
    }
  }

  using Facet = std::array<Index, 3>;  // vertices, ascending; unused ones are 0

  static bool is_even(const Index* vertices, std::size_t count) {
    bool even = true;
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = i + 1; j < count; ++j) even = even != (vertices[i] > vertices[j]);
    return even;
  }

  /// The element and side of each facet in a group: that of the cell the facet's normal points away
  /// from, else of the other cell.
  void write_surfaces() {
    const auto d = static_cast<std::size_t>(mesh_.dimension);
    if (d < 2) return;
    const Elements& facets = mesh_.elements[d - 1];
    std::vector<std::pair<Facet, Index>> wanted;
    std::vector<bool> is_wanted(facets.size(), false);
    for (const Group& group : mesh_.groups)
      if (group.dimension == mesh_.dimension - 1)
        for (const Index f : group.elements) is_wanted[f] = true;
    for (Index f = 0; f < facets.size(); ++f) {
      Facet facet{};
      std::copy_n(&facets.vertices[d * f], d, facet.begin());
      std::sort(facet.begin(), facet.begin() + static_cast<std::ptrdiff_t>(d));
      if (is_wanted[f]) wanted.push_back({facet, f});
    }
    if (wanted.empty()) return;
    std::sort(wanted.begin(), wanted.end());
    std::vector<Side> sides(facets.size());
    for (std::size_t c = 0; c < mesh_.cells().size(); ++c)
      for (int s = 0; s <= mesh_.dimension; ++s) {
        Facet side{};
        for (std::size_t k = 0; k < d; ++k)
          side[k] =
              mesh_.cells().vertices[(d + 1) * c + static_cast<std::size_t>(kAbaqusSides[d][s][k])];
        const bool even = is_even(side.data(), d);
        std::sort(side.begin(), side.begin() + static_cast<std::ptrdiff_t>(d));
        for (auto at = std::lower_bound(wanted.begin(), wanted.end(), std::pair{side, Index{0}});
             at != wanted.end() && at->first == side; ++at) {
          Side& known = sides[at->second];
          const bool away = even != is_even(&facets.vertices[d * at->second], d);
          if (known.cell == 0 || (away && !known.away)) known = {elements_[d][c], s + 1, away};
        }
      }
    write_surfaces_of(sides);
  }

  struct Side {
    std::uint64_t cell = 0;  // its number, 0: none
    int side = 0;
    bool away = false;  // the facet's normal points away from the cell
  };

  void write_surfaces_of(const std::vector<Side>& sides) {
    const char* letter = mesh_.dimension == 3 || in_plane_ ? ", S" : ", E";  // edges of shells
    NamedLists<Side> surfaces;
    for (const Group& group : mesh_.groups)
      if (group.dimension == mesh_.dimension - 1)
        for (const Index f : group.elements)
          if (sides[f].cell != 0) surfaces[name_of(group)].push_back(sides[f]);
    for (const auto& [name, faces] : surfaces) {
      out_ << "*SURFACE, TYPE=ELEMENT, NAME=" << surfaces.label(name) << '\n';
      for (const Side& face : faces) out_ << face.cell << letter << face.side << '\n';
    }
  }

  TextOutput& out_;
  const Mesh& mesh_;
  Numbers nodes_;
  std::array<Numbers, 4> elements_;  // numbers, by dimension
  Numbers cohesive_;
  bool in_plane_ = false;
};

}  // namespace

void write_abaqus(TextOutput& out, const Mesh& mesh) { AbaqusWriter(out, mesh).write(); }

}  // namespace cleave::app
