#pragma once
#include <array>
#include <cstddef>
#include <map>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "cleave/support/cuts.hpp"
#include "cleave/support/defects.hpp"
#include "cleave/support/random_meshes.hpp"

namespace cleave::topology {

/// What a case is an instance of, as the references see it.
enum class Mark {
  split,      // the cut gives new vertices
  shut,       // a facet of the cut stays interior
  branching,  // three facets of the cut or more meet in a ridge
  pinched,    // the mesh is not cut-regular before it is assembled
  closed,     // the mesh has no boundary
  pieces      // the mesh has several pieces
};

inline constexpr std::array<Mark, 6> kMarks{Mark::split,   Mark::shut,   Mark::branching,
                                            Mark::pinched, Mark::closed, Mark::pieces};

/// For D = 1 a facet is a vertex: the two corners at it always separate, so nothing stays shut; a
/// star is one or two mates, so nothing is pinched; there are no ridges, so nothing branches.
bool can_occur(Mark mark, int dimension);

/// Counts what the properties have met. One per process: `coverage()`.
class Coverage {
 public:
  using Marks = std::array<bool, kMarks.size()>;

  void record(const std::string& property, int dimension, support::MeshClass mesh_class,
              support::CutClass cut_class, const Marks& marks);

  void record_defect(int dimension, support::Defect defect);

  /// Property x dimension x class of input: cases run and the share of each mark; then the shares
  /// of the classes of cuts per property and dimension, and of planted defects per dimension.
  void print(std::ostream& out) const;

  /// One line for each class of meshes, cuts or defects and each mark that less than 5 % of the
  /// cases of a property in one dimension belong to, though it can occur there. Judges no property
  /// with fewer than 100 cases, where 5 % means little.
  std::vector<std::string> gaps() const;

 private:
  struct Counts {
    std::size_t cases = 0;
    std::array<std::size_t, kMarks.size()> marks{};
  };
  struct Row {
    std::map<support::MeshClass, Counts> meshes;
    std::map<support::CutClass, std::size_t> cuts;
    Counts total() const;
  };
  std::map<std::pair<std::string, int>, Row> rows_;
  std::map<int, std::map<support::Defect, std::size_t>> defects_;  // by dimension
};

Coverage& coverage();

}  // namespace cleave::topology
