#pragma once
#include <cstdint>
#include <vector>

#include "analysis/psychometric/likelihood/psychometric_fit.h"

namespace seamline::analysis {

/// A level beside what the fit expects of it.
struct LevelResidual {
  LevelCounts counts;
  double fitted = 0;             ///< psi, 0 to 1
  double deviance_residual = 0;  ///< signed root of the level's part of the deviance
};

/// Neighbouring levels whose answers the deviance judges together; often one level. K answers of n are right,
/// and E = sum of n_i psi(x_i) is expected.
struct LevelGroup {
  double low = 0, high = 0;  ///< the first and the last level
  double correct = 0, trials = 0, expected = 0;
  double deviance_residual = 0;  ///< signed root of 2 (K ln(K / E) + (n - K) ln((n - K) / (n - E)))
};

/// A level of fewer trials is put together with its neighbours.
inline constexpr double trials_of_group = 5;
/// Of more levels, neighbours are put together into at most so many groups of about as many trials.
inline constexpr std::size_t most_groups = 20;

/// D, the deviance: the sum over groups of what is under the root above; with a group for each level it is
/// 2 (ln L of the data's own proportions - ln L of the fit). Answers given one at a level have a deviance
/// that depends on the fit alone and says nothing of it (McCullagh and Nelder 1989, 4.4.5), so neighbouring
/// levels are put together. AIC = 2 (free parameters) - 2 ln L.
struct Goodness {
  double deviance = 0;
  int degrees_of_freedom = 0;  ///< groups less free parameters; not above 0: nothing can be tested
  double aic = 0;
  std::vector<LevelResidual> residuals;  ///< of every level
  std::vector<LevelGroup> groups;        ///< levels rising
};

[[nodiscard]] Goodness goodness_of_fit(const PsychometricFit& fit);

/// Monte Carlo p of the deviance (Wichmann and Hill 2001): the share of data sets simulated from the fit, and
/// fitted again, whose deviance in the same groups is at least as large; (1 + count) / (1 + replicates). NaN
/// without a degree of freedom, and for overdispersed fits, whose scatter the deviance does not judge.
[[nodiscard]] double deviance_p(const PsychometricFit& fit, int replicates, std::uint64_t seed);

/// Data as the fit expects them: binomial counts at its levels (or bins of very many). Replicate r draws from
/// stream r.
[[nodiscard]] FitProblem simulated_problem(const PsychometricFit& fit, std::uint64_t seed,
                                           std::uint64_t replicate);
/// The same from another function.
[[nodiscard]] FitProblem simulated_problem(const PsychometricFit& fit, const Theta& theta, std::uint64_t seed,
                                           std::uint64_t replicate);

}  // namespace seamline::analysis
