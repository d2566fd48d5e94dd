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

/// D = 2 (ln L of the data's own proportions - ln L of the fit); AIC = 2 (free parameters) - 2 ln L.
struct Goodness {
  double deviance = 0;
  int degrees_of_freedom = 0;  ///< levels less free parameters; not above 0: nothing can be tested
  double aic = 0;
  std::vector<LevelResidual> residuals;
};

[[nodiscard]] Goodness goodness_of_fit(const PsychometricFit& fit);

inline constexpr std::size_t most_simulated_levels = 1000;

/// Monte Carlo p of the deviance (Wichmann and Hill 2001): the share of data sets simulated from the fit, and
/// fitted again, whose deviance is at least as large; (1 + count) / (1 + replicates). With more than
/// `most_simulated_levels` the deviance is normal and p comes from its moments. NaN without two levels, and
/// for overdispersed fits, whose scatter the deviance does not judge.
[[nodiscard]] double deviance_p(const PsychometricFit& fit, int replicates, std::uint64_t seed);

/// Data as the fit expects them: binomial counts at its levels (or bins of very many). Replicate r draws from
/// stream r.
[[nodiscard]] FitProblem simulated_problem(const PsychometricFit& fit, std::uint64_t seed,
                                           std::uint64_t replicate);
/// The same from another function.
[[nodiscard]] FitProblem simulated_problem(const PsychometricFit& fit, const Theta& theta, std::uint64_t seed,
                                           std::uint64_t replicate);

}  // namespace seamline::analysis
