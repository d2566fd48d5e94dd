#pragma once
#include <functional>

namespace seamline::renderer {

/// Runs `work(index)` for every index in [0, count) on `threads` threads, each index once, in any order;
/// denormals are flushed to zero on every worker. The calling thread meanwhile calls `tick(finished)` about
/// ten times a second (may be empty). Throws Interrupted when the person asked to stop, after the pieces
/// under way have ended; an exception of `work` is thrown on after all workers have stopped. For one thread
/// without `tick` the calling thread does the work itself, and gets its floating-point mode back.
void parallel_for(int count, int threads, const std::function<void(int index)>& work,
                  const std::function<void(int finished)>& tick = {});

/// The number of threads to use when the person named none.
[[nodiscard]] int default_thread_count();

}  // namespace seamline::renderer
