#include "analysis/log_analysis/few_people.h"

#include <fmt/format.h>

#include "analysis/log_analysis/task_words.h"

namespace seamline::analysis {
namespace {

/// Under this many people intervals over participants were seen to fail (documentation/evidence/coverage.md).
constexpr int fewest_for_intervals = 5;

}  // namespace

std::string few_people_sentence(const Analysis& analysis) {
  const int used = analysis.counts.used;
  if (used < 2 || used >= fewest_for_intervals) return {};
  if (!asks_ratings(analysis.log))
    return fmt::format(
        "With {} participants little is known of how people differ: intervals over participants are wide, and "
        "each participant's own thresholds (thresholds_people.csv) say more.",
        used);
  return fmt::format(
      "With {} participants the 95 % intervals hold the truth less often than they say: in simulated studies of "
      "two to four people those of IP in 59 to 93 %, those of PT and SN in 82 to 98 %.",
      used);
}

}  // namespace seamline::analysis
