#include "cleave/fem/lame.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>

namespace cleave::fem {
namespace {

// With as many digits as tell the number from every other one.
std::string shortest(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

}  // namespace

Lame lame_of(double young, double poisson) {
  if (!(std::isfinite(young) && young > 0.0))
    throw std::invalid_argument("Young's modulus must be positive and finite, it is " +
                                shortest(young));
  if (!(poisson > -1.0 && poisson < 0.5))
    throw std::invalid_argument("Poisson's ratio must lie between -1 and 0.5, it is " +
                                shortest(poisson));
  return {young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson)),
          young / (2.0 * (1.0 + poisson))};
}

bool is_positive(const Lame& material) {
  return std::isfinite(material.mu) && material.mu > 0.0 && std::isfinite(material.lambda) &&
         3.0 * material.lambda + 2.0 * material.mu > 0.0;
}

void require_positive(const Lame& material) {
  if (!is_positive(material))
    throw std::invalid_argument(
        "a material needs mu > 0 and 3 lambda + 2 mu > 0, both finite; "
        "lambda is " +
        shortest(material.lambda) + ", mu is " + shortest(material.mu));
}

}  // namespace cleave::fem
