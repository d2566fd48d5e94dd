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

/// "Receiver (type 1)"; artifacts outside the paper have no type.
[[nodiscard]] std::string artifact_title(Artifact artifact);

/// "426 × 213" (width and height of the depth map), or the reason why there is none. `times` is the sign
/// between.
[[nodiscard]] std::string size_text(const WidthEstimate& estimate, const std::string& times = "×");

/// "380 to 470", "380 to above 4096", "below 64 to 90", "above 4096": a bound beyond the tested widths is
/// said in words.
[[nodiscard]] std::string interval_text(const WidthInterval& interval, int smallest_px, int largest_px);

/// A bound in px; none when it is open.
[[nodiscard]] std::optional<double> bound_px(double log2_px);

/// "426 (380 to 470)", or the reason why there is no estimate with its interval.
[[nodiscard]] std::string estimate_text(const WidthEstimate& estimate, int smallest_px, int largest_px);

/// Lines of cells as text with columns as wide as their widest cell.
[[nodiscard]] std::string aligned(const std::vector<std::vector<std::string>>& lines);

/// The table for a terminal: a line a quantity, beside the paper's value and, when simulated, the planted
/// one.
[[nodiscard]] std::string table_text(const Analysis& analysis);

}  // namespace seamline::analysis
