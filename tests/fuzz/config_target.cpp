// A configuration of `cleave check`: refused with an InputError, or settings for every file.
#include "check_config.hpp"

#include <cmath>

#include "error.hpp"
#include "targets.hpp"

namespace cleave::fuzz {

void fuzz_config(Bytes bytes) {
  static const Folder folder;
  try {
    const auto config = app::read_check_config(folder.put(".cleave-check.json", text_of(bytes)));
    for (const char* name : {"a.mesh", "scans/left/liver-2.msh", "../b.vtu", "Ω/ü.inp"}) {
      const auto file = config.folder / name;
      static_cast<void>(config.excludes(file));
      const app::CheckSettings settings = config.settings_for(file, {});
      FUZZ_REQUIRE(settings.flat_ratio >= 0 && std::isfinite(settings.flat_ratio));
      FUZZ_REQUIRE(settings.coincident_distance >= 0 &&
                   std::isfinite(settings.coincident_distance));
    }
  } catch (const app::InputError&) {
  }
}

}  // namespace cleave::fuzz
