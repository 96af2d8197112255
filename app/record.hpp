#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mesh.hpp"

/// The incision record OUT.cleave.json that `cut` writes beside OUT: what it takes to get the mesh
/// that was cut back from OUT, and what has been asked for. Since OUT is a function of these two,
/// whoever has the record can go on cutting, or take facets back, as if everything had been asked
/// for at once. Its size goes with the cut and with the elements below the cells that the cut
/// changed; of numbers that OUT cannot hold it keeps runs. docs/cutting.md,
/// docs/schemas/cleave-incision-1.schema.json
namespace cleave::app {

/// Whole numbers from `first` on.
struct Run {
  std::uint64_t first = 0, count = 0;
  friend bool operator==(const Run&, const Run&) = default;
};

/// The entries from `place` on have the numbers from `first` on.
struct NumberRun {
  std::uint64_t place = 0, first = 0, count = 0;
  friend bool operator==(const NumberRun&, const NumberRun&) = default;
};

/// What OUT does not say of the mesh that was cut, the original. Places count from 0: of points in
/// Mesh::points, of elements in Mesh::elements of their dimension.
struct OriginalRecord {
  struct Point {
    Index place;
    std::array<double, 3> point;
  };
  struct Element {  // that OUT does not have
    Index place;
    std::vector<Index> vertices, midside;  // places of points
  };
  struct Elements {
    std::uint64_t count = 0;         // of the original
    std::vector<Element> gone;       // ascending; the others are the first ones of OUT, in order
    std::vector<NumberRun> numbers;  // those that are not the number in OUT
  };
  struct Group {
    std::string name;
    int dimension = 0;
    std::int32_t tag = 0;
    std::vector<Index> added, removed;  // against the group of OUT with this name, from
                                        // which elements that are new in OUT are left out
  };
  struct Field {
    std::string name;
    int components = 1;
    bool integer = false;
    bool held = true;            // OUT has the values of what OUT has
    std::vector<double> values;  // of the points (or elements) that OUT does not have; of all if
                                 // not `held`
  };

  std::uint64_t vertices = 0;             // points of the original
  std::vector<Run> origins;               // for OUT's points in order: places in the original
  std::vector<Point> points;              // where OUT has none, or another one; ascending
  std::vector<NumberRun> vertex_numbers;  // those that are not the number in OUT
  std::array<Elements, 4> elements;       // by dimension, up to that of the cells
  std::vector<Group> groups;              // all, in order
  std::vector<Field> point_fields, cell_fields, facet_fields;
  CohesiveElements cohesive;
  std::optional<std::vector<Periodicity>> periodic;  // none: what OUT has, without copies
  bool two_dimensional_points = false;
  MshVersion msh_version = MshVersion::k41;
  bool msh_binary = false;
};

/// What the format of `path` gives back of the numbers and elements of `out` when it is read.
struct Held {
  bool numbers = false;            // of vertices and elements, if they are distinct
  std::array<bool, 4> elements{};  // by dimension: every element, in order
};
Held held_by(const std::filesystem::path& path, const Mesh& out);

/// What `out`, a file in which `held` is held, does not say of `original`. `origin` has for each
/// point of `out` its place in `original`; the first point from a place is the one that stays.
/// Elements of `out` that are in `original` come first, in its order, and have its numbers. Time:
/// linear, and sorting numbers.
OriginalRecord describe_original(const Mesh& original, const Mesh& out,
                                 const std::vector<Index>& origin, Held held);

/// The mesh that was cut. Throws InputError, which begins with `source`, the name of the record, if
/// the record does not fit `out`. Time and memory: linear in `out` and the record.
Mesh restore_original(const OriginalRecord& record, const Mesh& out, const std::string& source);

/// Two half-facets of the original that are mates there.
using FacetSides = std::pair<Index, Index>;

struct IncisionRecord {
  std::map<std::string, std::string> sha256;  // of the files that OUT is: by what their names have
                                              // after the stem of OUT (".msh", ".vtu.groups.json")
  int dimension = 0;
  std::uint64_t cells = 0;
  OriginalRecord original;
  std::vector<FacetSides> opened, shut;  // the scored facets, lesser half-facet first, ascending
  std::vector<std::string> groups;       // facet groups of the original asked for, by name
  std::vector<Index> others;             // scored facets asked for otherwise: lesser half-facets
  bool cohesive = false;                 // OUT has cohesive elements between the sides
  double offset = 0;                     // by which the sides are apart in OUT
};

/// The file that the record of the mesh file at `mesh_path` has the hash of by `suffix`, and back.
std::filesystem::path hashed_path(const std::filesystem::path& mesh_path,
                                  const std::string& suffix);
std::string hashed_suffix(const std::filesystem::path& mesh_path,
                          const std::filesystem::path& file);

/// Where the record of a mesh file is: beside the file itself, also if `mesh_path` is a link to it.
std::filesystem::path record_path(const std::filesystem::path& mesh_path);

/// docs/schemas/cleave-incision-1.schema.json. Nothing if a name is not UTF-8, which JSON needs.
std::optional<std::string> json_of(const IncisionRecord& record);

/// Reads a record strictly; whether it fits a mesh is not its business. Throws InputError.
IncisionRecord read_record(const std::filesystem::path& path);

}  // namespace cleave::app
