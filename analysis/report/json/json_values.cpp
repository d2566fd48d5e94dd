#include "analysis/report/json/json_values.h"

#include <cmath>

#include "support/text/csv.h"

namespace seamline::analysis {

using Json = nlohmann::ordered_json;

Json json_number(std::optional<double> value) {
  return value && std::isfinite(*value) ? Json(six_digits(*value)) : Json(nullptr);
}

Json json_interval(const WidthInterval& interval, double px_per_unit) {
  const auto end = [&](double log2_px) {
    return std::isfinite(log2_px) ? json_number(std::exp2(log2_px) / px_per_unit) : Json(nullptr);
  };
  return {end(interval.low_log2_px), end(interval.high_log2_px)};
}

Json json_width(const WidthEstimate& estimate, double px_per_unit) {
  Json json;
  json["estimate"] =
      estimate.log2_px ? json_number(std::exp2(*estimate.log2_px) / px_per_unit) : Json(nullptr);
  json["reason"] = estimate.reason.empty() ? Json(nullptr) : Json(estimate.reason);
  json["ci95"] = json_interval(estimate.ci95, px_per_unit);
  return json;
}

}  // namespace seamline::analysis
