#include "offset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cleave/cutting/predicates.hpp"
#include "edge_nodes.hpp"
#include "file_words.hpp"

namespace cleave::app {

using topology::HalfFacetId;

namespace {

using Vector = std::array<double, 3>;

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector along(const Vector& a, double t, const Vector& b) {  // a + t b
  return {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]};
}
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double length(const Vector& a) { return std::hypot(a[0], a[1], a[2]); }

// `a` scaled to length 1; zero stays.
Vector unit(const Vector& a) {
  const double l = length(a);
  return l > 0 ? Vector{a[0] / l, a[1] / l, a[2] / l} : Vector{};
}

// The points of a cell.
template <int D>
using Corners = std::array<Vector, static_cast<std::size_t>(D + 1)>;

// The unit vector that points from the facet opposite corner `i` into the cell, at right angles to
// the facet; zero for a flat cell.
template <int D>
Vector into_cell(const Corners<D>& p, std::size_t i) {
  std::array<Vector, static_cast<std::size_t>(D)> facet{};
  for (std::size_t from = 0, to = 0; from < p.size(); ++from)
    if (from != i) facet[to++] = p[from];
  std::array<Vector, 2> basis{};  // of the facet's directions, orthonormal
  std::size_t n = 0;
  const auto across = [&](Vector v) {
    for (std::size_t b = 0; b < n; ++b) v = along(v, -dot(v, basis[b]), basis[b]);
    return v;
  };
  for (std::size_t k = 1; k < facet.size(); ++k)
    basis[n++] = unit(across(minus(facet[k], facet[0])));
  return unit(across(minus(p[i], facet[0])));
}

// The exact sign of the volume of a cell.
template <int D>
int orientation(const Corners<D>& p) {
  if constexpr (D == 3) return cutting::orient3d(p[0], p[1], p[2], p[3]);
  if constexpr (D == 2)
    return cutting::orient2d({p[0][0], p[0][1]}, {p[1][0], p[1][1]}, {p[2][0], p[2][1]});
  return 1;
}

// D! times the volume, in floating point.
template <int D>
double volume(const Corners<D>& p) {
  const Vector a = minus(p[1], p[0]), b = minus(p[2], p[0]);
  if constexpr (D == 2) return a[0] * b[1] - a[1] * b[0];
  const Vector c = minus(p[static_cast<std::size_t>(D)], p[0]);
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

// To three digits.
double rounded_down(double x) {
  if (!(x > 0)) return 0;
  const double unit = std::pow(10, std::floor(std::log10(x)) - 2);
  return std::floor(x / unit) * unit;
}

template <int D>
class Mover {
 public:
  Mover(const Body<D>& body, double distance, CutOutput& output)
      : body_(body),
        mesh_(output.mesh),
        output_(output),
        distance_(distance),
        direction_(output.mesh.points.size()) {}

  void run(const std::vector<topology::OpenedFacet>& opened) {
    std::vector<bool> tip(mesh_.points.size());
    for (const auto& facet : opened) {
      std::vector<Index> sides;
      for (const HalfFacetId h : {facet.half_facet, facet.former_mate}) push_inward(h, sides);
      std::sort(sides.begin(), sides.end());
      for (auto at = std::adjacent_find(sides.begin(), sides.end()); at != sides.end();
           at = std::adjacent_find(at + 1, sides.end()))
        tip[*at] = true;
    }
    for (Index place = 0; place < direction_.size(); ++place)
      direction_[place] = tip[place] ? Vector{} : unit(direction_[place]);
    move_nodes();
    const std::vector<Vector> before = mesh_.points;
    for (Index place = 0; place < direction_.size(); ++place) {
      if (direction_[place] == Vector{}) continue;
      mesh_.points[place] = along(before[place], distance_ / 2, direction_[place]);
      if (mesh_.points[place] != before[place]) output_.moved.push_back({place, before[place]});
    }
    warn_of_inverted(before);
  }

 private:
  const Index* cell(std::size_t c) const {
    return &mesh_.cells().vertices[static_cast<std::size_t>(D + 1) * c];
  }
  Corners<D> corners(std::size_t c, const std::vector<Vector>& points) const {
    Corners<D> p{};
    std::transform(cell(c), cell(c) + D + 1, p.begin(), [&](Index v) { return points[v]; });
    return p;
  }

  // Adds the normal of half-facet `h` to its vertices, and these to `vertices`.
  void push_inward(HalfFacetId h, std::vector<Index>& vertices) {
    const std::size_t c = topology::cell_of<D>(h).value;
    const auto opposite = static_cast<std::size_t>(topology::local_index<D>(h));
    const Vector normal = into_cell<D>(corners(c, mesh_.points), opposite);
    for (std::size_t i = 0; i <= static_cast<std::size_t>(D); ++i) {
      if (i == opposite) continue;
      vertices.push_back(cell(c)[i]);
      direction_[cell(c)[i]] = along(direction_[cell(c)[i]], 1, normal);
    }
  }

  void move_nodes() {
    for (std::size_t k = 1; k <= static_cast<std::size_t>(D); ++k) {
      const Elements& elements = mesh_.elements[k];
      const Index* node = elements.midside.data();
      for (std::size_t e = 0; elements.second_order() && e < elements.size(); ++e)
        for (std::size_t i = 0; i <= k; ++i)
          for (std::size_t j = i + 1; j <= k; ++j, ++node) {
            const auto& a = direction_[elements.vertices[(k + 1) * e + i]];
            const auto& b = direction_[elements.vertices[(k + 1) * e + j]];
            direction_[*node] = {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
          }
    }
  }

  void warn_of_inverted(const std::vector<Vector>& before) {
    if (D == 1 || (D == 2 && !is_planar(*body_.mesh))) return;
    std::size_t inverted = 0;
    Index first = 0;
    double safe = distance_;
    for (Index c = 0; c < mesh_.cells().size(); ++c) {
      if (std::all_of(cell(c), cell(c) + D + 1, [&](Index v) { return direction_[v] == Vector{}; }))
        continue;
      const int sign = orientation<D>(corners(c, before));
      if (sign == 0) continue;
      safe = std::min(safe, first_flat(c, sign, before));
      if (orientation<D>(corners(c, mesh_.points)) == sign) continue;
      if (inverted++ == 0) first = c;
    }
    if (inverted == 0) return;
    output_.warnings.push_back(fmt::format(
        "the offset {:g} turns {} inside out, such as cell {}; the largest that turns none is "
        "about {:.3g}",
        distance_, counted(inverted, "cell"), cell_number(mesh_, {first}), rounded_down(safe)));
  }

  // The least offset at which cell `c` is flat, or the whole distance: the volume is a polynomial
  // of degree D in the offset, monotonic between the zeros of its derivative.
  double first_flat(Index c, int sign, const std::vector<Vector>& before) const {
    const auto at = [&](double t) {
      Corners<D> p = corners(c, before);
      for (std::size_t i = 0; i < p.size(); ++i)
        p[i] = along(p[i], t * distance_ / 2, direction_[cell(c)[i]]);
      return sign * volume<D>(p);
    };
    // Through the values at 0, 1/3, 2/3 and 1, as c0 + c1 t + c2 t^2 + c3 t^3.
    const double f0 = at(0), f1 = at(1. / 3), f2 = at(2. / 3), f3 = at(1);
    const double c1 = (-11 * f0 + 18 * f1 - 9 * f2 + 2 * f3) / 2;
    const double c2 = 9 * (2 * f0 - 5 * f1 + 4 * f2 - f3) / 2;
    const double c3 = 9 * (-f0 + 3 * f1 - 3 * f2 + f3) / 2;
    std::array<double, 4> stop{0, 1, 1, 1};  // and the zeros of the derivative between them
    const double root = c2 * c2 - 3 * c1 * c3;
    const double q = root < 0 ? 0 : -(c2 + std::copysign(std::sqrt(root), c2));  // none cancels
    if (q != 0) stop[1] = std::clamp(c1 / q, 0., 1.);
    if (q != 0 && c3 != 0) stop[2] = std::clamp(q / (3 * c3), 0., 1.);
    std::sort(stop.begin(), stop.end());
    for (std::size_t i = 0; i + 1 < stop.size(); ++i) {
      if (at(stop[i + 1]) > 0) continue;
      double low = stop[i], high = stop[i + 1];
      for (int step = 0; step < 60; ++step) {
        const double middle = (low + high) / 2;
        (at(middle) > 0 ? low : high) = middle;
      }
      return low * distance_;
    }
    return distance_;
  }

  const Body<D>& body_;
  Mesh& mesh_;
  CutOutput& output_;
  double distance_;
  std::vector<Vector> direction_;  // of each point: a unit vector, zero for one that stays
};

}  // namespace

template <int D>
void move_sides(const Body<D>& body, const topology::Incision<D>& incision, double distance,
                CutOutput& output) {
  Mover<D>(body, distance, output).run(incision.opened());
}

template void move_sides<1>(const Body<1>&, const topology::Incision<1>&, double, CutOutput&);
template void move_sides<2>(const Body<2>&, const topology::Incision<2>&, double, CutOutput&);
template void move_sides<3>(const Body<3>&, const topology::Incision<3>&, double, CutOutput&);

}  // namespace cleave::app
