#pragma once
#include <string>

#include "analysis/psychometric/likelihood/profile.h"
#include "analysis/psychometric/likelihood/psychometric_fit.h"

namespace seamline::analysis {

/// eta of the beta-binomial (count_terms.h): eta^2 is the correlation between two answers of a row.
struct OverdispersionEstimate {
  std::optional<double> eta;
  Interval ci95;       ///< profile likelihood; low is 0 when binomial data are not excluded, high may be open
  std::string reason;  ///< why there is no estimate
};

inline constexpr double largest_eta = 0.95;

/// Estimated with all other parameters, whatever the fit itself assumed.
[[nodiscard]] OverdispersionEstimate estimate_overdispersion(const PsychometricFit& fit);

}  // namespace seamline::analysis
