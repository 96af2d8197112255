#include <algorithm>
#include <map>
#include <span>

#include "files/abaqus.hpp"
#include "files/abaqus_content.hpp"
#include "files/abaqus_types.hpp"
#include "files/midside.hpp"

namespace cleave::app {
namespace {

using Kind = AbaqusSet::Kind;

/// Keywords that make, move or hide parts of the mesh, which would be read wrong without them.
constexpr std::array kRefused = {"INCLUDE", "NGEN",   "NFILL",           "NCOPY",  "NMAP",
                                 "ELGEN",   "ELCOPY", "TRANSFORM NODES", "SYSTEM", "NODE INPUT"};

/// A number that something is wrong with: reading again finds the line it stands on.
struct Watch {
  bool node;  // else an element
  std::uint64_t number;
  int occurrence;  // 1: the first
  std::string message;
};

class AbaqusReader {
 public:
  AbaqusReader(const InputText& text, std::optional<Watch> watch)
      : text_(text), lines_(text), watch_(std::move(watch)) {}

  Mesh read() {
    content_.mesh.source = text_.source();
    if (text_.bytes().empty() || text_.bytes().back() != '\n')
      text_.fail(text_.end(),
                 "the last line has no line end: the file may be truncated; append one if it is "
                 "complete");
    if (!lines_.more() || lines_.more_data())
      text_.fail_format("an Abaqus input file, whose keywords start with a star");
    while (lines_.more()) read_keyword(lines_.keyword());
    finish();
    return std::move(content_.mesh);
  }

 private:
  [[noreturn]] void find_line(Watch watch) const {
    AbaqusReader again(text_, watch);
    again.read();
    text_.fail(text_.begin(), watch.message);
  }

  void look(bool node, std::uint64_t number, const Row& row) {
    if (watch_ && watch_->node == node && watch_->number == number && --watch_->occurrence == 0)
      row.fail(watch_->message);
  }

  void read_keyword(const AbaqusKeyword& keyword) {
    const std::string& name = keyword.name;
    const bool outside = in_assembly_ && !in_instance_;
    if (name == "HEADING") return skip_data();
    if (name == "PART" || name == "INSTANCE") return open_part(keyword);
    if (name == "ASSEMBLY") in_assembly_ = true;
    if (name == "END ASSEMBLY") in_assembly_ = false;
    if (name == "END INSTANCE") in_instance_ = false;
    if (name == "ASSEMBLY" || name.substr(0, 4) == "END ") return skip_data();
    if (std::find(kRefused.begin(), kRefused.end(), name) != kRefused.end() ||
        ((name == "NODE" || name == "ELEMENT") && keyword.has("INPUT")))
      keyword.row.fail("*" + name +
                       " makes a part of the mesh that this file does not list; write the mesh as "
                       "one file of *NODE and *ELEMENT");
    if (name == "NODE" && !outside) return read_nodes(keyword);
    if (name == "ELEMENT" && !outside) return read_elements(keyword);
    if (name == "NSET" && (!outside || keyword.has("INSTANCE"))) return read_set(keyword);
    if (name == "ELSET" && (!outside || keyword.has("INSTANCE"))) return read_set(keyword);
    if (name == "SURFACE" && is_of_elements(keyword)) return read_surface(keyword);
    ++skipped_[name];
    skip_data();
  }

  void skip_data() {
    while (lines_.more_data()) lines_.data("a line");
  }

  void open_part(const AbaqusKeyword& keyword) {
    int& count = keyword.name == "PART" ? parts_ : instances_;
    if (++count == 2)
      keyword.row.fail("a second *" + keyword.name +
                       "; Cleave reads a single part: join the parts and their numbers first");
    in_instance_ = keyword.name == "INSTANCE";
    if (in_instance_ && lines_.more_data())
      lines_.data("a line").row().fail(
          "this moves the instance, and with it the nodes; write the mesh with its instance at "
          "rest");
  }

  void read_nodes(const AbaqusKeyword& keyword) {
    if (keyword.has("SYSTEM") && upper(*keyword.find("SYSTEM")) != "R")
      keyword.row.fail("nodes in a cylindrical or spherical system; write them as x, y, z");
    AbaqusSet* set = nullptr;
    if (keyword.has("NSET"))
      set =
          &content_.set(Kind::nodes, abaqus_name(keyword.value("NSET")), in_assembly_, keyword.row);
    while (lines_.more_data()) {
      CommaFields fields = lines_.data("a node");
      const std::uint32_t number = label(fields, "the number of a node");
      std::array<double, 3> point{};
      point[0] = fields.number_or_zero("the x coordinate of a node");
      point[1] = fields.number_or_zero("the y coordinate of a node");
      three_coordinates_ = three_coordinates_ || !fields.at_end();
      point[2] = fields.number_or_zero("the z coordinate of a node");
      for (int k = 0; k < 3; ++k) fields.number_or_zero("a direction cosine");  // of a normal
      if (!fields.at_end()) fields.row().fail("more fields than a node has");
      look(true, number, fields.row());
      content_.mesh.points.push_back(point);
      content_.mesh.vertex_numbers.push_back(number);
      if (set != nullptr) add_own_label(*set, keyword.row, number);
    }
  }

  static std::uint32_t label(CommaFields& fields, const char* what) {
    const auto number = fields.number<std::uint32_t>(what);
    if (number == 0) fields.row().fail("the number 0; nodes and elements are numbered from 1 on");
    return number;
  }

  static void add_label(AbaqusSet& set, const Row& row, AbaqusSet::Label label) {
    if (set.lines.empty() || set.lines.back().second.begin() != row.begin())
      set.lines.emplace_back(set.labels.size(), row);
    set.labels.push_back(label);
  }

  /// The number of a node or element that the keyword itself puts into a set.
  static void add_own_label(AbaqusSet& set, const Row& keyword, std::uint32_t number) {
    add_label(set, keyword, {number, 0, 0});
  }

  static std::uint32_t word_of(AbaqusSet& set, const std::string& word) {
    const auto known = std::find(set.words.begin(), set.words.end(), word);
    const auto place = static_cast<std::uint32_t>(known - set.words.begin());
    if (known == set.words.end()) set.words.push_back(word);
    return place;
  }

  void read_elements(const AbaqusKeyword& keyword) {
    const std::string type_name = upper(keyword.value("TYPE"));
    const AbaqusType* type = abaqus_type(type_name);
    if (type == nullptr)
      keyword.row.fail("elements of type " + printable(type_name, 40) +
                       " are no simplices (or not known): Cleave works on lines, triangles and "
                       "tetrahedra of first and second order; split them first");
    AbaqusSet* set = nullptr;
    if (keyword.has("ELSET"))
      set = &content_.set(Kind::elements, abaqus_name(keyword.value("ELSET")), in_assembly_,
                          keyword.row);
    require_one_kind(*type, keyword.row);
    while (lines_.more_data()) {
      CommaFields fields = lines_.data("an element");
      const Row row = fields.row();
      const std::uint32_t number = label(fields, "the number of an element");
      std::array<Index, 10> nodes{};
      for (int k = 0; k < type->nodes; ++k) {
        if (fields.at_end() && fields.goes_on()) fields = lines_.data("the nodes of an element");
        nodes[static_cast<std::size_t>(k)] = label(fields, "the number of a node");
        look(true, nodes[static_cast<std::size_t>(k)], row);
      }
      if (!fields.at_end())
        fields.row().fail("more than the " + std::to_string(type->nodes) + " nodes of a " +
                          type_name);
      look(false, number, row);
      add_element(*type, number, nodes);
      if (set != nullptr) add_own_label(*set, keyword.row, number);
    }
  }

  void require_one_kind(const AbaqusType& type, const Row& row) {
    if (type.cohesive) {
      if (content_.cohesive_nodes != 0 && content_.cohesive_nodes != type.nodes)
        row.fail("cohesive elements of two dimensions in one mesh");
      content_.cohesive_nodes = type.nodes;
      return;
    }
    const Elements& elements = content_.mesh.elements[static_cast<std::size_t>(type.dimension)];
    if (elements.size() > 0 && elements.second_order() != type.second_order)
      row.fail(
          "elements of first and second order are mixed in one dimension; convert them to one "
          "order");
  }

  void add_element(const AbaqusType& type, std::uint32_t number, std::array<Index, 10>& nodes) {
    if (type.cohesive) {
      if (type.nodes == 4) std::swap(nodes[2], nodes[3]);  // around the quadrangle
      CohesiveElements& cohesive = content_.mesh.cohesive;
      cohesive.vertices.insert(cohesive.vertices.end(), nodes.begin(), nodes.begin() + type.nodes);
      cohesive.numbers.push_back(number);
      cohesive.names.emplace_back();
      return;
    }
    if (type.dimension == 1 && type.second_order) std::swap(nodes[1], nodes[2]);  // end, mid, end
    const auto d = static_cast<std::size_t>(type.dimension);
    Elements& elements = content_.mesh.elements[d];
    elements.vertices.insert(elements.vertices.end(), nodes.begin(),
                             nodes.begin() + type.dimension + 1);
    elements.numbers.push_back(number);
    if (type.second_order)
      add_midside(elements, d, kCyclicMidside,
                  std::span(nodes).subspan(d + 1, edges_of_simplex(d)));
  }

  void read_set(const AbaqusKeyword& keyword) {
    const bool of_nodes = keyword.name == "NSET";
    if (of_nodes && keyword.has("ELSET"))
      keyword.row.fail("a node set given by an element set; list its nodes instead");
    AbaqusSet& set =
        content_.set(of_nodes ? Kind::nodes : Kind::elements,
                     abaqus_name(keyword.value(keyword.name)), in_assembly_, keyword.row);
    set.internal = set.internal || keyword.has("INTERNAL");
    while (lines_.more_data()) {
      CommaFields fields = lines_.data("labels");
      if (keyword.has("GENERATE"))
        read_range(set, fields);
      else
        while (!fields.at_end()) read_label(set, fields);
    }
  }

  static bool starts_number(std::string_view text) {
    return !text.empty() && std::string_view("+-0123456789").find(text[0]) != text.npos;
  }

  static void read_label(AbaqusSet& set, CommaFields& fields) {
    CommaFields ahead = fields;
    const std::string_view word = ahead.word();
    if (starts_number(word))
      return add_label(set, fields.row(), {label(fields, "a number of the set"), 0, 0});
    if (!word.empty()) add_label(set, fields.row(), {0, word_of(set, abaqus_name(word).key), 0});
    fields = ahead;
  }

  /// first, last, step: only numbers that exist can be in a set, so that a range that lies is found
  /// at its first number that does not.
  void read_range(AbaqusSet& set, CommaFields& fields) {
    const std::uint64_t first = label(fields, "the first number of a range");
    const std::uint64_t last = label(fields, "the last number of a range");
    const std::uint64_t step = fields.at_end() ? 1 : label(fields, "the step of a range");
    if (!fields.at_end()) fields.row().fail("more fields than a range has");
    const std::uint64_t count = last < first ? 0 : (last - first) / step + 1;
    if (count == 0 || (last - first) % step != 0)
      fields.row().fail("the range does not lead from its first to its last number");
    if (count > text_.bytes().size() - std::min(text_.bytes().size(), set.labels.size()))
      fields.row().fail("the set has more numbers than a file of " +
                        std::to_string(text_.bytes().size()) + " bytes can have elements");
    for (std::uint64_t number = first; number <= last; number += step)
      add_label(set, fields.row(), {static_cast<std::uint32_t>(number), 0, 0});
  }

  static bool is_of_elements(const AbaqusKeyword& keyword) {
    const std::string* type = keyword.find("TYPE");
    return (type == nullptr || upper(*type) == "ELEMENT") && !keyword.has("COMBINE");
  }

  void read_surface(const AbaqusKeyword& keyword) {
    AbaqusSet& set =
        content_.set(Kind::surface, abaqus_name(keyword.value("NAME")), in_assembly_, keyword.row);
    while (lines_.more_data()) {
      CommaFields fields = lines_.data("a face");
      const std::size_t before = set.labels.size();
      read_label(set, fields);
      const std::string side = upper(fields.at_end() ? std::string_view() : fields.word());
      if (!fields.at_end() || side.empty() || set.labels.size() != before + 1)
        fields.row().fail(
            "expected an element or a set of elements, a comma, and the side (S1 to S4); surfaces "
            "of all free faces must be written out");
      set.labels.back().side = word_of(set, side);
    }
  }

  void finish() {
    Mesh& mesh = content_.mesh;
    if (!skipped_.empty()) report_skipped();
    MshNodes nodes;
    if (const auto twice = nodes.index(mesh.vertex_numbers))
      find_line({true, *twice, 2,
                 "node number " + std::to_string(*twice) +
                     " is used a second time; numbers must be distinct"});
    for (std::size_t d = 1; d <= 3; ++d) {
      if (mesh.elements[d].size() > 0) mesh.dimension = static_cast<int>(d);
      to_places(mesh.elements[d].vertices, nodes);
      to_places(mesh.elements[d].midside, nodes);
    }
    to_places(mesh.cohesive.vertices, nodes);
    if (content_.cohesive_nodes != 0 && content_.cohesive_nodes != 2 * mesh.dimension)
      text_.fail(text_.begin(), "the cohesive elements do not fit cells of dimension " +
                                    std::to_string(mesh.dimension));
    if (mesh.dimension == 0) return;
    mesh.two_dimensional_points = mesh.dimension < 3 && !three_coordinates_;
    require_distinct_elements();
    resolve_abaqus_sets(content_, nodes);
  }

  /// Replaces numbers of nodes by places.
  void to_places(std::vector<Index>& vertices, const MshNodes& nodes) const {
    for (Index& vertex : vertices) {
      const Index place = nodes.find(vertex);
      if (place == MshNodes::kNone)
        find_line({true, vertex, 1, "there is no node " + std::to_string(vertex)});
      vertex = place;
    }
  }

  void require_distinct_elements() const {
    std::vector<std::uint64_t> all = content_.mesh.cohesive.numbers;
    for (const Elements& elements : content_.mesh.elements)
      all.insert(all.end(), elements.numbers.begin(), elements.numbers.end());
    std::sort(all.begin(), all.end());
    const auto twice = std::adjacent_find(all.begin(), all.end());
    if (twice != all.end())
      find_line({false, *twice, 2,
                 "element number " + std::to_string(*twice) +
                     " is used a second time; numbers must be distinct"});
  }

  void report_skipped() {
    std::size_t count = 0;
    std::string names;
    for (const auto& [name, times] : skipped_) {
      count += times;
      names += (names.empty() ? "*" : ", *") + printable(name, 40) +
               (times > 1 ? " (" + std::to_string(times) + ")" : "");
    }
    content_.mesh.dropped.push_back(text_.source() + ": " + std::to_string(count) +
                                    (count == 1 ? " keyword does" : " keywords do") +
                                    " not concern the mesh and will not be in an output: " + names);
  }

  const InputText& text_;
  AbaqusLines lines_;
  std::optional<Watch> watch_;
  AbaqusContent content_;
  bool in_assembly_ = false, in_instance_ = false, three_coordinates_ = false;
  int parts_ = 0, instances_ = 0;
  std::map<std::string, std::size_t> skipped_;
};

}  // namespace

AbaqusSet& AbaqusContent::set(AbaqusSet::Kind kind, const AbaqusName& name, bool of_assembly,
                              const Row& row) {
  const auto [place, is_new] = places_.try_emplace({kind, name.key}, sets.size());
  if (is_new) {
    AbaqusSet set;
    set.kind = kind;
    set.name = name;
    set.of_assembly = of_assembly;
    sets.push_back(std::move(set));
  }
  AbaqusSet& set = sets[place->second];
  if (set.of_assembly != of_assembly)
    row.fail("the part and the assembly both have a set '" + printable(name.shown, 40) +
             "'; rename one");
  return set;
}

const AbaqusSet* AbaqusContent::find(AbaqusSet::Kind kind, const std::string& key) const {
  const auto place = places_.find({kind, key});
  return place == places_.end() ? nullptr : &sets[place->second];
}

Mesh read_abaqus(const InputText& text) { return AbaqusReader(text, {}).read(); }

}  // namespace cleave::app
