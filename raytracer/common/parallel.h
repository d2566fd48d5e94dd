#pragma once
#include "support/running/parallel.h"

namespace seamline::renderer {

/// `run_parallel` as the renderer's loops over pixels want it: denormals are zero. (A depth mesh keeps them:
/// it holds its bound for distances of 1e-38 m too.) `tick` may be empty.
inline void parallel_for(int count, int threads, const std::function<void(int index)>& work,
                         const std::function<void(int finished)>& tick = {}) {
  run_parallel(count, threads, work, {.denormals = Denormals::zero, .tick = tick});
}

}  // namespace seamline::renderer
