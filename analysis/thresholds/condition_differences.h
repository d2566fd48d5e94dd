#pragma once
#include <optional>
#include <string>
#include <vector>

#include "analysis/thresholds/thresholds.h"

namespace seamline::analysis {

/// A threshold in one condition less the same threshold in the study's first condition, along the axis: in
/// octaves on log2 axes (1: twice the level), in the quantity's unit on linear ones.
struct ThresholdDifference {
  Artifact artifact = Artifact::none;
  std::string quantity;  ///< "PT", "SN" or "IP"
  std::string condition, to;
  int participants = 0;            ///< on the curves of all conditions
  std::optional<double> estimate;  ///< exactly where `ci95` is closed (closed_estimates.h)
  /// Where a threshold lies beyond the levels tested: what is known of the difference. Both ends infinite: it
  /// is not determined.
  LevelRange bounds;
  LevelRange ci95;   ///< an infinite end is open; holds `bounds`
  std::string text;  ///< "0.52 (0.11 to 0.93)", "above 1.2", "not determined"
};

/// Of every artifact with two conditions or more: every condition against the first, PT, SN and IP. Intervals
/// are expanded percentile intervals over participants with an answer at every level of every condition, each
/// replicate drawing the same people for all of them. A threshold beyond the levels tested counts as anywhere
/// there. Empty where the study has one condition; intervals are open under two participants or without
/// replicates.
[[nodiscard]] std::vector<ThresholdDifference> threshold_differences(const NoticeabilityData& data,
                                                                     const ResamplingRequest& request);

}  // namespace seamline::analysis
