#include "files/group_integers.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "error.hpp"
#include "files/group_sets.hpp"
#include "files/input_text.hpp"

namespace cleave::app {
namespace {

using nlohmann::json;

constexpr const char* kFormat = "cleave-groups/1";

/// A 32-bit integer of a group file, with messages that name the place.
std::int32_t integer_of(const json& value, const char* key, const std::string& place) {
  if (!value.is_number_integer())
    throw InputError(place + ": '" + key + "' must be an integer or list integers");
  const auto wide = value.get<std::int64_t>();  // negative if it has 64 bits without a sign
  if (wide < INT32_MIN || wide > INT32_MAX || (value.is_number_unsigned() && wide < 0))
    throw InputError(place + ": '" + key + "' has more than 32 bits");
  return static_cast<std::int32_t>(wide);
}

std::int32_t integer_in(const json& object, const char* key, const std::string& place) {
  const auto value = object.find(key);
  if (value == object.end()) throw InputError(place + ": needs the integer '" + key + "'");
  return integer_of(*value, key, place);
}

/// The integer as the number of a group.
std::int32_t tag_of(std::int32_t integer, const char* key, const std::string& place) {
  if (integer == 0) throw InputError(place + ": '" + key + "' must not be 0, which means no group");
  return integer;
}

std::int32_t tag_in(const json& object, const std::string& place) {
  return tag_of(integer_in(object, "tag", place), "tag", place);
}

int dimension_in(const json& object, const std::string& place) {
  const std::int32_t dimension = integer_in(object, "dimension", place);
  if (dimension < 0 || dimension > 3)
    throw InputError(place + ": 'dimension' must be 0, 1, 2 or 3");
  return dimension;
}

const json& list_in(const json& object, const char* key, const std::string& place) {
  const auto value = object.find(key);
  if (value == object.end() || !value->is_array())
    throw InputError(place + ": needs the list '" + key + "'");
  return *value;
}

std::string name_in(const json& object, const std::string& place) {
  const auto name = object.find("name");
  if (name == object.end() || !name->is_string() || name->get<std::string>().empty())
    throw InputError(place + ": needs the text 'name'");
  return name->get<std::string>();
}

json parse(const std::filesystem::path& path) {
  const InputText text(path);
  json document;
  try {
    document = json::parse(text.bytes());
  } catch (const json::parse_error& error) {
    text.fail(
        text.begin() + std::min(error.byte, text.bytes().size()),
        "this is not JSON; correct it, or remove it to read the mesh without names of groups");
  } catch (const json::out_of_range&) {
    throw InputError(path.string() +
                     ": has a number that is too large; correct it, or remove the "
                     "file to read the mesh without names of groups");
  }
  const auto format = document.is_object() ? document.find("format") : document.end();
  if (!document.is_object() || format == document.end() || *format != kFormat)
    throw InputError(path.string() + ": is not a file of group names (\"format\": \"" + kFormat +
                     "\"); remove it to read the mesh without names of groups");
  return document;
}

using Groups = std::map<std::pair<int, std::int32_t>, Group>;

Group& group_of(Groups& groups, int dimension, std::int32_t tag) {
  Group& group = groups[{dimension, tag}];
  group.dimension = dimension;
  group.tag = tag;
  if (group.name.empty()) group.name = std::to_string(tag);
  return group;
}

/// Replaces the group of an overlap's integer by memberships in the overlapping groups.
void apply_overlap(Groups& groups, const json& overlap, const std::string& place) {
  const int dimension = dimension_in(overlap, place);
  const auto found = groups.find({dimension, integer_in(overlap, "integer", place)});
  if (found == groups.end()) return;
  const auto elements = std::move(found->second.elements);
  groups.erase(found);
  for (const json& tag : list_in(overlap, "groups", place)) {
    auto& all =
        group_of(groups, dimension, tag_of(integer_of(tag, "groups", place), "groups", place))
            .elements;
    all.insert(all.end(), elements.begin(), elements.end());
  }
}

}  // namespace

void GroupIntegers::encode(int dimension, std::size_t count, const std::vector<Group>& groups) {
  const GroupSets sets = group_sets(count, groups);
  const std::vector<std::int32_t> tags = distinct_tags(groups, INT32_MIN);
  std::set<std::int32_t> used(tags.begin(), tags.end());
  std::vector<std::int32_t> integer_of_set{0};
  std::int32_t next = 1;
  for (std::size_t s = 1; s < sets.sets.size(); ++s) {
    const auto& members = sets.sets[s];
    if (members.size() == 1) {
      integer_of_set.push_back(tags[members[0]]);
      continue;
    }
    while (!used.insert(next).second) ++next;
    integer_of_set.push_back(next);
    Overlap overlap{dimension, next, {}};
    for (const std::size_t g : members) overlap.tags.push_back(tags[g]);
    overlaps.push_back(std::move(overlap));
  }
  auto& integers = of_element[static_cast<std::size_t>(dimension)];
  integers.reserve(count);
  for (const Index set : sets.of_element) integers.push_back(integer_of_set[set]);
  for (std::size_t g = 0; g < groups.size(); ++g)
    if (groups[g].elements.empty() || groups[g].name != std::to_string(tags[g]))
      named.push_back({dimension, tags[g], groups[g].name});
}

void GroupIntegers::encode_cohesive(const std::vector<std::string>& names) {
  std::vector<Group> groups;
  std::map<std::string, std::size_t> places;
  for (const std::string& name : names)
    if (!name.empty() && places.try_emplace(name, groups.size()).second)
      groups.push_back({name, 0, tag_of_name(name), {}});
  const std::vector<std::int32_t> tags = distinct_tags(groups, INT32_MIN);
  for (const std::string& name : names)
    of_cohesive.push_back(name.empty() ? 0 : tags[places.at(name)]);
  for (std::size_t g = 0; g < groups.size(); ++g)
    if (groups[g].name != std::to_string(tags[g]))
      cohesive_named.push_back({0, tags[g], groups[g].name});
}

std::string GroupIntegers::to_json() const {
  if (named.empty() && overlaps.empty() && cohesive_named.empty()) return {};
  json document = {{"format", kFormat}, {"groups", json::array()}, {"overlaps", json::array()}};
  for (const Named& group : named)
    document["groups"].push_back(
        {{"dimension", group.dimension}, {"tag", group.tag}, {"name", group.name}});
  for (const Overlap& overlap : overlaps)
    document["overlaps"].push_back(
        {{"dimension", overlap.dimension}, {"integer", overlap.integer}, {"groups", overlap.tags}});
  for (const Named& name : cohesive_named)
    document["cohesive"].push_back({{"tag", name.tag}, {"name", name.name}});
  return document.dump(1) + "\n";
}

std::vector<Group> groups_from_integers(int dimension, const std::vector<std::int32_t>& integers) {
  GroupCollector groups;
  for (std::size_t i = 0; i < integers.size(); ++i)
    if (integers[i] != 0) groups.add(dimension, integers[i], static_cast<Index>(i));
  return groups.finish();
}

std::vector<std::int32_t> mark_vertices(Mesh& mesh, const std::vector<std::int32_t>& of_vertex) {
  std::vector<std::int32_t> marks;
  Elements& marked = mesh.elements[0];
  for (std::size_t v = 0; v < of_vertex.size(); ++v) {
    if (of_vertex[v] == 0) continue;
    marked.vertices.push_back(static_cast<Index>(v));
    marked.numbers.push_back(mesh.vertex_numbers[v]);
    marks.push_back(of_vertex[v]);
  }
  return marks;
}

std::vector<Group> groups_of_vertices(const Mesh& mesh) {
  std::vector<Group> groups = groups_of(mesh, 0);
  for (Group& group : groups) {
    for (Index& element : group.elements) element = mesh.elements[0].vertices[element];
    std::sort(group.elements.begin(), group.elements.end());
    group.elements.erase(std::unique(group.elements.begin(), group.elements.end()),
                         group.elements.end());
  }
  return groups;
}

void apply_group_names(Mesh& mesh, const std::filesystem::path& path) {
  const json document = parse(path);
  Groups groups;
  for (Group& group : mesh.groups) groups[{group.dimension, group.tag}] = std::move(group);
  const auto place_of = [&](const char* list, std::size_t i) {
    return path.string() + ": " + list + "[" + std::to_string(i) + "]";
  };
  const json& overlaps = list_in(document, "overlaps", path.string());
  for (std::size_t i = 0; i < overlaps.size(); ++i)
    apply_overlap(groups, overlaps[i], place_of("overlaps", i));
  const json& named = list_in(document, "groups", path.string());
  std::map<std::pair<int, std::int32_t>, std::string> known_groups;
  for (std::size_t i = 0; i < named.size(); ++i) {
    const std::string place = place_of("groups", i);
    const int dimension = dimension_in(named[i], place);
    const std::int32_t tag = tag_in(named[i], place);
    const std::string name = name_in(named[i], place);
    const auto [known, is_new] = known_groups.try_emplace({dimension, tag}, name);
    if (!is_new)
      throw InputError(place + ": dimension " + std::to_string(dimension) + " has tag " +
                       std::to_string(tag) + " already, '" + known->second +
                       "'; give each group a tag of its own");
    group_of(groups, dimension, tag).name = name;
  }
  if (document.contains("cohesive")) {
    const json& cohesive = list_in(document, "cohesive", path.string());
    std::map<std::string, std::string> names;
    for (std::size_t i = 0; i < cohesive.size(); ++i) {
      const std::string place = place_of("cohesive", i);
      const std::string tag = std::to_string(tag_in(cohesive[i], place));
      const auto [known, is_new] = names.try_emplace(tag, name_in(cohesive[i], place));
      if (!is_new)
        throw InputError(place + ": tag " + tag + " is there already, '" + known->second +
                         "'; give each name a tag of its own");
    }
    for (std::string& name : mesh.cohesive.names)
      if (const auto known = names.find(name); known != names.end()) name = known->second;
  }
  mesh.groups.clear();
  for (auto& [key, group] : groups) {
    auto& elements = group.elements;
    std::sort(elements.begin(), elements.end());
    elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
    mesh.groups.push_back(std::move(group));
  }
}

}  // namespace cleave::app
