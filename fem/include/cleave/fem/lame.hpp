#pragma once

/// Linear elasticity on a complex of tetrahedra, matrix-free.
namespace cleave::fem {

/// The Lamé parameters of an isotropic material, in pascals.
struct Lame {
  double lambda = 0.0;
  double mu = 0.0;
};

/// From Young's modulus (pascals) and Poisson's ratio. Throws std::invalid_argument unless
/// young > 0 and -1 < poisson < 1/2, both finite.
Lame lame_of(double young, double poisson);

/// Whether mu > 0 and 3 lambda + 2 mu > 0, both finite: what the elastic energy needs to be
/// positive on every strain.
bool is_positive(const Lame& material);

/// Throws std::invalid_argument unless is_positive(material).
void require_positive(const Lame& material);

}  // namespace cleave::fem
