#pragma once
#include <nlohmann/json.hpp>
#include <optional>

#include "analysis/statistics/estimate.h"

namespace seamline::analysis {

/// Six significant digits, or null when there is no finite number.
[[nodiscard]] nlohmann::ordered_json json_number(std::optional<double> value);

/// {estimate, reason, ci95: [low, high]} of a width in units of `px_per_unit` px; an open end is null.
[[nodiscard]] nlohmann::ordered_json json_width(const WidthEstimate& estimate, double px_per_unit);

/// [low, high] in px; an open end is null.
[[nodiscard]] nlohmann::ordered_json json_interval(const WidthInterval& interval, double px_per_unit);

}  // namespace seamline::analysis
