#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "error.hpp"
#include "files/input_text.hpp"
#include "json_value.hpp"
#include "record.hpp"
#include "replace_files.hpp"

namespace cleave::app {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return value;
}

Json json_of(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(json_of(value));
  return list;
}

Json json_of(const std::vector<NumberRun>& runs) {
  Json list = Json::array();
  for (const NumberRun& run : runs) list.push_back({run.place, run.first, run.count});
  return list;
}

Json json_of(const std::vector<OriginalRecord::Field>& fields) {
  Json list = Json::array();
  for (const auto& field : fields)
    list.push_back({{"name", field.name},
                    {"components", field.components},
                    {"integer", field.integer},
                    {"held", field.held},
                    {"values", json_of(field.values)}});
  return list;
}

Json json_of(const CohesiveElements& cohesive) {
  return {
      {"vertices", cohesive.vertices}, {"numbers", cohesive.numbers}, {"names", cohesive.names}};
}

Json json_of(const Periodicity& condition) {
  Json pairs = Json::array();
  for (const auto& pair : condition.pairs) pairs.push_back({pair.vertex, pair.master});
  return {{"dimension", condition.dimension},
          {"entity", condition.entity},
          {"master", condition.master},
          {"affine", json_of(condition.affine)},
          {"pairs", pairs}};
}

Json json_of(const OriginalRecord::Elements& elements) {
  Json gone = Json::array();
  for (const auto& element : elements.gone) {
    Json entry{{"place", element.place}, {"vertices", element.vertices}};
    if (!element.midside.empty()) entry["midside"] = element.midside;
    gone.push_back(std::move(entry));
  }
  return {{"count", elements.count}, {"gone", gone}, {"numbers", json_of(elements.numbers)}};
}

Json json_of(const OriginalRecord& original) {
  Json json{{"vertices", original.vertices}, {"origins", Json::array()},
            {"points", Json::array()},       {"vertex_numbers", json_of(original.vertex_numbers)},
            {"elements", Json::array()},     {"groups", Json::array()}};
  for (const Run& run : original.origins) json["origins"].push_back({run.first, run.count});
  for (const auto& point : original.points)
    json["points"].push_back({{"place", point.place}, {"point", point.point}});
  for (const auto& elements : original.elements) json["elements"].push_back(json_of(elements));
  for (const auto& group : original.groups)
    json["groups"].push_back({{"name", group.name},
                              {"dimension", group.dimension},
                              {"tag", group.tag},
                              {"added", group.added},
                              {"removed", group.removed}});
  json["point_fields"] = json_of(original.point_fields);
  json["cell_fields"] = json_of(original.cell_fields);
  json["facet_fields"] = json_of(original.facet_fields);
  json["cohesive"] = json_of(original.cohesive);
  if (original.periodic) {
    json["periodic"] = Json::array();
    for (const auto& condition : *original.periodic) json["periodic"].push_back(json_of(condition));
  }
  json["two_dimensional_points"] = original.two_dimensional_points;
  json["msh_version"] = original.msh_version == MshVersion::k22 ? "2.2" : "4.1";
  json["msh_binary"] = original.msh_binary;
  return json;
}

Json json_of(const std::vector<FacetSides>& facets) {
  Json list = Json::array();
  for (const auto& [lesser, mate] : facets) list.push_back({lesser, mate});
  return list;
}

// Reading: what JsonValue does not know.

Index id(const JsonValue& value) {
  const std::uint64_t number = value.count();
  if (number >= topology::kNoIndex) value.fail("the number is too large");
  return static_cast<Index>(number);
}

std::vector<Index> ids(const JsonValue& value) {
  std::vector<Index> list;
  for (const JsonValue& item : value.items()) list.push_back(id(item));
  return list;
}

std::vector<Index> ascending_ids(const JsonValue& value) {
  auto list = ids(value);
  for (std::size_t i = 1; i < list.size(); ++i)
    if (list[i] <= list[i - 1]) value.fail("the numbers must ascend");
  return list;
}

std::vector<std::uint64_t> tuple(const JsonValue& value, std::size_t size) {
  std::vector<std::uint64_t> numbers;
  for (const JsonValue& item : value.items()) numbers.push_back(item.count());
  if (numbers.size() != size) value.fail(std::to_string(size) + " numbers are needed");
  return numbers;
}

std::int64_t integer(const JsonValue& value, double least, double greatest) {
  const double number = value.number();
  if (!(number >= least && number <= greatest) || number != std::floor(number))
    value.fail("a whole number in range is needed");
  return static_cast<std::int64_t>(number);
}

int dimension(const JsonValue& value, int least, int greatest) {
  return static_cast<int>(integer(value, least, greatest));
}

double value_of(const JsonValue& value) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (!value.is_string()) return value.number();
  const std::size_t which = value.choice({"nan", "inf", "-inf"});
  return which == 0   ? std::numeric_limits<double>::quiet_NaN()
         : which == 1 ? kInfinity
                      : -kInfinity;
}

std::vector<double> values_of(const JsonValue& value) {
  std::vector<double> values;
  for (const JsonValue& item : value.items()) values.push_back(value_of(item));
  return values;
}

std::vector<NumberRun> number_runs(const JsonValue& value) {
  std::vector<NumberRun> runs;
  for (const JsonValue& item : value.items()) {
    const auto run = tuple(item, 3);
    if (run[2] > std::numeric_limits<std::uint64_t>::max() - run[1])
      item.fail("the numbers are too large");
    runs.push_back({run[0], run[1], run[2]});
  }
  return runs;
}

std::vector<OriginalRecord::Field> fields(const JsonValue& value) {
  std::vector<OriginalRecord::Field> fields;
  for (const JsonValue& item : value.items()) {
    item.only({"name", "components", "integer", "held", "values"});
    fields.push_back(
        {item["name"].string(), static_cast<int>(integer(item["components"], 1, 1 << 20)),
         item["integer"].boolean(), item["held"].boolean(), values_of(item["values"])});
  }
  return fields;
}

CohesiveElements cohesive_of(const JsonValue& value, int cells) {
  value.only({"vertices", "numbers", "names"});
  CohesiveElements cohesive;
  cohesive.vertices = ids(value["vertices"]);
  for (const JsonValue& number : value["numbers"].items())
    cohesive.numbers.push_back(number.count());
  for (const JsonValue& name : value["names"].items()) cohesive.names.push_back(name.string());
  if (cohesive.names.size() != cohesive.size() ||
      cohesive.vertices.size() != 2 * static_cast<std::size_t>(cells) * cohesive.size())
    value.fail("the lists do not fit each other");
  return cohesive;
}

std::vector<Periodicity> periodic_of(const JsonValue& value) {
  constexpr double kMost = 9007199254740992.0;
  std::vector<Periodicity> periodic;
  for (const JsonValue& item : value.items()) {
    item.only({"dimension", "entity", "master", "affine", "pairs"});
    auto& condition = periodic.emplace_back();
    condition.dimension = dimension(item["dimension"], 0, 3);
    condition.entity = integer(item["entity"], -kMost, kMost);
    condition.master = integer(item["master"], -kMost, kMost);
    condition.affine = values_of(item["affine"]);
    if (!condition.affine.empty() && condition.affine.size() != 16)
      item["affine"].fail("16 numbers are needed, or none");
    for (const JsonValue& pair : item["pairs"].items()) {
      const auto list = ids(pair);
      if (list.size() != 2) pair.fail("2 numbers are needed");
      condition.pairs.push_back({list[0], list[1]});
    }
  }
  return periodic;
}

OriginalRecord::Elements elements_of(const JsonValue& value) {
  value.only({"count", "gone", "numbers"});
  OriginalRecord::Elements elements;
  elements.count = id(value["count"]);
  for (const JsonValue& item : value["gone"].items()) {
    item.only({"place", "vertices", "midside"});
    auto& gone = elements.gone.emplace_back();
    gone.place = id(item["place"]);
    gone.vertices = ids(item["vertices"]);
    if (item.has("midside")) gone.midside = ids(item["midside"]);
  }
  elements.numbers = number_runs(value["numbers"]);
  return elements;
}

OriginalRecord original_of(const JsonValue& value, int cells) {
  value.only({"vertices", "origins", "points", "vertex_numbers", "elements", "groups",
              "point_fields", "cell_fields", "facet_fields", "cohesive", "periodic",
              "two_dimensional_points", "msh_version", "msh_binary"});
  OriginalRecord original;
  original.vertices = id(value["vertices"]);
  for (const JsonValue& item : value["origins"].items()) {
    const auto run = tuple(item, 2);
    original.origins.push_back({run[0], run[1]});
  }
  for (const JsonValue& item : value["points"].items()) {
    item.only({"place", "point"});
    original.points.push_back({id(item["place"]), item["point"].vector()});
  }
  original.vertex_numbers = number_runs(value["vertex_numbers"]);
  const auto by_dimension = value["elements"].items();
  if (by_dimension.size() != original.elements.size()) value["elements"].fail("4 are needed");
  for (std::size_t d = 0; d < by_dimension.size(); ++d)
    original.elements[d] = elements_of(by_dimension[d]);
  for (const JsonValue& item : value["groups"].items()) {
    item.only({"name", "dimension", "tag", "added", "removed"});
    original.groups.push_back(
        {item["name"].string(), dimension(item["dimension"], 0, cells),
         static_cast<std::int32_t>(integer(item["tag"], INT32_MIN, INT32_MAX)),
         ascending_ids(item["added"]), ascending_ids(item["removed"])});
  }
  original.point_fields = fields(value["point_fields"]);
  original.cell_fields = fields(value["cell_fields"]);
  original.facet_fields = fields(value["facet_fields"]);
  original.cohesive = cohesive_of(value["cohesive"], cells);
  if (value.has("periodic")) original.periodic = periodic_of(value["periodic"]);
  original.two_dimensional_points = value["two_dimensional_points"].boolean();
  original.msh_version =
      value["msh_version"].choice({"2.2", "4.1"}) == 0 ? MshVersion::k22 : MshVersion::k41;
  original.msh_binary = value["msh_binary"].boolean();
  return original;
}

std::vector<FacetSides> facets_of(const JsonValue& value) {
  std::vector<FacetSides> facets;
  for (const JsonValue& item : value.items()) {
    const auto sides = ids(item);
    if (sides.size() != 2 || sides[0] >= sides[1])
      item.fail("the two half-facets of a facet are needed, the lesser one first");
    if (!facets.empty() && facets.back().first >= sides[0]) item.fail("the facets must ascend");
    facets.emplace_back(sides[0], sides[1]);
  }
  return facets;
}

}  // namespace

std::filesystem::path hashed_path(const std::filesystem::path& mesh_path,
                                  const std::string& suffix) {
  return mesh_path.parent_path() / (mesh_path.stem().string() + suffix);
}

std::string hashed_suffix(const std::filesystem::path& mesh_path,
                          const std::filesystem::path& file) {
  return file.filename().string().substr(mesh_path.stem().string().size());
}

std::filesystem::path record_path(const std::filesystem::path& mesh_path) {
  std::filesystem::path path = behind_links(mesh_path);
  path += ".cleave.json";
  return path;
}

std::optional<std::string> json_of(const IncisionRecord& record) {
  const Json json{{"schema", "cleave-incision/1"},
                  {"sha256", record.sha256},
                  {"dimension", record.dimension},
                  {"cells", record.cells},
                  {"opened", json_of(record.opened)},
                  {"shut", json_of(record.shut)},
                  {"groups", record.groups},
                  {"others", record.others},
                  {"cohesive", record.cohesive},
                  {"offset", record.offset},
                  {"original", json_of(record.original)}};
  try {
    return json.dump() + "\n";
  } catch (const Json::type_error&) {
    return std::nullopt;
  }
}

IncisionRecord read_record(const std::filesystem::path& path) {
  const InputText text(path);
  const auto json = parse_json(text.bytes(), text.source());
  const JsonValue document(json, text.source());
  document.only({"schema", "sha256", "dimension", "cells", "opened", "shut", "groups", "others",
                 "cohesive", "offset", "original"});
  document["schema"].choice({"cleave-incision/1"});
  IncisionRecord record;
  for (const auto& [suffix, hash] : document["sha256"].members()) {
    if (suffix.find('/') != std::string::npos) hash.fail("a suffix has no folder");
    record.sha256[suffix] = hash.string();
  }
  record.cohesive = document["cohesive"].boolean();
  record.offset = document["offset"].number();
  if (!(record.offset >= 0 && std::isfinite(record.offset)))
    document["offset"].fail("a finite number from 0 on is needed");
  record.dimension = dimension(document["dimension"], 1, 3);
  record.cells = document["cells"].count();
  record.opened = facets_of(document["opened"]);
  record.shut = facets_of(document["shut"]);
  for (const JsonValue& name : document["groups"].items()) record.groups.push_back(name.string());
  record.others = ascending_ids(document["others"]);
  record.original = original_of(document["original"], record.dimension);
  return record;
}

}  // namespace cleave::app
