#pragma once
#include <functional>
#include <span>
#include <vector>

#include "analysis/statistics/estimate.h"
#include "analysis/statistics/isotonic.h"
#include "analysis/statistics/resampling.h"

namespace seamline::analysis {

/// The 95 % interval of the largest width where the isotonic curve of mean noticeability equals a level, by
/// inverting a score test at each width w (the idea of Wilson's interval for a proportion). With the letters
/// of documentation/evidence/coverage.md:
///
///     T(w) = (g(w) - level) / s0(w)   against Student's t with n - 1 degrees of freedom
///
/// g is the isotonic fit, linear in log2 width. s0(w) is the standard error that g(w) would have if the mean
/// at w were the level: with few people a mean that is low by chance comes with a variance that is low by
/// chance, and the usual standard error then excludes the true width two to three times too often. So the
/// variance at each of the two neighbouring widths is read, as a function of the mean, at the mean it would
/// have had (`VarianceFunction`).
///
/// w is excluded on the low side when T says that the curve is above the level there or at a larger width (it
/// does not rise), on the high side when it is below there or at a smaller one. A side is open when no width
/// tested is excluded on it. `people` is at least 2.
[[nodiscard]] LevelInterval level_interval(double level, const std::vector<double>& level_x,
                                           const MeanVector& means, int people);

/// A falling curve at one width, and the standard error it would have if it were at the level there.
struct CurveAtX {
  double value = 0, standard_error = 0;
};

/// The widths that such a test does not exclude, on a grid of `steps_per_gap` between neighbouring widths,
/// bounds interpolated; open ends as for `level_interval`. `curve_at(left, t)` is asked a share t (0 to 1) of
/// the way from width number `left` to the next, widths rising.
[[nodiscard]] LevelInterval invert_level_test(
    double level, const std::vector<double>& level_x, int people, int steps_per_gap,
    const std::function<CurveAtX(std::size_t left, double t)>& curve_at);

/// Variance of a mean over people as a function of that mean: linear between the means of the widths tested,
/// constant beyond them. Ratings near 0 and near 4 vary less between people than those between.
class VarianceFunction {
 public:
  VarianceFunction(const IsotonicFit& fit, const MeanVector& means);
  [[nodiscard]] double at(double mean) const;

 private:
  std::vector<double> mean_;  ///< falling
  std::vector<double> variance_;
};

/// Tail probabilities at which a bootstrap distribution is read for a 95 % interval.
struct TailLevels {
  double low = 0.025, high = 0.975;
};

/// The expanded percentile interval (Hesterberg 2015, What Teachers Should Know about the Bootstrap): the
/// plain one is too narrow by sqrt((n - 1) / n) and by using z for t, so it is read at Phi(-sqrt(n / (n - 1))
/// t_{n-1, 0.975}).
[[nodiscard]] TailLevels expanded_levels(int people);

/// Reads an interval off replicates of which each says only that its width lies within a range (a point when
/// both ends are equal; infinite when it has no width): low from the lows, high from the highs, so doubt
/// widens the interval.
[[nodiscard]] LevelInterval percentile_interval(const std::vector<LevelInterval>& replicates,
                                                const TailLevels& levels);

/// Throws std::logic_error when a value is NaN. Whatever is sorted in the analysis is asked first.
void require_ordered(std::span<const double> values);

/// Quantile with linear interpolation between order statistics (type 7). Infinite values are ordinary values;
/// NaN has no place in an order: `require_ordered`. Reorders.
[[nodiscard]] double quantile(std::vector<double>& values, double probability);

}  // namespace seamline::analysis
