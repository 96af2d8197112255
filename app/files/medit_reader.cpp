#include <algorithm>
#include <array>
#include <optional>

#include "files/group_sets.hpp"
#include "files/medit.hpp"
#include "files/row.hpp"

namespace cleave::app {
namespace {

constexpr std::array<const char*, 4> kKind = {"vertex", "edge", "triangle", "tetrahedron"};

/// Sections that come as a count and so many rows, and say nothing about the elements themselves.
constexpr std::array kSkippedRows = {"Corners",
                                     "RequiredVertices",
                                     "Ridges",
                                     "RequiredEdges",
                                     "RequiredTriangles",
                                     "RequiredTetrahedra",
                                     "RequiredQuadrilaterals",
                                     "Normals",
                                     "NormalAtVertices",
                                     "NormalAtTriangleVertices",
                                     "NormalAtQuadrilateralVertices",
                                     "Tangents",
                                     "TangentAtVertices",
                                     "TangentAtEdges",
                                     "EdgesReference",
                                     "SubDomainFromMesh",
                                     "SubDomainFromGeom",
                                     "VertexOnGeometricVertex",
                                     "VertexOnGeometricEdge",
                                     "VertexOnGeometricTriangle",
                                     "VertexOnGeometricQuadrilateral",
                                     "EdgeOnGeometricEdge",
                                     "TriangleOnGeometricTriangle",
                                     "TriangleOnGeometricQuadrilateral",
                                     "QuadrilateralOnGeometricTriangle",
                                     "QuadrilateralOnGeometricQuadrilateral",
                                     "LocalParameters",
                                     "ParallelVertices",
                                     "ParallelTriangles"};

/// Keywords with one value.
constexpr std::array kSkippedValue = {"Geometry", "Identifier", "AngleOfCornerBound", "Iterations",
                                      "Time"};

/// Elements that are no simplices of order 1 or 2; harmless only where there are none.
constexpr std::array kRefused = {"Quadrilaterals", "Hexahedra",        "Hexaedra",    "Prisms",
                                 "Pentahedra",     "Pyramids",         "EdgesP3",     "TrianglesP3",
                                 "TetrahedraP3",   "QuadrilateralsQ2", "HexahedraQ2", "PrismsP2",
                                 "PyramidsP2"};

/// The sections of elements by dimension, of order 1 and 2.
constexpr std::array<const char*, 4> kOrder1 = {"Vertices", "Edges", "Triangles", "Tetrahedra"};
constexpr std::array<const char*, 4> kOrder2 = {"", "EdgesP2", "TrianglesP2", "TetrahedraP2"};

template <std::size_t N>
bool holds(const std::array<const char*, N>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

class MeditReader {
 public:
  explicit MeditReader(const InputText& text)
      : text_(text), rows_(text, text.begin(), text.end(), '#') {}

  Mesh read() {
    mesh_.source = text_.source();
    read_version();
    for (bool at_end = false; !at_end;) {
      if (!rows_.more())
        text_.fail(text_.end(),
                   "the file ends without the keyword End: it may be truncated; append a line End "
                   "if it is complete");
      Row row = rows_.next("a keyword");
      const std::string keyword(row.word());
      at_end = keyword == "End";
      if (at_end)
        row.finish("End");
      else
        read_section(keyword, row);
    }
    if (rows_.more()) rows_.next("nothing").fail("nothing may follow the keyword End");
    check_vertices();
    finish();
    return std::move(mesh_);
  }

 private:
  void read_version() {
    if (!rows_.more()) text_.fail_format("a Medit file: it holds only blank lines");
    Row row = rows_.next("MeshVersionFormatted");
    if (row.word() != "MeshVersionFormatted")
      text_.fail_format("a Medit file in text form, which starts with MeshVersionFormatted");
    const int version = value<int>(row, "the version of the format");
    if (version < 1 || version > 4)
      row.fail("MeshVersionFormatted is " + std::to_string(version) + "; known are 1 to 4");
  }

  /// The single value after a keyword, on the same line or on the next.
  template <class Number>
  Number value(Row& row, const char* what) {
    if (row.at_end()) row = rows_.next(what);
    const auto number = row.number<Number>(what);
    row.finish(what);
    return number;
  }

  std::size_t count(Row& row, const char* what, std::size_t least = 1) {
    if (row.at_end()) row = rows_.next(what);
    const std::size_t number = rows_.count(row, what, least);
    row.finish(what);
    return number;
  }

  void read_section(const std::string& keyword, Row& row) {
    if (keyword == "Dimension") return read_dimension(row);
    if (keyword == "Vertices") return read_vertices(row);
    for (std::size_t d = 1; d <= 3; ++d) {
      if (keyword == kOrder1[d]) return read_elements(d, 0, row);
      if (keyword == kOrder2[d]) return read_elements(d, d * (d + 1) / 2, row);
    }
    if (holds(kSkippedRows, keyword)) {
      const std::size_t rows = count(row, "the number of rows");
      for (std::size_t i = 0; i < rows; ++i) rows_.next("a row of the section");
    } else if (holds(kSkippedValue, keyword)) {
      if (row.at_end()) rows_.next("the value of the keyword");
    } else if (holds(kRefused, keyword)) {
      const Row keyword_row = row;
      if (count(row, "the number of elements") > 0)
        keyword_row.fail(keyword +
                         " are not simplices of order 1 or 2, the only elements Cleave works on; "
                         "split them into edges, triangles or tetrahedra first");
    } else {
      row.fail("unknown keyword '" + printable(keyword, 40) +
               "'; known are Dimension, Vertices, Edges, Triangles, Tetrahedra (and EdgesP2, "
               "TrianglesP2, TetrahedraP2), End and the "
               "sections that are skipped (Corners, Ridges, Normals, ...)");
    }
  }

  void read_dimension(Row& row) {
    if (dimension_) row.fail("a second Dimension");
    const Row keyword_row = row;
    dimension_ = value<int>(row, "the dimension");
    if (*dimension_ != 2 && *dimension_ != 3)
      keyword_row.fail("Dimension is " + std::to_string(*dimension_) + "; it must be 2 or 3");
  }

  void read_vertices(Row& row) {
    if (!dimension_) row.fail("Vertices before Dimension");
    require_first(0, row);
    const std::size_t count_of = count(row, "the number of vertices", 5);
    mesh_.points.reserve(count_of);
    references_[0].reserve(count_of);
    for (std::size_t i = 0; i < count_of; ++i) {
      Row vertex = rows_.next("a vertex");
      std::array<double, 3> point{};
      point[0] = vertex.number<double>("the x coordinate of a vertex");
      point[1] = vertex.number<double>("the y coordinate of a vertex");
      if (*dimension_ == 3) point[2] = vertex.number<double>("the z coordinate of a vertex");
      references_[0].push_back(vertex.number<std::int32_t>("the reference of a vertex"));
      vertex.finish("a vertex");
      mesh_.points.push_back(point);
    }
  }

  void read_elements(std::size_t dimension, std::size_t midside_count, Row& row) {
    require_first(dimension, row);
    const std::size_t count_of =
        count(row, "the number of elements", 2 * (dimension + 1 + midside_count));
    Elements& elements = mesh_.elements[dimension];
    elements.vertices.reserve((dimension + 1) * count_of);
    elements.midside.resize(midside_count * count_of);
    references_[dimension].reserve(count_of);
    for (std::size_t i = 0; i < count_of; ++i) {
      Row element = rows_.next("an element");
      for (std::size_t k = 0; k <= dimension; ++k) elements.vertices.push_back(vertex(element));
      for (std::size_t k = 0; k < midside_count; ++k)
        elements.midside[midside_count * i + medit_midside(dimension, k)] = vertex(element);
      references_[dimension].push_back(element.number<std::int32_t>("the reference of an element"));
      element.finish("an element");
    }
  }

  static Index vertex(Row& element) {
    const auto number = element.number<Index>("the number of a vertex");
    if (number == 0) element.fail("vertex number 0; vertices are numbered from 1 on");
    return number - 1;
  }

  void require_first(std::size_t dimension, const Row& row) {
    if (section_[dimension]) row.fail("a second section of this kind; join the two, in one order");
    section_[dimension] = row;
  }

  /// Vertex numbers are checked when all sections are known, since their order is free. Only a
  /// message needs the line, which is found again by walking over the section.
  void check_vertices() const {
    for (std::size_t dimension = 1; dimension <= 3; ++dimension) {
      const Elements& elements = mesh_.elements[dimension];
      check_places(dimension, elements.vertices, dimension + 1);
      check_places(dimension, elements.midside, dimension * (dimension + 1) / 2);
    }
  }

  void check_places(std::size_t dimension, const std::vector<Index>& places,
                    std::size_t per_element) const {
    const auto bad = std::find_if(places.begin(), places.end(),
                                  [&](auto v) { return v >= mesh_.points.size(); });
    if (bad == places.end()) return;
    const auto element = static_cast<std::size_t>(bad - places.begin()) / per_element;
    RowReader rows(text_, section_[dimension]->begin(), text_.end(), '#');
    Row row = rows.next("a section");
    row.word();
    if (row.at_end()) rows.next("a count");
    for (std::size_t i = 0; i < element; ++i) rows.next("an element");
    rows.next("an element")
        .fail(std::string(kKind[dimension]) + " " + std::to_string(element + 1) + " uses vertex " +
              std::to_string(std::uint64_t{*bad} + 1) + ", but the file has " +
              std::to_string(mesh_.points.size()) + " vertices");
  }

  void finish() {
    mesh_.two_dimensional_points = dimension_ == 2;
    if (dimension_ == 2 && !references_[3].empty())
      section_[3]->fail("tetrahedra in a file of Dimension 2; they need Dimension 3");
    number(mesh_.vertex_numbers, mesh_.points.size());
    references_[0] = mark_vertices(mesh_, references_[0]);
    for (std::size_t dimension = 0; dimension <= 3; ++dimension) {
      const auto& references = references_[dimension];
      if (dimension > 0) number(mesh_.elements[dimension].numbers, references.size());
      for (Group& group : groups_from_integers(static_cast<int>(dimension), references))
        mesh_.groups.push_back(std::move(group));
    }
  }

  static void number(std::vector<std::uint64_t>& numbers, std::size_t count) {
    numbers.resize(count);
    for (std::size_t i = 0; i < count; ++i) numbers[i] = i + 1;
  }

  const InputText& text_;
  RowReader rows_;
  Mesh mesh_;
  std::optional<int> dimension_;
  std::array<std::optional<Row>, 4> section_;  // the row of its keyword
  std::array<std::vector<std::int32_t>, 4> references_;
};

}  // namespace

Mesh read_medit(const InputText& text) { return MeditReader(text).read(); }

}  // namespace cleave::app
