#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "certificate.hpp"
#include "cleave/topology/certify.hpp"

namespace cleave::app {

/// Why the result in a certificate is not that of its cut.
struct CertificateRejection {
  /// A corner that shows it: the position of a cell, from 0, and its vertex in either list.
  struct Corner {
    topology::Index cell, before, after;
  };
  topology::Rejection::Clause clause{};
  std::array<Corner, 2> corners{};  // nothing for the clause `cells`
  std::string where;                // a sentence without its full stop
};

/// Nothing iff topology::certify accepts. Throws InputError with the line if there is nothing to
/// judge: a cell of `before` that has a vertex twice, two with the same vertices, a facet in three
/// cells, or a row of the cut that is no facet of `before`. Time: O(n log n) in the cells; memory,
/// dimension 3: less than 250 bytes per cell.
std::optional<CertificateRejection> certify(const CertificateFile& file);

}  // namespace cleave::app
