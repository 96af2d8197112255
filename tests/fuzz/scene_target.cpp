// A scene: refused with an InputError, or what its parts promise.
#include "scene.hpp"

#include <cmath>

#include "cleave/fem/lame.hpp"
#include "error.hpp"
#include "targets.hpp"

namespace cleave::fuzz {

void fuzz_scene(Bytes bytes) {
  try {
    const app::Scene scene = app::parse_scene(text_of(bytes), "scene.json", "folder");
    for (const app::MaterialSpec& material : scene.materials)
      FUZZ_REQUIRE(fem::is_positive(material.lame));
    for (const app::SupportSpec& support : scene.supports)
      FUZZ_REQUIRE(std::isfinite(support.value));
    for (const app::LoadSpec& load : scene.loads)
      for (const double x : load.vector) FUZZ_REQUIRE(std::isfinite(x));
    if (scene.solve) FUZZ_REQUIRE(scene.solve->tolerance > 0);
    FUZZ_REQUIRE(!scene.title.empty());
  } catch (const app::InputError&) {
  }
}

}  // namespace cleave::fuzz
