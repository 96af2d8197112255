#include "rational.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cleave/support/reference.hpp>
#include <optional>
#include <set>

namespace cleave::cutting::rational {
namespace {

namespace mp = boost::multiprecision;
using topology::Cell;
using topology::HalfFacetId;
using topology::VertexId;
using Q = mp::number<mp::cpp_rational_backend, mp::et_off>;
using Z = mp::number<mp::cpp_int_backend<>, mp::et_off>;

/// A polynomial in e > 0, smaller than any number: terms[i] belongs to e^i.
struct Series {
  std::vector<Z> terms;

  Series() = default;
  explicit Series(Z constant) : terms{std::move(constant)} {}

  int sign() const {
    for (const Z& term : terms)
      if (term != 0) return term.sign();
    return 0;
  }
};

Series plus(const Series& a, const Series& b, int factor) {
  Series sum;
  sum.terms.resize(std::max(a.terms.size(), b.terms.size()));
  for (std::size_t i = 0; i < a.terms.size(); ++i) sum.terms[i] += a.terms[i];
  for (std::size_t i = 0; i < b.terms.size(); ++i) sum.terms[i] += factor * b.terms[i];
  while (!sum.terms.empty() && sum.terms.back() == 0) sum.terms.pop_back();
  return sum;
}

Series operator+(const Series& a, const Series& b) { return plus(a, b, 1); }
Series operator-(const Series& a, const Series& b) { return plus(a, b, -1); }

Series operator*(const Series& a, const Series& b) {
  Series product;
  if (a.terms.empty() || b.terms.empty()) return product;
  product.terms.resize(a.terms.size() + b.terms.size() - 1);
  for (std::size_t i = 0; i < a.terms.size(); ++i)
    for (std::size_t j = 0; j < b.terms.size(); ++j)
      if (a.terms[i] != 0 && b.terms[j] != 0) product.terms[i + j] += a.terms[i] * b.terms[j];
  return product;
}

template <int D>
using Place = std::array<Series, static_cast<std::size_t>(D)>;

/// The points as fractions, times their common denominator. No sign depends on that factor.
template <int D, std::size_t N>
std::array<Place<D>, N> integers(const std::array<Point<D>, N>& points) {
  Z common = 1;
  for (const Point<D>& p : points)
    for (const double x : p) common = mp::lcm(common, Z(mp::denominator(Q(x))));
  std::array<Place<D>, N> places;
  for (std::size_t n = 0; n < N; ++n)
    for (std::size_t i = 0; i < points[n].size(); ++i)
      places[n][i] = Series(Z(mp::numerator(Q(points[n][i]) * Q(common))));
  return places;
}

/// The corners of a simplex and some more points, as integers.
template <int D, std::size_t N>
struct Setting {
  std::array<Place<D>, static_cast<std::size_t>(D)> simplex;
  std::array<Place<D>, N> points;

  Setting(const Simplex<D>& corners, const std::array<Point<D>, N>& others) {
    std::array<Point<D>, static_cast<std::size_t>(D) + N> all;
    std::copy(others.begin(), others.end(), std::copy(corners.begin(), corners.end(), all.begin()));
    const auto places = integers<D>(all);
    std::copy_n(places.begin(), D, simplex.begin());
    std::copy_n(places.begin() + D, N, points.begin());
  }

  /// Moves the simplex by (e, e^2, ..).
  void translate() {
    for (Place<D>& place : simplex)
      for (std::size_t i = 0; i < place.size(); ++i) {
        place[i].terms.resize(i + 2);
        place[i].terms[i + 1] = 1;
      }
  }
};

template <std::size_t N>
std::array<Series, N> operator-(const std::array<Series, N>& a, const std::array<Series, N>& b) {
  std::array<Series, N> difference;
  for (std::size_t i = 0; i < N; ++i) difference[i] = a[i] - b[i];
  return difference;
}

Series determinant(const std::array<Place<2>, 2>& m) {
  return m[0][0] * m[1][1] - m[0][1] * m[1][0];
}

Series determinant(const std::array<Place<3>, 3>& m) {
  Series sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    sum = sum + m[0][i] * (m[1][j] * m[2][k] - m[1][k] * m[2][j]);
  }
  return sum;
}

Series height(const std::array<Place<2>, 2>& s, const Place<2>& p) {
  return determinant(std::array<Place<2>, 2>{s[1] - s[0], p - s[0]});
}

Series height(const std::array<Place<3>, 3>& s, const Place<3>& p) {
  return determinant(std::array<Place<3>, 3>{s[1] - s[0], s[2] - s[0], p - s[0]});
}

/// Leaves out coordinate `axis`.
Place<2> flattened(const Place<3>& p, std::size_t axis) {
  return {p[(axis + 1) % 3], p[(axis + 2) % 3]};
}

/// Whether the point x / w, w > 0, which is on the line of `s`, is between its ends.
bool holds(const std::array<Place<2>, 2>& s, const Place<2>& x, const Series& w) {
  const std::size_t axis = (s[1][0] - s[0][0]).sign() != 0 ? 0 : 1;
  return (x[axis] - w * s[0][axis]).sign() != (x[axis] - w * s[1][axis]).sign();
}

/// Whether the point x / w, w > 0, which is in the plane of `s`, is within the triangle.
bool holds(const std::array<Place<3>, 3>& s, const Place<3>& x, const Series& w) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto flat = [axis](const Place<3>& p) { return flattened(p, axis); };
    const std::array<Place<2>, 3> t{flat(s[0]), flat(s[1]), flat(s[2])};
    if (determinant(std::array<Place<2>, 2>{t[1] - t[0], t[2] - t[0]}).sign() == 0) continue;
    const Place<2> y = flat(x);
    std::set<int> signs;
    for (std::size_t i = 0; i < 3; ++i) {
      const Place<2>&a = t[i], &b = t[(i + 1) % 3];
      const Place<2> from_a{y[0] - w * a[0], y[1] - w * a[1]};
      signs.insert(determinant(std::array<Place<2>, 2>{b - a, from_a}).sign());
    }
    return signs.size() == 1;
  }
  return false;
}

/// For all points: their sides of the translated simplex.
template <int D>
std::vector<int> sides(const Simplex<D>& simplex, const std::vector<Point<D>>& points) {
  std::vector<int> result;
  for (const Point<D>& p : points) result.push_back(side<D>(simplex, p));
  return result;
}

}  // namespace

template <int D>
int orient(const std::array<Point<D>, static_cast<std::size_t>(D) + 1>& corners) {
  Simplex<D> simplex;
  std::copy_n(corners.begin(), D, simplex.begin());
  const Setting<D, 1> setting(simplex, {corners.back()});
  return height(setting.simplex, setting.points[0]).sign();
}

template <int D>
bool is_flat(const Simplex<D>& simplex) {
  // The plane of a flat simplex is everywhere: no unit step leaves it.
  const Setting<D, 1> setting(simplex, {simplex[0]});
  for (std::size_t i = 0; i < simplex[0].size(); ++i) {
    Place<D> p = setting.points[0];
    p[i] = p[i] + Series(Z(1));
    if (height(setting.simplex, p).sign() != 0) return false;
  }
  return true;
}

template <int D>
int side(const Simplex<D>& simplex, const Point<D>& p) {
  Setting<D, 1> setting(simplex, {p});
  setting.translate();
  return height(setting.simplex, setting.points[0]).sign();
}

template <int D>
bool crosses(const Simplex<D>& simplex, const Point<D>& p, const Point<D>& q) {
  Setting<D, 2> setting(simplex, {p, q});
  setting.translate();
  const auto& [from, to] = setting.points;
  const Series a = height(setting.simplex, from), b = height(setting.simplex, to);
  if (a.sign() == b.sign()) return false;
  // The line meets the plane in (a to - b from) / (a - b); both are negated if a < b.
  const Series sign(Z(a.sign()));
  Place<D> x;
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = sign * (a * to[i] - b * from[i]);
  return holds(setting.simplex, x, sign * (a - b));
}

template <int D>
int compare_heights(const Simplex<D>& simplex, const Point<D>& p, const Point<D>& q) {
  const Setting<D, 2> setting(simplex, {p, q});
  Series a = height(setting.simplex, setting.points[0]);
  Series b = height(setting.simplex, setting.points[1]);
  if (a.sign() < 0) a = Series() - a;
  if (b.sign() < 0) b = Series() - b;
  return (a - b).sign();
}

template <int D>
std::vector<HalfFacetId> dual_edge(std::span<const Cell<D>> cells,
                                   const std::vector<Point<D>>& duals,
                                   std::span<const Simplex<D>> simplices) {
  const std::vector<std::optional<HalfFacetId>> mates = support::mates_of<D>(cells);
  std::set<HalfFacetId> odd;
  for (const Simplex<D>& simplex : simplices) {
    if (is_flat<D>(simplex)) continue;
    const std::vector<int> side = sides<D>(simplex, duals);
    for (const HalfFacetId h : support::interior_facets<D>(cells)) {
      const std::size_t one = topology::cell_of<D>(h).value;
      const std::size_t other = topology::cell_of<D>(*mates[h.value]).value;
      if (side[one] == side[other] || !crosses<D>(simplex, duals[one], duals[other])) continue;
      if (!odd.insert(h).second) odd.erase(h);
    }
  }
  return {odd.begin(), odd.end()};
}

template <int D>
ClosestEnds closest_ends(std::span<const Cell<D>> cells, const std::vector<Point<D>>& points,
                         std::span<const Simplex<D>> simplices, Ties ties) {
  std::set<std::pair<VertexId, VertexId>> edges;
  for (const Cell<D>& cell : cells)
    for (const VertexId v : cell)
      for (const VertexId w : cell)
        if (v < w) edges.emplace(v, w);

  ClosestEnds closest;
  for (const Simplex<D>& simplex : simplices) {
    if (is_flat<D>(simplex)) continue;
    const std::vector<int> side = sides<D>(simplex, points);
    for (const auto& edge : edges) {
      const Point<D>&p = points[edge.first.value], &q = points[edge.second.value];
      if (side[edge.first.value] == side[edge.second.value] || !crosses<D>(simplex, p, q)) continue;
      const int order = compare_heights<D>(simplex, p, q);
      if (order <= 0) closest.emplace(edge, edge.first);
      if (order > 0 || (order == 0 && ties == Ties::both)) closest.emplace(edge, edge.second);
    }
  }

  return closest;
}

template <int D>
std::vector<HalfFacetId> nearest_vertex(std::span<const Cell<D>> cells, const ClosestEnds& ends) {
  std::vector<std::set<VertexId>> sets(cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (const VertexId v : cells[c])
      for (const VertexId w : cells[c])
        if (v != w && ends.count({std::minmax(v, w), v})) sets[c].insert(v);

  const std::vector<std::optional<HalfFacetId>> mates = support::mates_of<D>(cells);
  std::set<HalfFacetId> chosen;
  for (topology::Index c = 0; c < cells.size(); ++c) {
    if (sets[c].size() != static_cast<std::size_t>(D)) continue;
    for (int i = 0; i <= D; ++i) {
      const HalfFacetId h = topology::half_facet<D>({c}, i);
      if (sets[c].count(cells[c][static_cast<std::size_t>(i)]) || !mates[h.value]) continue;
      chosen.insert(std::min(h, *mates[h.value]));
    }
  }
  return {chosen.begin(), chosen.end()};
}

template int orient<2>(const std::array<Point<2>, 3>&);
template int orient<3>(const std::array<Point<3>, 4>&);
template bool is_flat<2>(const Simplex<2>&);
template bool is_flat<3>(const Simplex<3>&);
template int side<2>(const Simplex<2>&, const Point<2>&);
template int side<3>(const Simplex<3>&, const Point<3>&);
template bool crosses<2>(const Simplex<2>&, const Point<2>&, const Point<2>&);
template bool crosses<3>(const Simplex<3>&, const Point<3>&, const Point<3>&);
template int compare_heights<2>(const Simplex<2>&, const Point<2>&, const Point<2>&);
template int compare_heights<3>(const Simplex<3>&, const Point<3>&, const Point<3>&);
template std::vector<HalfFacetId> dual_edge<2>(std::span<const Cell<2>>,
                                               const std::vector<Point<2>>&,
                                               std::span<const Simplex<2>>);
template std::vector<HalfFacetId> dual_edge<3>(std::span<const Cell<3>>,
                                               const std::vector<Point<3>>&,
                                               std::span<const Simplex<3>>);
template ClosestEnds closest_ends<2>(std::span<const Cell<2>>, const std::vector<Point<2>>&,
                                     std::span<const Simplex<2>>, Ties);
template ClosestEnds closest_ends<3>(std::span<const Cell<3>>, const std::vector<Point<3>>&,
                                     std::span<const Simplex<3>>, Ties);
template std::vector<HalfFacetId> nearest_vertex<2>(std::span<const Cell<2>>, const ClosestEnds&);
template std::vector<HalfFacetId> nearest_vertex<3>(std::span<const Cell<3>>, const ClosestEnds&);

}  // namespace cleave::cutting::rational
