#include "analysis/screening/kurtosis_screening.h"

#include <cmath>
#include <cstdlib>

namespace seamline::analysis {

namespace {

constexpr double extreme_share = 0.05;
constexpr double one_sided_share = 0.3;

/// How far from the mean of a stimulus a score is extreme, and that mean. A limit of 0: nothing is extreme.
struct ExtremeLimit {
  double mean = 0, distance = 0;
};

ExtremeLimit limit_of(const Eigen::VectorXd& scores) {
  double n = 0, sum = 0, m2 = 0, m4 = 0;
  for (double score : scores)
    if (!std::isnan(score)) n += 1, sum += score;
  if (n < 2) return {};
  const double mean = sum / n;
  for (double score : scores)
    if (!std::isnan(score)) {
      const double square = (score - mean) * (score - mean);
      m2 += square / n;
      m4 += square * square / n;
    }
  if (m2 < 1e-12) return {};  // all agree, but for the rounding of the mean
  const double kurtosis = m4 / (m2 * m2);
  const double sd = std::sqrt(m2 * n / (n - 1));
  const bool near_normal = kurtosis >= 2 && kurtosis <= 4;
  return {.mean = mean, .distance = sd * (near_normal ? 2 : std::sqrt(20.0))};
}

bool is_rejected(const KurtosisCount& count) {
  const int extreme = count.above + count.below;
  if (extreme == 0) return false;
  return extreme > extreme_share * count.stimuli &&
         std::abs(count.above - count.below) < one_sided_share * extreme;
}

}  // namespace

std::vector<KurtosisCount> screen_by_kurtosis(const Eigen::MatrixXd& score) {
  std::vector<KurtosisCount> counts(score.rows());
  for (Eigen::Index stimulus = 0; stimulus < score.cols(); ++stimulus) {
    const ExtremeLimit limit = limit_of(score.col(stimulus));
    for (Eigen::Index person = 0; person < score.rows(); ++person) {
      const double value = score(person, stimulus);
      if (std::isnan(value)) continue;
      KurtosisCount& count = counts[person];
      ++count.stimuli;
      if (limit.distance == 0) continue;
      if (value >= limit.mean + limit.distance) ++count.above;
      if (value <= limit.mean - limit.distance) ++count.below;
    }
  }
  for (KurtosisCount& count : counts) count.rejected = is_rejected(count);
  return counts;
}

}  // namespace seamline::analysis
