#include "analysis/statistics/logistic_level.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "analysis/statistics/interval.h"
#include "analysis/statistics/logistic_through_level.h"

namespace seamline::analysis {

namespace {

/// Every step is a fit; bounds are interpolated between steps of an eighth of a gap.
constexpr int logistic_steps_per_gap = 8;
/// A direction of the parameters that moves the curve less than this says nothing (a flat curve's centre).
constexpr double smallest_share_of_curvature = 1e-9;

/// Derivatives of the curve at a width by upper, lower, centre and ln scale.
Eigen::Vector4d derivatives(const Logistic4& curve, double level_x) {
  const double z = (level_x - curve.centre_x) / curve.scale_x;
  const double f = falling_logistic(z);
  const double slope = f * (1 - f) * (curve.upper - curve.lower);
  return {f, 1 - f, slope / curve.scale_x, slope * z};
}

Eigen::MatrixXd correlations(const Eigen::MatrixXd& covariance) {
  const Eigen::VectorXd sd = covariance.diagonal().cwiseMax(0).cwiseSqrt();
  const Eigen::VectorXd inverse = (sd.array() > 0).select(1 / sd.array(), 0);
  return inverse.asDiagonal() * covariance * inverse.asDiagonal();
}

/// h: how much each mean adds to the fitted curve at w, to first order.
Eigen::VectorXd weights_at(const Logistic4& curve, double at_x, const std::vector<double>& level_x) {
  Eigen::MatrixXd jacobian(static_cast<Eigen::Index>(level_x.size()), 4);
  for (std::size_t i = 0; i < level_x.size(); ++i)
    jacobian.row(static_cast<Eigen::Index>(i)) = derivatives(curve, level_x[i]).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> normal(jacobian.transpose() * jacobian);
  const Eigen::Vector4d curvature = normal.eigenvalues();  // rising
  const Eigen::Vector4d inverse =
      (curvature.array() > smallest_share_of_curvature * curvature[3]).select(1 / curvature.array(), 0);
  const Eigen::Matrix4d axes = normal.eigenvectors();
  return jacobian * (axes * (inverse.asDiagonal() * (axes.transpose() * derivatives(curve, at_x))));
}

}  // namespace

LevelInterval logistic_level_range(double level, const Logistic4Fit& fit, std::span<const double> level_x) {
  if (fit.verdict == Centre::too_few_levels) return {};
  const Logistic4& curve = fit.curve;
  if (value_at(curve, level_x.back()) > level)
    return {.low_x = above_every_level, .high_x = above_every_level};
  if (value_at(curve, level_x.front()) < level)
    return {.low_x = below_every_level, .high_x = below_every_level};
  if (fit.verdict == Centre::step) return fit.centre_range;
  if (!(curve.upper > level && level > curve.lower))  // flat at the level, as the largest width it equals
    return {.low_x = level_x.back(), .high_x = level_x.back()};
  const double width =
      std::clamp(curve.centre_x + curve.scale_x * std::log((curve.upper - level) / (level - curve.lower)),
                 level_x.front(), level_x.back());
  return {.low_x = width, .high_x = width};
}

LevelInterval logistic_level_interval(double level, const Logistic4Fit& fit,
                                      const std::vector<double>& level_x, const MeanVector& means,
                                      int people) {
  if (fit.verdict == Centre::too_few_levels) return {};
  const Eigen::MatrixXd correlation = correlations(means.covariance);
  const VarianceFunction variance_of(
      fit_non_increasing({means.mean.data(), static_cast<std::size_t>(means.mean.size())}), means);
  const LogisticBox box = logistic_box(level_x);
  Logistic4 near = fit.curve;

  const LevelInterval interval =
      invert_level_test(level, level_x, people, logistic_steps_per_gap, [&](std::size_t left, double t) {
        const std::size_t right = std::min(left + 1, level_x.size() - 1);
        const double w = (1 - t) * level_x[left] + t * level_x[right];
        near = fit_through_level(level, w, level_x, means.mean, box, &near).curve;
        const Eigen::VectorXd h = weights_at(near, w, level_x);
        Eigen::VectorXd residual(means.mean.size()), scaled(means.mean.size());
        for (Eigen::Index i = 0; i < means.mean.size(); ++i) {
          const double fitted = value_at(near, level_x[i]);
          residual[i] = means.mean[i] - fitted;
          scaled[i] = h[i] * std::sqrt(variance_of.at(fitted));
        }
        return CurveAtX{.value = level + h.dot(residual),
                        .standard_error = std::sqrt(std::max(0.0, scaled.dot(correlation * scaled)))};
      });
  const LevelInterval estimate = logistic_level_range(level, fit, level_x);
  return {.low_x = std::min(interval.low_x, estimate.low_x),
          .high_x = std::max(interval.high_x, estimate.high_x)};
}

}  // namespace seamline::analysis
