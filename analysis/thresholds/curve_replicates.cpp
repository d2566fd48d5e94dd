#include "analysis/thresholds/curve_replicates.h"

#include "analysis/statistics/isotonic.h"
#include "analysis/statistics/logistic_level.h"
#include "analysis/thresholds/thresholds.h"

namespace seamline::analysis {

namespace {

LevelInterval point(double level_x) {
  return {.low_x = level_x, .high_x = level_x};
}

}  // namespace

CurveReplicates::CurveReplicates(const std::vector<double>& level_x, int replicates) : fitter_(level_x) {
  for (auto* values : {&perceptual_, &slightly_noticeable_, &inflection_, &perceptual_logistic_,
                       &slightly_noticeable_logistic_})
    values->resize(replicates);
}

void CurveReplicates::set(int replicate, std::span<const double> means) {
  const std::size_t r = replicate;
  const std::vector<double>& level_x = fitter_.level_x();
  const IsotonicFit fit = fit_non_increasing(means);
  perceptual_[r] = point(largest_x_at(perceptual_level, level_x, fit.value));
  slightly_noticeable_[r] = point(largest_x_at(slight_level, level_x, fit.value));
  const Logistic4Fit logistic = fitter_.fit(means);
  inflection_[r] = logistic.centre_range;
  perceptual_logistic_[r] = logistic_level_range(perceptual_level, logistic, level_x);
  slightly_noticeable_logistic_[r] = logistic_level_range(slight_level, logistic, level_x);
}

CurveIntervals CurveReplicates::intervals(const TailLevels& levels) const {
  return {.perceptual = percentile_interval(perceptual_, levels),
          .slightly_noticeable = percentile_interval(slightly_noticeable_, levels),
          .inflection = percentile_interval(inflection_, levels),
          .perceptual_logistic = percentile_interval(perceptual_logistic_, levels),
          .slightly_noticeable_logistic = percentile_interval(slightly_noticeable_logistic_, levels)};
}

}  // namespace seamline::analysis
