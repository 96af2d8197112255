#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cleave/cutting/select.hpp"
#include "cleave/fem/lame.hpp"

namespace cleave::app {

using Point3 = std::array<double, 3>;

/// A cube (a box) of nodes[0] x nodes[1] x nodes[2] vertices with one corner at the origin, each
/// small box divided into the six tetrahedra of Kuhn. Vertices and cells are numbered from 0, x
/// fastest.
struct CubeSpec {
  std::array<std::uint64_t, 3> nodes{};
  Point3 size{};
};

/// A mesh file (path resolved against the folder of the scene), or a mesh to generate.
using MeshSpec = std::variant<std::filesystem::path, CubeSpec>;

/// A part of the body, at rest and before any stroke.
struct GroupName {
  std::string name;              // a group of the file
  std::optional<int> dimension;  // needed only if groups of several dimensions have that name
};
struct Box {
  Point3 low{}, high{};  // both ends belong to it
};
struct HalfSpace {
  Point3 point{}, normal{};  // where (x - point) . normal >= 0: the side the normal points into
};
struct VertexNumbers {
  std::vector<std::uint64_t> numbers;  // the file's own
};
struct Where {
  std::variant<GroupName, Box, HalfSpace, VertexNumbers> place;
  std::string at;  // JSON pointer of the entry, to be quoted in messages
};

/// One isotropic material; `density` is needed by gravity alone.
struct MaterialSpec {
  fem::Lame lame;
  std::optional<double> density;
  std::string group;  // the cell group it fills; empty: every cell
  std::string at;
};

/// Prescribed displacement: `value` for each of the coordinates 0, 1, 2 in `axes`.
struct SupportSpec {
  Where where;
  std::array<bool, 3> axes{};
  double value = 0.0;
};

struct LoadSpec {
  enum class Kind {
    force,        // newtons at each vertex of `where`
    total_force,  // newtons, shared by the vertices of `where` in proportion to star volumes
    traction,     // newtons per undeformed area on the boundary facets in `where`
    gravity       // acceleration of the cells in `where` (of all, without `where`)
  };
  Kind kind{};
  std::optional<Where> where;  // only gravity may do without
  Point3 vector{};
  std::optional<double> density;  // gravity: instead of the material's
  std::string at;
};

/// What one stroke cuts: along a blade's path, named facets, or groups of facets.
struct BladePath {
  std::vector<std::array<Point3, 2>> positions;  // successive positions of the blade's two ends
};
struct FacetList {
  std::vector<std::array<std::uint64_t, 3>> facets;  // the file's own vertex numbers
};
struct GroupNames {
  std::vector<std::string> names;
};
struct StrokeSpec {
  std::string name;  // to be shown; "stroke 1", .. if the scene gives none
  std::variant<BladePath, FacetList, GroupNames> path;
  cutting::SelectOptions select;  // a blade's alone
  std::string at;
};

struct SolveSpec {
  enum class Norm { residual, energy };
  enum class Preconditioner { none, jacobi };
  enum class Unsupported { refuse, modulo_free_modes };
  double tolerance = 1e-8;  // relative, in `norm`
  Norm norm = Norm::residual;
  Preconditioner preconditioner = Preconditioner::jacobi;
  std::uint64_t max_iterations = 20000;
  Unsupported on_unsupported = Unsupported::refuse;
};

struct OutputSpec {
  enum class Frames { states, final_only };
  bool vtu = true;  // final.vtu, and with Frames::states one file per state
  Frames frames = Frames::states;
  bool page = false;  // index.html
};

/// A scene: what to load or make, hold, pull, cut, solve and write. All parts but the mesh are
/// optional; one that is not named is not built.
struct Scene {
  std::string source;  // the file, to be quoted in messages
  std::string title;   // the scene's own, or the file's stem
  MeshSpec mesh;
  std::string length_unit;  // of the mesh's coordinates, to be shown; nothing is converted
  std::vector<MaterialSpec> materials;  // one for every cell, or one per group
  std::vector<SupportSpec> supports;
  std::vector<LoadSpec> loads;
  std::vector<StrokeSpec> strokes;
  std::optional<SolveSpec> solve;
  OutputSpec output;
};

/// Reads a scene strictly. Throws InputError that names file, place (JSON pointer; line for a
/// syntax error) and what is known there, for: a file that cannot be read, an unknown or repeated
/// key, a wrong type, an unknown value, a number that is not finite, a material that is not
/// positive, parts that need another (supports, loads and solve need a material). Groups, vertex
/// numbers and the mesh file itself are looked at later, where the mesh is known.
Scene read_scene(const std::filesystem::path& file);

/// The same from text; paths are relative to `folder`.
Scene parse_scene(std::string_view text, const std::string& source,
                  const std::filesystem::path& folder);

}  // namespace cleave::app
