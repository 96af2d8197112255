#pragma once
#include <cstdint>
#include <vector>

#include "complex_access.hpp"

namespace cleave::topology::detail {

/// A simplex that was collapsed through one of its faces, which was free then.
struct Collapse {
  Index face, simplex;
};

/// What collapsing all k-simplices of a complex gave: each was collapsed or is critical.
struct Gradient {
  std::vector<Collapse> collapses;  // in their order
  std::vector<Index> critical;      // ascending
  std::vector<Index> when;          // per (k-1)-simplex: its place in `collapses`, or kNone
};

/// Collapses the k-simplices for which `gone` is false, each through a face that no other has;
/// where there is none, the first simplex left is critical. `faces`: k+1 per simplex. Time: linear.
inline Gradient collapse_all(const std::vector<Index>& faces, std::size_t per_simplex,
                             std::size_t face_count, const std::vector<bool>& gone) {
  std::vector<Index> cofaces(face_count, 0), sum(face_count, 0);  // of those left
  for (std::size_t s = 0; s < gone.size(); ++s) {
    if (gone[s]) continue;
    for (std::size_t i = 0; i < per_simplex; ++i) {
      const Index face = faces[s * per_simplex + i];
      ++cofaces[face];
      sum[face] ^= static_cast<Index>(s);  // the simplex itself once it is alone
    }
  }
  Gradient gradient;
  gradient.when.assign(face_count, kNone);
  std::vector<bool> left(gone.size());
  for (std::size_t s = 0; s < gone.size(); ++s) left[s] = !gone[s];
  std::vector<Index> free;
  for (Index face = 0; face < face_count; ++face)
    if (cofaces[face] == 1) free.push_back(face);
  const auto remove = [&](Index s) {
    left[s] = false;
    for (std::size_t i = 0; i < per_simplex; ++i) {
      const Index face = faces[s * per_simplex + i];
      sum[face] ^= s;
      if (--cofaces[face] == 1) free.push_back(face);
    }
  };
  std::size_t next = 0;
  for (Index first = 0; first < gone.size(); ++first) {
    for (; next < free.size(); ++next) {
      const Index face = free[next];
      if (cofaces[face] != 1) continue;
      gradient.when[face] = static_cast<Index>(gradient.collapses.size());
      gradient.collapses.push_back({face, sum[face]});
      remove(sum[face]);
    }
    if (!left[first]) continue;
    gradient.critical.push_back(first);
    remove(first);
  }
  return gradient;
}

}  // namespace cleave::topology::detail
