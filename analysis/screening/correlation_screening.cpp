#include "analysis/screening/correlation_screening.h"

#include <algorithm>
#include <cmath>

#include "analysis/statistics/distributions.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

/// Sums over people, of those who have a score, so that the mean of the others takes one subtraction.
struct ScoreSums {
  Eigen::VectorXd sum, n;  ///< one a stimulus

  explicit ScoreSums(const Eigen::MatrixXd& score)
      : sum(Eigen::VectorXd::Zero(score.cols())), n(Eigen::VectorXd::Zero(score.cols())) {
    for (Eigen::Index stimulus = 0; stimulus < score.cols(); ++stimulus)
      for (const double value : score.col(stimulus))
        if (!std::isnan(value)) sum[stimulus] += value, n[stimulus] += 1;
  }

  /// Mean over everybody but one; NaN where nobody else has a score.
  [[nodiscard]] Eigen::VectorXd mean_of_others(const Eigen::VectorXd& own) const {
    Eigen::VectorXd mean(own.size());
    for (Eigen::Index stimulus = 0; stimulus < own.size(); ++stimulus) {
      const bool answered = !std::isnan(own[stimulus]);
      const double others = n[stimulus] - (answered ? 1 : 0);
      mean[stimulus] = others > 0 ? (sum[stimulus] - (answered ? own[stimulus] : 0)) / others : nan;
    }
    return mean;
  }
};

/// Means over the stimuli of each condition where both the participant and the others have a score.
Eigen::VectorXd condition_means(const Eigen::VectorXd& values, const Eigen::VectorXd& partner,
                                const std::vector<int>& condition) {
  const int count = condition.empty() ? 0 : *std::max_element(condition.begin(), condition.end()) + 1;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(count), n = Eigen::VectorXd::Zero(count);
  for (Eigen::Index i = 0; i < values.size(); ++i)
    if (!std::isnan(values[i]) && !std::isnan(partner[i])) {
      sum[condition[i]] += values[i];
      n[condition[i]] += 1;
    }
  return (n.array() > 0).select(sum.array() / n.array().max(1.0), nan);
}

int pairs(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  int count = 0;
  for (Eigen::Index i = 0; i < a.size(); ++i) count += std::isnan(a[i]) || std::isnan(b[i]) ? 0 : 1;
  return count;
}

bool varies(const Eigen::VectorXd& values) {
  double low = infinity, high = -low;
  for (double value : values)
    if (!std::isnan(value)) low = std::min(low, value), high = std::max(high, value);
  return high - low > 1e-12;
}

}  // namespace

double pearson_correlation(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  double n = 0, mean_a = 0, mean_b = 0, aa = 0, bb = 0, ab = 0;
  const auto both = [&](Eigen::Index i) { return !std::isnan(a[i]) && !std::isnan(b[i]); };
  for (Eigen::Index i = 0; i < a.size(); ++i)
    if (both(i)) n += 1, mean_a += a[i], mean_b += b[i];
  if (n < 3) return nan;
  mean_a /= n;
  mean_b /= n;
  for (Eigen::Index i = 0; i < a.size(); ++i)
    if (both(i)) {
      aa += (a[i] - mean_a) * (a[i] - mean_a);
      bb += (b[i] - mean_b) * (b[i] - mean_b);
      ab += (a[i] - mean_a) * (b[i] - mean_b);
    }
  return aa > 1e-12 && bb > 1e-12 ? ab / std::sqrt(aa * bb) : nan;
}

double critical_correlation(int count, double probability) {
  if (count < 3) return 1;
  const double t = student_quantile(count - 2, 1 - probability);
  return t / std::sqrt(count - 2 + t * t);
}

std::vector<CorrelationCheck> screen_by_correlation(const Eigen::MatrixXd& score,
                                                    const std::vector<int>& condition) {
  std::vector<CorrelationCheck> checks;
  const ScoreSums sums(score);
  for (Eigen::Index person = 0; person < score.rows(); ++person) {
    const Eigen::VectorXd own = score.row(person).transpose(), others = sums.mean_of_others(own);
    CorrelationCheck check;
    check.stimuli = pearson_correlation(own, others);
    check.conditions =
        pearson_correlation(condition_means(own, others, condition), condition_means(others, own, condition));
    check.critical = critical_correlation(pairs(own, others), escape_probability);
    // A correlation may be unknown, and is below nothing then.
    check.below_p913 = std::isless(check.stimuli, p913_stimulus_correlation) &&
                       std::isless(check.conditions, p913_condition_correlation);
    const bool same_everywhere = !varies(own) && varies(others);
    check.rejected =
        score.rows() >= 3 && (std::islessequal(check.stimuli, check.critical) || same_everywhere);
    checks.push_back(check);
  }
  return checks;
}

}  // namespace seamline::analysis
