#include "analysis/thresholds.h"

#include <cmath>

namespace seamline {

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

/// What each replicate says about the three widths.
struct Replicates {
  std::vector<WidthInterval> perceptual, slightly_noticeable, inflection;
};

WidthInterval point(double log2_px) {
  return {.low_log2_px = log2_px, .high_log2_px = log2_px};
}

Replicates resample(const ArtifactScores& scores, const std::vector<double>& log2_px,
                    const ResamplingRequest& request) {
  const auto count = static_cast<std::size_t>(request.replicates);
  Replicates replicates{.perceptual = std::vector<WidthInterval>(count),
                        .slightly_noticeable = std::vector<WidthInterval>(count),
                        .inflection = std::vector<WidthInterval>(count)};
  const Logistic4Fitter fitter(log2_px);
  for_each_replicate(scores.noticeability, request, [&](int replicate, const Eigen::VectorXd& mean) {
    const auto r = static_cast<std::size_t>(replicate);
    const std::span<const double> values(mean.data(), static_cast<std::size_t>(mean.size()));
    const IsotonicFit fit = fit_non_increasing(values);
    replicates.perceptual[r] = point(largest_log2_width_at(perceptual_level, log2_px, fit.value));
    replicates.slightly_noticeable[r] = point(largest_log2_width_at(slight_level, log2_px, fit.value));
    replicates.inflection[r] = fitter.fit(values).centre_range;
  });
  return replicates;
}

void add_intervals(const ArtifactScores& scores, const std::vector<double>& log2_px,
                   const ResamplingRequest& request, ArtifactThresholds& result) {
  const MeanVector means = mean_and_covariance(scores.noticeability);
  result.estimates.perceptual.ci95 = level_interval(perceptual_level, log2_px, means, result.participants);
  result.estimates.slightly_noticeable.ci95 =
      level_interval(slight_level, log2_px, means, result.participants);
  if (request.replicates < 1) return;
  const Replicates replicates = resample(scores, log2_px, request);
  const TailLevels levels = expanded_levels(result.participants);
  result.perceptual_bootstrap = percentile_interval(replicates.perceptual, levels);
  result.slightly_noticeable_bootstrap = percentile_interval(replicates.slightly_noticeable, levels);
  result.estimates.inflection.ci95 = percentile_interval(replicates.inflection, levels);
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
                            .slightly_noticeable_bootstrap = {}};
  if (means.empty()) {
    const WidthEstimate nothing{.log2_px = {}, .reason = "nobody answered at every width", .ci95 = {}};
    result.estimates.perceptual = result.estimates.slightly_noticeable = result.estimates.inflection =
        nothing;
    return result;
  }
  result.estimates = thresholds_of_means(log2_px, means);
  if (scores.people.size() >= 2) add_intervals(scores, log2_px, request, result);
  return result;
}

}  // namespace seamline
