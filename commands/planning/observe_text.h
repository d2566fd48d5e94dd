#pragma once
#include <string>
#include <vector>

#include "analysis/detection/detection_comparison.h"
#include "analysis/detection/pair_fit.h"

namespace seamline::analysis {

/// A source's patterns and what several observers say of them.
struct DetectionTable {
  const DetectionThresholds* thresholds = nullptr;
  std::vector<MeasureFit> fits;         ///< the image observer first, then the other measures
  std::vector<double> standard_db;      ///< of Watson and Ahumada's standard observer; empty: not asked
  bool criterion_from_outside = false;  ///< the first fit's criterion was fitted to another source
};

/// For a terminal: thresholds of people and observers pattern after pattern, root mean square errors, and
/// where the image observer fails.
[[nodiscard]] std::string detection_text(const DetectionTable& table);

/// For a terminal: what was fitted, and how it does on the other half beside simpler measures.
[[nodiscard]] std::string pairs_text(const PairJudgement& judgement);

}  // namespace seamline::analysis
