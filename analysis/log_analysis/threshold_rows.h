#pragma once
#include <optional>
#include <string>
#include <vector>

#include "analysis/log_analysis/analysis.h"

namespace seamline::analysis {

/// One number of Table 1: a quantity of an artifact with everything that is printed beside it. What terminal,
/// CSV, JSON and report are all written from, so that they cannot disagree.
struct ThresholdRow {
  Artifact artifact = Artifact::none;
  std::string quantity;         ///< "PT", "SN" or "IP"
  std::string key;              ///< "perceptual_threshold", "slightly_noticeable", "inflection"
  std::optional<double> level;  ///< of noticeability; none for IP
  WidthEstimate here;
  std::optional<WidthInterval> bootstrap;  ///< PT and SN: the expanded percentile interval, for comparison
  int smallest_px = 0, largest_px = 0;     ///< tested
  std::optional<int> paper_px;
  std::optional<WidthEstimate> planted;   ///< present when all participants are `threshold` observers
  std::optional<WidthEstimate> logistic;  ///< PT and SN: read off the logistic instead of the isotonic fit
  std::optional<WidthInterval> object_range;  ///< range when each object is left out; none with one object
  WidthEstimate corrected;                    ///< the same quantity of the curve corrected for guessing
  std::optional<WidthInterval>
      corrected_bootstrap;  ///< PT and SN: expanded percentile interval, for comparison
};

[[nodiscard]] std::vector<ThresholdRow> threshold_rows(const Analysis& analysis);

/// A bound in px; none when it is open.
[[nodiscard]] std::optional<double> bound_px(double log2_px);

}  // namespace seamline::analysis
