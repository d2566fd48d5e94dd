#pragma once
#include <Eigen/Core>
#include <vector>

#include "analysis/psychometric/likelihood/fit_options.h"
#include "analysis/psychometric/likelihood/level_counts.h"

namespace seamline::analysis {

/// The parameters that are searched, in unit coordinates t = (a(x) - centre) / range: threshold m, ln of the
/// scale s, lapse, guess.
using Theta = Eigen::Vector4d;
namespace parameter {
enum { threshold, log_scale, lapse, guess };
}

/// Counts at one place of the unit axis; whole numbers kept as doubles.
struct UnitCounts {
  double t = 0, k = 0, n = 0;
};

/// The data and the model as the search sees them. The tested levels lie from -0.5 to 0.5.
struct FitProblem {
  Sigmoid sigmoid = Sigmoid::normal;
  study::Axis axis = study::Axis::log2;
  double sign = 1;                 ///< +1 increasing, -1 decreasing
  std::vector<UnitCounts> levels;  ///< pooled, rising; never empty; bins of very many (level_bins.h)
  std::vector<UnitCounts> rows;    ///< as given: the units that overdispersion is about
  /// Answers without a stimulus (level 0 on a log2 axis), at `no_stimulus_t`; they are no part of `levels`,
  /// but of `rows`.
  UnitCounts no_stimulus = {};
  double centre = 0, range = 1;
  double smallest_gap = 1;  ///< between neighbouring levels, unit axis; 1 when there is one level
  double median_gap = 1;
  Theta lower, upper;  ///< the box
  Priors priors;       ///< already on the unit axis
  bool overdispersed = false;
  bool equal_rates = false;  ///< guess = lapse, with the bounds of lapse

  [[nodiscard]] double to_unit(double axis_value) const { return (axis_value - centre) / range; }
  [[nodiscard]] double to_axis(double unit) const { return centre + range * unit; }
};

/// The box of the search, as stated in documentation/reference/psychometric_fit.md: thresholds up to this
/// many ranges of the tested levels beyond them, scales up to `largest_scale` ranges.
inline constexpr double ranges_beyond = 5;
inline constexpr double largest_scale = 1000;

/// So far below every level, threshold and scale of the box that F is exactly 0 there, or 1 when it falls.
inline constexpr double no_stimulus_t = -1e8;

/// The highest ln L that the answers without a stimulus can have on their own.
[[nodiscard]] double best_without_stimulus(const FitProblem& problem);

/// theta with guess = lapse where the problem wants that.
[[nodiscard]] inline Theta with_tied_rates(const FitProblem& problem, Theta theta) {
  if (problem.equal_rates) theta[parameter::guess] = theta[parameter::lapse];
  return theta;
}

/// `counts` is validated, with at least one trial.
[[nodiscard]] FitProblem make_problem(const std::vector<LevelCounts>& counts, const FitOptions& options,
                                      study::Direction direction);

/// Sets the gaps between the levels, and with them the smallest scale.
void set_gaps(FitProblem& problem);

/// psi and 1 - psi at t.
struct ResponseProbability {
  double right = 0, wrong = 0;
};
[[nodiscard]] ResponseProbability probability_at(const FitProblem& problem, const Theta& theta, double t);

/// ln L without the binomial coefficient; with eta > 0 the beta-binomial one, over rows.
[[nodiscard]] double log_likelihood(const FitProblem& problem, const Theta& theta, double eta);

/// What is maximised, ln L + ln prior, with what Newton's method and Fisher scoring need.
struct Objective {
  double value = 0;
  Eigen::Vector4d gradient;
  Eigen::Matrix4d observed;  ///< minus the second derivatives
  Eigen::Matrix4d expected;  ///< Fisher's information; positive semidefinite
};
[[nodiscard]] Objective objective_at(const FitProblem& problem, const Theta& theta, double eta);
[[nodiscard]] double objective_value(const FitProblem& problem, const Theta& theta, double eta);

}  // namespace seamline::analysis
