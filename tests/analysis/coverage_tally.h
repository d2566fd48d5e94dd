#pragma once
#include <cmath>
#include <cstdio>

#include "analysis/scores/level_words.h"
#include "analysis/statistics/estimate.h"

namespace seamline::test {
using namespace analysis;

/// How often intervals held a planted value, and by which end they missed it.
struct CoverageTally {
  int studies = 0, held = 0, too_high = 0, too_low = 0, open = 0, estimated = 0;

  void add(const LevelInterval& interval, double level_x) {
    ++studies;
    if (interval.low_x > level_x)
      ++too_high;
    else if (interval.high_x < level_x)
      ++too_low;
    else
      ++held;
    open += std::isfinite(interval.low_x) && std::isfinite(interval.high_x) ? 0 : 1;
  }
  void add(const LevelInterval& interval, const ThresholdEstimate& planted) {
    if (planted.level_x) add(interval, *planted.level_x);
  }
  void add(const ThresholdEstimate& found, const ThresholdEstimate& planted) {
    if (planted.level_x) add(found.ci95, *planted.level_x);
    estimated += found.level_x ? 1 : 0;
  }
  [[nodiscard]] double share(int count) const { return 100.0 * count / studies; }
  [[nodiscard]] double percent() const { return share(held); }

  /// A line of the documentation's tables; `other` is an interval of the same quantity for comparison.
  void print(const char* population, const char* artifact, const char* quantity,
             const ThresholdEstimate& planted, const CoverageTally* other) const {
    if (!planted.level_x) {
      std::printf("| %s | %s | %s | %s |  |  |  |  |  |\n", population, artifact, quantity,
                  reason_text(planted, {}).c_str());
      return;
    }
    std::printf("| %s | %s | %s | %.0f | %.1f | %.1f | %.1f | %.0f | ", population, artifact, quantity,
                std::exp2(*planted.level_x), percent(), share(too_high), share(too_low), share(open));
    if (other != nullptr) std::printf("%.1f", other->percent());
    std::printf(" |\n");
    std::fflush(stdout);
  }
};

}  // namespace seamline::test
