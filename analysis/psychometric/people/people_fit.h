#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "analysis/psychometric/likelihood/profile.h"
#include "analysis/psychometric/likelihood/psychometric_fit.h"

namespace seamline::analysis {

/// A person's own function, drawn towards everybody's by as much as their answers leave open (posterior mean,
/// and a 95 % interval by Student's quantile with the mean's own uncertainty included).
struct PersonEstimate {
  double threshold = 0;
  Interval threshold_ci95;
  double width = 0;
  Interval width_ci95;
  std::int64_t trials = 0;
};

/// A mixed psychometric model: people's thresholds are normal on the axis, their scales log-normal and
/// independent of the thresholds, lapse and guess rate are everybody's.
struct PeopleFit {
  bool identified = false;
  std::string why;  ///< of what is not identified, the reason; else empty
  std::size_t people = 0;
  double threshold =
      0;  ///< level of the mean of people's thresholds on the axis (the geometric mean on log2)
  Interval threshold_ci95;  ///< over participants
  double threshold_sd = 0;  ///< between people, on the axis (octaves on log2)
  double width = 0;         ///< of the median person, on the axis
  Interval width_ci95;
  double width_sd =
      0;  ///< between people, of log2 of the width; 0 where people do not differ more than chance
  double lapse = 0, guess = 0;
  double log_likelihood = 0;  ///< marginal, without the binomial coefficient
  double aic = 0;
  std::vector<PersonEstimate> each;  ///< in the order given
  std::vector<std::string> remarks;
  /// How the mean threshold (axis) and log2 of the width move when person p is left out, people x 2, less the
  /// mean of that: what intervals and differences are made of.
  Eigen::MatrixXd left_out;
  /// Variances of the two that the binomial scatter of the answers alone gives, lapse and guess rate unknown:
  /// the few people's own scatter may by chance be smaller, and no interval is then shorter than these make
  /// it.
  Eigen::Vector2d noise = Eigen::Vector2d::Zero();
};

inline constexpr int people_quadrature_nodes = 9;

/// Fits the model by maximum marginal likelihood (people_likelihood.h), Newton's method with exact
/// derivatives from the fit of everybody's sums. `counts[p]` are the rows of person p. Intervals: the
/// estimate -+ t se with
///
///     se^2 = (n - 1) / n sum_p (theta_(p) - mean)^2,    theta_(p) - theta = -n / (n - 1) H^-1 g_p
///
/// the jackknife over the n people, each left-out estimate by one Newton step whose curvature is n - 1 n-ths
/// of everybody's (it stays bounded where the maximum hangs on one person's curvature); se is never smaller
/// than `noise` makes it; t is Student's quantile with n - 1 degrees of freedom. Not identified with fewer
/// than three people who answered, when the sums do not determine a threshold, and when the likelihood is
/// flat at its maximum. `own_widths` false: everybody has one width.
[[nodiscard]] PeopleFit fit_people(const PsychometricFit& sums,
                                   const std::vector<std::vector<LevelCounts>>& counts,
                                   bool own_widths = true);

}  // namespace seamline::analysis
