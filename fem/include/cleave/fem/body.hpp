#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "cleave/fem/lame.hpp"
#include "cleave/topology/complex.hpp"

namespace cleave::fem {

/// Undeformed places of the vertices, one per vertex of a complex, in metres (or any one unit).
using Points = std::span<const std::array<double, 3>>;

/// What a body is made of: materials[of_cell[c]] is the material of cell c.
struct Materials {
  std::vector<Lame> table;
  std::vector<std::uint32_t> of_cell;

  /// One material for all cells.
  static Materials uniform(std::size_t cell_count, const Lame& material) {
    return {{material}, std::vector<std::uint32_t>(cell_count, 0)};
  }
};

/// A vertex of a cell has a coordinate that is NaN or infinite.
struct PointNotFinite {
  topology::VertexId vertex;
  topology::CellId cell;  // a cell that uses it
};
/// The volume of a cell is zero, or too small for its sign to be sure in double precision:
/// |det| <= 16 epsilon times the product of the three edges at its first vertex.
struct FlatCell {
  topology::CellId cell;
};
/// A cell is turned inside out against the others of its piece.
struct InvertedCell {
  topology::CellId cell;
};
/// Entry `material` of the table has no positive energy (see require_positive).
struct BadMaterial {
  std::uint32_t material;
  Lame value;
};
/// A cell names a material that the table does not have.
struct UnknownMaterial {
  topology::CellId cell;
  std::uint32_t material;
};

using BodyFlaw = std::variant<PointNotFinite, FlatCell, InvertedCell, BadMaterial, UnknownMaterial>;

/// One line of plain words with the 0-based ids of the witness.
std::string describe(const BodyFlaw& flaw);

/// Thrown by what needs a sound body. `flaws` are those that `check_body` gives.
class InvalidBody : public std::invalid_argument {
 public:
  explicit InvalidBody(std::vector<BodyFlaw> all);
  std::vector<BodyFlaw> flaws;
};

/// All flaws of the geometry, ordered by cell: points that are not finite, flat cells, and cells
/// inverted against the majority of the sound cells of their piece (on a tie: those that are
/// negative by the sign of the cell). Throws std::invalid_argument unless there is one point per
/// vertex. Time: linear.
std::vector<BodyFlaw> check_body(const topology::Complex<3>& k, Points points);

/// All flaws of the materials: bad entries of the table, then cells that name none of it. Throws
/// std::invalid_argument unless there is one entry per cell. Time: linear.
std::vector<BodyFlaw> check_materials(const topology::Complex<3>& k, const Materials& materials);

/// The volume of a cell, in cubic units of the points; never negative.
double cell_volume(const topology::Complex<3>& k, Points points, topology::CellId cell);

/// Per vertex, the sum of the volumes of the cells around it (0 for one that no cell uses).
std::vector<double> star_volumes(const topology::Complex<3>& k, Points points);

}  // namespace cleave::fem
