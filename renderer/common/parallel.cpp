#include "renderer/common/parallel.h"

#include <xmmintrin.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <thread>

#include "renderer/common/floating_point.h"
#include "support/running/interrupt.h"
#include "support/running/parallel.h"

namespace seamline::renderer {
namespace {

/// Gives the calling thread its floating-point mode back.
class FloatingPointMode {
 public:
  FloatingPointMode() = default;
  ~FloatingPointMode() { _mm_setcsr(before_); }
  FloatingPointMode(const FloatingPointMode&) = delete;
  FloatingPointMode& operator=(const FloatingPointMode&) = delete;

 private:
  unsigned before_ = _mm_getcsr();
};

void run_here(int count, const std::function<void(int)>& work) {
  const FloatingPointMode mode;
  flush_denormals_to_zero();
  for (int index = 0; index < count; ++index) {
    work(index);
    if (interrupted()) throw Interrupted{};
  }
}

}  // namespace

void parallel_for(int count, int threads, const std::function<void(int)>& work,
                  const std::function<void(int)>& tick) {
  // Another thread would start on another core, whose caches hold nothing yet.
  if (threads <= 1 && !tick) return run_here(count, work);
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

}  // namespace seamline::renderer
