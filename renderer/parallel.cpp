#include "renderer/parallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <thread>

#include "renderer/geometry.h"
#include "stimuli/support/interrupt.h"
#include "stimuli/support/parallel.h"

namespace seamline {

void parallel_for(int count, int threads, const std::function<void(int)>& work,
                  const std::function<void(int)>& tick) {
  std::atomic<int> finished = 0;
  std::atomic<bool> stop = false;
  std::future<void> ended = std::async(std::launch::async, [&] {
    run_parallel(count, std::max(threads, 1), [&](int index) {
      if (stop) return;
      flush_denormals_to_zero();
      work(index);
      ++finished;
    });
  });
  while (ended.wait_for(std::chrono::milliseconds(100)) != std::future_status::ready) {
    if (interrupted()) stop = true;
    if (tick) tick(finished);
  }
  ended.get();
  if (stop || interrupted()) throw Interrupted{};
  if (tick) tick(count);
}

int default_thread_count() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace seamline
