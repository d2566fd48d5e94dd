#pragma once
#include <optional>
#include <string>
#include <vector>

#include "analysis/psychometric/intervals/judged_fit.h"

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
[[nodiscard]] std::vector<FitQuantity> quantities(const JudgedFit& report);

/// Levels of percentages correct.
[[nodiscard]] std::vector<FitQuantity> percent_quantities(const JudgedFit& report);

/// "increasing", "decreasing"; "linear", "log2": the words of the command line.
[[nodiscard]] const char* word(study::Direction direction);
[[nodiscard]] const char* word(study::Axis axis);

}  // namespace seamline::analysis
