#include "laboratory/bench/bench_timing.h"

#include <algorithm>
#include <ctime>

namespace seamline::renderer {
namespace {

double now_s(Clock clock) {
  timespec time{};
  clock_gettime(clock == Clock::processor ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC, &time);
  return time.tv_sec + 1e-9 * time.tv_nsec;
}

double upper_median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

double InterleavedTimes::median_s(std::size_t work) const {
  return upper_median(seconds[work]);
}

double InterleavedTimes::median_ratio(std::size_t work, std::size_t other) const {
  std::vector<double> ratios;
  for (std::size_t repeat = 0; repeat < seconds[work].size(); ++repeat)
    ratios.push_back(seconds[work][repeat] / seconds[other][repeat]);
  return upper_median(ratios);
}

double time_once(Clock clock, const std::function<void()>& work) {
  const double start_s = now_s(clock);
  work();
  return now_s(clock) - start_s;
}

InterleavedTimes time_interleaved(int repeats, Clock clock, std::span<const std::function<void()>> works) {
  for (const auto& work : works) work();
  InterleavedTimes timings;
  timings.seconds.resize(works.size());
  for (int repeat = 0; repeat < repeats; ++repeat)
    for (std::size_t i = 0; i < works.size(); ++i) timings.seconds[i].push_back(time_once(clock, works[i]));
  return timings;
}

}  // namespace seamline::renderer
