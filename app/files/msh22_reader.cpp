#include <algorithm>
#include <array>

#include "files/msh_format.hpp"

namespace cleave::app {
namespace {

/// What is remembered of the row before, to notice that gmsh repeats an element once per physical
/// group of its geometrical entity.
struct RowBefore {
  int dimension = -1;
  std::int32_t physical = 0, entity = 0;
};

/// True if the last two elements of this dimension have the same vertices.
bool repeats_last(const Elements& elements, std::size_t corners) {
  const auto end = elements.vertices.end();
  std::array<std::uint32_t, 4> last{}, before{};
  std::copy(end - corners, end, last.begin());
  std::copy(end - 2 * corners, end - corners, before.begin());
  std::sort(last.begin(), last.begin() + corners);
  std::sort(before.begin(), before.begin() + corners);
  return last == before;
}

void drop_last(Elements& elements, std::size_t corners) {
  elements.vertices.resize(elements.vertices.size() - corners);
  elements.numbers.pop_back();
}

}  // namespace

void read_msh22_nodes(const InputText& text, const MshSection& section, MshContent& content) {
  RowReader rows(text, section.begin, section.end);
  Row header = rows.next("the number of nodes");
  const std::size_t count = rows.count(header, "the number of nodes");
  header.finish("the number of nodes");
  content.mesh.points.reserve(count);
  content.mesh.vertex_numbers.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    Row row = rows.next("a node");
    const auto number = row.number<std::uint64_t>("the number of a node");
    content.watched_node.look(row, number, "node");
    const auto x = row.number<double>("the x coordinate of a node");
    const auto y = row.number<double>("the y coordinate of a node");
    const auto z = row.number<double>("the z coordinate of a node");
    row.finish("a node");
    content.mesh.vertex_numbers.push_back(number);
    content.mesh.points.push_back({x, y, z});
  }
  if (rows.more()) rows.next("a node").fail("more nodes than the count says");
}

void read_msh22_elements(const InputText& text, const MshSection& section, MshContent& content) {
  RowReader rows(text, section.begin, section.end);
  Row header = rows.next("the number of elements");
  const std::size_t count = rows.count(header, "the number of elements");
  header.finish("the number of elements");
  RowBefore before;
  for (std::size_t i = 0; i < count; ++i) {
    Row row = rows.next("an element");
    const auto number = row.number<std::uint64_t>("the number of an element");
    const int dimension = msh_dimension(row, row.number<int>("the type of an element"), number);
    const auto tags = row.number<std::uint32_t>("the number of tags");
    RowBefore now{dimension, 0, 0};
    if (tags > 0) now.physical = msh_physical_tag(row);
    if (tags > 1) now.entity = row.number<std::int32_t>("a tag");
    for (std::uint32_t t = 2; t < tags; ++t) row.number<std::int32_t>("a tag");
    std::uint32_t place = content.add_element(row, dimension, number);
    Elements& elements = content.mesh.elements[static_cast<std::size_t>(dimension)];
    const auto corners = static_cast<std::size_t>(dimension) + 1;
    if (now.dimension == before.dimension && now.entity == before.entity &&
        now.physical != before.physical && repeats_last(elements, corners)) {
      drop_last(elements, corners);
      --place;
    }
    if (now.physical != 0) content.groups.add(dimension, now.physical, place);
    before = now;
  }
  if (rows.more()) rows.next("an element").fail("more elements than the count says");
}

}  // namespace cleave::app
