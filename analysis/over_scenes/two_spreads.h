#pragma once
#include <Eigen/Core>

#include "analysis/statistics/estimate.h"

namespace seamline::analysis {

/// The mean of one threshold over scenes, with what it owes to the people and to the scenes that happened to
/// be asked. Units of the axis.
struct TwoSpreads {
  double mean_x = 0;
  double people_variance = 0;  ///< of the mean, over people: these scenes
  double scenes_variance = 0;  ///< of the mean, over scenes beside that: between_scenes^2 / scenes
  double between_scenes = 0;   ///< standard deviation of thresholds between scenes, people's noise taken out
  double people_degrees = 0;   ///< of freedom: people - 1
  double degrees = 0;          ///< of freedom of the sum of both variances (Satterthwaite)

  /// Half of the 95 % interval of the mean over people, for these scenes.
  [[nodiscard]] double half_these() const;
  /// Half of the 95 % interval of the mean over people and scenes, for scenes like these.
  [[nodiscard]] double half_like_these() const;
};

/// Two-way variance of the mean of `x`, one threshold a scene, seen by the same people (Cameron, Gelbach and
/// Miller 2011: people + scenes - both). C is the covariance of x over people (the jackknife's), s^2 the
/// variance of x, m the number of scenes:
///
///     people = 1' C 1 / m^2,    between^2 = max(0, s^2 - own),    own = mean C_ii - mean C_ij (i != j)
///     variance = people + between^2 / m
///     degrees = variance^2 / (people^2 / (people - 1) + (s^2 / m)^2 / (m - 1))
///
/// `shared_variance` is of what moves all scenes alike and no number of people tells (the form of the curve);
/// it adds to `people_variance`. Two scenes and two people at least.
[[nodiscard]] TwoSpreads two_spreads(const Eigen::VectorXd& x, const Eigen::MatrixXd& covariance, int people,
                                     double shared_variance = 0);

/// What a study would have: a standard error of the mean over people, and a standard deviation between
/// scenes.
[[nodiscard]] TwoSpreads expected_spreads(double people_error, int people, double between_scenes, int scenes);

}  // namespace seamline::analysis
