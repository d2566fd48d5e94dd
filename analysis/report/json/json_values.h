#pragma once
#include <nlohmann/json.hpp>
#include <optional>

#include "analysis/scores/level_axis.h"

namespace seamline::analysis {

/// Six significant digits, or null when there is no finite number.
[[nodiscard]] nlohmann::ordered_json json_number(std::optional<double> value);

/// {estimate, reason, ci95: [low, high]} of a level, divided by `divisor`; an open end is null. Beside a
/// reason `reason_word` has its word.
[[nodiscard]] nlohmann::ordered_json json_estimate(const ThresholdEstimate& estimate, const LevelAxis& axis,
                                                   double divisor = 1);

/// [low, high] of levels, divided by `divisor`; an open end is null.
[[nodiscard]] nlohmann::ordered_json json_interval(const LevelInterval& interval, const LevelAxis& axis,
                                                   double divisor = 1);

/// A level as a number: whole where the quantity is.
[[nodiscard]] nlohmann::ordered_json json_level(const LevelAxis& axis, double level);

}  // namespace seamline::analysis
