#pragma once
#include <functional>
#include <span>
#include <vector>

namespace seamline::renderer {

/// Seconds of work done in turns, so that what else the machine does falls on all alike.
struct InterleavedTimes {
  std::vector<std::vector<double>> seconds;  ///< of each work, in each repeat

  [[nodiscard]] double median_s(std::size_t work) const;
  /// The median of `work`'s time over that of `other` in the same repeat.
  [[nodiscard]] double median_ratio(std::size_t work, std::size_t other) const;
};

/// Which clock: processor time, summed over the process's threads, does not count what other programs take;
/// wall time is what people wait.
enum class Clock { processor, wall };

/// Runs each work once unmeasured, then all of them in turn, `repeats` times.
[[nodiscard]] InterleavedTimes time_interleaved(int repeats, Clock clock,
                                                std::span<const std::function<void()>> works);

/// Seconds of one run.
[[nodiscard]] double time_once(Clock clock, const std::function<void()>& work);

}  // namespace seamline::renderer
