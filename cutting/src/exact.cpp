#include "exact.hpp"

#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

namespace cleave::cutting::detail {
namespace {

namespace mp = boost::multiprecision;

/// As large as needed; up to 512 bits without the heap, which coordinates of like size never
/// exceed.
using Integer = mp::number<mp::cpp_int_backend<512>, mp::et_off>;

/// A double as mantissa * 2^exponent, the mantissa odd or 0.
struct Dyadic {
  std::int64_t mantissa = 0;
  int exponent = 0;
};

Dyadic dyadic(double x) {
  if (x == 0) return {};
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  const auto whole = static_cast<std::int64_t>(std::ldexp(fraction, 53));
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(whole));
  return {whole / (std::int64_t{1} << zeros), exponent - 53 + zeros};
}

template <int D>
int least_exponent(const std::array<Row<D>, static_cast<std::size_t>(D)>& rows) {
  int least = std::numeric_limits<int>::max();
  for (const Row<D>& row : rows)
    for (const Point<D>* point : {&row.to, &row.from, &row.also_to, &row.also_from})
      for (const double x : *point)
        if (x != 0) least = std::min(least, dyadic(x).exponent);
  return least;
}

Integer scaled(double x, int least) {
  const Dyadic d = dyadic(x);
  if (d.mantissa == 0) return 0;
  return Integer(d.mantissa) << static_cast<unsigned>(d.exponent - least);
}

Integer determinant(const std::array<std::array<Integer, 2>, 2>& m) {
  return m[0][0] * m[1][1] - m[0][1] * m[1][0];
}

Integer determinant(const std::array<std::array<Integer, 3>, 3>& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) +
         m[0][1] * (m[1][2] * m[2][0] - m[1][0] * m[2][2]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

}  // namespace

template <int D>
int exact_determinant_sign(const std::array<Row<D>, static_cast<std::size_t>(D)>& rows) {
  constexpr auto kSize = static_cast<std::size_t>(D);
  const int least = least_exponent<D>(rows);
  std::array<std::array<Integer, kSize>, kSize> m;
  for (std::size_t i = 0; i < kSize; ++i)
    for (std::size_t j = 0; j < kSize; ++j)
      m[i][j] = scaled(rows[i].to[j], least) - scaled(rows[i].from[j], least) +
                scaled(rows[i].also_to[j], least) - scaled(rows[i].also_from[j], least);
  return determinant(m).sign();
}

template int exact_determinant_sign<2>(const std::array<Row<2>, 2>&);
template int exact_determinant_sign<3>(const std::array<Row<3>, 3>&);

}  // namespace cleave::cutting::detail
