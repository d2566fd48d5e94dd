#include "analysis/screening/correlation_screening.h"

#include <algorithm>
#include <cmath>

#include "analysis/statistics/distributions.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

/// Mean over everybody but one, of those who have a score.
Eigen::VectorXd mean_of_others(const Eigen::MatrixXd& score, Eigen::Index person) {
  Eigen::VectorXd mean(score.cols());
  for (Eigen::Index stimulus = 0; stimulus < score.cols(); ++stimulus) {
    double sum = 0, n = 0;
    for (Eigen::Index other = 0; other < score.rows(); ++other)
      if (other != person && !std::isnan(score(other, stimulus))) sum += score(other, stimulus), n += 1;
    mean[stimulus] = n > 0 ? sum / n : nan;
  }
  return mean;
}

/// Means over the stimuli of each condition where both the participant and the others have a score.
Eigen::VectorXd condition_means(const Eigen::VectorXd& values, const Eigen::VectorXd& partner,
                                const std::vector<int>& condition) {
  const int count = condition.empty() ? 0 : *std::max_element(condition.begin(), condition.end()) + 1;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(count), n = Eigen::VectorXd::Zero(count);
  for (Eigen::Index i = 0; i < values.size(); ++i)
    if (!std::isnan(values[i]) && !std::isnan(partner[i])) {
      sum[condition[static_cast<std::size_t>(i)]] += values[i];
      n[condition[static_cast<std::size_t>(i)]] += 1;
    }
  return sum.array() / n.array();  // 0 / 0: no score, no number
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
  for (Eigen::Index person = 0; person < score.rows(); ++person) {
    const Eigen::VectorXd own = score.row(person).transpose(), others = mean_of_others(score, person);
    CorrelationCheck check;
    check.stimuli = pearson_correlation(own, others);
    check.conditions =
        pearson_correlation(condition_means(own, others, condition), condition_means(others, own, condition));
    check.critical = critical_correlation(pairs(own, others), escape_probability);
    check.below_p913 =
        check.stimuli < p913_stimulus_correlation && check.conditions < p913_condition_correlation;
    const bool same_everywhere = !varies(own) && varies(others);
    check.rejected = score.rows() >= 3 && (check.stimuli <= check.critical || same_everywhere);
    checks.push_back(check);
  }
  return checks;
}

}  // namespace seamline::analysis
