#pragma once
#include <string>
#include <vector>

#include "analysis/log_analysis/threshold_rows.h"

namespace seamline::analysis {

/// "Receiver (type 1)"; artifacts outside the paper have no type.
[[nodiscard]] std::string artifact_title(Artifact artifact);

/// "426 × 213" (width and height of the depth map), or the reason why there is none. `times` is the sign
/// between.
[[nodiscard]] std::string size_text(const WidthEstimate& estimate, const std::string& times = "×");

/// "380 to 470", "380 to above 4096", "below 64 to 90", "above 4096": a bound beyond the tested widths is
/// said in words.
[[nodiscard]] std::string interval_text(const WidthInterval& interval, int smallest_px, int largest_px);

/// "426 (380 to 470)", or the reason why there is no estimate with its interval.
[[nodiscard]] std::string estimate_text(const WidthEstimate& estimate, int smallest_px, int largest_px);

/// Lines of cells as text with columns as wide as their widest cell.
[[nodiscard]] std::string aligned(const std::vector<std::vector<std::string>>& lines);

/// The table for a terminal: a line a quantity, beside the paper's value and, when simulated, the planted
/// one.
[[nodiscard]] std::string table_text(const Analysis& analysis);

}  // namespace seamline::analysis
