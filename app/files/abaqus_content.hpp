#pragma once
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "files/abaqus_lines.hpp"
#include "files/msh_nodes.hpp"
#include "mesh.hpp"

namespace cleave::app {

/// A set or surface as the file defines it, perhaps in several places.
struct AbaqusSet {
  enum class Kind { nodes, elements, surface };
  struct Label {
    std::uint32_t number = 0;  // of a node or element; 0: a set is named
    std::uint32_t set = 0;     // place in `words` of the key of that set
    std::uint32_t side = 0;    // of a surface: place in `words` of S1, ..
  };
  Kind kind = Kind::nodes;
  AbaqusName name;
  bool internal = false;     // serves surfaces only
  bool of_assembly = false;  // defined outside of the part
  std::vector<Label> labels;
  std::vector<std::string> words;
  /// A label stands on the line that the last of these at or before it begins.
  std::vector<std::pair<std::size_t, Row>> lines;
};

/// What the keywords of a file give. Vertices of elements are the file's numbers of nodes until
/// they are resolved.
struct AbaqusContent {
  Mesh mesh;
  std::vector<AbaqusSet> sets;  // by first appearance
  int cohesive_nodes = 0;       // per cohesive element, 0: none

  /// The set of this kind and name, new if need be. Throws InputError (`row`) if the part and the
  /// assembly both define one.
  AbaqusSet& set(AbaqusSet::Kind kind, const AbaqusName& name, bool of_assembly, const Row& row);

  /// The set of this kind and key, or null.
  const AbaqusSet* find(AbaqusSet::Kind kind, const std::string& key) const;

 private:
  std::map<std::pair<AbaqusSet::Kind, std::string>, std::size_t> places_;
};

/// Makes groups of the sets and surfaces, whose facets become elements where they are none, and
/// names the cohesive elements. Vertices must be places. Throws InputError for a label that names
/// nothing.
void resolve_abaqus_sets(AbaqusContent& content, const MshNodes& nodes);

}  // namespace cleave::app
