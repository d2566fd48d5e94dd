#pragma once
#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include "support/running/interrupt.h"

namespace seamline::renderer {

/// Calls work(i) for every i in [0, count) on `threads` threads (0: one for each core), in no particular
/// order. The work must not throw, and must not depend on the order; Interrupted is thrown when the person
/// asked to stop. Denormals are kept, unlike in
/// `parallel_for`: a mesh holds its bound for distances of 1e-38 m too.
template <class Work>
void for_each_in_parallel(int count, int threads, const Work& work) {
  const int cores = threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency());
  std::atomic<int> next = 0;
  const auto worker = [&] {
    for (int i = next++; i < count && !interrupted(); i = next++) work(i);
  };
  {
    std::vector<std::jthread> helpers;
    for (int i = 1; i < std::min(cores, count); ++i) helpers.emplace_back(worker);
    worker();
  }
  stop_if_interrupted();
}

}  // namespace seamline::renderer
