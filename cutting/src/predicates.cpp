#include "cleave/cutting/predicates.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "exact.hpp"

namespace cleave::cutting {
namespace {

using detail::exact_determinant_sign;
using detail::Row;

constexpr double kRoundoff = 0x1p-53;

/// What the filter says of a determinant: its sign, or that it cannot tell.
constexpr int kUnsure = 2;

int sign_of(double x) { return (x > 0) - (x < 0); }

/// A determinant's row in doubles, and for each entry a bound on the numbers it was made of. An
/// entry is off by at most 3 roundoffs of its size.
template <int D>
struct RoundedRow {
  Point<D> entries, sizes;
};

template <int D>
RoundedRow<D> difference(const Point<D>& to, const Point<D>& from) {
  RoundedRow<D> row;
  for (std::size_t j = 0; j < to.size(); ++j) {
    row.entries[j] = to[j] - from[j];
    row.sizes[j] = std::abs(row.entries[j]);
  }
  return row;
}

template <int D>
RoundedRow<D> sum_of_differences(const Point<D>& p, const Point<D>& q, const Point<D>& from) {
  RoundedRow<D> row;
  for (std::size_t j = 0; j < from.size(); ++j) {
    const double a = p[j] - from[j], b = q[j] - from[j];
    row.entries[j] = a + b;
    row.sizes[j] = std::abs(a) + std::abs(b);
  }
  return row;
}

bool all_within(double low, double high, std::initializer_list<double> values) {
  return std::all_of(values.begin(), values.end(), [=](double x) { return low <= x && x <= high; });
}

/// Each of the 2 products has factors off by 1 and at most 3 roundoffs, and two more roundings: the
/// error is below 12 roundoffs of (largest first column) x (largest second column). Within the
/// range asked for, nothing overflows and what underflows is far below the 4 roundoffs to spare.
int filtered(const RoundedRow<2>& r, const RoundedRow<2>& s) {
  const double x = std::max(r.sizes[0], s.sizes[0]), y = std::max(r.sizes[1], s.sizes[1]);
  if (x == 0 || y == 0) return 0;
  if (!all_within(1e-140, 1e150, {x, y})) return kUnsure;
  const double det = r.entries[0] * s.entries[1] - r.entries[1] * s.entries[0];
  return std::abs(det) > 16 * kRoundoff * x * y ? sign_of(det) : kUnsure;
}

/// As above: 6 products, factors off by 1, 1 and at most 3 roundoffs, five more roundings each:
/// below 60 roundoffs of the product of the largest entries of the columns.
int filtered(const RoundedRow<3>& r, const RoundedRow<3>& s, const RoundedRow<3>& t) {
  Point<3> most;
  for (std::size_t j = 0; j < 3; ++j) most[j] = std::max({r.sizes[j], s.sizes[j], t.sizes[j]});
  if (most[0] == 0 || most[1] == 0 || most[2] == 0) return 0;
  if (!all_within(1e-97, 1e102, {most[0], most[1], most[2]})) return kUnsure;
  const Point<3>&a = r.entries, &b = s.entries, &c = t.entries;
  const double det = a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                     a[2] * (b[0] * c[1] - b[1] * c[0]);
  return std::abs(det) > 64 * kRoundoff * most[0] * most[1] * most[2] ? sign_of(det) : kUnsure;
}

/// The sign of det(q-p, b-a).
int cross_sign(const Point<2>& p, const Point<2>& q, const Point<2>& a, const Point<2>& b) {
  const int sign = filtered(difference<2>(q, p), difference<2>(b, a));
  return sign != kUnsure ? sign : exact_determinant_sign<2>({Row<2>{q, p}, Row<2>{b, a}});
}

/// The sign of the first component of (q-p) x (b-a) that is not 0; 0 if all are.
int leading_cross_sign(const Point<3>& p, const Point<3>& q, const Point<3>& a, const Point<3>& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto flat = [j = (i + 1) % 3, k = (i + 2) % 3](const Point<3>& x) {
      return Point<2>{x[j], x[k]};
    };
    if (const int sign = cross_sign(flat(p), flat(q), flat(a), flat(b))) return sign;
  }
  return 0;
}

/// The sign of the first component of q-p, turned left by a right angle, that is not 0.
int leading_turned_sign(const Point<2>& p, const Point<2>& q) {
  if (q[1] != p[1]) return q[1] > p[1] ? -1 : 1;
  return (q[0] > p[0]) - (q[0] < p[0]);
}

int orient(const std::array<Point<2>, 2>& s, const Point<2>& p) { return orient2d(s[0], s[1], p); }
int orient(const std::array<Point<3>, 3>& s, const Point<3>& p) {
  return orient3d(s[0], s[1], s[2], p);
}

int normal_sign(const std::array<Point<2>, 2>& s) { return leading_turned_sign(s[0], s[1]); }
int normal_sign(const std::array<Point<3>, 3>& s) {
  return leading_cross_sign(s[0], s[1], s[0], s[2]);
}

/// The sign of det(q-p, a-p) with `a` translated: det(q-p, e) decides a zero.
int line_sign(const Point<2>& p, const Point<2>& q, const Point<2>& a) {
  const int sign = orient2d(p, q, a);
  return sign != 0 ? sign : leading_turned_sign(p, q);
}

/// The sign of det(q-p, a-p, b-p) with `a` and `b` translated: det(q-p, e, b-p) + det(q-p, a-p, e)
/// = e.((q-p) x (a-b)) decides a zero.
int line_sign(const Point<3>& p, const Point<3>& q, const Point<3>& a, const Point<3>& b) {
  const int sign = orient3d(p, q, a, b);
  return sign != 0 ? sign : leading_cross_sign(p, q, b, a);
}

bool line_meets(const std::array<Point<2>, 2>& s, const Point<2>& p, const Point<2>& q) {
  return line_sign(p, q, s[0]) != line_sign(p, q, s[1]);
}

bool line_meets(const std::array<Point<3>, 3>& s, const Point<3>& p, const Point<3>& q) {
  const int sign = line_sign(p, q, s[0], s[1]);
  return line_sign(p, q, s[1], s[2]) == sign && line_sign(p, q, s[2], s[0]) == sign;
}

/// The sign of (height of p) + (height of q): the determinant is linear in its last row.
int height_sum_sign(const std::array<Point<2>, 2>& s, const Point<2>& p, const Point<2>& q) {
  const int sign = filtered(difference<2>(s[1], s[0]), sum_of_differences<2>(p, q, s[0]));
  return sign != kUnsure
             ? sign
             : exact_determinant_sign<2>({Row<2>{s[1], s[0]}, Row<2>{p, s[0], q, s[0]}});
}

int height_sum_sign(const std::array<Point<3>, 3>& s, const Point<3>& p, const Point<3>& q) {
  const int sign = filtered(difference<3>(s[1], s[0]), difference<3>(s[2], s[0]),
                            sum_of_differences<3>(p, q, s[0]));
  return sign != kUnsure ? sign
                         : exact_determinant_sign<3>(
                               {Row<3>{s[1], s[0]}, Row<3>{s[2], s[0]}, Row<3>{p, s[0], q, s[0]}});
}

/// The normal in doubles, and the sum of the sizes of the products each component is made of.
void set_normal(const std::array<Point<2>, 2>& s, Point<2>& normal, Point<2>& size) {
  const Point<2> u = difference<2>(s[1], s[0]).entries;
  normal = {-u[1], u[0]};
  size = {std::abs(u[1]), std::abs(u[0])};
}

void set_normal(const std::array<Point<3>, 3>& s, Point<3>& normal, Point<3>& size) {
  const Point<3> u = difference<3>(s[1], s[0]).entries, v = difference<3>(s[2], s[0]).entries;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const double plus = u[j] * v[k], minus = u[k] * v[j];
    normal[i] = plus - minus;
    size[i] = std::abs(plus) + std::abs(minus);
  }
}

}  // namespace

int orient2d(const Point<2>& a, const Point<2>& b, const Point<2>& c) {
  return cross_sign(a, b, a, c);
}

int orient3d(const Point<3>& a, const Point<3>& b, const Point<3>& c, const Point<3>& d) {
  const int sign = filtered(difference<3>(b, a), difference<3>(c, a), difference<3>(d, a));
  return sign != kUnsure ? sign
                         : exact_determinant_sign<3>({Row<3>{b, a}, Row<3>{c, a}, Row<3>{d, a}});
}

template <int D>
SweptSimplex<D>::SweptSimplex(const std::array<Point<D>, static_cast<std::size_t>(D)>& corners)
    : corners_(corners), normal_sign_(normal_sign(corners)), box_{corners[0], corners[0]} {
  for (const Point<D>& corner : corners)
    for (std::size_t i = 0; i < corner.size(); ++i) {
      box_.low[i] = std::min(box_.low[i], corner[i]);
      box_.high[i] = std::max(box_.high[i], corner[i]);
    }
  set_normal(corners_, normal_, normal_size_);
}

template <int D>
int SweptSimplex<D>::side(const Point<D>& p) const {
  const int sign = orient(corners_, p);
  return sign != 0 ? sign : -normal_sign_;
}

template <int D>
bool SweptSimplex<D>::crossed_between_sides(const Point<D>& p, const Point<D>& q) const {
  return line_meets(corners_, p, q);
}

template <int D>
int SweptSimplex<D>::compare_heights(const Point<D>& p, const Point<D>& q) const {
  return side(p) * height_sum_sign(corners_, p, q);
}

template <int D>
bool SweptSimplex<D>::may_meet(const Box<D>& box) const {
  for (std::size_t i = 0; i < box.low.size(); ++i)
    if (box.low[i] > box_.high[i] || box.high[i] < box_.low[i]) return false;

  // The middle of the box lies at `height`, the box reaches `reach` to both sides of it. Rounding
  // errors are below 1e-13 of the terms, underflow below 1e-200 as nothing here exceeds 1e100; with
  // larger numbers the answer is the cautious one.
  double height = 0, reach = 0, terms = 0;
  for (std::size_t i = 0; i < box.low.size(); ++i) {
    const double middle = 0.5 * box.low[i] + 0.5 * box.high[i];
    const double half = 0.5 * box.high[i] - 0.5 * box.low[i];
    const double offset = middle - corners_[0][i];
    if (!(std::max({std::abs(offset), half, normal_size_[i]}) < 1e100)) return true;
    height += normal_[i] * offset;
    reach += std::abs(normal_[i]) * half;
    terms += normal_size_[i] * (std::abs(offset) + std::abs(middle) + half);
  }
  return !(std::abs(height) > reach + 1e-13 * terms + 1e-200);
}

template class SweptSimplex<2>;
template class SweptSimplex<3>;

}  // namespace cleave::cutting
