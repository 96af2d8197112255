#include <algorithm>
#include <array>
#include <cstring>

#include "files/msh_content.hpp"

namespace cleave::app {
namespace {

/// The count of a section, a line of text in both forms; so many rows of at least `least` bytes
/// follow.
std::size_t read_count(RowReader& rows, const char* what, std::size_t least) {
  Row header = rows.next(what);
  const std::size_t count = rows.count(header, what, least);
  header.finish(what);
  return count;
}

std::size_t read_count(BinaryRows& rows, const char* what, std::size_t least) {
  Row header = rows.line(what);
  const auto count = header.number<std::uint64_t>(what);
  header.finish(what);
  check_count(rows.text(), header.begin(), rows.end(), count, least, what);
  return static_cast<std::size_t>(count);
}

/// The elements of a 2.2 file in order. gmsh repeats an element once per physical group of its
/// geometrical entity; consecutive rows of one entity with the same vertices are one element.
class Elements22 {
 public:
  explicit Elements22(MshContent& content) : content_(content) {}

  /// Reads the tags and the nodes of an element from the rest of its row.
  template <class Row>
  void read(Row& row, const MshKind& kind, std::uint64_t number, std::uint32_t tag_count) {
    Before now{&kind, 0, 0};
    if (tag_count > 0) now.physical = msh_physical_tag(row);
    if (tag_count > 1) now.entity = row.template number<std::int32_t>("a tag");
    for (std::uint32_t t = 2; t < tag_count; ++t) row.template number<std::int32_t>("a tag");
    const bool may_repeat = now.kind == before_.kind && now.entity == before_.entity &&
                            now.physical != before_.physical;
    before_ = now;
    kind.cohesive ? read_cohesive(row, number, may_repeat) : read_simplex(row, number, may_repeat);
  }

 private:
  struct Before {
    const MshKind* kind = nullptr;
    std::int32_t physical = 0, entity = 0;
  };

  template <class Row>
  void read_simplex(Row& row, std::uint64_t number, bool may_repeat) {
    const MshKind& kind = *before_.kind;
    Index place = content_.add_element<true>(row, kind, number);
    Elements& elements = content_.mesh.elements[static_cast<std::size_t>(kind.dimension)];
    if (may_repeat && repeats_last(elements.vertices, kind.corners)) {
      elements.vertices.resize(elements.vertices.size() - kind.corners);
      elements.midside.resize(elements.midside.size() - kind.midside);
      elements.numbers.pop_back();
      --place;
      content_.repeated.push_back({number, kind.dimension, place});
    }
    if (before_.physical != 0) content_.groups.add(kind.dimension, before_.physical, place);
  }

  template <class Row>
  void read_cohesive(Row& row, std::uint64_t number, bool may_repeat) {
    const MshKind& kind = *before_.kind;
    content_.add_cohesive<true>(row, kind, number, before_.physical);
    MshCohesive& list = content_.cohesive[static_cast<std::size_t>(kind.dimension - 2)];
    if (!may_repeat || !repeats_last(list.vertices, kind.corners)) return;
    list.vertices.resize(list.vertices.size() - kind.corners);
    list.numbers.pop_back();
    list.tags.pop_back();
    list.places.pop_back();
    content_.repeated.push_back({number, MshRepeated::kCohesive, 0});
    content_.cohesive_in_several_groups = true;
  }

  static bool repeats_last(const std::vector<Index>& vertices, std::size_t corners) {
    if (vertices.size() < 2 * corners) return false;
    const auto end = vertices.end();
    const auto size = static_cast<std::ptrdiff_t>(corners);
    std::array<Index, 6> last{}, before{};
    std::copy(end - size, end, last.begin());
    std::copy(end - 2 * size, end - size, before.begin());
    std::sort(last.begin(), last.begin() + size);
    std::sort(before.begin(), before.begin() + size);
    return last == before;
  }

  MshContent& content_;
  Before before_;
};

void read_rows(RowReader& rows, std::size_t count, MshContent& content) {
  Elements22 elements(content);
  for (std::size_t i = 0; i < count; ++i) {
    Row row = rows.next("an element");
    const auto number = row.number<std::uint64_t>("the number of an element");
    const MshKind& kind = msh_kind(row, row.number<int>("the type of an element"), number);
    elements.read(row, kind, number, row.number<std::uint32_t>("the number of tags"));
  }
  if (rows.more()) rows.next("an element").fail("more elements than the count says");
}

/// In binary a header says what so many rows have in common.
void read_rows(BinaryRows& rows, std::size_t count, MshContent& content) {
  Elements22 elements(content);
  for (std::size_t found = 0; found < count;) {
    BinaryRow header = rows.next("a header of elements");
    const auto type = header.number<std::int32_t>("the type of elements");
    const auto block = header.number<std::int32_t>("the number of elements");
    const auto tag_count = header.number<std::int32_t>("the number of tags");
    const MshKind& kind = msh_kind(header, type, std::nullopt);
    if (block <= 0 || tag_count < 0 || static_cast<std::size_t>(block) > count - found)
      header.fail("a header speaks of " + std::to_string(block) + " elements with " +
                  std::to_string(tag_count) + " tags; " + std::to_string(count - found) +
                  " elements are left");
    const std::size_t bytes = 4 * (1 + static_cast<std::size_t>(tag_count) + kind.nodes());
    check_count(rows.text(), rows.position(), rows.end(), static_cast<std::uint64_t>(block), bytes,
                "the number of elements");
    content.expect(kind, static_cast<std::size_t>(block));
    for (std::int32_t i = 0; i < block; ++i) {
      BinaryRow row = rows.next("an element");
      const std::uint64_t number = msh_number<true>(row, "the number of an element");
      elements.read(row, kind, number, static_cast<std::uint32_t>(tag_count));
    }
    found += static_cast<std::size_t>(block);
  }
}

}  // namespace

template <class Rows>
void read_msh22_nodes(Rows& rows, MshContent& content) {
  constexpr bool kBinary = std::is_same_v<Rows, BinaryRows>;
  const std::size_t count = read_count(rows, "the number of nodes", kBinary ? 28 : 7);
  content.mesh.points.reserve(count);
  content.mesh.vertex_numbers.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    auto row = rows.next("a node");
    const std::uint64_t number = msh_number<true>(row, "the number of a node");
    content.watched_node.look(row, number, "node");
    const auto x = row.template number<double>("the x coordinate of a node");
    const auto y = row.template number<double>("the y coordinate of a node");
    const auto z = row.template number<double>("the z coordinate of a node");
    row.finish("a node");
    content.mesh.vertex_numbers.push_back(number);
    content.mesh.points.push_back({x, y, z});
  }
  if (rows.more()) rows.next("a node").fail("more nodes than the count says");
}

template <class Rows>
void read_msh22_elements(Rows& rows, MshContent& content) {
  constexpr std::size_t kLeast = 5;  // bytes of a row, at least a point's
  const std::size_t count = read_count(rows, "the number of elements", kLeast);
  read_rows(rows, count, content);
}

template void read_msh22_nodes(RowReader&, MshContent&);
template void read_msh22_nodes(BinaryRows&, MshContent&);
template void read_msh22_elements(RowReader&, MshContent&);
template void read_msh22_elements(BinaryRows&, MshContent&);

void read_msh22_periodic(RowReader& rows, MshContent& content) {
  const std::size_t count = read_count(rows, "the number of periodic entities", 1);
  for (std::size_t i = 0; i < count; ++i) {
    Periodicity periodic;
    Row row = rows.next("a periodic entity");
    periodic.dimension = row.number<int>("the dimension of an entity");
    if (periodic.dimension < 0 || periodic.dimension > 2)
      row.fail("the dimension of a periodic entity must be 0, 1 or 2");
    periodic.entity = row.number<std::int32_t>("the number of an entity");
    periodic.master = row.number<std::int32_t>("the number of an entity");
    row.finish("a periodic entity");
    row = rows.next("the number of pairs of nodes");
    if (row.rest().substr(0, 6) == "Affine") {
      row.word();
      for (int k = 0; k < 16; ++k)
        periodic.affine.push_back(row.number<double>("a number of an affine map"));
      row.finish("an affine map");
      row = rows.next("the number of pairs of nodes");
    }
    const std::size_t pairs = rows.count(row, "the number of pairs of nodes", 3);
    row.finish("the number of pairs of nodes");
    const auto entity = static_cast<std::uint64_t>(std::abs(periodic.entity));
    periodic.pairs.reserve(pairs);
    for (std::size_t p = 0; p < pairs; ++p) {
      row = rows.next("a pair of nodes");
      const Index vertex = content.node<true>(row, "periodic entity", entity);
      periodic.pairs.push_back({vertex, content.node<true>(row, "periodic entity", entity)});
      row.finish("a pair of nodes");
    }
    content.mesh.periodic.push_back(std::move(periodic));
  }
  if (rows.more()) rows.next("a pair").fail("more periodic entities than the count says");
}

}  // namespace cleave::app
