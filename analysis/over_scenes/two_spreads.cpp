#include "analysis/over_scenes/two_spreads.h"

#include <algorithm>
#include <cmath>

#include "analysis/statistics/distributions.h"

namespace seamline::analysis {

namespace {

/// Satterthwaite's degrees of freedom of a sum of two variances.
double degrees_of_sum(double sum, double one, double one_degrees, double other, double other_degrees) {
  const double square = one * one / one_degrees + other * other / other_degrees;
  return square > 0 ? std::max(1.0, sum * sum / square) : one_degrees;
}

double half_length(double variance, double degrees) {
  return student_with_above(degrees, (1 - confidence) / 2) * std::sqrt(variance);
}

}  // namespace

double TwoSpreads::half_these() const {
  return half_length(people_variance, people_degrees);
}

double TwoSpreads::half_like_these() const {
  return half_length(people_variance + scenes_variance, degrees);
}

TwoSpreads two_spreads(const Eigen::VectorXd& x, const Eigen::MatrixXd& covariance, int people,
                       double shared_variance) {
  const double scenes = x.size();
  TwoSpreads spreads{.mean_x = x.mean()};
  const double all = covariance.sum(), own = covariance.trace();
  spreads.people_variance = std::max(0.0, all) / (scenes * scenes) + shared_variance;
  const double squares = (x.array() - spreads.mean_x).square().sum() / (scenes - 1);
  const double noise = own / scenes - (all - own) / (scenes * (scenes - 1));
  const double between = std::max(0.0, squares - noise);
  spreads.between_scenes = std::sqrt(between);
  spreads.scenes_variance = between / scenes;
  spreads.people_degrees = people - 1.0;
  spreads.degrees = degrees_of_sum(spreads.people_variance + spreads.scenes_variance, spreads.people_variance,
                                   spreads.people_degrees, squares / scenes, scenes - 1);
  return spreads;
}

TwoSpreads expected_spreads(double people_error, int people, double between_scenes, int scenes) {
  TwoSpreads spreads{.people_variance = people_error * people_error,
                     .scenes_variance = between_scenes * between_scenes / scenes,
                     .between_scenes = between_scenes,
                     .people_degrees = people - 1.0};
  spreads.degrees = degrees_of_sum(spreads.people_variance + spreads.scenes_variance, spreads.people_variance,
                                   spreads.people_degrees, spreads.scenes_variance, scenes - 1.0);
  return spreads;
}

}  // namespace seamline::analysis
