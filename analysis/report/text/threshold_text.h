#pragma once
#include <string>
#include <vector>

#include "analysis/log_analysis/threshold_rows.h"

namespace seamline::analysis {

/// "Receiver (type 1)", with the condition behind it: "Receiver (type 1), soft"; artifacts outside the paper
/// have no type.
[[nodiscard]] std::string artifact_title(Artifact artifact, const std::string& condition = "");

/// "426 × 213" (width and height of the depth map; `times` is the sign between), the level of other
/// quantities, or the reason why there is none.
[[nodiscard]] std::string size_text(const ThresholdEstimate& estimate, const LevelAxis& axis,
                                    const std::string& times = "×");

/// Whether an interval excludes anything: one that ends on one side at least is shown.
[[nodiscard]] bool has_end(const LevelInterval& interval);

/// "380 to 470", "380 to above 4096", "below 64 to 90", "above 4096": a bound beyond the tested levels is
/// said in words.
[[nodiscard]] std::string interval_text(const LevelInterval& interval, const TestedLevels& tested);

/// "426 (380 to 470)", or the reason why there is no estimate with its interval.
[[nodiscard]] std::string estimate_text(const ThresholdEstimate& estimate, const TestedLevels& tested);

/// Lines of cells as text with columns as wide as their widest cell. Where lines would have more than 160
/// letters, cells of the widest columns go on below, broken between words.
[[nodiscard]] std::string aligned(const std::vector<std::vector<std::string>>& lines);

/// The table for a terminal: a line a quantity, beside the paper's value and, when simulated, the planted
/// one.
[[nodiscard]] std::string table_text(const Analysis& analysis);

/// Which planted values straight lines between the levels tested miss however many people there are, by more
/// than a tenth of an octave; a sentence with its line break, or nothing.
[[nodiscard]] std::string design_bias_text(const Analysis& analysis);

}  // namespace seamline::analysis
