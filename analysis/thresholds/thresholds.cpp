#include "analysis/thresholds/thresholds.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/statistics/logistic_level.h"
#include "analysis/thresholds/curve_replicates.h"

namespace seamline::analysis {

namespace {

ThresholdEstimate level_estimate(double level, const std::vector<double>& level_x,
                                 const std::vector<double>& fit) {
  const double width = largest_x_at(level, level_x, fit);
  ThresholdEstimate estimate;
  if (std::isfinite(width)) estimate.level_x = width;
  if (width == above_every_level) estimate.reason = "above at every width";
  if (width == below_every_level) estimate.reason = "below at every width";
  return estimate;
}

/// Why a logistic has no centre or does not cross a level, in levels.
std::string reason_in(const LevelAxis& axis, const Logistic4Fit& fit, const std::vector<double>& level_x) {
  const bool rising = axis.noticeability == Direction::increasing;
  if (of_depth_widths(axis) && !rising) return reason(fit, level_x);
  const auto text = [&](double x) { return estimated_text(axis, level_at(axis, x)); };
  switch (fit.verdict) {
    case Centre::step: {
      const std::string low = text(fit.centre_range.low_x), high = text(fit.centre_range.high_x);
      return fmt::format("a step between {} and {}: the {}s tested do not say where", rising ? high : low,
                         rising ? low : high, level_word(axis));
    }
    case Centre::below_range:
      return fmt::format("steepest {} {}", rising ? "above" : "below", text(level_x.front()));
    case Centre::above_range:
      return fmt::format("steepest {} {}", rising ? "below" : "above", text(level_x.back()));
    case Centre::not_falling:
      return fmt::format("not identified: noticeability does not {} with the {}", rising ? "rise" : "fall",
                         level_word(axis));
    case Centre::identified:
    case Centre::straight:
    case Centre::too_few_levels:
      return in_words_of(axis, reason(fit, level_x));
  }
  return "";
}

/// The reasons of a curve whose levels are not widths, in its own words.
void say_in_levels(const LevelAxis& axis, const std::vector<double>& level_x, CurveThresholds& found) {
  for (ThresholdEstimate* estimate :
       {&found.perceptual, &found.slightly_noticeable, &found.perceptual_logistic,
        &found.slightly_noticeable_logistic, &found.inflection}) {
    const bool of_curve =
        estimate->reason.starts_with("above at") || estimate->reason.starts_with("below at");
    if (!estimate->reason.empty())
      estimate->reason =
          of_curve ? in_words_of(axis, estimate->reason) : reason_in(axis, found.logistic, level_x);
  }
}

void add_intervals(const ArtifactScores& scores, const std::vector<double>& level_x,
                   const ResamplingRequest& request, ArtifactThresholds& result) {
  const Eigen::MatrixXd on_axis = scores.noticeability.leftCols(static_cast<Eigen::Index>(level_x.size()));
  const MeanVector means = mean_and_covariance(on_axis);
  const int people = result.participants;
  CurveThresholds& found = result.estimates;
  found.perceptual.ci95 = level_interval(perceptual_level, level_x, means, people);
  found.slightly_noticeable.ci95 = level_interval(slight_level, level_x, means, people);
  found.perceptual_logistic.ci95 =
      logistic_level_interval(perceptual_level, found.logistic, level_x, means, people);
  found.slightly_noticeable_logistic.ci95 =
      logistic_level_interval(slight_level, found.logistic, level_x, means, people);
  if (request.replicates < 1) return;
  CurveReplicates replicates(level_x, request.replicates);
  for_each_replicate(on_axis, request, [&](int replicate, const Eigen::VectorXd& mean) {
    replicates.set(replicate, {mean.data(), static_cast<std::size_t>(mean.size())});
  });
  const CurveIntervals intervals = replicates.intervals(expanded_levels(people));
  result.perceptual_bootstrap = intervals.perceptual;
  result.slightly_noticeable_bootstrap = intervals.slightly_noticeable;
  found.inflection.ci95 = intervals.inflection;
  result.perceptual_logistic_bootstrap = intervals.perceptual_logistic;
  result.slightly_noticeable_logistic_bootstrap = intervals.slightly_noticeable_logistic;
}

}  // namespace

std::vector<double> log2_widths(const std::vector<int>& width_px) {
  std::vector<double> level_x;
  for (int width : width_px) level_x.push_back(std::log2(width));
  return level_x;
}

CurveThresholds thresholds_of_means(const std::vector<double>& level_x, const std::vector<double>& means,
                                    const LevelAxis& axis) {
  CurveThresholds result;
  result.isotonic = fit_non_increasing(means);
  result.perceptual = level_estimate(perceptual_level, level_x, result.isotonic.value);
  result.slightly_noticeable = level_estimate(slight_level, level_x, result.isotonic.value);
  result.logistic = Logistic4Fitter(level_x).fit(means);
  result.perceptual_logistic = logistic_level_estimate(perceptual_level, result.logistic, level_x);
  result.slightly_noticeable_logistic = logistic_level_estimate(slight_level, result.logistic, level_x);
  result.inflection.reason = reason(result.logistic, level_x);
  if (result.logistic.verdict == Centre::identified)
    result.inflection.level_x = result.logistic.curve.centre_x;
  say_in_levels(axis, level_x, result);
  return result;
}

ArtifactThresholds estimate_thresholds(const ArtifactScores& scores, const ResamplingRequest& request) {
  const std::vector<double> level_x = levels_on_axis(scores), means = means_on_axis(scores);
  ArtifactThresholds result{.artifact = scores.artifact,
                            .condition = scores.condition,
                            .participants = static_cast<int>(scores.people.size()),
                            .estimates = {},
                            .perceptual_bootstrap = {},
                            .slightly_noticeable_bootstrap = {},
                            .perceptual_logistic_bootstrap = {},
                            .slightly_noticeable_logistic_bootstrap = {}};
  if (means.empty()) {
    const ThresholdEstimate nothing{.level_x = {},
                                    .reason = scores.cells.empty()
                                                  ? in_words_of(scores.axis, "nobody answered at every width")
                                                  : "no level on the axis was shown",
                                    .ci95 = {}};
    result.estimates.perceptual = result.estimates.slightly_noticeable = result.estimates.inflection =
        result.estimates.perceptual_logistic = result.estimates.slightly_noticeable_logistic = nothing;
    return result;
  }
  result.estimates = thresholds_of_means(level_x, means, scores.axis);
  if (scores.people.size() >= 2) add_intervals(scores, level_x, request, result);
  return result;
}

}  // namespace seamline::analysis
