#pragma once
#include <optional>
#include <string>
#include <vector>

#include "analysis/psychometric/report/fit_report.h"

namespace seamline::analysis {

/// One line of a report: a number only where the data identify it.
struct FitQuantity {
  std::string name;  ///< key of the JSON
  std::string unit;
  std::optional<double> estimate;
  Interval ci95;
  std::optional<Interval> bootstrap_ci95;
  std::string reason;  ///< why there is no estimate
};

/// Threshold, width, lapse, guess, overdispersion.
[[nodiscard]] std::vector<FitQuantity> quantities(const FitReport& report);

/// Levels of percentages correct.
[[nodiscard]] std::vector<FitQuantity> percent_quantities(const FitReport& report);

}  // namespace seamline::analysis
