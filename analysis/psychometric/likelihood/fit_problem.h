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
  double centre = 0, range = 1;
  double smallest_gap = 1;  ///< between neighbouring levels, unit axis; 1 when there is one level
  double median_gap = 1;
  Theta lower, upper;  ///< the box
  Priors priors;       ///< already on the unit axis
  bool overdispersed = false;

  [[nodiscard]] double to_unit(double axis_value) const { return (axis_value - centre) / range; }
  [[nodiscard]] double to_axis(double unit) const { return centre + range * unit; }
};

/// The box of the search, as stated in documentation/psychometric_fit.md: thresholds up to this many ranges
/// of the tested levels beyond them, scales up to `largest_scale` ranges.
inline constexpr double ranges_beyond = 5;
inline constexpr double largest_scale = 1000;

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
