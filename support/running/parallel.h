#pragma once
#include <functional>

namespace seamline {

/// Runs `work(i)` for i in 0..count-1 on `threads` threads (0: as many as the machine has), in no particular
/// order. The first exception of a thread is thrown again here.
void run_parallel(int count, int threads, const std::function<void(int index)>& work);

}  // namespace seamline
