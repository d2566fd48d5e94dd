#pragma once
#include "analysis/psychometric/likelihood/fit_problem.h"

namespace seamline::analysis {

/// With more levels than this neighbours are pooled, so that a fit takes no longer for a million levels than
/// for some thousands once they are read.
inline constexpr std::size_t most_unpooled_levels = 2048;

/// Part of the unit axis whose levels stay apart as far as possible.
struct Focus {
  double low = 0, high = 0;
};

/// `levels` (rising) pooled into at most `most_unpooled_levels` bins, each at the mean place of its trials:
/// half of them for the levels in focus, half for the others, each with as many levels as its neighbours. Psi
/// changes so little within a bin, (bin / scale)^2 / 24 of itself, that a fit to bins is the fit to the
/// levels; where the function is so steep that it is not, `search_levels` (search.h) looks again in focus.
[[nodiscard]] std::vector<UnitCounts> pooled_into_bins(const std::vector<UnitCounts>& levels,
                                                       const Focus& focus);

}  // namespace seamline::analysis
