#include "analysis/joint/joint_mean_curve.h"

#include <cmath>
#include <numbers>

namespace seamline::analysis {

namespace {

/// F and its first four derivatives.
std::array<double, 5> normal_derivatives(double z) {
  const double d = std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi);
  return {std::erfc(-z / std::numbers::sqrt2) / 2, d, -z * d, (z * z - 1) * d, (3 - z * z) * z * d};
}

double mean_guess(const JointCurve& curve) {
  double mean = 0;
  for (int r = 0; r < curve.ratings; ++r) mean += (r + 1) * curve.g[r];
  return mean;
}

/// (f M)'' and so on, with M's derivatives: Leibniz.
double product(const std::array<double, 5>& f, const std::array<double, 4>& m, int order) {
  constexpr std::array<std::array<double, 4>, 4> binomial = {
      {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}}};
  double sum = 0;
  for (int i = 0; i <= order; ++i) sum += binomial[order][i] * f[order - i] * m[i];
  return sum;
}

void write_order(int order, double by, MeanAtZ& at, double MeanAtZ::ByShape::*member) {
  if (order == 0) at.value.*member = by;
  if (order == 2) at.second.*member = by;
}

}  // namespace

MeanAtZ mean_at_z(const JointCurve& curve, JointMean mean, double chance, double z) {
  const bool counted = mean == JointMean::as_counted;
  const double c = counted ? chance * mean_guess(curve) : 0, rest = 1 - curve.lapse;
  const std::array<double, 5> f = normal_derivatives(z);
  const std::size_t cuts = mean == JointMean::detected ? 0 : static_cast<std::size_t>(curve.ratings) - 1;
  std::array<double, 4> m = {1 - c, 0, 0, 0};  // mu - c and its derivatives
  std::array<std::array<double, 4>, most_joint_ratings - 1> by_cut{};
  std::array<double, 4> by_spread{};
  for (std::size_t k = 0; k < cuts; ++k) {
    const double u = (z - curve.t[k]) / curve.rho;
    const std::array<double, 5> g = normal_derivatives(u);
    double power = 1;
    for (std::size_t n = 0; n < 4; ++n) {
      m[n] += g[n] * power;
      by_cut[k][n] = -g[n + 1] * power / curve.rho;
      by_spread[n] -= (static_cast<double>(n) * g[n] + u * g[n + 1]) * power;
      power /= curve.rho;
    }
  }
  MeanAtZ at;
  for (int n = 0; n < 4; ++n) at.z[n] = rest * product(f, m, n);
  at.z[0] += c;
  const double share = curve.lapse / most_lapse, lapse_d = curve.lapse * (1 - share);
  for (const int order : {0, 2}) {
    write_order(order, -lapse_d * product(f, m, order), at, &MeanAtZ::ByShape::lapse);
    write_order(order, rest * product(f, by_spread, order), at, &MeanAtZ::ByShape::spread);
    auto& into = order == 0 ? at.value : at.second;
    // t_k moves with t_2 and with every distance up to it.
    for (std::size_t j = 0; j < cuts; ++j) {
      const double moved = j == 0 ? 1 : curve.t[j] - curve.t[j - 1];
      for (std::size_t k = j; k < cuts; ++k) into.cut[j] += moved * rest * product(f, by_cut[k], order);
    }
    const double by_c = (order == 0 ? 1.0 : 0.0) - rest * f[order];
    for (std::size_t r = 0; counted && r < cuts; ++r)
      into.guess[r] = by_c * chance * curve.g[r + 1] * (static_cast<double>(r) + 2 - mean_guess(curve));
  }
  return at;
}

double mean_noticeability(const JointCurve& curve, JointMean mean, double chance, double x) {
  return mean_at_z(curve, mean, chance, (curve.m - x) / curve.s).z[0];
}

double floor_of_mean(const JointCurve& curve, JointMean mean, double chance) {
  return mean == JointMean::as_counted ? chance * mean_guess(curve) : 0;
}

}  // namespace seamline::analysis
