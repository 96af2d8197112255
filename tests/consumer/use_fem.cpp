#include <cleave/fem/lame.hpp>

int main() {
  const cleave::fem::Lame material = cleave::fem::lame_of(2.5, 0.25);
  return material.mu > 0.0 ? 0 : 1;
}
