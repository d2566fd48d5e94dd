#include "analysis/psychometric/people/people_fit.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "analysis/psychometric/people/people_likelihood.h"
#include "analysis/statistics/distributions.h"
#include "study/placement/sigmoid_shape.h"
#include "support/running/interrupt.h"
#include "support/text/counted.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

constexpr int most_climb_steps = 300;
constexpr double enough_gain = 1e-8;         ///< log units
constexpr double quadrature_noise = 1e-5;    ///< by which nodes that move change the likelihood
constexpr double small_gain = 1e-3;          ///< a climb that ends with no more to gain has arrived
constexpr double smallest_sd_share = 1e-3;   ///< of the scale, or in e-folds: less is 0
constexpr double largest_ln_scale_sd = 2.5;  ///< e-folds: people's scales then differ without bound

/// The marginal likelihood at a place.
struct PeoplePlace {
  PeopleTheta theta = PeopleTheta::Zero();
  double value = -infinity;
  std::vector<PersonPart> parts;
  PeopleTheta gradient = PeopleTheta::Zero();
  PeopleMatrix hessian = PeopleMatrix::Zero(), outer = PeopleMatrix::Zero();
  std::array<bool, 6> rests{};  ///< at a bound, or no parameter
  bool converged = false;
};

PeoplePlace place_at(const PeopleProblem& people, const PeopleTheta& theta) {
  PeoplePlace place;
  place.theta = theta;
  place.value = 0;
  for (const FitProblem& person : people.each) {
    stop_if_interrupted();
    place.parts.push_back(person_part(person, theta, people_quadrature_nodes));
    const PersonPart& part = place.parts.back();
    place.value += part.value;
    place.gradient += part.gradient;
    place.hessian += part.hessian;
    place.outer += part.gradient * part.gradient.transpose();
  }
  for (int i = 0; i < 6; ++i) {
    const bool equal = people.each.front().equal_rates && i == people_parameter::guess;
    const double low = people.lower[i], high = people.upper[i], slope = place.gradient[i];
    place.rests[i] =
        equal || high <= low || (theta[i] <= low && slope <= 0) || (theta[i] >= high && slope >= 0);
  }
  return place;
}

/// `matrix` with the rows and columns of what rests those of the identity.
PeopleMatrix without_rest(PeopleMatrix matrix, const std::array<bool, 6>& rests) {
  for (int i = 0; i < 6; ++i) {
    if (!rests[i]) continue;
    matrix.row(i).setZero();
    matrix.col(i).setZero();
    matrix(i, i) = 1;
  }
  return matrix;
}

PeopleTheta without_rest(PeopleTheta vector, const std::array<bool, 6>& rests) {
  for (int i = 0; i < 6; ++i)
    if (rests[i]) vector[i] = 0;
  return vector;
}

/// Newton's step where the curvature is definite, else one by the scores' outer product; both damped.
PeopleTheta climb_step(const PeoplePlace& here, double damping) {
  const PeopleTheta slope = without_rest(here.gradient, here.rests);
  const auto solved = [&](const PeopleMatrix& curvature, double extra, PeopleTheta& move) {
    PeopleMatrix damped = without_rest(curvature, here.rests);
    damped.diagonal() += extra * here.outer.diagonal().cwiseMax(1e-9);
    const Eigen::LLT<PeopleMatrix> factor(damped);
    if (factor.info() != Eigen::Success) return false;
    move = factor.solve(slope);
    return move.allFinite();
  };
  PeopleTheta move = PeopleTheta::Zero();
  if (!solved(-here.hessian, damping, move) && !solved(here.outer, std::max(damping, 1e-6), move))
    solved(here.outer, 1 + damping, move);
  const double largest = move.cwiseAbs().maxCoeff();
  return largest > 1 ? PeopleTheta(move / largest) : move;
}

PeoplePlace climb_people(const PeopleProblem& people, const PeopleTheta& start) {
  PeoplePlace here = place_at(people, start.cwiseMax(people.lower).cwiseMin(people.upper));
  double damping = 0;
  for (int step = 0; step < most_climb_steps && std::isfinite(here.value); ++step) {
    const PeopleTheta move = climb_step(here, damping);
    if (here.gradient.dot(move) < enough_gain) {
      here.converged = true;
      break;
    }
    const PeopleTheta next = (here.theta + move).cwiseMax(people.lower).cwiseMin(people.upper);
    PeoplePlace there = place_at(people, next);
    if (there.value >= here.value - quadrature_noise) {
      here = std::move(there);
      damping = damping < 1e-6 ? 0 : damping * 0.3;
    } else {
      damping = std::max(1e-3, damping * 10);
      if (damping > 1e9) {
        here.converged = true;  // no slope is left that double precision can follow
        break;
      }
    }
    here.converged = here.gradient.dot(climb_step(here, 0)) < small_gain;
  }
  return here;
}

/// The likeliest place of climbs from people who differ little and much.
PeoplePlace likeliest_people(const PeopleProblem& people, const Theta& sums, double steepest) {
  PeoplePlace best;
  for (const double share : {0.3, 0.8}) {
    PeopleTheta start;
    const double scale = std::max(std::exp(sums[parameter::log_scale]), steepest);
    start << sums[parameter::threshold], std::log(scale * std::sqrt(1 - share * share)),
        sums[parameter::lapse], sums[parameter::guess], share * scale,
        people.upper[people_parameter::log_scale_sd] > 0 ? 0.3 : 0;
    PeoplePlace found = climb_people(people, start);
    if (found.value > best.value) best = std::move(found);
  }
  return best;
}

/// Sets a deviation to 0 for good.
void hold_at_zero(PeopleProblem& people, int deviation) {
  people.upper[deviation] = 0;
}

/// How the estimates move when a person is left out, people x 6, to first order; empty where the likelihood
/// is flat at its maximum.
Eigen::MatrixXd moves_left_out(const PeoplePlace& at) {
  const PeopleMatrix all = without_rest(PeopleMatrix(-at.hessian), at.rests);
  const Eigen::LLT<PeopleMatrix> factor(all);
  // A tiny pivot is rounding: nothing is said about some direction.
  if (factor.info() != Eigen::Success ||
      (factor.matrixLLT().diagonal().cwiseAbs2().array() < 1e-9 * all.diagonal().array().abs()).any())
    return {};
  const double n = at.parts.size();
  Eigen::MatrixXd moves(static_cast<Eigen::Index>(at.parts.size()), 6);
  for (std::size_t p = 0; p < at.parts.size(); ++p)
    moves.row(static_cast<Eigen::Index>(p)) =
        -n / (n - 1) * factor.solve(without_rest(at.parts[p].gradient, at.rests)).transpose();
  moves.rowwise() -= moves.colwise().mean().eval();
  return moves;
}

PeopleFit people_not_identified(PeopleFit fit, const std::string& why) {
  fit.identified = false;
  fit.why = why;
  return fit;
}

/// Of a column in unit coordinates; `noise` is its variance by the answers alone.
double people_se(const Eigen::MatrixXd& left_out, int column, double noise) {
  const double n = left_out.rows();
  return std::sqrt(std::max(noise, (n - 1) / n * left_out.col(column).squaredNorm()));
}

/// Variance of a coordinate by Fisher's information of all answers under the mean person's function.
double noise_variance(const FitProblem& frame, const PeopleTheta& theta, int coordinate) {
  FitProblem plain = frame;
  plain.overdispersed = false;
  const double variance =
      coordinate_variance(plain, {.theta = with_tied_rates(plain, theta.head<4>()), .eta = 0}, coordinate);
  return std::isfinite(variance) ? variance : 0;
}

/// Everything in the user's units.
void write_people(const PsychometricFit& sums, const PeopleProblem& people, const PeoplePlace& at,
                  PeopleFit& fit) {
  const FitProblem& frame = sums.search.problem;
  const PeopleTheta& theta = at.theta;
  const auto level = [&](double unit) { return level_of(frame.axis, frame.to_axis(unit)); };
  const double unit_width = study::scales_in_width(frame.sigmoid) * frame.range;
  const auto width = [&](double log_scale) { return std::exp(log_scale) * unit_width; };
  const double t = student_quantile(fit.people - 1, 0.975);
  const double mean_noise = noise_variance(frame, theta, parameter::threshold),
               log_scale_noise = noise_variance(frame, theta, parameter::log_scale);
  fit.noise = {mean_noise * frame.range * frame.range,
               log_scale_noise / (std::numbers::ln2 * std::numbers::ln2)};
  const double se = people_se(fit.left_out, people_parameter::mean, mean_noise),
               log_scale_se = people_se(fit.left_out, people_parameter::log_scale, log_scale_noise);
  const double mean = theta[people_parameter::mean], log_scale = theta[people_parameter::log_scale];
  fit.threshold = level(mean);
  fit.threshold_ci95 = {.low = level(mean - t * se), .high = level(mean + t * se)};
  fit.threshold_sd = theta[people_parameter::sd] * frame.range;
  fit.width = width(log_scale);
  fit.width_ci95 = {.low = width(log_scale - t * log_scale_se), .high = width(log_scale + t * log_scale_se)};
  fit.width_sd = theta[people_parameter::log_scale_sd] / std::numbers::ln2;
  fit.lapse = theta[people_parameter::lapse];
  fit.guess = frame.equal_rates ? fit.lapse : theta[people_parameter::guess];
  fit.log_likelihood = at.value;
  const auto free = [&](int i) {
    return people.upper[i] > people.lower[i] && !(frame.equal_rates && i == people_parameter::guess) ? 1 : 0;
  };
  fit.aic = 2 * (2 + free(2) + free(3) + free(4) + free(5)) - 2 * at.value;
  const auto own_sd = [](double variance, double between, double mean_se) {
    const double open = between > 0 ? std::min(1.0, variance / (between * between)) : 1;
    return std::sqrt(variance + open * open * mean_se * mean_se);
  };
  for (std::size_t p = 0; p < at.parts.size(); ++p) {
    const PersonPart& part = at.parts[p];
    const double sd = own_sd(part.mean_variance, theta[people_parameter::sd], se);
    const double log_sd =
        own_sd(part.log_scale_variance, theta[people_parameter::log_scale_sd], log_scale_se);
    PersonEstimate person{
        .threshold = level(part.mean),
        .threshold_ci95 = {.low = level(part.mean - t * sd), .high = level(part.mean + t * sd)},
        .width = width(part.log_scale),
        .width_ci95 = {.low = width(part.log_scale - t * log_sd),
                       .high = width(part.log_scale + t * log_sd)}};
    for (const UnitCounts& counts : people.each[p].levels) person.trials += std::llround(counts.n);
    person.trials += std::llround(people.each[p].no_stimulus.n);
    fit.each.push_back(person);
  }
}

}  // namespace

PeopleFit fit_people(const PsychometricFit& sums, const std::vector<std::vector<LevelCounts>>& counts,
                     bool own_widths) {
  PeopleFit fit;
  fit.people = counts.size();
  if (counts.size() < 3)
    return people_not_identified(
        fit, counted(counts.size(), "participant") + ", and how people differ takes at least three");
  if (sums.levels.size() < 2) return people_not_identified(fit, "under two levels");
  if (sums.search.best.value - sums.flat_log_likelihood <= chi_squared_95 / 2)
    return people_not_identified(fit, "everybody's answers together do not change with level");
  const FitProblem& frame = sums.search.problem;
  PeopleProblem people = make_people_problem(frame, counts);
  if (!own_widths) hold_at_zero(people, people_parameter::log_scale_sd);
  const Theta& start = sums.search.smooth ? sums.search.smooth->theta : sums.search.best.theta;
  const double steepest = 0.2 * frame.median_gap;
  PeoplePlace at = likeliest_people(people, start, steepest);
  const auto again_without = [&](int deviation, const std::string& remark) {
    hold_at_zero(people, deviation);
    fit.remarks.push_back(remark);
    at = likeliest_people(people, at.theta.head<4>(), steepest);
  };
  if (at.theta[people_parameter::log_scale_sd] > largest_ln_scale_sd || !at.converged)
    again_without(people_parameter::log_scale_sd,
                  "how people's widths differ is not identified: one width was fitted");
  else if (own_widths && at.theta[people_parameter::log_scale_sd] < smallest_sd_share)
    again_without(people_parameter::log_scale_sd, "people's widths do not differ more than chance");
  if (at.theta[people_parameter::sd] < smallest_sd_share * std::exp(at.theta[people_parameter::log_scale]))
    again_without(people_parameter::sd, "people's thresholds do not differ more than chance");
  if (!std::isfinite(at.value) || !at.converged)
    return people_not_identified(fit, "the likelihood's maximum was not found");
  if (std::abs(at.theta[people_parameter::mean]) > 0.5 + 0.99 * ranges_beyond)
    return people_not_identified(fit, "the mean threshold lies far beyond the levels");
  fit.left_out = moves_left_out(at);
  if (fit.left_out.rows() == 0 && people.upper[people_parameter::log_scale_sd] > 0) {
    again_without(people_parameter::log_scale_sd,
                  "how people's widths differ is not identified: one width was fitted");
    fit.left_out = moves_left_out(at);
  }
  if (fit.left_out.rows() == 0) return people_not_identified(fit, "the likelihood is flat at its maximum");
  fit.identified = true;
  write_people(sums, people, at, fit);
  // On the axis, and in log2 of the width.
  Eigen::MatrixXd moves(fit.left_out.rows(), 2);
  moves.col(0) = fit.left_out.col(people_parameter::mean) * frame.range;
  moves.col(1) = fit.left_out.col(people_parameter::log_scale) / std::numbers::ln2;
  fit.left_out = moves;
  return fit;
}

}  // namespace seamline::analysis
