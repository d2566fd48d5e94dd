#include "analysis/psychometric/likelihood/level_bins.h"

#include <algorithm>

namespace seamline::analysis {

namespace {

using Iterator = std::vector<UnitCounts>::const_iterator;

void add_bins(Iterator first, Iterator last, std::size_t bins, std::vector<UnitCounts>& pooled) {
  const std::size_t count = last - first;
  bins = std::min(bins, count);
  for (std::size_t bin = 0; bin < bins; ++bin) {
    UnitCounts sum;
    for (std::size_t i = bin * count / bins; i < (bin + 1) * count / bins; ++i) {
      const UnitCounts& level = first[static_cast<std::ptrdiff_t>(i)];
      sum.n += level.n;
      sum.k += level.k;
      sum.t += (level.t - sum.t) * level.n / sum.n;
    }
    pooled.push_back(sum);
  }
}

}  // namespace

std::vector<UnitCounts> pooled_into_bins(const std::vector<UnitCounts>& levels, const Focus& focus) {
  if (levels.size() <= most_unpooled_levels) return levels;
  const auto place = [&](double t) {
    return std::lower_bound(levels.begin(), levels.end(), t,
                            [](const UnitCounts& level, double at) { return level.t < at; });
  };
  const Iterator first = place(focus.low), last = std::max(first, place(focus.high));
  const std::size_t before = first - levels.begin();
  const auto outside = before + static_cast<std::size_t>(levels.end() - last);
  const std::size_t half = most_unpooled_levels / 2;
  std::vector<UnitCounts> pooled;
  const std::size_t share = outside > 0 ? half * before / outside : 0;
  add_bins(levels.begin(), first, before > 0 ? std::max<std::size_t>(share, 1) : 0, pooled);
  add_bins(first, last, half, pooled);
  add_bins(last, levels.end(), last < levels.end() ? std::max<std::size_t>(half - share, 1) : 0, pooled);
  return pooled;
}

}  // namespace seamline::analysis
