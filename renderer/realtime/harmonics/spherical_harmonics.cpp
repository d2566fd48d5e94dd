#include "renderer/realtime/harmonics/spherical_harmonics.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace seamline::renderer {
namespace {

/// sqrt((2 l + 1) / (4 std::numbers::pi) (l - m)! / (l + m)!)
double normalization(int l, int m) {
  double ratio = 1;
  for (int k = l - m + 1; k <= l + m; ++k) ratio /= k;
  return std::sqrt((2 * l + 1) / (4 * std::numbers::pi) * ratio);
}

struct Legendre {
  double value, slope;
};
Legendre legendre(int degree, double x) {
  double before = 1, now = x;
  for (int l = 2; l <= degree; ++l) {
    const double next = ((2 * l - 1) * x * now - (l - 1) * before) / l;
    before = now;
    now = next;
  }
  if (degree == 0) return {1, 0};
  return {now, degree * (x * now - before) / (x * x - 1)};
}

}  // namespace

void evaluate_harmonics(int bands, const Eigen::Vector3d& direction, std::span<double> out) {
  assert(bands >= 1 && bands <= most_bands);
  const double x = direction.x(), y = direction.y(), z = direction.z();
  double cosine = 1, sine = 0;  // of m phi, times sin(theta)^m
  double diagonal = 1;          // P_m^m over sin(theta)^m
  for (int m = 0; m < bands; ++m) {
    double before = 0, now = diagonal;
    for (int l = m; l < bands; ++l) {
      const double value = normalization(l, m) * now;
      const auto middle = static_cast<std::size_t>(l * (l + 1));
      if (m == 0) {
        out[middle] = value;
      } else {
        out[middle + static_cast<std::size_t>(m)] = std::numbers::sqrt2 * value * cosine;
        out[middle - static_cast<std::size_t>(m)] = std::numbers::sqrt2 * value * sine;
      }
      const double next = ((2 * l + 1) * z * now - (l + m) * before) / (l + 1 - m);
      before = now;
      now = next;
    }
    diagonal *= 2 * m + 1;
    const double turned = cosine * x - sine * y;
    sine = cosine * y + sine * x;
    cosine = turned;
  }
}

SphereRule sphere_rule(int rows) {
  SphereRule rule;
  const int columns = 2 * rows;
  for (int row = 0; row < rows; ++row) {
    double z = std::cos(std::numbers::pi * (row + 0.75) / (rows + 0.5));
    for (int step = 0; step < 50; ++step) {
      const Legendre at = legendre(rows, z);
      const double change = at.value / at.slope;
      z -= change;
      if (std::abs(change) < 1e-15) break;
    }
    const double slope = legendre(rows, z).slope;
    const double weight = 2 / ((1 - z * z) * slope * slope) * (2 * std::numbers::pi / columns);
    const double flat = std::sqrt(1 - z * z);
    for (int column = 0; column < columns; ++column) {
      const double azimuth = 2 * std::numbers::pi * (column + 0.5) / columns;
      rule.directions.emplace_back(flat * std::cos(azimuth), flat * std::sin(azimuth), z);
      rule.weights_sr.push_back(weight);
    }
  }
  return rule;
}

Eigen::MatrixXd harmonic_rotation(int bands, const Eigen::Matrix3d& rotation) {
  const int count = coefficient_count(bands);
  const SphereRule rule = sphere_rule(bands);  // products have degree 2 (bands - 1)
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(count, count);
  Eigen::VectorXd here(count), there(count);
  const auto values = [](Eigen::VectorXd& of) {
    return std::span<double>(of.data(), static_cast<std::size_t>(of.size()));
  };
  for (std::size_t i = 0; i < rule.directions.size(); ++i) {
    evaluate_harmonics(bands, rule.directions[i], values(here));
    evaluate_harmonics(bands, rotation.transpose() * rule.directions[i], values(there));
    for (int l = 0; l < bands; ++l) {
      const int first = l * l, of_band = 2 * l + 1;
      out.block(first, first, of_band, of_band) +=
          rule.weights_sr[i] * here.segment(first, of_band) * there.segment(first, of_band).transpose();
    }
  }
  return out;
}

std::vector<double> clamped_cosine_bands(int bands) {
  std::vector<double> out;
  for (int l = 0; l < bands; ++l) {
    // 2 std::numbers::pi times the integral of x P_l(x) from 0 to 1; the recurrence of P_l gives it from
    // values at 0.
    if (l == 1) {
      out.push_back(2 * std::numbers::pi / 3);
    } else if (l % 2 == 1) {
      out.push_back(0);
    } else {
      double ratio = 1;  // l! / (2^l ((l / 2)!)^2)
      for (int k = 1; k <= l / 2; ++k) ratio *= (2.0 * k - 1) / (2.0 * k);
      const double sign = l % 4 == 0 ? -1 : 1;
      out.push_back(l == 0 ? std::numbers::pi
                           : 2 * std::numbers::pi * sign * ratio / ((l + 2.0) * (l - 1.0)));
    }
  }
  return out;
}

}  // namespace seamline::renderer
