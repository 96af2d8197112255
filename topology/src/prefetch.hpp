#pragma once

namespace cleave::topology::detail {

/// Asks the processor to bring `place` into its caches. Does nothing else; any address will do.
inline void prefetch(const void* place) {
#if defined(__GNUC__)
  __builtin_prefetch(place);
#else
  static_cast<void>(place);
#endif
}

}  // namespace cleave::topology::detail
