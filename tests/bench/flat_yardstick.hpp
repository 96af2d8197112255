#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

/// D-simplices in two flat arrays, written as plainly as it goes: what a program that trusts its
/// input and reports nothing would do. The library is measured against it in the same run. It
/// shares no code with the library.
namespace cleave::bench {

template <int D>
struct FlatMesh {
  static constexpr std::uint32_t kNone = UINT32_MAX, kCorners = D + 1;
  using Cell = std::array<std::uint32_t, D + 1>;

  std::vector<Cell> cells;
  std::vector<std::uint32_t> mates;  // half-facet (D+1)*c + i is opposite vertex i of cell c
  std::vector<bool> reversed;        // cells oriented against the order of their tuple
  std::uint32_t vertices = 0;

  /// Finds the mates; returns whether they all induce opposite orientations. Cells are put into
  /// the buckets of their two least vertices, in one of which each of their facets has its least
  /// vertex; facets of a bucket are chained by their second vertex and compared.
  bool match() {
    std::vector<std::uint32_t> start(vertices + 2, 0), sorted(2 * cells.size());
    for (const Cell& cell : cells) {
      const auto [least, second] = two_least(cell);
      ++start[least + 2];
      ++start[second + 2];
    }
    for (std::uint32_t v = 0; v < vertices; ++v) start[v + 2] += start[v + 1];
    for (std::uint32_t c = 0; c < cells.size(); ++c) {
      const auto [least, second] = two_least(cells[c]);
      sorted[start[least + 1]++] = c;
      sorted[start[second + 1]++] = c;
    }
    mates.assign(kCorners * cells.size(), kNone);
    std::vector<std::uint32_t> head(vertices + 1, kNone);
    std::vector<Facet> bucket;
    bool coherent = true;
    for (std::uint32_t v = 0; v < vertices; ++v) {
      bucket.clear();
      for (std::uint32_t n = start[v]; n < start[v + 1]; ++n) {
        const Ascending cell(cells[sorted[n]], reversed[sorted[n]]);
        const std::size_t from = cell.vertex[0] == v ? 1 : 0, end = from == 1 ? kCorners : 1;
        for (std::size_t omitted = from; omitted < end; ++omitted)
          coherent &= join(cell.facet(omitted, sorted[n]), bucket, head);
      }
      for (const Facet& facet : bucket) head[facet.second()] = kNone;
    }
    return coherent;
  }

  /// The same by facets instead of cells: more memory, but fewer misses where the numbers of cells
  /// and vertices have no order.
  bool match_by_facets() {
    const auto half_facets = static_cast<std::uint32_t>(kCorners * cells.size());
    std::vector<std::uint32_t> start(vertices + 2, 0);
    for (const Cell& cell : cells) {
      const auto [least, second] = two_least(cell);
      start[least + 2] += D;
      ++start[second + 2];
    }
    for (std::uint32_t v = 0; v < vertices; ++v) start[v + 2] += start[v + 1];
    std::vector<Facet> sorted(half_facets);
    for (std::uint32_t c = 0; c < cells.size(); ++c) {
      const Ascending cell(cells[c], reversed[c]);
      sorted[start[cell.vertex[1] + 1]++] = cell.facet(0, c);
      for (std::size_t omitted = 1; omitted < kCorners; ++omitted)
        sorted[start[cell.vertex[0] + 1]++] = cell.facet(omitted, c);
    }
    mates.assign(half_facets, kNone);
    bool coherent = true;
    for (std::uint32_t v = 0; v < vertices; ++v)
      for (std::uint32_t a = start[v]; a < start[v + 1]; ++a)
        for (std::uint32_t b = a + 1; b < start[v + 1]; ++b)
          if (sorted[a].rest == sorted[b].rest) coherent &= pair_up(sorted[a], sorted[b]);
    return coherent;
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
    return rename_parts(sides);
  }

  /// Takes facets back, half-facets and their mates of before; the vertices from `original` on copy
  /// `parent`. The copies that meet are one again, under the least of their numbers.
  void stitch(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs,
              const std::vector<std::uint32_t>& parent, std::uint32_t original) {
    std::vector<std::uint32_t> into(parent.size(), kNone);  // of each copy: a lesser number
    const auto parent_of = [&](std::uint32_t v) { return v < original ? v : parent[v - original]; };
    const auto last = [&](std::uint32_t v) {
      while (v >= original && into[v - original] != kNone) v = into[v - original];
      return v;
    };
    for (const auto& [one, other] : pairs) {
      mates[one] = other;
      mates[other] = one;
      for (std::uint32_t a = one - one % kCorners, n = 0; n < kCorners; ++n)
        for (std::uint32_t b = other - other % kCorners, m = 0; m < kCorners; ++m) {
          if (a + n == one || b + m == other) continue;
          if (parent_of(vertex(a + n)) != parent_of(vertex(b + m))) continue;
          const auto [least, greatest] = std::minmax({last(vertex(a + n)), last(vertex(b + m))});
          if (least != greatest) into[greatest - original] = least;
        }
    }
    std::vector<std::uint32_t> part;
    for (const auto& [one, other] : pairs)
      for (const std::uint32_t side : {one, other})
        for (std::uint32_t corner = side - side % kCorners, n = 0; n < kCorners; ++n)
          if (const std::uint32_t v = vertex(corner + n); last(v) != v)
            flood(corner + n, v, last(v), part);
  }

  std::uint32_t& vertex(std::uint32_t corner) {
    return cells[corner / kCorners][corner % kCorners];
  }

  /// Renames `from` to `to` in the cells that are connected with the corner's around it; `part` is
  /// left with their corners.
  void flood(std::uint32_t corner, std::uint32_t from, std::uint32_t to,
             std::vector<std::uint32_t>& part) {
    part.assign(1, corner);
    vertex(corner) = to;
    for (std::size_t next = 0; next < part.size(); ++next) {
      const std::uint32_t begin = part[next] - part[next] % kCorners;
      for (std::uint32_t h = begin; h < begin + kCorners; ++h) {
        if (h == part[next] || mates[h] == kNone) continue;
        const std::uint32_t there = mates[h] - mates[h] % kCorners;
        for (std::uint32_t across = there; across < there + kCorners; ++across)
          if (vertex(across) == from) {
            vertex(across) = to;
            part.push_back(across);
          }
      }
    }
  }

 private:
  /// A facet without its least vertex, in ascending order, and how that order is oriented.
  struct Facet {
    std::array<std::uint32_t, D - 1> rest;
    std::uint32_t half_facet, next;
    bool odd;
    std::uint32_t second() const {
      if constexpr (D == 1)
        return 0;
      else
        return rest[0];
    }
  };

  /// The vertices of a cell in ascending order, and how that order is oriented.
  struct Ascending {
    Ascending(const Cell& cell, bool cell_reversed) : odd(cell_reversed) {
      std::array<std::uint64_t, D + 1> key{};
      for (std::size_t i = 0; i < kCorners; ++i) key[i] = std::uint64_t{cell[i]} << 3U | i;
      for (std::size_t end = kCorners; end-- > 1;)
        for (std::size_t i = 0; i < end; ++i) {
          const std::uint64_t low = std::min(key[i], key[i + 1]);
          odd ^= low != key[i];
          key[i + 1] = std::max(key[i], key[i + 1]);
          key[i] = low;
        }
      for (std::size_t i = 0; i < kCorners; ++i) {
        vertex[i] = static_cast<std::uint32_t>(key[i] >> 3U);
        index[i] = static_cast<std::uint32_t>(key[i] & 7U);
      }
    }
    Facet facet(std::size_t omitted, std::uint32_t cell) const {
      Facet facet{};
      for (std::size_t i = 0; i + 1 < D; ++i)
        facet.rest[i] = vertex[i + 1 + (i + 1 >= omitted ? 1 : 0)];
      facet.half_facet = kCorners * cell + index[omitted];
      facet.odd = odd != (omitted % 2 == 1);
      return facet;
    }
    std::array<std::uint32_t, D + 1> vertex{}, index{};
    bool odd;
  };

  static std::pair<std::uint32_t, std::uint32_t> two_least(const Cell& cell) {
    std::uint32_t least = std::min(cell[0], cell[1]), second = std::max(cell[0], cell[1]);
    for (std::size_t i = 2; i < kCorners; ++i) {
      second = std::min(second, std::max(least, cell[i]));
      least = std::min(least, cell[i]);
    }
    return {least, second};
  }

  bool pair_up(const Facet& one, const Facet& other) {
    mates[one.half_facet] = other.half_facet;
    mates[other.half_facet] = one.half_facet;
    return one.odd != other.odd;
  }

  /// Pairs the facet with its like in the bucket, or adds it; false if the orientations are equal.
  bool join(Facet facet, std::vector<Facet>& bucket, std::vector<std::uint32_t>& head) {
    std::uint32_t& first = head[facet.second()];
    for (std::uint32_t n = first; n != kNone; n = bucket[n].next)
      if (bucket[n].rest == facet.rest) return pair_up(bucket[n], facet);
    facet.next = first;
    first = static_cast<std::uint32_t>(bucket.size());
    bucket.push_back(facet);
    return true;
  }

  /// Gives every part around a corner of these half-facets a number of its own; of the parts of one
  /// vertex the first gets its number back.
  std::uint32_t rename_parts(const std::vector<std::uint32_t>& sides) {
    const std::uint32_t old = vertices;
    std::vector<std::uint32_t> part;  // corners of the part being flooded
    std::vector<std::pair<std::uint32_t, std::uint32_t>> parts;  // vertex, a corner
    for (const std::uint32_t side : sides) {
      const std::uint32_t begin = side - side % kCorners;
      for (std::uint32_t corner = begin; corner < begin + kCorners; ++corner) {
        const std::uint32_t name = vertex(corner);
        if (corner == side || name >= old) continue;
        flood(corner, name, old + static_cast<std::uint32_t>(parts.size()), part);
        parts.emplace_back(name, corner);
      }
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
};

}  // namespace cleave::bench
