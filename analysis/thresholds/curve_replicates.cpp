#include "analysis/thresholds/curve_replicates.h"

#include "analysis/statistics/isotonic.h"
#include "analysis/statistics/logistic_level.h"
#include "analysis/thresholds/thresholds.h"

namespace seamline::analysis {

namespace {

WidthInterval point(double log2_px) {
  return {.low_log2_px = log2_px, .high_log2_px = log2_px};
}

}  // namespace

CurveReplicates::CurveReplicates(const std::vector<double>& log2_px, int replicates) : fitter_(log2_px) {
  for (auto* values : {&perceptual_, &slightly_noticeable_, &inflection_, &perceptual_logistic_,
                       &slightly_noticeable_logistic_})
    values->resize(static_cast<std::size_t>(replicates));
}

void CurveReplicates::set(int replicate, std::span<const double> means) {
  const auto r = static_cast<std::size_t>(replicate);
  const std::vector<double>& log2_px = fitter_.log2_px();
  const IsotonicFit fit = fit_non_increasing(means);
  perceptual_[r] = point(largest_log2_width_at(perceptual_level, log2_px, fit.value));
  slightly_noticeable_[r] = point(largest_log2_width_at(slight_level, log2_px, fit.value));
  const Logistic4Fit logistic = fitter_.fit(means);
  inflection_[r] = logistic.centre_range;
  perceptual_logistic_[r] = logistic_level_range(perceptual_level, logistic, log2_px);
  slightly_noticeable_logistic_[r] = logistic_level_range(slight_level, logistic, log2_px);
}

CurveIntervals CurveReplicates::intervals(const TailLevels& levels) const {
  return {.perceptual = percentile_interval(perceptual_, levels),
          .slightly_noticeable = percentile_interval(slightly_noticeable_, levels),
          .inflection = percentile_interval(inflection_, levels),
          .perceptual_logistic = percentile_interval(perceptual_logistic_, levels),
          .slightly_noticeable_logistic = percentile_interval(slightly_noticeable_logistic_, levels)};
}

}  // namespace seamline::analysis
