#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "error.hpp"
#include "files/midside.hpp"
#include "files/row.hpp"
#include "files/tetgen.hpp"

namespace cleave::app {
namespace {

constexpr std::array<const char*, 4> kKind = {"vertex", "edge", "triangle", "tetrahedron"};

/// The columns that follow the vertices of an element, and the values they hold.
struct Columns {
  explicit Columns(std::size_t count) : values(count) {}
  std::vector<std::vector<double>> values;  // by column

  void read(Row& row) {
    for (auto& column : values) column.push_back(row.number<double>("an attribute"));
  }

  /// The columns from `first` on as fields.
  std::vector<Field> fields(std::size_t first) {
    std::vector<Field> all;
    for (std::size_t c = first; c < values.size(); ++c)
      all.push_back({"attribute_" + std::to_string(c - first + 1), 1, std::move(values[c])});
    return all;
  }

  /// The first column as integers of groups, if it is that everywhere.
  std::optional<std::vector<std::int32_t>> groups() const {
    if (values.empty()) return {};
    std::vector<std::int32_t> integers;
    integers.reserve(values[0].size());
    for (const double value : values[0]) {
      if (!(std::abs(value) <= INT32_MAX) || value != std::trunc(value)) return {};
      integers.push_back(static_cast<std::int32_t>(value));
    }
    return integers;
  }
};

class TetgenReader {
 public:
  explicit TetgenReader(const TetgenTexts& texts) : texts_(texts) {}

  Mesh read() {
    mesh_.source = texts_.node.source();
    read_nodes();
    read_cells();
    if (mesh_.dimension == 3 && texts_.face != nullptr) read_lower(*texts_.face, 2);
    if (texts_.edge != nullptr) read_lower(*texts_.edge, 1);
    for (int d = 0; d <= 3; ++d)
      for (Group& group : groups_from_integers(d, integers_[static_cast<std::size_t>(d)]))
        mesh_.groups.push_back(std::move(group));
    return std::move(mesh_);
  }

 private:
  static RowReader rows_of(const InputText& text) {
    if (text.bytes().empty() || text.bytes().back() != '\n')
      text.fail(text.end(),
                "the last line has no line end: the file may be truncated; append one if it is "
                "complete");
    return {text, text.begin(), text.end(), '#'};
  }

  static void finish(RowReader& rows, const char* what) {
    if (rows.more())
      rows.next("nothing").fail("more rows than the " + std::string(what) +
                                " that the first line promises");
  }

  /// A count of the first line that may be left out, then 0.
  static std::size_t optional_count(const RowReader& rows, Row& row, const char* what) {
    return row.at_end() ? 0 : rows.count(row, what);
  }

  static bool flag(const RowReader& rows, Row& row, const char* what) {
    const std::size_t value = optional_count(rows, row, what);
    if (value > 1) row.fail(std::string(what) + " is " + std::to_string(value) + ", not 0 or 1");
    return value == 1;
  }

  /// Each row holds an attribute, which takes two bytes at least.
  static void require_room(const RowReader& rows, const Row& row, std::size_t count,
                           std::size_t attributes) {
    if (attributes > rows.text().bytes().size() / (2 * count))
      row.fail("the file is too short for " + std::to_string(attributes) + " attributes in " +
               std::to_string(count) + " rows");
  }

  void read_nodes() {
    RowReader rows = rows_of(texts_.node);
    Row head = rows.next("the number of points");
    const std::size_t count = rows.count(head, "the number of points");
    const std::size_t dimension = rows.count(head, "the number of coordinates");
    if (dimension != 2 && dimension != 3)
      head.fail("points of " + std::to_string(dimension) + " coordinates; they must have 2 or 3");
    if (count == 0) head.fail("the file holds no points");
    const std::size_t attributes = optional_count(rows, head, "the number of attributes");
    const bool marked = flag(rows, head, "the number of boundary markers");
    head.finish("counts");
    require_room(rows, head, count, attributes);
    mesh_.two_dimensional_points = dimension == 2;
    mesh_.points.reserve(count);
    Columns columns(attributes);
    std::vector<std::int32_t> markers(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
      Row row = rows.next("a point");
      read_number(row, i, "point");
      std::array<double, 3> point{};
      point[0] = row.number<double>("the x coordinate of a point");
      point[1] = row.number<double>("the y coordinate of a point");
      if (dimension == 3) point[2] = row.number<double>("the z coordinate of a point");
      columns.read(row);
      if (marked) markers[i] = row.number<std::int32_t>("the boundary marker of a point");
      row.finish("a point");
      mesh_.points.push_back(point);
    }
    finish(rows, "points");
    mesh_.vertex_numbers = numbers(count);
    mesh_.point_fields = columns.fields(0);
    integers_[0] = mark_vertices(mesh_, markers);
  }

  /// Numbers are consecutive, from that of the first point on, which is 0 or 1.
  void read_number(Row& row, std::size_t place, const char* kind) {
    const auto number = row.number<std::uint64_t>("a number");
    if (!first_) {
      if (number > 1)
        row.fail("the first point has number " + std::to_string(number) +
                 "; numbers start from 0 or 1");
      first_ = number;
    }
    if (number != *first_ + place)
      row.fail(std::string(kind) + " number " + std::to_string(number) + " where " +
               std::to_string(*first_ + place) + " comes next; numbers must be consecutive, from " +
               std::to_string(*first_) + " on in all files");
  }

  std::vector<std::uint64_t> numbers(std::size_t count) const {
    std::vector<std::uint64_t> all(count);
    for (std::size_t i = 0; i < count; ++i) all[i] = *first_ + i;
    return all;
  }

  Index vertex(Row& row) const {
    const auto number = row.number<std::uint64_t>("the number of a point");
    if (number < *first_ || number - *first_ >= mesh_.points.size())
      row.fail("there is no point " + std::to_string(number) + "; " + texts_.node.source() +
               " has the numbers " + std::to_string(*first_) + " to " +
               std::to_string(*first_ + mesh_.points.size() - 1));
    return static_cast<Index>(number - *first_);
  }

  /// The vertices of an element, and its nodes of second order where it has them.
  void read_vertices(Row& row, int dimension, bool second_order) {
    Elements& elements = mesh_.elements[static_cast<std::size_t>(dimension)];
    for (int k = 0; k <= dimension; ++k) elements.vertices.push_back(vertex(row));
    if (!second_order) return;
    std::array<Index, 6> nodes{};
    const std::size_t edges = edges_of_simplex(static_cast<std::size_t>(dimension));
    for (std::size_t k = 0; k < edges; ++k) nodes[k] = vertex(row);
    add_midside(elements, static_cast<std::size_t>(dimension), kTetgenMidside,
                std::span(nodes).first(edges));
  }

  void read_cells() {
    RowReader rows = rows_of(texts_.ele);
    Row head = rows.next("the number of cells");
    const std::size_t count = rows.count(head, "the number of cells");
    const std::size_t nodes = rows.count(head, "the number of nodes per cell");
    const bool flat = mesh_.two_dimensional_points;
    second_order_ = nodes == (flat ? 6 : 10);
    if (!second_order_ && nodes != (flat ? 3 : 4))
      head.fail("cells of " + std::to_string(nodes) + " nodes in a mesh of " +
                (flat ? "2 coordinates; triangles have 3 or 6" : "3; tetrahedra have 4 or 10"));
    if (count == 0) head.fail("the file holds no cells");
    const std::size_t attributes = optional_count(rows, head, "the number of attributes");
    head.finish("counts");
    require_room(rows, head, count, attributes);
    mesh_.dimension = flat ? 2 : 3;
    const auto d = static_cast<std::size_t>(mesh_.dimension);
    Columns columns(attributes);
    mesh_.elements[d].vertices.reserve((d + 1) * count);
    for (std::size_t i = 0; i < count; ++i) {
      Row row = rows.next("a cell");
      read_number(row, i, kKind[d]);
      read_vertices(row, mesh_.dimension, second_order_);
      columns.read(row);
      row.finish("a cell");
    }
    finish(rows, "cells");
    mesh_.elements[d].numbers = numbers(count);
    auto groups = columns.groups();
    mesh_.cell_fields = columns.fields(groups ? 1 : 0);
    if (groups) integers_[d] = std::move(*groups);
  }

  /// Faces of tetrahedra, or edges. How many columns a row has is told by its length: TetGen adds
  /// nodes for -o2 and neighbours for -nn, neither of which the first line mentions.
  void read_lower(const InputText& text, int dimension) {
    RowReader rows = rows_of(text);
    const auto d = static_cast<std::size_t>(dimension);
    Row head = rows.next("a number of elements");
    const std::size_t count = rows.count(head, "a number of elements");
    const bool marked = flag(rows, head, "the number of boundary markers");
    head.finish("counts");
    std::vector<std::int32_t> markers(count, 0);
    std::optional<std::size_t> width;
    for (std::size_t i = 0; i < count; ++i) {
      Row row = rows.next("an element");
      const std::size_t columns = columns_of(row);
      if (!width) width = columns;
      if (columns != *width)
        row.fail("a row of " + std::to_string(columns) + " columns, but the first has " +
                 std::to_string(*width));
      read_number(row, i, kKind[d]);
      const Extra extra = extra_columns(row, dimension, columns - (marked ? 1 : 0) - 1);
      read_vertices(row, dimension, extra.second_order);
      if (marked) markers[i] = row.number<std::int32_t>("a boundary marker");
      for (std::size_t k = 0; k < extra.neighbours; ++k)
        row.number<std::int64_t>("the number of a neighbour");
      row.finish("an element");
    }
    finish(rows, "elements");
    mesh_.elements[d].numbers = numbers(count);
    integers_[d] = std::move(markers);
  }

  static std::size_t columns_of(Row row) {
    std::size_t columns = 0;
    for (; !row.at_end(); row.word()) ++columns;
    return columns;
  }

  struct Extra {
    bool second_order;
    std::size_t neighbours;
  };

  /// What `columns` columns, without number and marker, are.
  Extra extra_columns(const Row& row, int dimension, std::size_t columns) const {
    const auto corners = static_cast<std::size_t>(dimension) + 1;
    const std::size_t edges = edges_of_simplex(corners - 1);
    const std::size_t neighbours = mesh_.dimension == 3 ? edges == 3 ? 2 : 1 : 0;
    if (second_order_ && columns == corners + edges) return {true, 0};
    if (second_order_ && columns == corners + edges + neighbours) return {true, neighbours};
    if (columns == corners) return {false, 0};
    if (columns == corners + neighbours) return {false, neighbours};
    row.fail("a row of the wrong length: a " + std::string(kKind[corners - 1]) + " has " +
             std::to_string(corners) + " points" +
             (second_order_ ? " or, of second order, " + std::to_string(corners + edges) : ""));
  }

  const TetgenTexts& texts_;
  Mesh mesh_;
  std::optional<std::uint64_t> first_;
  bool second_order_ = false;
  std::array<std::vector<std::int32_t>, 4> integers_;  // of groups, by dimension
};

/// The text of a file that may be absent.
std::optional<InputText> text_if_there(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return {};
  return InputText(path);
}

}  // namespace

TetgenPaths tetgen_paths(const std::filesystem::path& path) {
  const auto with = [&](const char* extension) {
    std::filesystem::path other = path;
    return other.replace_extension(extension);
  };
  return {with(".node"), with(".ele"), with(".face"), with(".edge")};
}

Mesh read_tetgen(const TetgenTexts& texts) { return TetgenReader(texts).read(); }

Mesh read_tetgen(const std::filesystem::path& path) {
  if (is_gzip_name(path))
    throw InputError("'" + path.string() +
                     "': TetGen's files are read as they are, not compressed; unpack them first");
  const TetgenPaths paths = tetgen_paths(path);
  const InputText node(paths.node), ele(paths.ele);
  const auto face = text_if_there(paths.face), edge = text_if_there(paths.edge);
  Mesh mesh = read_tetgen({node, ele, face ? &*face : nullptr, edge ? &*edge : nullptr});
  mesh.source = path.string();
  return mesh;
}

}  // namespace cleave::app
