#include "sensors/files/estimated_depth.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::sensors {
namespace {

constexpr double no_distance = std::numeric_limits<double>::infinity();

/// What is straight in the value.
double straight(DepthValue kind, double depth_m) {
  return kind == DepthValue::inverse ? 1 / depth_m : depth_m;
}

DepthLine least_squares(DepthValue kind, std::span<const KnownValue> known, const std::string& field) {
  const double count = known.size();
  if (known.size() == 1) return {.scale = straight(kind, known[0].depth_m) / known[0].value, .shift = 0};
  double mean_value = 0, mean_straight = 0;
  for (const KnownValue& one : known) {
    mean_value += one.value / count;
    mean_straight += straight(kind, one.depth_m) / count;
  }
  double spread = 0, together = 0;
  for (const KnownValue& one : known) {
    spread += (one.value - mean_value) * (one.value - mean_value);
    together += (one.value - mean_value) * (straight(kind, one.depth_m) - mean_straight);
  }
  if (!(spread > 0))
    throw input_error({.field = field,
                       .wanted = "places whose values differ",
                       .found = fmt::format("{} of the value {:g}", known.size(), mean_value)});
  const double scale = together / spread;
  return {.scale = scale, .shift = mean_straight - scale * mean_value};
}

}  // namespace

double metres_of_value(DepthValue kind, const DepthLine& line, double value) {
  const double at = line.scale * value + line.shift;
  if (!(at > 0) || !std::isfinite(at)) return no_distance;
  return kind == DepthValue::inverse ? 1 / at : at;
}

DepthFit fit_depth(DepthValue kind, std::span<const KnownValue> known, const std::string& field) {
  if (known.empty())
    throw input_error({.field = field, .wanted = "a place whose distance is known", .found = "none"});
  DepthFit fit{.line = least_squares(kind, known, field), .used = known.size()};
  if (!(fit.line.scale > 0) || !std::isfinite(fit.line.scale))
    throw input_error({.field = field,
                       .wanted = kind == DepthValue::inverse
                                     ? "larger values where it is nearer, as inverse depth has"
                                     : "larger values where it is farther, as relative depth has",
                       .found = fmt::format("a scale of {:g}{}", fit.line.scale,
                                            kind == DepthValue::inverse
                                                ? " (" + request_name("depth_value") + " relative?)"
                                                : " (" + request_name("depth_value") + " inverse?)")});
  const double count = fit.used;
  for (const KnownValue& one : known) {
    const double depth_m = metres_of_value(kind, fit.line, one.value), error_m = depth_m - one.depth_m;
    if (std::isinf(depth_m)) continue;  // beyond infinity: no distance to compare
    fit.abs_rel += std::abs(error_m) / one.depth_m / count;
    fit.rmse_m += error_m * error_m / count;
    fit.within_quarter += std::max(depth_m / one.depth_m, one.depth_m / depth_m) < 1.25 ? 1 / count : 0;
  }
  fit.rmse_m = std::sqrt(fit.rmse_m);
  return fit;
}

std::string fit_text(DepthValue kind, const DepthFit& fit, const std::string& from) {
  return fmt::format("{} = {:.6g} value {} {:.6g}, {}: AbsRel {:.4f}, RMSE {:.3g} m, delta < 1.25 {:.1f} %",
                     kind == DepthValue::inverse ? "1 / distance" : "distance", fit.line.scale,
                     fit.line.shift < 0 ? "-" : "+", std::abs(fit.line.shift), from, fit.abs_rel, fit.rmse_m,
                     100 * fit.within_quarter);
}

}  // namespace seamline::sensors
