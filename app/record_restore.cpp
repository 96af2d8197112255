#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "error.hpp"
#include "record.hpp"
#include "record_origin.hpp"

namespace cleave::app {
namespace {

// Puts the original together; whatever of the record does not fit is refused.
class Restoration {
 public:
  Restoration(const OriginalRecord& record, const Mesh& out, const std::string& source)
      : record_(record), out_(out), source_(source), origins_(origins_of_points()) {}

  Mesh original() const {
    Mesh mesh;
    mesh.source = out_.source;
    mesh.dimension = out_.dimension;
    mesh.two_dimensional_points = record_.two_dimensional_points;
    mesh.msh_version = record_.msh_version;
    mesh.msh_binary = record_.msh_binary;
    restore_points(mesh);
    std::array<std::vector<Index>, 4> place;  // in OUT, of each element; kNoPlace: none
    for (std::size_t d = 0; d < 4; ++d)
      mesh.elements[d] = elements(static_cast<int>(d), record_.elements[d], place[d]);
    if (mesh.cells().size() != out_.cells().size()) fail("it has another number of cells");
    for (const auto& group : record_.groups)
      mesh.groups.push_back(restored(group, place[static_cast<std::size_t>(group.dimension)]));
    mesh.point_fields = fields(record_.point_fields, out_.point_fields, origins_.first);
    mesh.cell_fields = fields(record_.cell_fields, out_.cell_fields,
                              place[static_cast<std::size_t>(mesh.dimension)]);
    mesh.facet_fields = fields(record_.facet_fields, out_.facet_fields,
                               place[static_cast<std::size_t>(mesh.dimension - 1)]);
    mesh.cohesive = record_.cohesive;
    require_places(mesh.cohesive.vertices);
    mesh.periodic = record_.periodic ? *record_.periodic : without_copies(out_.periodic, origins_);
    for (const Periodicity& condition : mesh.periodic)
      for (const auto& pair : condition.pairs) require_places({pair.vertex, pair.master});
    return mesh;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format(
        "{}: this record does not fit {}: {}; restore both files, or give --forget (or remove the "
        "record) to start anew from the mesh as it is",
        source_, out_.source, what));
  }

  Origins origins_of_points() const {
    if (record_.vertices > out_.points.size() + record_.points.size())
      fail("it speaks of more vertices than there are");
    std::vector<Index> of;
    of.reserve(out_.points.size());
    for (const Run& run : record_.origins) {
      if (run.count > out_.points.size() - of.size() || run.first > record_.vertices ||
          run.count > record_.vertices - run.first)
        fail("it speaks of vertices that are not there");
      for (std::uint64_t i = 0; i < run.count; ++i) of.push_back(static_cast<Index>(run.first + i));
    }
    if (of.size() != out_.points.size()) fail("it has another number of vertices");
    return {std::move(of), static_cast<std::size_t>(record_.vertices)};
  }

  void require_places(const std::vector<Index>& places) const {
    for (const Index place : places)
      if (place >= record_.vertices) fail("an element has a vertex that is not there");
  }

  void restore_points(Mesh& mesh) const {
    mesh.points.resize(record_.vertices);
    mesh.vertex_numbers.resize(record_.vertices);
    std::vector<bool> known(record_.vertices);
    for (std::size_t p = 0; p < known.size(); ++p) {
      const Index from = origins_.first[p];
      if (from == kNoPlace) continue;
      known[p] = true;
      mesh.points[p] = out_.points[from];
      mesh.vertex_numbers[p] = out_.vertex_numbers[from];
    }
    for (const auto& point : record_.points) {
      if (point.place >= known.size()) fail("a vertex is not there");
      known[point.place] = true;
      mesh.points[point.place] = point.point;
    }
    if (std::find(known.begin(), known.end(), false) != known.end())
      fail("it leaves out the place of a vertex");
    renumber(mesh.vertex_numbers, record_.vertex_numbers);
    auto numbers = mesh.vertex_numbers;
    std::sort(numbers.begin(), numbers.end());
    if (std::adjacent_find(numbers.begin(), numbers.end()) != numbers.end())
      fail("two vertices have the same number");
  }

  void renumber(std::vector<std::uint64_t>& numbers, const std::vector<NumberRun>& runs) const {
    for (const NumberRun& run : runs) {
      if (run.place > numbers.size() || run.count > numbers.size() - run.place)
        fail("it numbers what is not there");
      for (std::uint64_t i = 0; i < run.count; ++i) numbers[run.place + i] = run.first + i;
    }
  }

  Elements elements(int dimension, const OriginalRecord::Elements& record,
                    std::vector<Index>& place) const {
    const Elements& out = out_.elements[static_cast<std::size_t>(dimension)];
    const auto corners = static_cast<std::size_t>(dimension) + 1,
               edges = corners * (corners - 1) / 2;
    if (record.count < record.gone.size() || record.count - record.gone.size() > out.size())
      fail("it speaks of elements that are not there");
    const bool second_order = record.count > record.gone.size()
                                  ? out.second_order()
                                  : !record.gone.empty() && !record.gone.front().midside.empty();
    Elements restored;
    Index next = 0;
    auto gone = record.gone.begin();
    for (Index e = 0; e < record.count; ++e) {
      if (gone != record.gone.end() && gone->place == e) {
        if (gone->vertices.size() != corners || gone->midside.size() != (second_order ? edges : 0))
          fail("an element has the wrong number of vertices");
        require_places(gone->vertices);
        require_places(gone->midside);
        add(restored.vertices, gone->vertices);
        add(restored.midside, gone->midside);
        restored.numbers.push_back(0);
        place.push_back(kNoPlace);
        ++gone;
        continue;
      }
      if (next >= out.size()) fail("its elements are out of order");
      for (std::size_t i = 0; i < corners; ++i)
        restored.vertices.push_back(origins_.of[out.vertices[corners * next + i]]);
      for (std::size_t i = 0; second_order && i < edges; ++i)
        restored.midside.push_back(origins_.of[out.midside[edges * next + i]]);
      restored.numbers.push_back(out.numbers[next]);
      place.push_back(next++);
    }
    if (gone != record.gone.end()) fail("its elements are out of order");
    renumber(restored.numbers, record.numbers);
    return restored;
  }

  static void add(std::vector<Index>& to, const std::vector<Index>& more) {
    to.insert(to.end(), more.begin(), more.end());
  }

  Group restored(const OriginalRecord::Group& record, const std::vector<Index>& place) const {
    Group group{record.name, record.dimension, record.tag, {}};
    const auto same = [&](const Group& g) {
      return g.dimension == record.dimension && g.name == record.name;
    };
    const auto in_out = std::find_if(out_.groups.begin(), out_.groups.end(), same);
    const auto in_group = [&](Index e) {
      if (std::binary_search(record.added.begin(), record.added.end(), e)) return true;
      return in_out != out_.groups.end() && place[e] != kNoPlace &&
             std::binary_search(in_out->elements.begin(), in_out->elements.end(), place[e]) &&
             !std::binary_search(record.removed.begin(), record.removed.end(), e);
    };
    for (Index e = 0; e < place.size(); ++e)
      if (in_group(e)) group.elements.push_back(e);
    if (!record.added.empty() && record.added.back() >= place.size())
      fail("a group has an element that is not there");
    return group;
  }

  std::vector<Field> fields(const std::vector<OriginalRecord::Field>& records,
                            const std::vector<Field>& out, const std::vector<Index>& place) const {
    std::vector<Field> fields;
    for (const auto& record : records) {
      const auto same = [&](const Field& f) {
        return f.name == record.name && f.components == record.components;
      };
      const auto in_out = std::find_if(out.begin(), out.end(), same);
      if (record.held && in_out == out.end()) continue;  // the format has no fields
      const auto width = static_cast<std::size_t>(record.components);
      const auto from_record =
          record.held ? static_cast<std::size_t>(std::count(place.begin(), place.end(), kNoPlace))
                      : place.size();
      if (record.values.size() != width * from_record)
        fail(fmt::format("the field {} has another number of values", record.name));
      Field& field = fields.emplace_back(Field{record.name, record.components, {}, record.integer});
      auto next = record.values.begin();
      for (const Index at : place) {
        const bool held = record.held && at != kNoPlace;
        const auto from =
            held ? in_out->values.begin() + static_cast<std::ptrdiff_t>(width * at) : next;
        field.values.insert(field.values.end(), from, from + record.components);
        if (!held) next += record.components;
      }
    }
    return fields;
  }

  const OriginalRecord& record_;
  const Mesh& out_;
  const std::string& source_;
  const Origins origins_;
};

}  // namespace

Mesh restore_original(const OriginalRecord& record, const Mesh& out, const std::string& source) {
  return Restoration(record, out, source).original();
}

}  // namespace cleave::app
