#include "certify_certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "cleave/topology/cell_soup.hpp"

namespace cleave::app {
namespace {

using topology::Cell;
using topology::CellId;
using topology::Facet;
using topology::HalfFacetId;
using topology::VertexId;
using Clause = topology::Rejection::Clause;

template <class Row>
std::vector<Row> rows(const std::vector<std::uint32_t>& numbers) {
  std::vector<Row> rows(numbers.size() / Row{}.size());
  for (std::size_t i = 0; i < rows.size() * Row{}.size(); ++i)
    rows[i / Row{}.size()][i % Row{}.size()] = VertexId{numbers[i]};
  return rows;
}

template <class Row>
std::string shown(const Row& row) {
  std::string text;
  for (const VertexId v : row) text += (text.empty() ? "" : " ") + std::to_string(v.value);
  return "(" + text + ")";
}

/// A facet, its vertices ascending, in one of its cells.
template <int D>
struct Side {
  Facet<D> facet;
  VertexId opposite;
  HalfFacetId half_facet;
};

/// All sides of all cells, sorted. Refuses cells that have a vertex twice.
template <int D>
std::vector<Side<D>> sides_of(const std::vector<Cell<D>>& cells, const CertificateFile& file) {
  std::vector<Side<D>> sides;
  sides.reserve(cells.size() * (D + 1));
  for (topology::Index c = 0; c < cells.size(); ++c) {
    Cell<D> sorted = cells[c];
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end())
      file.fail_at_cell(c, fmt::format("cell {} has vertex {} twice", c, twice->value));
    for (int i = 0; i <= D; ++i) {
      const VertexId opposite = cells[c][static_cast<std::size_t>(i)];
      Side<D> side{{}, opposite, topology::half_facet<D>(CellId{c}, i)};
      std::remove_copy(sorted.begin(), sorted.end(), side.facet.begin(), opposite);
      sides.push_back(side);
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side<D>& a, const Side<D>& b) {
    return a.facet != b.facet ? a.facet < b.facet : a.half_facet < b.half_facet;
  });
  return sides;
}

/// Refuses two cells with the same vertices, and a facet in three cells.
template <int D>
void require_pseudo_manifold(const std::vector<Side<D>>& sides, const CertificateFile& file) {
  const auto cell = [&](std::size_t n) { return topology::cell_of<D>(sides[n].half_facet).value; };
  for (std::size_t n = 1; n < sides.size(); ++n) {
    if (sides[n].facet != sides[n - 1].facet) continue;
    if (sides[n].opposite == sides[n - 1].opposite)
      file.fail_at_cell(
          cell(n), fmt::format("cells {} and {} have the same vertices", cell(n - 1), cell(n)));
    if (n > 1 && sides[n].facet == sides[n - 2].facet)
      file.fail_at_cell(cell(n),
                        fmt::format("the facet {} is in three cells: {}, {} and {}",
                                    shown(sides[n].facet), cell(n - 2), cell(n - 1), cell(n)));
  }
}

/// A half-facet of each facet of the cut. Refuses rows that are no facet.
template <int D>
std::vector<HalfFacetId> cut_of(const std::vector<Side<D>>& sides, const CertificateFile& file) {
  std::vector<HalfFacetId> cut;
  for (Facet<D> facet : rows<Facet<D>>(file.certificate().cut)) {
    const Facet<D> row = facet;
    std::sort(facet.begin(), facet.end());
    const auto found =
        std::lower_bound(sides.begin(), sides.end(), facet,
                         [](const Side<D>& side, const Facet<D>& f) { return side.facet < f; });
    if (found == sides.end() || found->facet != facet)
      file.fail_at_facet(cut.size(), fmt::format("{} is no facet of a cell", shown(row)));
    cut.push_back(found->half_facet);
  }
  return cut;
}

std::string where(const CertificateRejection& rejection, const Certificate& certificate) {
  const auto& [one, other] = rejection.corners;
  switch (rejection.clause) {
    case Clause::cells:
      return fmt::format("{} before and {} after", certificate.cell_count(),
                         certificate.after.size() / certificate.corners());
    case Clause::parent:
      if (one.cell == other.cell)
        return fmt::format("cell {} has vertex {} twice after, for vertices {} and {} before",
                           one.cell, one.after, one.before, other.before);
      return fmt::format(
          "cells {} and {} share vertex {} after, which is vertex {} of the one and {} of the "
          "other before",
          one.cell, other.cell, one.after, one.before, other.before);
    case Clause::uncut:
      return fmt::format(
          "cells {} and {} have a facet that is not in the cut, but its vertex {} is vertex {} of "
          "the one and {} of the other after",
          one.cell, other.cell, one.before, one.after, other.after);
    case Clause::connected:
      return fmt::format(
          "cells {} and {} share vertex {} after, but no chain of facets that are not in the cut "
          "connects them around vertex {}",
          one.cell, other.cell, one.after, one.before);
  }
  return "";
}

template <int D>
std::optional<CertificateRejection> certify_cells(const CertificateFile& file) {
  const Certificate& certificate = file.certificate();
  const auto before = rows<Cell<D>>(certificate.before), after = rows<Cell<D>>(certificate.after);
  topology::require_ids_suffice(D, before.size(), 0);
  std::vector<HalfFacetId> cut;
  {
    const auto sides = sides_of<D>(before, file);
    require_pseudo_manifold<D>(sides, file);
    cut = cut_of<D>(sides, file);
  }
  const auto rejection = topology::certify<D>(before, cut, after);
  if (!rejection) return std::nullopt;
  CertificateRejection told{rejection->clause, {}, {}};
  if (rejection->clause != Clause::cells)
    for (std::size_t i = 0; i < 2; ++i) {
      const auto corner = i == 0 ? rejection->one : rejection->other;
      told.corners[i] = {topology::cell_of<D>(corner).value, certificate.before[corner.value],
                         certificate.after[corner.value]};
    }
  told.where = where(told, certificate);
  return told;
}

}  // namespace

std::optional<CertificateRejection> certify(const CertificateFile& file) {
  if (file.certificate().dimension == 1) return certify_cells<1>(file);
  if (file.certificate().dimension == 2) return certify_cells<2>(file);
  if (file.certificate().dimension == 3) return certify_cells<3>(file);
  return certify_cells<4>(file);
}

}  // namespace cleave::app
