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
  /// Level on the axis and its 95 % interval: estimate -+ t standard errors of the jackknife over people,
  /// people - 1 degrees of freedom. As everywhere there is an estimate exactly where its interval is closed;
  /// `reason` says why there is none.
  ThresholdEstimate here;
  LevelInterval simultaneous;  ///< holds together with those of the other thresholds of its quantity (max t)
  double standard_error = 0;   ///< units of the axis; NaN without an estimate
  bool beyond_levels =
      false;  ///< the estimate lies outside the levels tested of its curve: by the model alone
};

/// Every quantity of every curve: quantities run fastest. A threshold has no number, but a reason,
///
///   - where the curve has none (CurveVerdict), or the fit has no numbers (JointVerdict)
///   - "the level lies in the guess floor": the floor of PT or SN with its uncertainty (one-sided 97.5 %)
///     reaches the level
///   - "above every level", "below every level": it lies further beyond the levels tested than the largest
///     gap between them, or its interval does not exclude that
///   - "not asked": PT, SN and IP where nobody was asked for ratings
[[nodiscard]] std::vector<JointThreshold> joint_thresholds(const JointFit& fit, const JointData& data,
                                                           const JointJackknife& left_out);

/// Mean noticeability at x with its 95 % interval over participants: for bands in figures.
struct MeanBand {
  double x = 0, mean = 0, low = 0, high = 0;
};
[[nodiscard]] MeanBand mean_band(const JointFit& fit, const JointJackknife& left_out, int curve,
                                 JointMean mean, double x);

/// The probability that an object is seen, psi, at x.
[[nodiscard]] double seen_at(const JointFit& fit, int curve, double x);

}  // namespace seamline::analysis
