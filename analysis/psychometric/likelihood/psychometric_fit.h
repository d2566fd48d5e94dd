#pragma once
#include <optional>
#include <string>
#include <vector>

#include "analysis/psychometric/likelihood/search.h"

namespace seamline::analysis {

/// The best psychometric function for some counts, with everything that intervals are computed from later:
/// one pays only for those that are asked for. Values are in the user's units.
struct PsychometricFit {
  FitOptions options;
  study::Direction direction = study::Direction::increasing;
  /// The other direction is less likely by more than 1.92 log units; true when it was given.
  bool direction_known = false;
  std::vector<LevelCounts> levels;  ///< pooled, rising; those without a trial left out; may be empty
  LevelCounts no_stimulus;          ///< answers at level 0 of a log2 axis; no part of `levels`
  int levels_without_trials = 0;
  bool is_step = false;  ///< no sigmoid is likelier than a step: threshold and width are then ranges
  study::PsychometricFunction function;  ///< the estimate; when `is_step` the middle of those as likely
  double width = 0;                      ///< between F = 0.05 and 0.95, on the axis (octaves on log2)
  double eta = 0;                        ///< overdispersion; 0 in a binomial fit
  double log_likelihood = 0;             ///< without the binomial coefficient
  double flat_log_likelihood = 0;        ///< of the likeliest constant probability that the model allows
  int free_parameters = 0;
  bool converged = false;
  Search search;  ///< empty when there are no levels
};

/// Fits by maximum likelihood (or the posterior's maximum, with priors), the global maximum within the box of
/// documentation/reference/psychometric_fit.md. `counts` may be in any order, repeat levels (their sums
/// count; with overdispersion each row counts by itself), and hold rows without trials. Throws InputError
/// when counts or options are not valid. What the data do not identify is told by `verdict_on` (verdict.h).
[[nodiscard]] PsychometricFit fit_psychometric(const std::vector<LevelCounts>& counts,
                                               const FitOptions& options);

/// psi at a level under the fit.
[[nodiscard]] double fitted_probability(const PsychometricFit& fit, double level);

}  // namespace seamline::analysis
