#include "mesh_info.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "body.hpp"
#include "file_words.hpp"

namespace cleave::app {
namespace {

using Json = nlohmann::ordered_json;
using Range = std::optional<std::array<double, 2>>;

MeshInfo::Kind kind_of(int dimension, const char* name, int order,
                       const std::vector<std::uint64_t>& numbers) {
  MeshInfo::Kind kind{dimension, name, order, numbers.size(), 0, 0};
  if (numbers.empty()) return kind;
  const auto [least, greatest] = std::minmax_element(numbers.begin(), numbers.end());
  kind.least = *least;
  kind.greatest = *greatest;
  return kind;
}

void extend(Range& range, double value) {
  if (!std::isfinite(value)) return;
  if (!range) range = {value, value};
  (*range)[0] = std::min((*range)[0], value);
  (*range)[1] = std::max((*range)[1], value);
}

void add_fields(MeshInfo& info, const char* on, const std::vector<Field>& fields) {
  for (const Field& field : fields) {
    const auto components = static_cast<std::size_t>(field.components);
    MeshInfo::FieldInfo one{field.name, on, field.components, field.integer,
                            std::vector<Range>(components)};
    for (std::size_t i = 0; i < field.values.size(); ++i)
      extend(one.ranges[i % components], field.values[i]);
    info.fields.push_back(std::move(one));
  }
}

void add_box(MeshInfo& info, const Mesh& mesh) {
  std::array<Range, 3> ranges;
  for (const auto& point : mesh.points) {
    if (!std::all_of(point.begin(), point.end(), [](double x) { return std::isfinite(x); })) {
      ++info.not_finite;
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k) extend(ranges[k], point[k]);
  }
  if (!ranges[0]) return;
  info.box.emplace();
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t end = 0; end < 2; ++end) (*info.box)[end][k] = (*ranges[k])[end];
}

std::optional<topology::Summary> summary_of(const Mesh& mesh) {
  try {
    if (mesh.dimension == 1) return topology::summarize(soup_of<1>(mesh));
    if (mesh.dimension == 2) return topology::summarize(soup_of<2>(mesh));
    return topology::summarize(soup_of<3>(mesh));
  } catch (const std::length_error&) {
    return std::nullopt;
  }
}

std::string text_of(const std::array<double, 3>& point) {
  return fmt::format("({}, {}, {})", point[0], point[1], point[2]);
}

std::string numbers_text(const MeshInfo::Kind& kind) {
  return fmt::format("numbers {} to {}{}", kind.least, kind.greatest,
                     kind.greatest - kind.least + 1 == kind.count ? "" : ", with gaps");
}

std::string text_of(const MeshInfo::FieldInfo& field) {
  std::string ranges;
  for (const Range& range : field.ranges)
    ranges += (ranges.empty() ? "" : ", ") +
              (range ? fmt::format("{} to {}", (*range)[0], (*range)[1]) : "no finite value");
  return fmt::format("  field of {} '{}'{}: {}\n", field.on, field.name,
                     field.integer ? " (integers)" : "", ranges);
}

Json json_of(const MeshInfo::Kind& kind) {
  return {{"dimension", kind.dimension}, {"kind", kind.name},
          {"order", kind.order},         {"count", kind.count},
          {"least_number", kind.least},  {"greatest_number", kind.greatest}};
}

Json json_of(const MeshInfo::FieldInfo& field) {
  Json ranges = Json::array();
  for (const Range& range : field.ranges) ranges.push_back(range ? Json(*range) : Json(nullptr));
  return {{"name", field.name},
          {"on", field.on},
          {"components", field.components},
          {"integer", field.integer},
          {"ranges", ranges}};
}

}  // namespace

MeshInfo info_of(const Mesh& mesh, const std::filesystem::path& path) {
  constexpr std::array kNames = {"vertex", "edge", "triangle", "tetrahedron"};
  MeshInfo info;
  info.source = mesh.source;
  info.form = form_of(path);
  info.dimension = mesh.dimension;
  info.vertices = kind_of(0, "vertex", 1, mesh.vertex_numbers);
  for (int d = 0; d <= 3; ++d) {
    const Elements& elements = mesh.elements[static_cast<std::size_t>(d)];
    if (elements.size() > 0)
      info.elements.push_back(kind_of(d, d == 0 ? "point" : kNames[static_cast<std::size_t>(d)],
                                      elements.second_order() ? 2 : 1, elements.numbers));
  }
  if (mesh.cohesive.size() > 0)
    info.elements.push_back(kind_of(mesh.dimension, "cohesive element", 1, mesh.cohesive.numbers));
  add_fields(info, "points", mesh.point_fields);
  add_fields(info, "cells", mesh.cell_fields);
  add_fields(info, "facets", mesh.facet_fields);
  add_box(info, mesh);
  info.topology = summary_of(mesh);
  return info;
}

std::string text_of(const MeshInfo& info, const Mesh& mesh) {
  const FileForm& form = info.form;
  std::string text =
      fmt::format("{}: {}{}, {}; dimension {}\n", info.source, form.format,
                  form.version.empty() ? "" : " " + form.version, form.encoding, info.dimension);
  text += fmt::format("  {}, {}\n", counted(info.vertices.count, "vertex", "vertices"),
                      numbers_text(info.vertices));
  for (const MeshInfo::Kind& kind : info.elements)
    text += fmt::format(
        "  {}{}, {}\n",
        counted(kind.count, kind.name, kind.name == "tetrahedron" ? "tetrahedra" : std::string()),
        kind.order == 2 ? " of second order" : "", numbers_text(kind));
  for (const Group& group : mesh.groups)
    text += fmt::format("  group '{}' of dimension {} (integer {}): {}\n", group.name,
                        group.dimension, group.tag, counted(group.elements.size(), "element"));
  for (const MeshInfo::FieldInfo& field : info.fields) text += text_of(field);
  for (const Periodicity& one : mesh.periodic)
    text += fmt::format("  entity {} of dimension {} is periodic to {}: {}\n", one.entity,
                        one.dimension, one.master, counted(one.pairs.size(), "pair"));
  if (info.box)
    text += fmt::format("  from {} to {}\n", text_of((*info.box)[0]), text_of((*info.box)[1]));
  if (info.not_finite > 0)
    text += fmt::format("  {} not finite\n", counted(info.not_finite, "point has coordinates",
                                                     "points have coordinates"));
  if (info.topology)
    text +=
        fmt::format("  {}, {}, Euler characteristic {}\n", counted(info.topology->pieces, "piece"),
                    counted(info.topology->boundary_components, "boundary component"),
                    info.topology->euler_characteristic);
  return text;
}

std::string json_of(const MeshInfo& info, const Mesh& mesh) {
  Json elements = Json::array(), groups = Json::array(), fields = Json::array(),
       periodic = Json::array();
  for (const MeshInfo::Kind& kind : info.elements) elements.push_back(json_of(kind));
  for (const Group& group : mesh.groups)
    groups.push_back({{"name", group.name},
                      {"dimension", group.dimension},
                      {"integer", group.tag},
                      {"elements", group.elements.size()}});
  for (const MeshInfo::FieldInfo& field : info.fields) fields.push_back(json_of(field));
  for (const Periodicity& one : mesh.periodic)
    periodic.push_back({{"dimension", one.dimension},
                        {"entity", one.entity},
                        {"master", one.master},
                        {"pairs", one.pairs.size()}});
  Json box = nullptr, topology = nullptr;
  if (info.box) box = {{"low", (*info.box)[0]}, {"high", (*info.box)[1]}};
  if (info.topology)
    topology = {{"pieces", info.topology->pieces},
                {"boundary_components", info.topology->boundary_components},
                {"euler_characteristic", info.topology->euler_characteristic}};
  const Json all = {{"schema", "cleave-info/1"},
                    {"file", info.source},
                    {"format", info.form.format},
                    {"version", info.form.version},
                    {"encoding", info.form.encoding},
                    {"dimension", info.dimension},
                    {"vertices",
                     {{"count", info.vertices.count},
                      {"least_number", info.vertices.least},
                      {"greatest_number", info.vertices.greatest},
                      {"not_finite", info.not_finite}}},
                    {"elements", elements},
                    {"groups", groups},
                    {"fields", fields},
                    {"periodicities", periodic},
                    {"bounding_box", box},
                    {"topology", topology},
                    {"not_read", mesh.dropped}};
  return all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace cleave::app
