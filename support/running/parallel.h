#pragma once
#include <functional>

namespace seamline {

/// What a loop's work does with numbers that are too small for a normal float.
enum class Denormals {
  kept,
  zero  ///< SSE's flush-to-zero and denormals-are-zero, on every thread while it works
};

struct ParallelOptions {
  Denormals denormals = Denormals::kept;
  /// Called by the calling thread about ten times a second, and at the end; may be empty. With it the calling
  /// thread does no work.
  std::function<void(int finished)> tick = {};
};

/// The program's one parallel loop: `work(i)` for every i in [0, count) on `threads` threads (0: one for each
/// core), each once, in any order. Without `tick` the calling thread is one of them, so that the work of one
/// thread stays on its core, and gets its floating-point mode back. Once somebody asked to stop, no piece is
/// begun, and Interrupted is thrown when those under way have ended. The first exception of `work` is thrown
/// on after all threads have stopped.
///
/// Not oneTBB's `parallel_for`, which is installed with Embree: stopping, the mode of every worker and the
/// exact number of threads would each need code of ours around it, and there is nothing for it to balance.
void run_parallel(int count, int threads, const std::function<void(int index)>& work,
                  const ParallelOptions& options = {});

/// The number of threads to use when the person named none.
[[nodiscard]] int default_thread_count();

}  // namespace seamline
