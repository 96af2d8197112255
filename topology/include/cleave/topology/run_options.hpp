#pragma once
#include <functional>

namespace cleave::topology {

/// How work on a whole mesh is done. The result does not depend on it.
struct RunOptions {
  /// How many threads share the work, the calling one included; less than 1 counts as 1, and more
  /// than the cells keep busy are not started.
  int threads = 1;

  /// Told now and then, a few hundred times at most, which fraction of the work is done (from 0 to
  /// 1, ascending), on the calling thread. What it throws ends the work and comes out of it.
  std::function<void(double)> progress = {};
};

}  // namespace cleave::topology
