#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cut_state.hpp"

namespace cleave::app {

/// All that `cleave cut` has to say. Numbers are those of MESH unless said otherwise.
struct CutReport {
  struct Copy {
    std::uint64_t vertex, parent;  // in OUT, in MESH
  };
  struct Because {
    std::uint64_t vertex;
    std::vector<std::uint64_t> through;  // cells
  };
  struct Fix {
    std::vector<std::vector<std::uint64_t>> facets;  // to be cut as well, so that it opens
    bool exact;                                      // no smaller set would do
    std::vector<std::vector<std::uint64_t>> kept;    // what needs these of --keep is not offered
  };
  struct Shut {
    std::vector<std::uint64_t> facet;  // vertices, ascending
    std::vector<Because> because;      // per vertex of the facet
    std::optional<Fix> fix;            // if asked for
  };
  struct Opened {
    std::vector<std::uint64_t> facet;
    std::uint64_t by;  // a vertex that separates its sides
  };
  struct Earlier {
    std::size_t opened, shut;
  };
  struct OneSided {
    std::string name;
    std::vector<std::vector<std::uint64_t>> loop;  // facets
  };

  std::size_t cells = 0, vertices_before = 0, vertices_after = 0;  // vertices that cells use
  std::size_t edge_nodes_before = 0, edge_nodes_after = 0;         // of second order, no vertices
  std::size_t cohesive = 0;                         // elements put between opened sides
  std::size_t requested = 0, opened = 0, shut = 0;  // the scored facets, earlier cuts' among them
  std::size_t not_interior = 0, kept = 0;           // asked for, but not scored
  std::optional<Earlier> earlier;                   // what the record of MESH says
  std::size_t pieces_before = 0, pieces_after = 0;
  bool cut_regular = true;  // the result
  std::size_t pinched_edges = 0;
  std::vector<Copy> regularized, splits;
  std::vector<Shut> shut_facets;
  std::optional<std::vector<Opened>> opened_facets;  // if asked for
  std::vector<OneSided> one_sided;
  std::optional<Fix> fix;                         // for all shut facets together, if asked for
  std::vector<std::vector<std::uint64_t>> added;  // cut besides, to reach a level
};

/// What is left out of a report unless it is asked for.
struct Wanted {
  bool opened = false;           // opened_facets, and the fix of each shut facet
  bool fix = false;              // for all of them together
  topology::FacetSet keep = {};  // in no fix
};

/// Fills `report` in for `state`, whose output is `output`; facets and parents have the numbers of
/// `shown`, the mesh that MESH holds. Leaves not_interior, kept, earlier and added alone;
/// opened_facets and what would open the shut ones only if they are asked for. Time: linear in the
/// mesh; for the fixes, in the stars of the shut facets.
template <int D>
void fill_report(const CutState<D>& state, const Mesh& shown, const CutOutput& output,
                 const Wanted& wanted, CutReport& report);

/// A few lines; with `explain` one more for each shut or opened facet.
std::string text_of(const CutReport& report, const std::string& source, bool explain);

/// A facets file with the facets of report.fix: docs/schemas/facets.schema.json
std::string fix_it_file(const CutReport& report);

/// docs/schemas/cleave-cut-1.schema.json
std::string json_of(const CutReport& report);

}  // namespace cleave::app
