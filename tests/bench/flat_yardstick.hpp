#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

/// Tetrahedra in two flat arrays, written as plainly as it goes: what a program that trusts its
/// input and reports nothing would do. The library is measured against it in the same run. It
/// shares no code with the library.
namespace cleave::bench {

struct FlatMesh {
  static constexpr std::uint32_t kNone = UINT32_MAX;

  std::vector<std::array<std::uint32_t, 4>> cells;
  std::vector<std::uint32_t> mates;  // half-facet 4*c + i is opposite vertex i of cell c
  std::uint32_t vertices = 0;

  /// Finds the mates: faces are put into buckets by their least vertex, and the few of one bucket
  /// are compared with each other.
  void match() {
    const auto half_facets = static_cast<std::uint32_t>(4 * cells.size());
    std::vector<std::uint32_t> start(vertices + 2, 0);
    for (std::uint32_t h = 0; h < half_facets; ++h) ++start[face(h)[0] + 2];
    for (std::uint32_t v = 0; v < vertices; ++v) start[v + 2] += start[v + 1];
    struct Entry {
      std::uint32_t second, third, half_facet;
    };
    std::vector<Entry> sorted(half_facets);
    for (std::uint32_t h = 0; h < half_facets; ++h) {
      const auto f = face(h);
      sorted[start[f[0] + 1]++] = {f[1], f[2], h};
    }
    mates.assign(half_facets, kNone);
    for (std::uint32_t v = 0; v < vertices; ++v)
      for (std::uint32_t a = start[v]; a < start[v + 1]; ++a)
        for (std::uint32_t b = a + 1; b < start[v + 1]; ++b)
          if (sorted[a].second == sorted[b].second && sorted[a].third == sorted[b].third) {
            mates[sorted[a].half_facet] = sorted[b].half_facet;
            mates[sorted[b].half_facet] = sorted[a].half_facet;
          }
  }

  /// Separates the cells along the facets of these half-facets: every part of a star that borders
  /// them gets a new vertex, of one part per vertex the old number is restored. Facets that stay
  /// shut are left without mates. Returns the number of vertices added.
  std::uint32_t unglue(const std::vector<std::uint32_t>& cut) {
    std::vector<std::uint32_t> sides;
    for (const std::uint32_t h : cut) {
      sides.push_back(h);
      sides.push_back(mates[h]);
    }
    for (const std::uint32_t h : sides) mates[h] = kNone;

    const std::uint32_t old = vertices;
    std::vector<std::uint32_t> part;  // corners of the part being flooded
    std::vector<std::pair<std::uint32_t, std::uint32_t>> parts;  // parent, a corner
    for (const std::uint32_t side : sides)
      for (std::uint32_t corner = side & ~3u; corner < (side & ~3u) + 4; ++corner) {
        const std::uint32_t parent = vertex(corner);
        if (corner == side || parent >= old) continue;
        flood(corner, parent, old + static_cast<std::uint32_t>(parts.size()), part);
        parts.emplace_back(parent, corner);
      }

    std::sort(parts.begin(), parts.end());
    std::uint32_t added = 0;
    for (std::size_t n = 0; n < parts.size(); ++n) {
      const bool first = n == 0 || parts[n].first != parts[n - 1].first;
      if (first) flood(parts[n].second, vertex(parts[n].second), parts[n].first, part);
      added += first ? 0 : 1;
    }
    vertices = old + static_cast<std::uint32_t>(parts.size());
    return added;
  }

 private:
  std::uint32_t& vertex(std::uint32_t corner) { return cells[corner / 4][corner % 4]; }

  /// The three vertices of half-facet `h`, ascending.
  std::array<std::uint32_t, 3> face(std::uint32_t h) const {
    const auto& cell = cells[h / 4];
    std::uint32_t a = cell[(h + 1) % 4], b = cell[(h + 2) % 4], c = cell[(h + 3) % 4];
    if (a > b) std::swap(a, b);
    if (b > c) std::swap(b, c);
    if (a > b) std::swap(a, b);
    return {a, b, c};
  }

  /// Renames `from` to `to` in the cells that are connected with the corner's around it.
  void flood(std::uint32_t corner, std::uint32_t from, std::uint32_t to,
             std::vector<std::uint32_t>& part) {
    part.assign(1, corner);
    vertex(corner) = to;
    for (std::size_t next = 0; next < part.size(); ++next)
      for (std::uint32_t h = part[next] & ~3u; h < (part[next] & ~3u) + 4; ++h) {
        if (h == part[next] || mates[h] == kNone) continue;
        for (std::uint32_t across = mates[h] & ~3u; across < (mates[h] & ~3u) + 4; ++across)
          if (vertex(across) == from) {
            vertex(across) = to;
            part.push_back(across);
          }
      }
  }
};

}  // namespace cleave::bench
