#include "analysis/joint/joint_jets.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace seamline::analysis {

namespace {

/// F of the model and what it lacks to 1, without cancellation, with its derivatives.
struct NormalTerms {
  double value = 1, complement = 0, d = 0, dd = 0;
};

NormalTerms normal_terms(double z) {
  const double d = std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi);
  return {.value = std::erfc(-z / std::numbers::sqrt2) / 2,
          .complement = std::erfc(z / std::numbers::sqrt2) / 2,
          .d = d,
          .dd = -z * d};
}

/// F of a jet.
Jet normal_jet(const Jet& z, const NormalTerms& f) {
  Jet jet;
  jet.value = f.value;
  jet.d = f.d * z.d;
  jet.dd = f.dd * z.d * z.d.transpose() + f.d * z.dd;
  return jet;
}

Jet z_jet(const CurveTerms& terms, double x) {
  Jet z;
  const double inverse = 1 / terms.curve.s;
  z.value = (terms.curve.m - x) * inverse;
  z.d[at_m] = inverse;
  z.d[at_scale] = -z.value;
  z.dd(at_m, at_scale) = z.dd(at_scale, at_m) = -inverse;
  z.dd(at_scale, at_scale) = z.value;
  return z;
}

/// psi of z.
Jet seen_jet(const CurveTerms& terms, const Jet& z, const NormalTerms& f) {
  Jet seen = normal_jet(z, f);
  const double rest = 1 - terms.curve.lapse;
  const CurveVector slope = seen.d;
  seen.value *= rest;
  seen.d *= rest;
  seen.dd *= rest;
  seen.d[at_lapse] = -terms.lapse_d * f.value;
  seen.dd.row(at_lapse) = -terms.lapse_d * slope.transpose();
  seen.dd.col(at_lapse) = -terms.lapse_d * slope;
  seen.dd(at_lapse, at_lapse) = -terms.lapse_dd * f.value;
  return seen;
}

/// (z - t_k) / rho; k counts from 0.
Jet cut_jet(const CurveTerms& terms, const Jet& z, std::size_t k) {
  Jet cut;
  const double inverse = 1 / terms.curve.rho;
  cut.value = (z.value - terms.curve.t[k]) * inverse;
  cut.d = z.d * inverse;
  cut.dd = z.dd * inverse;
  for (std::size_t j = 0; j <= k; ++j) {
    const auto at = at_cut + static_cast<Eigen::Index>(j);
    cut.d[at] = -terms.distance[j] * inverse;
    if (j > 0) cut.dd(at, at) = cut.d[at];
  }
  cut.dd.row(at_spread) = -cut.d.transpose();
  cut.dd.col(at_spread) = -cut.d;
  cut.dd(at_spread, at_spread) = cut.value;
  cut.d[at_spread] = -cut.value;
  return cut;
}

/// g(r), r from 0.
Jet guess_jet(const JointCurve& curve, int r) {
  Jet guess;
  const double g = curve.g[r];
  guess.value = g;
  for (Eigen::Index i = 0; i < curve.ratings - 1; ++i) {
    const double gi = curve.g[i + 1], is_i = i + 1 == r ? 1 : 0;
    guess.d[at_guess + i] = g * (is_i - gi);
    for (Eigen::Index j = 0; j < curve.ratings - 1; ++j) {
      const double gj = curve.g[j + 1], is_j = j + 1 == r ? 1 : 0;
      guess.dd(at_guess + i, at_guess + j) = g * ((is_i - gi) * (is_j - gj) - (i == j ? gj : 0) + gi * gj);
    }
  }
  return guess;
}

/// F(upper) - F(lower) from the side where both are small.
double between(const NormalTerms& upper, const NormalTerms& lower) {
  return lower.value > 0.5 ? lower.complement - upper.complement : upper.value - lower.value;
}

}  // namespace

CurveTerms terms_of(const JointModel& model, const Eigen::VectorXd& theta, int curve) {
  CurveTerms terms;
  terms.curve = curve_at(model, theta, curve);
  const double share = terms.curve.lapse / most_lapse;
  terms.lapse_d = most_lapse * share * (1 - share);
  terms.lapse_dd = terms.lapse_d * (1 - 2 * share);
  terms.to.fill(-1);
  terms.to[at_m] = model.threshold(curve);
  terms.to[at_scale] = model.log_scale(curve);
  terms.to[at_lapse] = model.lapse(curve);
  for (int r = 0; r < model.ratings; ++r) terms.guess[r] = guess_jet(terms.curve, r);
  if (model.ratings == 1) return terms;
  terms.to[at_spread] = model.log_spread(curve);
  for (Eigen::Index k = 0; k < model.ratings - 1; ++k) {
    terms.to[at_cut + k] = model.first_cut(curve) + k;
    terms.to[at_guess + k] = model.first_guess(curve) + k;
    terms.distance[k] = k == 0 ? 1 : std::exp(theta[model.first_cut(curve) + k]);
  }
  return terms;
}

LevelJets level_jets(const CurveTerms& terms, double x) {
  LevelJets level;
  const Jet z = z_jet(terms, x);
  const NormalTerms f = normal_terms(z.value);
  level.seen = seen_jet(terms, z, f);
  level.unseen = std::max(least_probability, terms.curve.lapse + (1 - terms.curve.lapse) * f.complement);
  NormalTerms f_above;
  Jet above;
  for (std::size_t r = 0; r < static_cast<std::size_t>(terms.curve.ratings); ++r) {
    Jet next;
    NormalTerms f_next{.value = 0, .complement = 1, .d = 0, .dd = 0};
    if (r + 1 < static_cast<std::size_t>(terms.curve.ratings)) {
      const Jet cut = cut_jet(terms, z, r);
      f_next = normal_terms(cut.value);
      next = normal_jet(cut, f_next);
    }
    level.q[r].value = between(f_above, f_next);
    level.q[r].d = above.d - next.d;
    level.q[r].dd = above.dd - next.dd;
    above = next;
    f_above = f_next;
  }
  return level;
}

}  // namespace seamline::analysis
