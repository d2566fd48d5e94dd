#pragma once
#include <Eigen/Core>
#include <vector>

#include "analysis/psychometric/likelihood/fit_problem.h"

namespace seamline::analysis {

/// What a mixed psychometric model estimates, in unit coordinates (fit_problem.h): a person's threshold is
/// normal with mean `mean` and SD `sd`, ln of a person's scale normal with mean `log_scale` and SD
/// `log_scale_sd`; lapse and guess rate are everybody's.
using PeopleTheta = Eigen::Matrix<double, 6, 1>;
using PeopleMatrix = Eigen::Matrix<double, 6, 6>;
namespace people_parameter {
enum { mean, log_scale, lapse, guess, sd, log_scale_sd };
}

/// Counts of several people and the box of the search; `each[p].levels` are person p's, `each[p].no_stimulus`
/// too.
struct PeopleProblem {
  std::vector<FitProblem> each;
  PeopleTheta lower, upper;
};

/// `frame` is the problem of everybody's sums: its axis, box and sigmoid are the people's. `counts[p]` are
/// person p's rows, with at least one trial. Priors and overdispersion are left out.
[[nodiscard]] PeopleProblem make_people_problem(const FitProblem& frame,
                                                const std::vector<std::vector<LevelCounts>>& counts);

/// What one person adds to the marginal log-likelihood, and what their answers say of them.
struct PersonPart {
  double value = 0;
  PeopleTheta gradient = PeopleTheta::Zero();
  PeopleMatrix hessian = PeopleMatrix::Zero();
  double mean = 0, log_scale = 0;  ///< posterior means of the person's threshold and ln scale
  double mean_variance = 0, log_scale_variance = 0;  ///< posterior variances
};

/// ln of the integral over the person's threshold and ln scale, by adaptive Gauss-Hermite quadrature of
/// `nodes` nodes a dimension about the mode:
///
///     ln int int prod_i P(k_i | m = mean + sd u, ln s = log_scale + log_scale_sd v) phi(u) phi(v) du dv
///
/// Gradient and Hessian are exact for the nodes as they lie (Louis 1982). A deviation that is 0 takes one
/// node.
[[nodiscard]] PersonPart person_part(const FitProblem& person, const PeopleTheta& theta, int nodes);

}  // namespace seamline::analysis
