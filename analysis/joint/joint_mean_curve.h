#pragma once
#include <array>

#include "analysis/joint/joint_model.h"

namespace seamline::analysis {

/// Which answers a mean noticeability counts.
enum class JointMean {
  as_counted,  ///< all right answers, lucky guesses among them, as the paper counts
  seen,        ///< those that were seen: corrected for guessing
  detected     ///< psi: 1 where it was seen, whatever the rating
};

/// A mean noticeability at one z = (m - x) / s, and its derivatives by z and by the coordinates that shape
/// it. With mu(z) = 1 + sum_k F((z - t_k) / rho), the mean rating of what is seen, and c = b sum r g(r):
///
///     E(z) = (1 - lapse) F(z) (mu(z) - c) + c      as_counted
///     E(z) = (1 - lapse) F(z) mu(z)                seen
///     E(z) = (1 - lapse) F(z)                      detected
struct MeanAtZ {
  std::array<double, 4> z{};  ///< E, E', E'', E'''
  /// Of E and of E'' by l, t_2, log distances of the cuts, log rho, h_2..: JointModel's order within a curve.
  struct ByShape {
    double lapse = 0, spread = 0;
    std::array<double, most_joint_ratings - 1> cut{}, guess{};
  };
  ByShape value, second;
};

/// `chance` is b of the curve.
[[nodiscard]] MeanAtZ mean_at_z(const JointCurve& curve, JointMean mean, double chance, double z);

/// E alone.
[[nodiscard]] double mean_noticeability(const JointCurve& curve, JointMean mean, double chance, double x);

/// E far beyond the threshold, where nothing is seen: c, or 0.
[[nodiscard]] double floor_of_mean(const JointCurve& curve, JointMean mean, double chance);

}  // namespace seamline::analysis
