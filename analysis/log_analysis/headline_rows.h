#pragma once
#include <optional>
#include <string>
#include <vector>

#include "analysis/log_analysis/threshold_rows.h"
#include "analysis/thresholds/threshold_rules.h"

namespace seamline::analysis {

/// One threshold of record: what the joint model says, with the paper's own way beside it. Terminal, page,
/// CSV and JSON are all written from these rows.
struct HeadlineRow {
  Artifact artifact = Artifact::none;
  std::string condition;  ///< empty where the study has one
  TestedLevels tested;
  const ThresholdRule* rule = nullptr;
  ThresholdEstimate here;
  LevelInterval simultaneous;  ///< holds together with those of the same threshold of all curves
  bool beyond_levels = false;  ///< the estimate is outside the levels tested, by the model alone
  std::optional<ThresholdEstimate> paper_way;  ///< PT, SN and IP
  std::optional<int> paper_px;                 ///< Table 1 of the paper
  std::optional<ThresholdEstimate> planted;    ///< of simulated observers
  std::string differs;  ///< why the paper's way lies outside the interval, a sentence; empty: it does not
};

/// A row a curve and rule, in the order of the curves and of `threshold_rules`; of a curve whose PT lies in
/// the guess floor the corrected ones come first. Empty where there is no joint model (adaptive logs).
[[nodiscard]] std::vector<HeadlineRow> headline_rows(const Analysis& analysis);

/// What a reader of the thresholds must know: why there are no numbers, whose levels lie in the guess floor,
/// what differs from the paper's way.
[[nodiscard]] std::vector<std::string> notes_on_headline(const Analysis& analysis);

/// Whether a curve's threshold is none because its level lies in the guess floor.
[[nodiscard]] bool in_guess_floor(const ThresholdEstimate& estimate);

}  // namespace seamline::analysis
