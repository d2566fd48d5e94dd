#include "analysis/thresholds/thresholds.h"

#include <cassert>
#include <cmath>

#include "analysis/statistics/logistic_level.h"
#include "analysis/thresholds/closed_estimates.h"
#include "analysis/thresholds/curve_replicates.h"
#include "analysis/thresholds/threshold_rules.h"

namespace seamline::analysis {

namespace {

/// Everything that is read off a curve: the thresholds of record, and PT and SN off the logistic beside them.
const std::vector<ThresholdRule>& all_rules() {
  static const std::vector<ThresholdRule> rules = [] {
    std::vector<ThresholdRule> all(paper_rules.begin(), paper_rules.end());
    all.push_back({"PT", "perceptual_threshold", "", perceptual_level, CurveEstimator::logistic,
                   IntervalMethod::score_test, &CurveThresholds::perceptual_logistic});
    all.push_back({"SN", "slightly_noticeable", "", slight_level, CurveEstimator::logistic,
                   IntervalMethod::score_test, &CurveThresholds::slightly_noticeable_logistic});
    return all;
  }();
  return rules;
}

/// Where a curve itself puts a threshold: a point, or what it leaves open.
LevelInterval range_of(const ThresholdRule& rule, const CurveThresholds& curve,
                       const std::vector<double>& level_x) {
  if (!rule.level) return curve.logistic.centre_range;
  if (rule.estimator == CurveEstimator::logistic)
    return logistic_level_range(*rule.level, curve.logistic, level_x);
  const double x = largest_x_at(*rule.level, level_x, curve.isotonic.value);
  return {.low_x = x, .high_x = x};
}

LevelInterval score_test_interval(const ThresholdRule& rule, const CurveThresholds& curve,
                                  const std::vector<double>& level_x, const MeanVector& means, int people) {
  assert(rule.level);  // a centre has no level to test
  return rule.estimator == CurveEstimator::logistic
             ? logistic_level_interval(*rule.level, curve.logistic, level_x, means, people)
             : level_interval(*rule.level, level_x, means, people);
}

void add_intervals(const ArtifactScores& scores, const std::vector<double>& level_x,
                   const ResamplingRequest& request, ArtifactThresholds& result) {
  const Eigen::MatrixXd on_axis = scores.noticeability.leftCols(static_cast<Eigen::Index>(level_x.size()));
  const MeanVector means = mean_and_covariance(on_axis);
  const int people = means.fewest;
  CurveThresholds& found = result.estimates;
  CurveIntervals bootstrap;  // open where none is asked for
  if (request.replicates > 0) {
    CurveReplicates replicates(level_x, request.replicates);
    for_each_replicate(on_axis, request, [&](int replicate, const Eigen::VectorXd& mean) {
      replicates.set(replicate, {mean.data(), static_cast<std::size_t>(mean.size())});
    });
    bootstrap = replicates.intervals(expanded_levels(people));
  }
  result.perceptual_bootstrap = bootstrap.perceptual;
  result.slightly_noticeable_bootstrap = bootstrap.slightly_noticeable;
  result.perceptual_logistic_bootstrap = bootstrap.perceptual_logistic;
  result.slightly_noticeable_logistic_bootstrap = bootstrap.slightly_noticeable_logistic;
  const auto resampled = [&](const ThresholdRule& rule) {
    if (!rule.level) return bootstrap.inflection;
    const bool logistic = rule.estimator == CurveEstimator::logistic, pt = *rule.level == perceptual_level;
    if (logistic) return pt ? bootstrap.perceptual_logistic : bootstrap.slightly_noticeable_logistic;
    return pt ? bootstrap.perceptual : bootstrap.slightly_noticeable;
  };
  for (const ThresholdRule& rule : all_rules())
    (found.*rule.estimate).ci95 = rule.interval == IntervalMethod::score_test
                                      ? score_test_interval(rule, found, level_x, means, people)
                                      : resampled(rule);
}

}  // namespace

std::vector<double> log2_widths(const std::vector<int>& width_px) {
  std::vector<double> level_x;
  for (int width : width_px) level_x.push_back(std::log2(width));
  return level_x;
}

void keep_closed(CurveThresholds& found, const std::vector<double>& level_x, const LevelAxis& axis) {
  for (const ThresholdRule& rule : all_rules())
    keep_closed(found.*rule.estimate, range_of(rule, found, level_x), axis);
}

CurveThresholds thresholds_of_means(const std::vector<double>& level_x, const std::vector<double>& means,
                                    const LevelAxis& axis) {
  CurveThresholds result;
  result.isotonic = fit_non_increasing(means);
  result.logistic = Logistic4Fitter(level_x).fit(means);
  for (const ThresholdRule& rule : all_rules()) {
    result.*rule.estimate = rule.level
                                ? estimate_in(range_of(rule, result, level_x), result.logistic, level_x, axis)
                                : centre_of(result.logistic, level_x, axis);
  }
  return result;
}

ArtifactThresholds estimate_thresholds(const ArtifactScores& scores, const ResamplingRequest& request) {
  const std::vector<double> level_x = levels_on_axis(scores), means = means_on_axis(scores);
  ArtifactThresholds result{.artifact = scores.artifact,
                            .condition = scores.condition,
                            .participants = static_cast<int>(scores.people.size()),
                            .fewest = people_at_levels(scores).first,
                            .estimates = {},
                            .perceptual_bootstrap = {},
                            .slightly_noticeable_bootstrap = {},
                            .perceptual_logistic_bootstrap = {},
                            .slightly_noticeable_logistic_bootstrap = {}};
  if (means.empty()) {
    const ThresholdEstimate nothing{
        .level_x = {},
        .reason = scores.cells.empty() ? NoThreshold::nobody_answered : NoThreshold::no_level_shown,
        .ci95 = {}};
    result.estimates.perceptual = result.estimates.slightly_noticeable = result.estimates.inflection =
        result.estimates.perceptual_logistic = result.estimates.slightly_noticeable_logistic = nothing;
    return result;
  }
  result.estimates = thresholds_of_means(level_x, means, scores.axis);
  if (result.fewest >= 2) add_intervals(scores, level_x, request, result);
  keep_closed(result.estimates, level_x, scores.axis);
  return result;
}

}  // namespace seamline::analysis
