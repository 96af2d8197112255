#include "losses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "file_numbers.hpp"
#include "file_words.hpp"
#include "files/abaqus.hpp"
#include "files/group_integers.hpp"
#include "files/group_sets.hpp"

namespace cleave::app {
namespace {

/// What a format has a place for.
struct Holds {
  bool second_order, cohesive, periodic;
  bool point_fields, cell_fields, facet_fields;
  bool field_names, integer_fields;
  bool vertex_elements;  // points as elements, not only marks on vertices
};

Holds holds(MeshFormat format) {
  switch (format) {
    case MeshFormat::kMedit:
      return {true, false, false, false, false, false, true, true, false};
    case MeshFormat::kGmsh:
      return {true, true, true, true, true, true, true, false, true};
    case MeshFormat::kTetgen:
      return {true, false, false, true, true, false, false, false, false};
    case MeshFormat::kAbaqus:
      return {true, true, false, false, false, false, true, true, false};
    case MeshFormat::kVtu:
    case MeshFormat::kVtk:
      break;
  }
  return {true, true, false, true, true, true, true, true, true};
}

class LossFinder {
 public:
  LossFinder(const Mesh& mesh, const std::filesystem::path& path, const WriteOptions& options)
      : mesh_(mesh), format_(format_of(path)), holds_(holds(format_)), options_(options) {}

  std::vector<Loss> find() {
    find_second_order();
    add(holds_.cohesive ? 0 : mesh_.cohesive.size(), "cohesive-elements", "cohesive element",
        "left out");
    find_periodic();
    find_fields();
    find_groups();
    find_vertex_elements();
    find_numbers();
    return std::move(losses_);
  }

 private:
  /// `plural` is given where it is not `what` and an s.
  void add(std::size_t count, const char* kind, const std::string& what, const std::string& fate,
           const std::string& plural = {}) {
    if (count == 0) return;
    losses_.push_back({kind, count,
                       fmt::format("{}: {} {} {}", name_of(format_), counted(count, what, plural),
                                   count == 1 ? "is" : "are", fate)});
  }

  void find_second_order() {
    std::size_t count = 0;
    for (const Elements& elements : mesh_.elements) {
      const bool kept =
          holds_.second_order && (format_ != MeshFormat::kTetgen || mesh_.cells().second_order());
      if (elements.second_order() && !kept) count += elements.size();
    }
    add(count, "second-order", "element of second order",
        "written without midside nodes, which stay as vertices", "elements of second order");
  }

  void find_periodic() {
    std::size_t pairs = 0;
    for (const Periodicity& periodicity : mesh_.periodic) pairs += periodicity.pairs.size();
    if (!holds_.periodic) add(pairs, "periodic-pairs", "periodic pair", "left out");
  }

  void find_fields() {
    const auto all = [](bool held, const std::vector<Field>& fields) {
      return held ? 0 : fields.size();
    };
    std::size_t cells = all(holds_.cell_fields, mesh_.cell_fields);
    std::size_t facets = all(holds_.facet_fields, mesh_.facet_fields);
    if (format_ == MeshFormat::kVtu || format_ == MeshFormat::kVtk) find_vtk_fields(cells, facets);
    add(all(holds_.point_fields, mesh_.point_fields), "point-fields", "field of points", "left out",
        "fields of points");
    add(cells, "cell-fields", "field of cells", "left out", "fields of cells");
    add(facets, "facet-fields", "field of facets", "left out", "fields of facets");
    std::size_t renamed = 0, real = 0;
    const auto look = [&](bool held, const std::vector<Field>& fields) {
      for (std::size_t f = 0; held && f < fields.size(); ++f) {
        if (!holds_.integer_fields && fields[f].integer) ++real;
        if (!holds_.field_names &&
            (fields[f].name != fmt::format("attribute_{}", f + 1) || fields[f].components != 1))
          ++renamed;
      }
    };
    look(holds_.point_fields, mesh_.point_fields);
    look(holds_.cell_fields, mesh_.cell_fields);
    look(holds_.facet_fields, mesh_.facet_fields);
    add(renamed, "field-names", "field",
        "written as attributes, one per component, that have no names");
    add(real, "field-types", "field of integers", "written as real numbers", "fields of integers");
  }

  /// Cell data `group` is said by the groups; two arrays cannot have one name.
  void find_vtk_fields(std::size_t& cells, std::size_t& facets) const {
    for (const Field& field : mesh_.cell_fields)
      if (field.name == "group") ++cells;
    for (const Field& field : mesh_.facet_fields)
      if (field.name == "group" ||
          std::any_of(mesh_.cell_fields.begin(), mesh_.cell_fields.end(), [&](const Field& other) {
            return other.name == field.name &&
                   (other.components != field.components || other.integer != field.integer);
          }))
        ++facets;
  }

  void find_groups() {
    std::size_t renumbered = 0, empty = 0, joined = 0;
    const bool by_name = format_ == MeshFormat::kAbaqus;
    for (int d = 0; d <= 3; ++d) {
      std::vector<Group> groups;
      std::set<std::string> names;
      for (Group& group : in_order_of_writing(d)) {
        if (by_name && group.elements.empty())
          ++empty;
        else if (by_name && !names.insert(group.name).second)
          ++joined;
        else
          groups.push_back(std::move(group));
      }
      std::vector<Group> read = groups;
      for (Group& group : read)
        if (by_name) group.tag = tag_of_name(group.name);
      const auto tags = distinct_tags(read, format_ == MeshFormat::kGmsh ? 1 : INT32_MIN);
      for (std::size_t g = 0; g < groups.size(); ++g)
        if (tags[g] != groups[g].tag) ++renumbered;
    }
    add(empty, "empty-groups", "group without elements", "left out", "groups without elements");
    add(joined, "group-names", "group", "joined with another of its name");
    add(renumbered, "group-numbers", "group", "given another integer; the name stays");
  }

  /// The groups of a dimension as a file lists them. An Abaqus file has one set of elements per
  /// name, whatever their dimensions.
  std::vector<Group> in_order_of_writing(int dimension) const {
    std::vector<Group> groups = groups_of(mesh_, dimension);
    if (format_ != MeshFormat::kAbaqus || dimension == 0) return groups;
    std::map<std::string, std::size_t> first;
    for (const Group& group : mesh_.groups)
      if (group.dimension > 0 && !group.elements.empty()) first.emplace(group.name, first.size());
    std::stable_sort(groups.begin(), groups.end(),
                     [&](const Group& a, const Group& b) { return first[a.name] < first[b.name]; });
    return groups;
  }

  void find_vertex_elements() {
    if (holds_.vertex_elements) return;
    std::set<Index> marked;
    for (const Group& group : groups_of_vertices(mesh_))
      marked.insert(group.elements.begin(), group.elements.end());
    add(mesh_.elements[0].size() - marked.size(), "vertex-elements",
        "point without a group of its own", "left out", "points without a group of their own");
  }

  void find_numbers() {
    const FileNumbers numbers = numbers_in(mesh_, format_, options_);
    std::size_t elements = numbers_changed(mesh_.cohesive.numbers, numbers.cohesive);
    for (std::size_t d = points_have_numbers() ? 0 : 1; d <= 3; ++d)
      elements += numbers_changed(mesh_.elements[d].numbers, numbers.elements[d]);
    add(numbers_changed(mesh_.vertex_numbers, numbers.vertices), "vertex-numbers", "vertex number",
        "given anew");
    add(elements, "element-numbers", "element number", "given anew");
  }

  /// Whether points are elements with numbers of their own, not marks on vertices.
  bool points_have_numbers() const {
    const Elements& points = mesh_.elements[0];
    for (std::size_t e = 0; e < points.size(); ++e)
      if (points.numbers[e] != mesh_.vertex_numbers[points.vertices[e]]) return true;
    return false;
  }

  const Mesh& mesh_;
  MeshFormat format_;
  Holds holds_;
  const WriteOptions& options_;
  std::vector<Loss> losses_;
};

}  // namespace

std::vector<Loss> losses_of(const Mesh& mesh, const std::filesystem::path& path,
                            const WriteOptions& options) {
  require_options_fit(path, options);
  return LossFinder(mesh, path, options).find();
}

}  // namespace cleave::app
