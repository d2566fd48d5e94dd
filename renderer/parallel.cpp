#include "renderer/parallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "renderer/geometry.h"
#include "stimuli/support/interrupt.h"

namespace seamline {

void parallel_for(int count, int threads, const std::function<void(int)>& work,
                  const std::function<void(int)>& tick) {
  std::atomic<int> next = 0, finished = 0;
  std::atomic<bool> stop = false;
  std::exception_ptr failure;
  std::mutex mutex;
  std::condition_variable ended;
  int running = std::clamp(threads, 1, std::max(count, 1));
  const auto worker = [&] {
    flush_denormals_to_zero();
    try {
      for (int index = next++; index < count && !stop; index = next++) {
        work(index);
        ++finished;
      }
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
      stop = true;
    }
    const std::lock_guard lock(mutex);
    if (--running == 0) ended.notify_all();
  };
  {
    std::vector<std::jthread> workers;
    const int worker_count = running;
    for (int i = 0; i < worker_count; ++i) workers.emplace_back(worker);
    std::unique_lock lock(mutex);
    while (!ended.wait_for(lock, std::chrono::milliseconds(100), [&] { return running == 0; })) {
      if (interrupted()) stop = true;
      if (tick) tick(finished);
    }
  }
  if (failure) std::rethrow_exception(failure);
  if (stop || interrupted()) throw Interrupted{};
  if (tick) tick(count);
}

int default_thread_count() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace seamline
