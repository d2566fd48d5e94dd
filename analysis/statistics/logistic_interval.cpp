#include "analysis/statistics/logistic_interval.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "analysis/statistics/interval.h"
#include "analysis/statistics/logistic_level.h"
#include "analysis/statistics/logistic_through_level.h"

namespace seamline::analysis {

namespace {

/// Every step is a fit; bounds are interpolated between steps of an eighth of a gap.
constexpr int logistic_steps_per_gap = 8;
/// A direction of the parameters that moves the curve less than this says nothing (a flat curve's centre).
constexpr double smallest_share_of_curvature = 1e-9;

/// Derivatives of the curve at a width by upper, lower, centre and ln scale.
Eigen::Vector4d derivatives(const Logistic4& curve, double log2_px) {
  const double z = (log2_px - curve.centre_log2_px) / curve.scale_octaves;
  const double f = 1 / (1 + std::exp(z));
  const double slope = f * (1 - f) * (curve.upper - curve.lower);
  return {f, 1 - f, slope / curve.scale_octaves, slope * z};
}

Eigen::MatrixXd correlations(const Eigen::MatrixXd& covariance) {
  const Eigen::VectorXd sd = covariance.diagonal().cwiseMax(0).cwiseSqrt();
  const Eigen::VectorXd inverse = (sd.array() > 0).select(1 / sd.array(), 0);
  return inverse.asDiagonal() * covariance * inverse.asDiagonal();
}

/// h: how much each mean adds to the fitted curve at w, to first order.
Eigen::VectorXd weights_at(const Logistic4& curve, double at_log2_px, const std::vector<double>& log2_px) {
  Eigen::MatrixXd jacobian(static_cast<Eigen::Index>(log2_px.size()), 4);
  for (std::size_t i = 0; i < log2_px.size(); ++i)
    jacobian.row(static_cast<Eigen::Index>(i)) = derivatives(curve, log2_px[i]).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> normal(jacobian.transpose() * jacobian);
  const Eigen::Vector4d curvature = normal.eigenvalues();  // rising
  const Eigen::Vector4d inverse =
      (curvature.array() > smallest_share_of_curvature * curvature[3]).select(1 / curvature.array(), 0);
  const Eigen::Matrix4d axes = normal.eigenvectors();
  return jacobian * (axes * (inverse.asDiagonal() * (axes.transpose() * derivatives(curve, at_log2_px))));
}

}  // namespace

WidthInterval logistic_level_interval(double level, const Logistic4Fit& fit,
                                      const std::vector<double>& log2_px, const MeanVector& means,
                                      int people) {
  if (fit.verdict == Centre::too_few_widths) return {};
  const Eigen::MatrixXd correlation = correlations(means.covariance);
  const VarianceFunction variance_of(
      fit_non_increasing({means.mean.data(), static_cast<std::size_t>(means.mean.size())}), means);
  const LogisticBox box = logistic_box(log2_px);
  Logistic4 near = fit.curve;

  const WidthInterval interval =
      invert_level_test(level, log2_px, people, logistic_steps_per_gap, [&](std::size_t left, double t) {
        const std::size_t right = std::min(left + 1, log2_px.size() - 1);
        const double w = (1 - t) * log2_px[left] + t * log2_px[right];
        near = fit_through_level(level, w, log2_px, means.mean, box, &near).curve;
        const Eigen::VectorXd h = weights_at(near, w, log2_px);
        Eigen::VectorXd residual(means.mean.size()), scaled(means.mean.size());
        for (Eigen::Index i = 0; i < means.mean.size(); ++i) {
          const double fitted = value_at(near, log2_px[static_cast<std::size_t>(i)]);
          residual[i] = means.mean[i] - fitted;
          scaled[i] = h[i] * std::sqrt(variance_of.at(fitted));
        }
        return CurveAtWidth{.value = level + h.dot(residual),
                            .standard_error = std::sqrt(std::max(0.0, scaled.dot(correlation * scaled)))};
      });
  const WidthInterval estimate = logistic_level_range(level, fit, log2_px);
  return {.low_log2_px = std::min(interval.low_log2_px, estimate.low_log2_px),
          .high_log2_px = std::max(interval.high_log2_px, estimate.high_log2_px)};
}

}  // namespace seamline::analysis
