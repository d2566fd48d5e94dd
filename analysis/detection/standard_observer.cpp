#include "analysis/detection/standard_observer.h"

#include <Eigen/Core>
#include <cassert>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>
#include <vector>

namespace seamline::analysis {
namespace {

using Spectrum = Eigen::MatrixXcd;

constexpr double pooled_exponent = 2.4081, aperture_deg = 0.6273;

double sech(double x) {
  return 1 / std::cosh(x);
}

double oblique_factor(double x_cpd, double y_cpd) {
  constexpr double corner_cpd = 3.4815, slope_cpd = 13.5715;
  const double frequency = std::hypot(x_cpd, y_cpd);
  if (frequency <= corner_cpd) return 1;
  const double sine = 2 * x_cpd * y_cpd / (frequency * frequency);  // sin 2 theta
  return 1 - (1 - std::exp(-(frequency - corner_cpd) / slope_cpd)) * sine * sine;
}

/// Along columns, then along rows.
void transform(Spectrum& values, bool forward) {
  Eigen::FFT<double> fft;
  for (int turn = 0; turn < 2; ++turn) {
    for (Eigen::Index column = 0; column < values.cols(); ++column) {
      const Eigen::VectorXcd before = values.col(column);
      Eigen::VectorXcd after(before.size());
      if (forward)
        fft.fwd(after, before);
      else
        fft.inv(after, before);
      values.col(column) = after;
    }
    values.transposeInPlace();
  }
}

double frequency_cpd(Eigen::Index index, Eigen::Index side, double pixels_per_degree) {
  const double cycles = index < side / 2 ? index : index - side;
  return cycles * pixels_per_degree / static_cast<double>(side);
}

}  // namespace

double standard_contrast_sensitivity(double frequency_cpd) {
  return 373.08 * (sech(std::pow(frequency_cpd / 4.1726, 0.7786)) - 0.8493 * sech(frequency_cpd / 1.3625));
}

double standard_observer_threshold_db(const Image& pattern_contrast, double pixels_per_degree) {
  assert(pattern_contrast.channels == 1 && pattern_contrast.width_px == pattern_contrast.height_px);
  const Eigen::Index side = pattern_contrast.width_px;
  Spectrum values(side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) values(y, x) = double{pattern_contrast.at(x, y)};
  transform(values, true);
  for (Eigen::Index y = 0; y < side; ++y)
    for (Eigen::Index x = 0; x < side; ++x) {
      const double x_cpd = frequency_cpd(x, side, pixels_per_degree);
      const double y_cpd = frequency_cpd(y, side, pixels_per_degree);
      values(y, x) *= standard_contrast_sensitivity(std::hypot(x_cpd, y_cpd)) * oblique_factor(x_cpd, y_cpd);
    }
  transform(values, false);
  double sum = 0;
  for (Eigen::Index y = 0; y < side; ++y)
    for (Eigen::Index x = 0; x < side; ++x) {
      const double x_deg = static_cast<double>(x - side / 2) / pixels_per_degree / aperture_deg;
      const double y_deg = static_cast<double>(y - side / 2) / pixels_per_degree / aperture_deg;
      const double seen = std::abs(values(y, x).real()) * std::exp(-(x_deg * x_deg + y_deg * y_deg) / 2);
      sum += std::pow(seen, pooled_exponent);
    }
  return 20 / pooled_exponent * std::log10(sum / (pixels_per_degree * pixels_per_degree));
}

}  // namespace seamline::analysis
