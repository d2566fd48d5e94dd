#include "analysis/scores/opinion_score.h"

#include <algorithm>
#include <cmath>

#include "analysis/statistics/distributions.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

/// Mean and variance (n - 1) of scores.
struct Moments {
  double n = 0, mean = nan, variance = nan;
};

Moments moments_of(const Eigen::VectorXd& scores) {
  double n = 0, sum = 0, squares = 0;
  for (const double score : scores)
    if (!std::isnan(score)) n += 1, sum += score;
  if (n == 0) return {};
  const double mean = sum / n;
  for (const double score : scores)
    if (!std::isnan(score)) squares += (score - mean) * (score - mean);
  return {.n = n, .mean = mean, .variance = n > 1 ? squares / (n - 1) : nan};
}

/// The same without one of the scores (NaN: nobody's), from those of all.
Moments moments_without(const Moments& all, double score) {
  if (std::isnan(score)) return all;
  const double n = all.n - 1;
  if (n <= 0) return {};
  const double mean = all.mean + (all.mean - score) / n;
  const double squares = all.variance * n - (score - all.mean) * (score - mean);
  return {.n = n, .mean = mean, .variance = n > 1 ? std::max(0.0, squares) / (n - 1) : nan};
}

/// Least squares through the origin: a = sum(S^2 f) / sum(f^2), f = (x - L)(H - x).
SosParameter fit_sos(const std::vector<Moments>& stimuli, const RatingScale& scale) {
  SosParameter sos;
  double product = 0, square = 0;
  for (const Moments& moments : stimuli) {
    if (moments.n < 2) continue;
    const double f = (moments.mean - scale.lowest) * (scale.highest - moments.mean);
    product += moments.variance * f;
    square += f * f;
    ++sos.stimuli;
  }
  sos.a = square > 0 ? product / square : nan;
  sos.ci95_low = sos.ci95_high = nan;
  return sos;
}

}  // namespace

std::vector<OpinionScore> opinion_scores(const Eigen::MatrixXd& score) {
  std::vector<OpinionScore> scores;
  for (Eigen::Index stimulus = 0; stimulus < score.cols(); ++stimulus) {
    const Moments moments = moments_of(score.col(stimulus));
    const double half = moments.n > 1
                            ? student_quantile(moments.n - 1, 0.975) * std::sqrt(moments.variance / moments.n)
                            : nan;
    scores.push_back({.n = static_cast<int>(moments.n),
                      .mean = moments.mean,
                      .sd = std::sqrt(moments.variance),
                      .ci95_low = moments.mean - half,
                      .ci95_high = moments.mean + half});
  }
  return scores;
}

SosParameter sos_parameter(const Eigen::MatrixXd& score, const RatingScale& scale) {
  std::vector<Moments> all;
  for (Eigen::Index stimulus = 0; stimulus < score.cols(); ++stimulus)
    all.push_back(moments_of(score.col(stimulus)));
  SosParameter sos = fit_sos(all, scale);
  const double n = score.rows();
  if (n < 3) return sos;
  double sum = 0, squares = 0;
  std::vector<double> without;
  std::vector<Moments> others(all.size());
  for (Eigen::Index person = 0; person < score.rows(); ++person) {
    for (std::size_t s = 0; s < all.size(); ++s)
      others[s] = moments_without(all[s], score(person, static_cast<Eigen::Index>(s)));
    without.push_back(fit_sos(others, scale).a);
  }
  for (double a : without) sum += a / n;
  for (double a : without) squares += (a - sum) * (a - sum);
  const double half = student_quantile(n - 1, 0.975) * std::sqrt((n - 1) / n * squares);
  sos.ci95_low = sos.a - half;
  sos.ci95_high = sos.a + half;
  return sos;
}

}  // namespace seamline::analysis
