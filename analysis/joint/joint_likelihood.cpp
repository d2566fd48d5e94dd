#include "analysis/joint/joint_likelihood.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace seamline::analysis {

namespace {

// Coordinates of one curve, in the order of the derivatives below.
constexpr Eigen::Index at_m = 0, at_scale = 1, at_lapse = 2, at_cut = 3, at_spread = 6, at_guess = 7;
constexpr Eigen::Index curve_size = 10;
using CurveVector = Eigen::Matrix<double, curve_size, 1>;
using CurveMatrix = Eigen::Matrix<double, curve_size, curve_size>;

/// A value with its first and second derivatives.
struct Jet {
  double value = 0;
  CurveVector d = CurveVector::Zero();
  CurveMatrix dd = CurveMatrix::Zero();
};

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

/// What the cells of a curve have in common.
struct CurveTerms {
  JointCurve curve;
  double lapse_d = 0, lapse_dd = 0;         ///< of the lapse rate by l
  std::array<double, 3> distance{};         ///< t_k - t_{k-1}; the first is 1, the derivative of t_2
  std::array<Eigen::Index, curve_size> to;  ///< place of each coordinate in theta; -1: not in the model
};

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
  if (model.ratings == 1) return terms;
  terms.to[at_spread] = model.log_spread(curve);
  for (Eigen::Index k = 0; k < model.ratings - 1; ++k) {
    terms.to[static_cast<std::size_t>(at_cut + k)] = model.first_cut(curve) + k;
    terms.to[static_cast<std::size_t>(at_guess + k)] = model.first_guess(curve) + k;
    terms.distance[static_cast<std::size_t>(k)] = k == 0 ? 1 : std::exp(theta[model.first_cut(curve) + k]);
  }
  return terms;
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
  const double g = curve.g[static_cast<std::size_t>(r)];
  guess.value = g;
  for (Eigen::Index i = 0; i < curve.ratings - 1; ++i) {
    const double gi = curve.g[static_cast<std::size_t>(i) + 1], is_i = i + 1 == r ? 1 : 0;
    guess.d[at_guess + i] = g * (is_i - gi);
    for (Eigen::Index j = 0; j < curve.ratings - 1; ++j) {
      const double gj = curve.g[static_cast<std::size_t>(j) + 1], is_j = j + 1 == r ? 1 : 0;
      guess.dd(at_guess + i, at_guess + j) = g * ((is_i - gi) * (is_j - gj) - (i == j ? gj : 0) + gi * gj);
    }
  }
  return guess;
}

/// F(upper) - F(lower) from the side where both are small.
double between(const NormalTerms& upper, const NormalTerms& lower) {
  return lower.value > 0.5 ? lower.complement - upper.complement : upper.value - lower.value;
}

constexpr double least_probability = 1e-300;

/// Log likelihood of one curve's cells, with derivatives by its own coordinates.
struct CurveSum {
  double value = 0;
  CurveVector gradient = CurveVector::Zero();
  CurveMatrix hessian = CurveMatrix::Zero();
  std::array<double, most_joint_ratings> guesses{};  ///< answers that can only be guesses, by rating
};

using Counts = Eigen::Ref<const Eigen::VectorXd>;

/// Right answers of one cell.
void add_right(const CurveTerms& terms, const JointCell& cell, const Counts& counts,
               const std::array<Jet, most_joint_ratings>& guess, CurveSum& sum, const Jet& z,
               const Jet& seen) {
  const int ratings = terms.curve.ratings;
  Jet above, q;
  NormalTerms f_above;
  above.value = 1;
  for (int r = 0; r < ratings; ++r) {
    const auto place = static_cast<std::size_t>(r);
    Jet next;
    NormalTerms f_next{.value = 0, .complement = 1, .d = 0, .dd = 0};
    if (r + 1 < ratings) {
      const Jet cut = cut_jet(terms, z, place);
      f_next = normal_terms(cut.value);
      next = normal_jet(cut, f_next);
    }
    const double n = counts[r];
    if (n > 0) {
      q.value = between(f_above, f_next);
      q.d = above.d - next.d;
      q.dd = above.dd - next.dd;
      const Jet& g = guess[place];
      const double b = cell.chance, unseen = 1 - seen.value, difference = q.value - b * g.value;
      const double p = std::max(least_probability, seen.value * q.value + unseen * b * g.value);
      const double weight = n / p;
      const CurveVector d = difference * seen.d + seen.value * q.d + unseen * b * g.d;
      const CurveVector mixed = q.d - b * g.d;
      sum.value += n * std::log(p);
      sum.gradient += weight * d;
      sum.hessian += weight * (difference * seen.dd + seen.d * mixed.transpose() +
                               mixed * seen.d.transpose() + seen.value * q.dd + unseen * b * g.dd) -
                     (weight / p) * d * d.transpose();
    }
    above = next;
    f_above = f_next;
  }
}

/// Answers of one cell. Wrong ones are (1 - psi) (1 - b) g(r); what depends on g alone is added once a curve.
void add_cell(const CurveTerms& terms, const JointCell& cell, const Counts& counts,
              const std::array<Jet, most_joint_ratings>& guess, CurveSum& sum) {
  const int ratings = terms.curve.ratings;
  const double wrong = counts.tail(ratings).sum();
  sum.value += wrong * std::log(1 - cell.chance);
  for (int r = 0; r < ratings; ++r) sum.guesses[static_cast<std::size_t>(r)] += counts[ratings + r];
  if (!std::isfinite(cell.x)) {
    for (int r = 0; r < ratings; ++r) sum.guesses[static_cast<std::size_t>(r)] += counts[r];
    sum.value += counts.head(ratings).sum() * std::log(cell.chance);
    return;
  }
  const Jet z = z_jet(terms, cell.x);
  const NormalTerms f = normal_terms(z.value);
  const Jet seen = seen_jet(terms, z, f);
  if (wrong > 0) {
    const double unseen =
        std::max(least_probability, terms.curve.lapse + (1 - terms.curve.lapse) * f.complement);
    sum.value += wrong * std::log(unseen);
    sum.gradient -= (wrong / unseen) * seen.d;
    sum.hessian -= (wrong / unseen) * seen.dd + (wrong / (unseen * unseen)) * seen.d * seen.d.transpose();
  }
  add_right(terms, cell, counts, guess, sum, z, seen);
}

/// sum_r n_r log g(r).
void add_guesses(const JointCurve& curve, const std::array<double, most_joint_ratings>& counts,
                 CurveSum& sum) {
  double all = 0;
  for (int r = 0; r < curve.ratings; ++r) {
    const auto place = static_cast<std::size_t>(r);
    all += counts[place];
    if (counts[place] > 0) sum.value += counts[place] * std::log(std::max(least_probability, curve.g[place]));
  }
  for (Eigen::Index i = 0; i < curve.ratings - 1; ++i) {
    const double gi = curve.g[static_cast<std::size_t>(i) + 1];
    sum.gradient[at_guess + i] += counts[static_cast<std::size_t>(i) + 1] - all * gi;
    for (Eigen::Index j = 0; j < curve.ratings - 1; ++j) {
      const double gj = curve.g[static_cast<std::size_t>(j) + 1];
      sum.hessian(at_guess + i, at_guess + j) -= all * ((i == j ? gi : 0) - gi * gj);
    }
  }
}

void spread_into(const CurveTerms& terms, const CurveSum& sum, Evaluation& total) {
  total.value += sum.value;
  for (std::size_t i = 0; i < terms.to.size(); ++i) {
    if (terms.to[i] < 0) continue;
    total.gradient[terms.to[i]] += sum.gradient[static_cast<Eigen::Index>(i)];
    for (std::size_t j = 0; j < terms.to.size(); ++j)
      if (terms.to[j] >= 0)
        total.hessian(terms.to[i], terms.to[j]) +=
            sum.hessian(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  }
}

Evaluation zero_evaluation(const JointModel& model) {
  const Eigen::Index n = model.parameters();
  return {.value = 0, .gradient = Eigen::VectorXd::Zero(n), .hessian = Eigen::MatrixXd::Zero(n, n)};
}

/// The quadratic penalty of one coordinate.
void pull(Evaluation& penalty, const Eigen::VectorXd& theta, Eigen::Index at, double centre, double sd) {
  const double away = (theta[at] - centre) / sd;
  penalty.value -= away * away / 2;
  penalty.gradient[at] -= away / sd;
  penalty.hessian(at, at) -= 1 / (sd * sd);
}

// Of the penalties, as the header says.
constexpr double threshold_sd_ranges = 2, log_scale_sd = 1.5, lapse_centre = -1, lapse_sd = 1.5, cut_sd = 4,
                 distance_sd = 1.5, spread_sd = 1, scales_in_range = 7, guess_answers = 0.5;

}  // namespace

JointCounts all_counts(const JointData& data) {
  return {.cells = data.answers.colwise().sum().transpose(),
          .references = data.references.colwise().sum().transpose()};
}

JointCounts person_counts(const JointData& data, Eigen::Index person) {
  return {.cells = data.answers.row(person).transpose(),
          .references = data.references.row(person).transpose()};
}

Evaluation joint_likelihood(const JointModel& model, const JointCounts& counts,
                            const Eigen::VectorXd& theta) {
  Evaluation total = zero_evaluation(model);
  const Eigen::Index width = 2 * static_cast<Eigen::Index>(model.ratings);
  std::size_t c = 0;
  for (int curve = 0; curve < model.curves; ++curve) {
    const CurveTerms terms = terms_of(model, theta, curve);
    std::array<Jet, most_joint_ratings> guess;
    for (int r = 0; r < model.ratings; ++r) guess[static_cast<std::size_t>(r)] = guess_jet(terms.curve, r);
    CurveSum sum;
    for (; c < model.cells.size() && model.cells[c].curve == curve; ++c) {
      const auto of_cell = counts.cells.segment(static_cast<Eigen::Index>(c) * width, width);
      if ((of_cell.array() > 0).any()) add_cell(terms, model.cells[c], of_cell, guess, sum);
    }
    // Nobody's curve is shown in a reference trial: where curves have their own guess ratings each has a
    // share.
    for (int r = 0; r < model.ratings; ++r)
      sum.guesses[static_cast<std::size_t>(r)] += counts.references[r] / model.curves;
    add_guesses(terms.curve, sum.guesses, sum);
    spread_into(terms, sum, total);
  }
  return total;
}

double joint_log_likelihood(const JointModel& model, const JointCounts& counts,
                            const Eigen::VectorXd& theta) {
  const Eigen::Index width = 2 * static_cast<Eigen::Index>(model.ratings);
  double value = 0;
  std::vector<JointCurve> curves;
  for (int curve = 0; curve < model.curves; ++curve) {
    curves.push_back(curve_at(model, theta, curve));
    for (int r = 0; r < model.ratings; ++r)
      if (counts.references[r] > 0)
        value += counts.references[r] / model.curves *
                 std::log(std::max(least_probability, curves.back().g[static_cast<std::size_t>(r)]));
  }
  for (std::size_t c = 0; c < model.cells.size(); ++c) {
    const auto of_cell = counts.cells.segment(static_cast<Eigen::Index>(c) * width, width);
    const JointCell& cell = model.cells[c];
    const Eigen::VectorXd p =
        outcome_probabilities(curves[static_cast<std::size_t>(cell.curve)], cell.x, cell.chance);
    for (Eigen::Index o = 0; o < width; ++o)
      if (of_cell[o] > 0) value += of_cell[o] * std::log(std::max(least_probability, p[o]));
  }
  return value;
}

Eigen::VectorXd penalty_centre(const JointModel& model) {
  Eigen::VectorXd centre = Eigen::VectorXd::Zero(model.parameters());
  for (int curve = 0; curve < model.curves; ++curve) {
    centre[model.threshold(curve)] = model.centre_x;
    centre[model.log_scale(curve)] = std::log(model.range_x / scales_in_range);
    centre[model.lapse(curve)] = lapse_centre;
  }
  return centre;
}

Evaluation joint_penalty(const JointModel& model, const Eigen::VectorXd& theta) {
  Evaluation penalty = zero_evaluation(model);
  const Eigen::VectorXd centre = penalty_centre(model);
  const auto first = [](bool shared, int curve) { return !shared || curve == 0; };
  for (int curve = 0; curve < model.curves; ++curve) {
    const auto at = [&](Eigen::Index place, double sd) { pull(penalty, theta, place, centre[place], sd); };
    at(model.threshold(curve), threshold_sd_ranges * model.range_x);
    if (first(model.sharing.scale, curve)) at(model.log_scale(curve), log_scale_sd);
    if (first(model.sharing.lapse, curve)) at(model.lapse(curve), lapse_sd);
    if (model.ratings == 1) continue;
    if (first(model.sharing.criteria, curve)) {
      at(model.first_cut(curve), cut_sd);
      for (Eigen::Index k = 1; k < model.ratings - 1; ++k) at(model.first_cut(curve) + k, distance_sd);
      at(model.log_spread(curve), spread_sd);
    }
    if (!first(model.sharing.guess_ratings, curve)) continue;
    CurveSum half;
    half.guesses.fill(guess_answers);
    const CurveTerms terms = terms_of(model, theta, curve);
    add_guesses(terms.curve, half.guesses, half);
    spread_into(terms, half, penalty);
  }
  return penalty;
}

}  // namespace seamline::analysis
