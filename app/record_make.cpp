#include <algorithm>
#include <cstring>

#include "cleave/topology/violation.hpp"
#include "cut_output.hpp"
#include "mesh_file.hpp"
#include "record.hpp"
#include "record_origin.hpp"

namespace cleave::app {
namespace {

bool same_bits(const double* a, const double* b, std::size_t count) {
  return count == 0 || std::memcmp(a, b, count * sizeof *a) == 0;
}

void add_number(std::vector<NumberRun>& runs, std::uint64_t place, std::uint64_t number) {
  if (!runs.empty() && runs.back().place + runs.back().count == place &&
      runs.back().first + runs.back().count == number)
    ++runs.back().count;
  else
    runs.push_back({place, number, 1});
}

bool distinct_and_positive(const Mesh& mesh) {
  std::vector<std::uint64_t> all;
  for (const Elements& elements : mesh.elements)
    all.insert(all.end(), elements.numbers.begin(), elements.numbers.end());
  if (!std::is_sorted(all.begin(), all.end())) std::sort(all.begin(), all.end());
  return all.empty() ||
         (all.front() > 0 && std::adjacent_find(all.begin(), all.end()) == all.end());
}

// For each element of the original its place in OUT; kNoPlace for those that are gone.
std::vector<Index> places_in_out(const Elements& original, const Elements& out) {
  std::vector<Index> place(original.size(), kNoPlace);
  Index next = 0;
  for (std::size_t e = 0; e < original.size(); ++e)
    if (next < out.size() && out.numbers[next] == original.numbers[e]) place[e] = next++;
  return place;
}

// Whether `elements` are those of OUT at `place`, by the points they come from.
bool agree(const std::vector<Index>& vertices, const std::vector<Index>& in_out, std::size_t width,
           const std::vector<Index>& place, const Origins& origins) {
  for (std::size_t e = 0; e < place.size(); ++e)
    for (std::size_t i = 0; place[e] != kNoPlace && i < width; ++i)
      if (origins.of[in_out[width * place[e] + i]] != vertices[width * e + i]) return false;
  return true;
}

OriginalRecord::Elements describe_elements(const Elements& original, const Elements& out,
                                           int dimension, const std::vector<Index>& place,
                                           bool numbers_held, const Origins& origins) {
  const auto corners = static_cast<std::size_t>(dimension) + 1, edges = corners * (corners - 1) / 2;
  if (!agree(original.vertices, out.vertices, corners, place, origins) ||
      (original.second_order() && !agree(original.midside, out.midside, edges, place, origins)))
    throw topology::InvariantBroken("an element of the output is not where its original was");
  OriginalRecord::Elements record;
  record.count = original.size();
  for (Index e = 0; e < original.size(); ++e) {
    if (place[e] == kNoPlace) {
      const auto slice = [&](const std::vector<Index>& all, std::size_t width) {
        const auto from = all.begin() + static_cast<std::ptrdiff_t>(width * e);
        return std::vector(from, from + static_cast<std::ptrdiff_t>(width));
      };
      record.gone.push_back({e, slice(original.vertices, corners),
                             slice(original.midside, original.second_order() ? edges : 0)});
    }
    if (place[e] == kNoPlace || !numbers_held) add_number(record.numbers, e, original.numbers[e]);
  }
  return record;
}

OriginalRecord::Group describe_group(const Group& group, const Mesh& out,
                                     const std::vector<Index>& place) {
  std::vector<Index> expected;  // of those that OUT has
  const auto same = [&](const Group& g) {
    return g.dimension == group.dimension && g.name == group.name;
  };
  const auto in_out = std::find_if(out.groups.begin(), out.groups.end(), same);
  if (in_out != out.groups.end())
    for (Index e = 0; e < place.size(); ++e)
      if (place[e] != kNoPlace &&
          std::binary_search(in_out->elements.begin(), in_out->elements.end(), place[e]))
        expected.push_back(e);
  OriginalRecord::Group record{group.name, group.dimension, group.tag, {}, {}};
  std::set_difference(group.elements.begin(), group.elements.end(), expected.begin(),
                      expected.end(), std::back_inserter(record.added));
  std::set_difference(expected.begin(), expected.end(), group.elements.begin(),
                      group.elements.end(), std::back_inserter(record.removed));
  return record;
}

// Fields of entities that are in OUT at `place`.
std::vector<OriginalRecord::Field> describe_fields(const std::vector<Field>& fields,
                                                   const std::vector<Field>& out,
                                                   const std::vector<Index>& place) {
  std::vector<OriginalRecord::Field> records;
  for (const Field& field : fields) {
    auto& record = records.emplace_back();
    record.name = field.name;
    record.components = field.components;
    record.integer = field.integer;
    const auto width = static_cast<std::size_t>(field.components);
    const auto same = [&](const Field& f) {
      return f.name == field.name && f.components == field.components;
    };
    const auto in_out = std::find_if(out.begin(), out.end(), same);
    record.held = in_out != out.end();
    for (std::size_t i = 0; record.held && i < place.size(); ++i)
      if (place[i] != kNoPlace)
        record.held = same_bits(&field.values[width * i], &in_out->values[width * place[i]], width);
    for (std::size_t i = 0; i < place.size(); ++i)
      if (!record.held || place[i] == kNoPlace)
        record.values.insert(record.values.end(), &field.values[width * i],
                             &field.values[width * i] + width);
  }
  return records;
}

// Whether the vertex elements of `out` are what Medit has: marks of the vertices themselves, so one
// in a group for each vertex that has any, in their order.
bool are_marks(const Mesh& out) {
  const Elements& elements = out.elements[0];
  std::vector<bool> grouped(elements.size());
  for (const Group& group : out.groups)
    if (group.dimension == 0)
      for (const Index e : group.elements) grouped[e] = true;
  for (std::size_t e = 0; e < elements.size(); ++e)
    if (!grouped[e] || (e > 0 && elements.vertices[e] <= elements.vertices[e - 1])) return false;
  return true;
}

}  // namespace

Held held_by(const std::filesystem::path& path, const Mesh& out) {
  const MeshFormat format = format_of(path);
  Held held;
  held.numbers = numbering_of(path) == Numbering::kept;
  const bool vtk = format == MeshFormat::kVtu || format == MeshFormat::kVtk;
  if (vtk || format == MeshFormat::kGmsh) held.elements = {true, true, true, true};
  if (format == MeshFormat::kMedit) held.elements = {are_marks(out), true, true, true};
  if (format == MeshFormat::kTetgen || format == MeshFormat::kAbaqus)
    held.elements = {false, true, true, true};
  return held;
}

OriginalRecord describe_original(const Mesh& original, const Mesh& out,
                                 const std::vector<Index>& origin, Held held) {
  const Origins origins(origin, original.points.size());
  OriginalRecord record;
  record.vertices = original.points.size();
  for (const Index place : origin) {
    auto& runs = record.origins;
    if (!runs.empty() && runs.back().first + runs.back().count == place)
      ++runs.back().count;
    else
      runs.push_back({place, 1});
  }
  for (Index p = 0; p < original.points.size(); ++p) {
    const Index stays = origins.first[p];
    if (stays == kNoPlace || !same_bits(out.points[stays].data(), original.points[p].data(), 3))
      record.points.push_back({p, original.points[p]});
    if (stays == kNoPlace || out.vertex_numbers[stays] != original.vertex_numbers[p])
      add_number(record.vertex_numbers, p, original.vertex_numbers[p]);
  }

  const bool numbers_held = held.numbers && distinct_and_positive(out);
  std::array<std::vector<Index>, 4> place;
  for (std::size_t d = 0; d <= static_cast<std::size_t>(original.dimension); ++d) {
    place[d] = places_in_out(original.elements[d], out.elements[d]);
    if (!held.elements[d] && d < static_cast<std::size_t>(original.dimension))
      place[d].assign(place[d].size(), kNoPlace);
    record.elements[d] = describe_elements(original.elements[d], out.elements[d],
                                           static_cast<int>(d), place[d], numbers_held, origins);
  }
  for (const Group& group : original.groups)
    record.groups.push_back(
        describe_group(group, out, place[static_cast<std::size_t>(group.dimension)]));
  record.point_fields = describe_fields(original.point_fields, out.point_fields, origins.first);
  record.cell_fields = describe_fields(original.cell_fields, out.cell_fields,
                                       place[static_cast<std::size_t>(original.dimension)]);
  record.facet_fields = describe_fields(original.facet_fields, out.facet_fields,
                                        place[static_cast<std::size_t>(original.dimension - 1)]);
  record.cohesive = original.cohesive;
  if (!same_pairs(without_copies(out.periodic, origins), original.periodic))
    record.periodic = original.periodic;
  record.two_dimensional_points = original.two_dimensional_points;
  record.msh_version = original.msh_version;
  record.msh_binary = original.msh_binary;
  return record;
}

}  // namespace cleave::app
