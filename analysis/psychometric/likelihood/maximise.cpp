#include "analysis/psychometric/likelihood/maximise.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>

#include "analysis/psychometric/likelihood/overdispersion.h"
#include "study/placement/sigmoid_shape.h"
#include "support/running/interrupt.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

constexpr int most_steps = 60;
constexpr int most_turns = 25;                ///< between eta and the rest
constexpr double enough_log_units = 1e-11;    ///< stop when a step can gain no more, in ln L
constexpr double largest_log_scale_step = 2;  ///< in e-folds
constexpr double largest_place_step = 1;      ///< in ranges of the levels
constexpr double share_margin = 1e-9;         ///< keeps F strictly between 0 and 1 at the sought level

/// F at the sought level.
double sigmoid_share(const SoughtLevel& level, const Theta& theta) {
  if (level.of == SoughtLevel::Of::sigmoid) return level.share;
  const double g = theta[parameter::guess], l = theta[parameter::lapse];
  return (level.share - g) / (1 - g - l);
}

/// theta and its derivatives by the coordinates.
struct Chart {
  Theta theta;
  Eigen::Matrix4d jacobian;
};

bool is_threshold(const SoughtLevel& level) {
  return level.of == SoughtLevel::Of::sigmoid && level.share == 0.5;
}

std::optional<Chart> chart_of_level(const FitProblem& problem, const Theta& coordinates,
                                    const SoughtLevel& level) {
  Chart chart{.theta = coordinates, .jacobian = Eigen::Matrix4d::Identity()};
  if (is_threshold(level)) return chart;
  const double q = sigmoid_share(level, coordinates);
  if (!(q > 0 && q < 1)) return std::nullopt;
  const double z = study::sigmoid_quantile(problem.sigmoid, q);
  const double signed_scale = problem.sign * std::exp(coordinates[parameter::log_scale]);
  chart.theta[parameter::threshold] -= signed_scale * z;
  chart.jacobian(0, 1) = -signed_scale * z;
  if (level.of == SoughtLevel::Of::response) {
    const double A = 1 - coordinates[parameter::guess] - coordinates[parameter::lapse];
    const double dz_dq = 1 / study::sigmoid_point(problem.sigmoid, z).density;
    chart.jacobian(0, 2) = -signed_scale * dz_dq * q / A;
    chart.jacobian(0, 3) = -signed_scale * dz_dq * (q - 1) / A;
  }
  return chart;
}

/// With equal rates the guess rate is no coordinate: it follows the lapse rate.
std::optional<Chart> chart_at(const FitProblem& problem, const Theta& coordinates, const SoughtLevel& level) {
  std::optional<Chart> chart = chart_of_level(problem, with_tied_rates(problem, coordinates), level);
  if (chart && problem.equal_rates) {
    chart->jacobian.col(parameter::lapse) += chart->jacobian.col(parameter::guess);
    chart->jacobian.col(parameter::guess).setZero();
  }
  return chart;
}

/// The objective seen in the coordinates of a chart.
struct View {
  double value = -infinity;
  Eigen::Vector4d gradient = Eigen::Vector4d::Zero();
  Eigen::Matrix4d observed = Eigen::Matrix4d::Identity(), expected = Eigen::Matrix4d::Identity();
};

class Climb {
 public:
  Climb(const FitProblem& problem, const Held& held, double eta)
      : problem_(problem), held_(held), eta_(eta), lower_(problem.lower), upper_(problem.upper) {
    if (held.level.of == SoughtLevel::Of::response) {
      upper_[parameter::lapse] = std::min(upper_[parameter::lapse], 1 - held.level.share - share_margin);
      const int guess = problem.equal_rates ? parameter::lapse : parameter::guess;
      upper_[guess] = std::min(upper_[guess], held.level.share - share_margin);
    }
  }

  Maximum from(Theta at) {
    for (int i = 0; i < 4; ++i)
      if (!held_.fixed[i]) at[i] = std::clamp(at[i], lower_[i], std::max(lower_[i], upper_[i]));
    View here = view(at);
    double damping = 0;
    bool converged = false;
    for (int step = 0; step < most_steps && !converged && std::isfinite(here.value); ++step) {
      const Eigen::Vector4d move = step_from(at, here, damping);
      const double gain = here.gradient.dot(move);
      if (gain < enough_log_units) {
        converged = true;
        break;
      }
      const View there = view(at + move);
      if (there.value >= here.value) {
        at += move;
        here = there;
        damping = damping < 1e-6 ? 0 : damping * 0.1;
      } else {
        damping = std::max(1e-3, damping * 10);
        converged = damping > 1e12;  // no slope is left that double precision can follow
      }
    }
    const std::optional<Chart> chart = chart_at(problem_, at, held_.level);
    return {.theta = chart ? chart->theta : at, .eta = eta_, .value = here.value, .converged = converged};
  }

 private:
  [[nodiscard]] View view(const Theta& at) const {
    const std::optional<Chart> chart = chart_at(problem_, at, held_.level);
    if (!chart) return {};
    const Objective objective = objective_at(problem_, chart->theta, eta_);
    if (!std::isfinite(objective.value)) return {};
    const Eigen::Matrix4d& J = chart->jacobian;
    if (is_threshold(held_.level) && !problem_.equal_rates)
      return {objective.value, objective.gradient, objective.observed, objective.expected};
    return {objective.value, J.transpose() * objective.gradient, J.transpose() * objective.observed * J,
            J.transpose() * objective.expected * J};
  }

  /// The damped step, clipped to the box. Coordinates that are held, or that push against their bound, rest.
  [[nodiscard]] Eigen::Vector4d step_from(const Theta& at, const View& here, double damping) const {
    std::array<bool, 4> rests{};
    Eigen::Vector4d slope = here.gradient;
    for (int i = 0; i < 4; ++i) {
      bool& rest = rests[i];
      rest = held_.fixed[i] || lower_[i] >= upper_[i] || (problem_.equal_rates && i == parameter::guess) ||
             (at[i] <= lower_[i] && slope[i] <= 0) || (at[i] >= upper_[i] && slope[i] >= 0);
      if (rest) slope[i] = 0;
    }
    const auto solve = [&](Eigen::Matrix4d curvature, double extra, Eigen::Vector4d& move) {
      for (int i = 0; i < 4; ++i) {
        if (rests[i]) {
          curvature.row(i).setZero();
          curvature.col(i).setZero();
          curvature(i, i) = 1;
        } else {
          curvature(i, i) += extra * std::max(here.expected(i, i), 1e-12);
        }
      }
      const Eigen::LLT<Eigen::Matrix4d> factor(curvature);
      if (factor.info() != Eigen::Success) return false;
      move = factor.solve(slope);
      return move.allFinite();
    };
    Eigen::Vector4d move = Eigen::Vector4d::Zero();
    if (!solve(here.observed, damping, move) && !solve(here.expected, std::max(damping, 1e-9), move))
      solve(here.expected, std::max(damping, 1e-3), move);
    double shorter = 1;
    if (std::abs(move[0]) > largest_place_step) shorter = largest_place_step / std::abs(move[0]);
    if (std::abs(move[1]) * shorter > largest_log_scale_step)
      shorter = largest_log_scale_step / std::abs(move[1]);
    move *= shorter;
    for (int i = 0; i < 4; ++i)
      if (!rests[i]) move[i] = std::clamp(at[i] + move[i], lower_[i], upper_[i]) - at[i];
    return move;
  }

  const FitProblem& problem_;
  const Held& held_;
  double eta_;
  Theta lower_, upper_;
};

}  // namespace

std::optional<double> place_of(const FitProblem& problem, const Theta& theta, const SoughtLevel& level) {
  const double q = sigmoid_share(level, theta);
  if (!(q > 0 && q < 1)) return std::nullopt;
  return theta[parameter::threshold] +
         problem.sign * std::exp(theta[parameter::log_scale]) * study::sigmoid_quantile(problem.sigmoid, q);
}

std::optional<Theta> theta_with(const FitProblem& problem, const Theta& coordinates,
                                const SoughtLevel& level) {
  const std::optional<Chart> chart = chart_at(problem, coordinates, level);
  return chart ? std::optional(chart->theta) : std::nullopt;
}

double likeliest_eta(const FitProblem& problem, const Theta& theta) {
  // Brent's parabola takes costs from each other, which infinite ones have no difference for.
  constexpr double least_likely = -1e300;
  const auto cost = [&](double eta) { return -std::max(log_likelihood(problem, theta, eta), least_likely); };
  constexpr std::array<double, 11> tried = {0, 0.01, 0.02, 0.04, 0.08, 0.14, 0.22, 0.34, 0.5, 0.7, 0.95};
  std::size_t best = 0;
  for (std::size_t i = 1; i < tried.size(); ++i)
    if (cost(tried[i]) < cost(tried[best])) best = i;
  const auto [eta, value] = boost::math::tools::brent_find_minima(
      cost, tried[best == 0 ? 0 : best - 1],
      std::min(largest_eta, tried[std::min(best + 1, tried.size() - 1)]), 26);
  return value < cost(0) ? eta : 0;
}

Maximum maximise(const FitProblem& problem, const Held& held, const Theta& coordinates, double eta) {
  if (interrupted()) throw Interrupted{};  // whatever takes long is made of many climbs
  Maximum best = Climb(problem, held, eta).from(coordinates);
  if (!problem.overdispersed) return best;
  Theta at = coordinates;
  for (int turn = 0; turn < most_turns; ++turn) {
    const double before = best.value;
    const double next_eta = likeliest_eta(problem, best.theta);
    at.tail<3>() = best.theta.tail<3>();
    if (!held.fixed[0]) at[0] = place_of(problem, best.theta, held.level).value_or(at[0]);
    const Maximum next = Climb(problem, held, next_eta).from(at);
    if (next.value > best.value) best = next;
    if (best.value == before || best.value - before < 1e-8) break;  // both may be infinite
  }
  return best;
}

}  // namespace seamline::analysis
