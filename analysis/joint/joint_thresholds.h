#pragma once
#include <string>
#include <vector>

#include "analysis/joint/joint_jackknife.h"
#include "analysis/joint/joint_quantities.h"
#include "analysis/statistics/estimate.h"

namespace seamline::analysis {

/// One threshold of one curve with its intervals over participants.
struct JointThreshold {
  int curve = 0;
  JointQuantity quantity = JointQuantity::perceptual;
  /// Level on the axis and its 95 % interval over participants (`level_pivot`). As everywhere there is an
  /// estimate exactly where its interval is closed; `reason` says why there is none.
  ThresholdEstimate here;
  LevelInterval simultaneous;  ///< holds together with those of the other thresholds of its quantity (max t)
  double standard_error = 0;   ///< by the jackknife, units of the axis; NaN without an estimate
  bool beyond_levels =
      false;  ///< the estimate lies outside the levels tested of its curve: by the model alone
};

/// Whether a mean noticeability E reaches a level at x, as a t of people - 1 degrees of freedom: positive
/// where E is above the level. c is the floor of guesses, the variance the jackknife's over people:
///
///     h(x) = log(E(x) - c) - log(level - c),    t = h / se(h)
///
/// Intervals are the x with |t| at most its critical value (as Fieller's). Logarithms, because what a level
/// near the floor asks for is how many times E exceeds it; with E itself intervals held the truth too seldom
/// (documentation/explanation/joint_model.md).
[[nodiscard]] double level_pivot(const JointFit& fit, const JointJackknife& left_out, int curve,
                                 const SoughtMean& sought, double x);

/// The standard error that thresholds of a curve have from the form of the curve alone, units of the axis.
/// Where no level lies on the slope nothing but the form places the curve, and people with another form lie
/// elsewhere between the two levels, however many they are (documentation/evidence/coverage.md). 0 where the
/// levels around the threshold lie closely enough. Intervals hold it.
[[nodiscard]] double place_error_of(const JointFit& fit, int curve);

/// Every quantity of every curve: quantities run fastest. IP: estimate -+ t standard errors. A threshold has
/// no number, but a reason,
///
///   - where the curve or the fit has no numbers (JointVerdict)
///   - `guess_floor`: the floor of PT or SN with its uncertainty (one-sided 97.5 %) reaches the level
///   - `open_hardest`, `open_easiest`, `open_both`: it lies further beyond the levels tested than the largest
///     gap between them, or its interval does not exclude that
///   - `ratings_not_asked`: PT, SN and IP where nobody was asked for ratings
[[nodiscard]] std::vector<JointThreshold> joint_thresholds(const JointFit& fit, const JointData& data,
                                                           const JointJackknife& left_out);

/// One of them, without the simultaneous interval (open): what a simulated study needs.
[[nodiscard]] JointThreshold joint_threshold(const JointFit& fit, const JointData& data,
                                             const JointJackknife& left_out, int curve,
                                             JointQuantity quantity);

/// Mean noticeability at x with its 95 % interval over participants: for bands in figures.
struct MeanBand {
  double x = 0, mean = 0, low = 0, high = 0;
};
[[nodiscard]] MeanBand mean_band(const JointFit& fit, const JointJackknife& left_out, int curve,
                                 JointMean mean, double x);

/// The probability that an object is seen, psi, at x.
[[nodiscard]] double seen_at(const JointFit& fit, int curve, double x);

}  // namespace seamline::analysis
