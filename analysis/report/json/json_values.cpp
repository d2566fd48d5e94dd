#include "analysis/report/json/json_values.h"

#include <cmath>
#include <cstdint>

#include "analysis/scores/level_words.h"
#include "support/text/csv.h"

namespace seamline::analysis {

using Json = nlohmann::ordered_json;

Json json_number(std::optional<double> value) {
  return value && std::isfinite(*value) ? Json(six_digits(*value)) : Json(nullptr);
}

Json json_interval(const LevelInterval& interval, const LevelAxis& axis, double divisor) {
  const LevelRange range = range_at(axis, interval);
  const auto end = [&](double level) {
    return std::isfinite(level) ? json_number(level / divisor) : Json(nullptr);
  };
  return {end(range.low), end(range.high)};
}

Json json_estimate(const ThresholdEstimate& estimate, const LevelAxis& axis, double divisor) {
  Json json;
  json["estimate"] =
      estimate.level_x ? json_number(level_at(axis, *estimate.level_x) / divisor) : Json(nullptr);
  json["reason"] = estimate.reason ? Json(reason_text(estimate, axis)) : Json(nullptr);
  if (estimate.reason) json["reason_word"] = word(*estimate.reason);
  json["ci95"] = json_interval(estimate.ci95, axis, divisor);
  return json;
}

Json json_level(const LevelAxis& axis, double level) {
  return facts(axis.quantity).whole ? Json(static_cast<std::int64_t>(level)) : json_number(level);
}

}  // namespace seamline::analysis
