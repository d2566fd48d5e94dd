#include "analysis/logistic_interval.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "analysis/interval.h"
#include "analysis/logistic_level.h"

namespace seamline {

namespace {

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

}  // namespace

std::optional<WidthInterval> logistic_level_interval(double level, const Logistic4Fit& fit,
                                                     const std::vector<double>& log2_px,
                                                     const MeanVector& means, int people) {
  const bool curved = fit.verdict == Centre::identified || fit.verdict == Centre::below_range ||
                      fit.verdict == Centre::above_range;
  if (!curved) return std::nullopt;
  const auto widths = static_cast<Eigen::Index>(log2_px.size());
  Eigen::MatrixXd jacobian(widths, 4);
  Eigen::VectorXd fitted(widths);
  for (Eigen::Index i = 0; i < widths; ++i) {
    jacobian.row(i) = derivatives(fit.curve, log2_px[static_cast<std::size_t>(i)]).transpose();
    fitted[i] = value_at(fit.curve, log2_px[static_cast<std::size_t>(i)]);
  }
  const Eigen::FullPivLU<Eigen::Matrix4d> normal(jacobian.transpose() * jacobian);
  if (!normal.isInvertible() || normal.rcond() < 1e-10) return std::nullopt;
  const Eigen::MatrixXd weights = jacobian * normal.inverse();  // widths x 4
  const Eigen::MatrixXd correlation = correlations(means.covariance);
  const VarianceFunction variance_of(
      fit_non_increasing({means.mean.data(), static_cast<std::size_t>(means.mean.size())}), means);

  return invert_level_test(level, log2_px, people, [&](std::size_t left, double t) {
    const std::size_t right = std::min(left + 1, log2_px.size() - 1);
    const double w = (1 - t) * log2_px[left] + t * log2_px[right];
    const double g = value_at(fit.curve, w);
    const Eigen::VectorXd h = weights * derivatives(fit.curve, w);
    Eigen::VectorXd scaled(widths);
    for (Eigen::Index i = 0; i < widths; ++i)
      scaled[i] = h[i] * std::sqrt(variance_of.at(fitted[i] + level - g));
    return CurveAtWidth{.value = g,
                        .standard_error = std::sqrt(std::max(0.0, scaled.dot(correlation * scaled)))};
  });
}

}  // namespace seamline
