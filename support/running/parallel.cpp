#include "support/running/parallel.h"

#include <immintrin.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "support/running/interrupt.h"

namespace seamline {
namespace {

/// Sets the calling thread's floating-point mode, and gives it its own back.
class FloatingPointMode {
 public:
  explicit FloatingPointMode(Denormals denormals) {
    if (denormals == Denormals::kept) return;
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
  }
  ~FloatingPointMode() { _mm_setcsr(before_); }
  FloatingPointMode(const FloatingPointMode&) = delete;
  FloatingPointMode& operator=(const FloatingPointMode&) = delete;

 private:
  unsigned before_ = _mm_getcsr();
};

/// What the threads of one loop share.
class Loop {
 public:
  Loop(int count, Denormals denormals, const std::function<void(int)>& work)
      : count_(count), denormals_(denormals), work_(work) {}

  /// Takes pieces until there are none, somebody asked to stop, or a piece failed.
  void work() {
    const FloatingPointMode mode(denormals_);
    try {
      for (int index = next_++; index < count_; index = next_++) {
        stop_if_interrupted();
        work_(index);
        ++finished_;
      }
    } catch (...) {
      const std::lock_guard guard(lock_);
      if (!failure_) failure_ = std::current_exception();
      next_ = count_;
    }
  }

  /// What a helper does: `work`, and says that it has ended.
  void help() {
    work();
    const std::lock_guard guard(lock_);
    ++ended_;
    has_ended_.notify_one();
  }

  /// Calls `tick` until so many helpers have ended.
  void watch(int helpers, const std::function<void(int)>& tick) {
    std::unique_lock guard(lock_);
    const auto all_ended = [&] { return ended_ == helpers; };
    while (!has_ended_.wait_for(guard, std::chrono::milliseconds(100), all_ended)) {
      guard.unlock();
      tick(finished_);
      guard.lock();
    }
  }

  void throw_failure() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  const int count_;
  const Denormals denormals_;
  const std::function<void(int)>& work_;
  std::atomic<int> next_ = 0, finished_ = 0;
  std::mutex lock_;
  std::condition_variable has_ended_;
  int ended_ = 0;
  std::exception_ptr failure_;
};

}  // namespace

void run_parallel(int count, int threads, const std::function<void(int)>& work,
                  const ParallelOptions& options) {
  Loop loop(count, options.denormals, work);
  const int used = std::min(threads > 0 ? threads : default_thread_count(), count);
  const bool watches = static_cast<bool>(options.tick);
  {
    std::vector<std::jthread> helpers;
    for (int i = watches ? 0 : 1; i < used; ++i) helpers.emplace_back([&loop] { loop.help(); });
    if (watches)
      loop.watch(static_cast<int>(helpers.size()), options.tick);
    else
      loop.work();
  }
  loop.throw_failure();
  stop_if_interrupted();
  if (watches) options.tick(count);
}

int default_thread_count() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace seamline
