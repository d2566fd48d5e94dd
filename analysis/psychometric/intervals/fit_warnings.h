#pragma once
#include <string>
#include <vector>

#include "analysis/psychometric/intervals/verdict.h"

namespace seamline::analysis {

/// All that the warnings are about.
struct FitEvidence {
  Verdict verdict;
  Interval width_ci95;
  OverdispersionEstimate overdispersion;
  Goodness goodness;
  double deviance_p = 0;  ///< NaN: not tested
};

/// What a reader of the fit must know, a sentence each with the evidence: separation, rates at their bounds,
/// misfit and reversals, tiny counts, extrapolation, overdispersion, levels left out.
[[nodiscard]] std::vector<std::string> warnings_on(const PsychometricFit& fit, const FitEvidence& evidence,
                                                   const std::string& unit = "");

}  // namespace seamline::analysis
