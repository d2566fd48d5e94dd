#include "analysis/joint/joint_cell.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace seamline::analysis {

namespace {

constexpr std::size_t most_cuts = most_joint_ratings - 1;
using OfRatings = std::array<double, most_joint_ratings>;
using OfCuts = std::array<double, most_cuts>;
using CellMatrix = Eigen::Matrix<double, CellSum::size, CellSum::size>;

/// F of the model and what it lacks to 1, without cancellation, with its derivatives.
struct NormalTerms {
  double value = 0, complement = 1, d = 0, dd = 0;
};

NormalTerms normal_terms(double z) {
  const double d = std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi);
  return {.value = std::erfc(-z / std::numbers::sqrt2) / 2,
          .complement = std::erfc(z / std::numbers::sqrt2) / 2,
          .d = d,
          .dd = -z * d};
}

/// F(upper) - F(lower) from the side where both are small.
double between(const NormalTerms& upper, const NormalTerms& lower) {
  return lower.value > 0.5 ? lower.complement - upper.complement : upper.value - lower.value;
}

/// A level of a curve: psi, and F of the cut under each rating (1 under the first, 0 over the last).
struct Level {
  double z = 0, seen = 0, unseen = 1;  ///< psi, and what it lacks to 1
  NormalTerms f;                       ///< of z
  OfCuts u{};                          ///< (z - t_k) / rho
  std::array<NormalTerms, most_joint_ratings + 1> cut;
};

Level level_at(const JointCurve& curve, double x) {
  Level level;
  level.z = (curve.m - x) / curve.s;
  level.f = normal_terms(level.z);
  level.seen = (1 - curve.lapse) * level.f.value;
  level.unseen = std::max(least_probability, curve.lapse + (1 - curve.lapse) * level.f.complement);
  const std::size_t cuts = curve.ratings - 1;
  level.cut[0] = {.value = 1, .complement = 0};
  for (std::size_t k = 0; k < cuts; ++k) {
    level.u[k] = (level.z - curve.t[k]) / curve.rho;
    level.cut[k + 1] = normal_terms(level.u[k]);
  }
  return level;
}

/// Derivatives of a cell's log likelihood by psi, q(r) and g(r); `seen_q` by psi and q(r), and so on.
struct ByProbabilities {
  double value = 0, seen = 0, seen_seen = 0;
  OfRatings q{}, g{}, q_q{}, g_g{}, seen_q{}, seen_g{}, q_g{};
};

ByProbabilities by_probabilities(const Level& level, const JointCurve& curve, double chance,
                                 const Eigen::Ref<const Eigen::VectorXd>& counts) {
  ByProbabilities by;
  const double wrong = counts.tail(curve.ratings).sum();
  if (wrong > 0) {
    by.value += wrong * std::log(level.unseen);
    by.seen -= wrong / level.unseen;
    by.seen_seen -= wrong / level.unseen / level.unseen;
  }
  for (std::size_t r = 0; r < static_cast<std::size_t>(curve.ratings); ++r) {
    const double n = counts[static_cast<Eigen::Index>(r)];
    if (!(n > 0)) continue;
    const double q = between(level.cut[r], level.cut[r + 1]), guessed = chance * curve.g[r];
    const double p = std::max(least_probability, level.seen * q + level.unseen * guessed);
    const double seen = (q - guessed) / p, of_q = level.seen / p, of_g = level.unseen * chance / p;
    by.value += n * std::log(p);
    by.seen += n * seen;
    by.q[r] = n * of_q;
    by.g[r] = n * of_g;
    by.seen_seen -= n * seen * seen;
    by.q_q[r] = -n * of_q * of_q;
    by.g_g[r] = -n * of_g * of_g;
    by.seen_q[r] = n / p - n * seen * of_q;
    by.seen_g[r] = -n * chance / p - n * seen * of_g;
    by.q_g[r] = -n * of_q * of_g;
  }
  return by;
}

/// The same by z, l, the u_k and g(r), where u_k and z count as independent.
struct ByArguments {
  double z = 0, l = 0, z_z = 0, z_l = 0, l_l = 0;
  OfCuts u{}, z_u{}, l_u{};
  std::array<OfCuts, most_cuts> u_u{};     ///< both halves
  std::array<OfRatings, most_cuts> u_g{};  ///< u_k bounds ratings k and k + 1 alone
  OfRatings z_g{}, l_g{};
};

ByArguments by_arguments(const CurveTerms& terms, const Level& level, const ByProbabilities& by) {
  const double rest = 1 - terms.curve.lapse;
  const double seen_z = rest * level.f.d, seen_l = -terms.lapse_d * level.f.value;
  ByArguments to;
  to.z = by.seen * seen_z;
  to.l = by.seen * seen_l;
  to.z_z = by.seen_seen * seen_z * seen_z + by.seen * rest * level.f.dd;
  to.z_l = by.seen_seen * seen_z * seen_l - by.seen * terms.lapse_d * level.f.d;
  to.l_l = by.seen_seen * seen_l * seen_l - by.seen * terms.lapse_dd * level.f.value;
  const std::size_t ratings = terms.curve.ratings;
  for (std::size_t r = 0; r < ratings; ++r) {
    to.z_g[r] = by.seen_g[r] * seen_z;
    to.l_g[r] = by.seen_g[r] * seen_l;
  }
  for (std::size_t k = 0; k + 1 < ratings; ++k) {
    const NormalTerms& cut = level.cut[k + 1];
    const double more = by.q[k + 1] - by.q[k], seen_u = (by.seen_q[k + 1] - by.seen_q[k]) * cut.d;
    to.u[k] = more * cut.d;
    to.z_u[k] = seen_u * seen_z;
    to.l_u[k] = seen_u * seen_l;
    to.u_u[k][k] = (by.q_q[k] + by.q_q[k + 1]) * cut.d * cut.d + more * cut.dd;
    if (k + 2 < ratings) to.u_u[k][k + 1] = to.u_u[k + 1][k] = -by.q_q[k + 1] * cut.d * level.cut[k + 2].d;
    to.u_g[k][k] = -by.q_g[k] * cut.d;
    to.u_g[k][k + 1] = by.q_g[k + 1] * cut.d;
  }
  return to;
}

/// z moves all u_k = (z - t_k) / rho: after this `by` is by z at fixed t and rho. Derivatives by t_k and
/// log rho are added.
void add_cuts(const CurveTerms& terms, const Level& level, ByArguments& by, CellSum& sum) {
  const double inverse = 1 / terms.curve.rho;
  const std::size_t cuts = terms.curve.ratings - 1;
  double by_z = 0, z_z = 0, z_l = 0, spread = 0, spread_spread = 0, z_spread = 0, l_spread = 0;
  for (std::size_t k = 0; k < cuts; ++k) {
    double row = 0, row_u = 0;  // of u_u, and with the other's u
    for (std::size_t j = 0; j < cuts; ++j) {
      row += by.u_u[k][j];
      row_u += by.u_u[k][j] * level.u[j];
    }
    const Eigen::Index at = CellSum::cut + static_cast<Eigen::Index>(k);
    sum.gradient[at] -= by.u[k] * inverse;
    for (std::size_t j = k; j < cuts; ++j)
      sum.hessian(at, CellSum::cut + static_cast<Eigen::Index>(j)) += by.u_u[k][j] * inverse * inverse;
    sum.hessian(at, CellSum::log_spread) += (row_u + by.u[k]) * inverse;
    sum.hessian(CellSum::lapse, at) -= by.l_u[k] * inverse;
    for (std::size_t r = k; r < k + 2; ++r) {
      const Eigen::Index guess = CellSum::guess + static_cast<Eigen::Index>(r);
      sum.hessian(at, guess) -= by.u_g[k][r] * inverse;
      sum.hessian(CellSum::log_spread, guess) -= by.u_g[k][r] * level.u[k];
      by.z_g[r] += by.u_g[k][r] * inverse;
    }
    by_z += by.u[k] * inverse;
    z_z += (2 * by.z_u[k] + row * inverse) * inverse;
    z_l += by.l_u[k] * inverse;
    spread -= by.u[k] * level.u[k];
    spread_spread += (row_u + by.u[k]) * level.u[k];
    z_spread -= by.z_u[k] * level.u[k] + (row_u + by.u[k]) * inverse;
    l_spread -= by.l_u[k] * level.u[k];
    by.z_u[k] = -(by.z_u[k] + row * inverse) * inverse;  // by z and t_k from here on
  }
  by.z += by_z;
  by.z_z += z_z;
  by.z_l += z_l;
  sum.gradient[CellSum::log_spread] += spread;
  sum.hessian(CellSum::log_spread, CellSum::log_spread) += spread_spread;
  sum.hessian(CellSum::lapse, CellSum::log_spread) += l_spread;
  sum.hessian(CellSum::m, CellSum::log_spread) += z_spread / terms.curve.s;
  sum.hessian(CellSum::log_scale, CellSum::log_spread) -= z_spread * level.z;
}

/// z = (m - x) / s.
void add_place(const CurveTerms& terms, const Level& level, const ByArguments& by, CellSum& sum) {
  const double z_m = 1 / terms.curve.s, z_scale = -level.z;
  sum.gradient[CellSum::m] += by.z * z_m;
  sum.gradient[CellSum::log_scale] += by.z * z_scale;
  sum.gradient[CellSum::lapse] += by.l;
  sum.hessian(CellSum::m, CellSum::m) += by.z_z * z_m * z_m;
  sum.hessian(CellSum::m, CellSum::log_scale) += by.z_z * z_m * z_scale - by.z * z_m;
  sum.hessian(CellSum::log_scale, CellSum::log_scale) += by.z_z * z_scale * z_scale + by.z * level.z;
  sum.hessian(CellSum::lapse, CellSum::lapse) += by.l_l;
  const auto with_z = [&](Eigen::Index at, double z_at) {
    sum.hessian(CellSum::m, at) += z_at * z_m;
    sum.hessian(CellSum::log_scale, at) += z_at * z_scale;
  };
  with_z(CellSum::lapse, by.z_l);
  for (std::size_t k = 0; k + 1 < static_cast<std::size_t>(terms.curve.ratings); ++k)
    with_z(CellSum::cut + static_cast<Eigen::Index>(k), by.z_u[k]);
  for (std::size_t r = 0; r < static_cast<std::size_t>(terms.curve.ratings); ++r)
    with_z(CellSum::guess + static_cast<Eigen::Index>(r), by.z_g[r]);
}

/// Derivatives of g(r) by h, r from 0.
void write_guess_rows(const JointCurve& curve, CurveTerms& terms) {
  for (Eigen::Index r = 0; r < curve.ratings; ++r)
    for (Eigen::Index i = 0; i < curve.ratings - 1; ++i)
      terms.by_model(CellSum::guess + r, CurveSum::guess + i) =
          curve.g[r] * ((i + 1 == r ? 1 : 0) - curve.g[i + 1]);
}

/// Second derivative of g(r) by h_{i+2} and h_{j+2}.
double guess_curvature(const JointCurve& curve, Eigen::Index r, Eigen::Index i, Eigen::Index j) {
  const double gi = curve.g[i + 1], gj = curve.g[j + 1], is_i = i + 1 == r ? 1 : 0, is_j = j + 1 == r ? 1 : 0;
  return curve.g[r] * ((is_i - gi) * (is_j - gj) - (i == j ? gj : 0) + gi * gj);
}

/// What the model's coordinates bend, and guesses: sum_r n_r log g(r).
void add_guesses(const JointCurve& curve, const CellSum& cells, CurveSum& sum) {
  double all = 0;
  for (std::size_t r = 0; r < static_cast<std::size_t>(curve.ratings); ++r) {
    all += cells.guesses[r];
    if (cells.guesses[r] > 0)
      sum.value += cells.guesses[r] * std::log(std::max(least_probability, curve.g[r]));
  }
  for (Eigen::Index i = 0; i < curve.ratings - 1; ++i)
    for (Eigen::Index j = 0; j < curve.ratings - 1; ++j) {
      double bend = -all * ((i == j ? curve.g[i + 1] : 0) - curve.g[i + 1] * curve.g[j + 1]);
      for (Eigen::Index r = 0; r < curve.ratings; ++r)
        bend += cells.gradient[CellSum::guess + r] * guess_curvature(curve, r, i, j);
      sum.hessian(CurveSum::guess + i, CurveSum::guess + j) += bend;
    }
}

}  // namespace

CurveTerms terms_of(const JointModel& model, const Eigen::VectorXd& theta, int curve) {
  CurveTerms terms;
  terms.curve = curve_at(model, theta, curve);
  const double share = terms.curve.lapse / most_lapse;
  terms.lapse_d = most_lapse * share * (1 - share);
  terms.lapse_dd = terms.lapse_d * (1 - 2 * share);
  terms.by_model.setZero();
  for (const Eigen::Index same : {CellSum::m, CellSum::log_scale, CellSum::lapse, CellSum::log_spread})
    terms.by_model(same, same) = 1;
  terms.to.fill(-1);
  terms.to[CellSum::m] = model.threshold(curve);
  terms.to[CellSum::log_scale] = model.log_scale(curve);
  terms.to[CellSum::lapse] = model.lapse(curve);
  if (model.ratings == 1) return terms;
  write_guess_rows(terms.curve, terms);
  terms.to[CurveSum::log_spread] = model.log_spread(curve);
  for (Eigen::Index k = 0; k < model.ratings - 1; ++k) {
    terms.to[CellSum::cut + k] = model.first_cut(curve) + k;
    terms.to[CurveSum::guess + k] = model.first_guess(curve) + k;
    const double distance = k == 0 ? 1 : std::exp(theta[model.first_cut(curve) + k]);
    for (Eigen::Index moved = k; moved < model.ratings - 1; ++moved)
      terms.by_model(CellSum::cut + moved, CellSum::cut + k) = distance;
  }
  return terms;
}

void add_cell(const CurveTerms& terms, const JointCell& cell, const Eigen::Ref<const Eigen::VectorXd>& counts,
              CellSum& sum) {
  const std::size_t ratings = terms.curve.ratings;
  sum.value += counts.tail(terms.curve.ratings).sum() * std::log(1 - cell.chance);
  for (std::size_t r = 0; r < ratings; ++r) sum.guesses[r] += counts[static_cast<Eigen::Index>(ratings + r)];
  if (!std::isfinite(cell.x)) {
    for (std::size_t r = 0; r < ratings; ++r) sum.guesses[r] += counts[static_cast<Eigen::Index>(r)];
    sum.value += counts.head(terms.curve.ratings).sum() * std::log(cell.chance);
    return;
  }
  const Level level = level_at(terms.curve, cell.x);
  const ByProbabilities by = by_probabilities(level, terms.curve, cell.chance, counts);
  ByArguments arguments = by_arguments(terms, level, by);
  sum.value += by.value;
  for (std::size_t r = 0; r < ratings; ++r) {
    const Eigen::Index at = CellSum::guess + static_cast<Eigen::Index>(r);
    sum.gradient[at] += by.g[r];
    sum.hessian(at, at) += by.g_g[r];
    sum.hessian(CellSum::lapse, at) += arguments.l_g[r];
  }
  add_cuts(terms, level, arguments, sum);
  add_place(terms, level, arguments, sum);
}

Eigen::Matrix<double, CurveSum::size, 1> curve_gradient(const CurveTerms& terms, const CellSum& cells) {
  Eigen::Matrix<double, CurveSum::size, 1> gradient = terms.by_model.transpose() * cells.gradient;
  double all = 0;
  for (int r = 0; r < terms.curve.ratings; ++r) all += cells.guesses[r];
  for (Eigen::Index i = 0; i < terms.curve.ratings - 1; ++i)
    gradient[CurveSum::guess + i] += cells.guesses[i + 1] - all * terms.curve.g[i + 1];
  return gradient;
}

CurveSum curve_sum(const CurveTerms& terms, const CellSum& cells) {
  CurveSum sum;
  sum.value = cells.value;
  sum.gradient = curve_gradient(terms, cells);
  const CellMatrix both_halves = cells.hessian.selfadjointView<Eigen::Upper>();
  sum.hessian.noalias() =
      terms.by_model.transpose().lazyProduct((both_halves.lazyProduct(terms.by_model)).eval());
  // A distance is the exponential of its coordinate: its second derivative is its first.
  for (Eigen::Index k = 1; k < terms.curve.ratings - 1; ++k)
    sum.hessian(CellSum::cut + k, CellSum::cut + k) += sum.gradient[CellSum::cut + k];
  add_guesses(terms.curve, cells, sum);
  return sum;
}

}  // namespace seamline::analysis
