#pragma once
#include <optional>
#include <string>
#include <vector>

#include "analysis/psychometric/intervals/judged_fit.h"

namespace seamline::analysis {

/// The same counts under every sigmoid.
struct SigmoidComparison {
  std::vector<JudgedFit> fits;  ///< AIC rising
};

/// Throws InputError as `judge_fit` does. Only the likeliest has everything that `request` asks for; the
/// others go without bootstrap.
[[nodiscard]] SigmoidComparison compare_sigmoids(const std::vector<LevelCounts>& counts,
                                                 const FitOptions& options, const FitRequest& request);

/// A table: AIC, its difference from the lowest, weight exp(-difference / 2) over the sum of all (Akaike),
/// and what each says of threshold and width; then the likeliest as `fit_text` has it.
[[nodiscard]] std::string comparison_text(const SigmoidComparison& comparison);

/// `fit_json` of the likeliest, and the table as `sigmoids`.
[[nodiscard]] std::string comparison_json(const SigmoidComparison& comparison);

}  // namespace seamline::analysis
