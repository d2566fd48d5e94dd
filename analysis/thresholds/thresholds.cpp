#include "analysis/thresholds/thresholds.h"

#include <cmath>

#include "analysis/statistics/logistic_interval.h"
#include "analysis/statistics/logistic_level.h"
#include "analysis/thresholds/curve_replicates.h"

namespace seamline::analysis {

namespace {

WidthEstimate level_estimate(double level, const std::vector<double>& log2_px,
                             const std::vector<double>& fit) {
  const double width = largest_log2_width_at(level, log2_px, fit);
  WidthEstimate estimate;
  if (std::isfinite(width)) estimate.log2_px = width;
  if (width == above_every_width) estimate.reason = "above at every width";
  if (width == below_every_width) estimate.reason = "below at every width";
  return estimate;
}

void add_intervals(const ArtifactScores& scores, const std::vector<double>& log2_px,
                   const ResamplingRequest& request, ArtifactThresholds& result) {
  const MeanVector means = mean_and_covariance(scores.noticeability);
  const int people = result.participants;
  CurveThresholds& found = result.estimates;
  found.perceptual.ci95 = level_interval(perceptual_level, log2_px, means, people);
  found.slightly_noticeable.ci95 = level_interval(slight_level, log2_px, means, people);
  found.perceptual_logistic.ci95 =
      logistic_level_interval(perceptual_level, found.logistic, log2_px, means, people);
  found.slightly_noticeable_logistic.ci95 =
      logistic_level_interval(slight_level, found.logistic, log2_px, means, people);
  if (request.replicates < 1) return;
  CurveReplicates replicates(log2_px, request.replicates);
  for_each_replicate(scores.noticeability, request, [&](int replicate, const Eigen::VectorXd& mean) {
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
  std::vector<double> log2_px;
  for (int width : width_px) log2_px.push_back(std::log2(width));
  return log2_px;
}

CurveThresholds thresholds_of_means(const std::vector<double>& log2_px, const std::vector<double>& means) {
  CurveThresholds result;
  result.isotonic = fit_non_increasing(means);
  result.perceptual = level_estimate(perceptual_level, log2_px, result.isotonic.value);
  result.slightly_noticeable = level_estimate(slight_level, log2_px, result.isotonic.value);
  result.logistic = Logistic4Fitter(log2_px).fit(means);
  result.perceptual_logistic = logistic_level_estimate(perceptual_level, result.logistic, log2_px);
  result.slightly_noticeable_logistic = logistic_level_estimate(slight_level, result.logistic, log2_px);
  result.inflection.reason = reason(result.logistic, log2_px);
  if (result.logistic.verdict == Centre::identified)
    result.inflection.log2_px = result.logistic.curve.centre_log2_px;
  return result;
}

ArtifactThresholds estimate_thresholds(const ArtifactScores& scores, const ResamplingRequest& request) {
  const std::vector<double> log2_px = log2_widths(scores.width_px);
  std::vector<double> means;
  for (const CellMean& cell : scores.cells) means.push_back(cell.mean);
  ArtifactThresholds result{.artifact = scores.artifact,
                            .participants = static_cast<int>(scores.people.size()),
                            .estimates = {},
                            .perceptual_bootstrap = {},
                            .slightly_noticeable_bootstrap = {},
                            .perceptual_logistic_bootstrap = {},
                            .slightly_noticeable_logistic_bootstrap = {}};
  if (means.empty()) {
    const WidthEstimate nothing{.log2_px = {}, .reason = "nobody answered at every width", .ci95 = {}};
    result.estimates.perceptual = result.estimates.slightly_noticeable = result.estimates.inflection =
        result.estimates.perceptual_logistic = result.estimates.slightly_noticeable_logistic = nothing;
    return result;
  }
  result.estimates = thresholds_of_means(log2_px, means);
  if (scores.people.size() >= 2) add_intervals(scores, log2_px, request, result);
  return result;
}

}  // namespace seamline::analysis
