#include "analysis/report/json/thresholds_parts.h"

#include <cmath>

#include "analysis/report/json/json_values.h"

namespace seamline::analysis {
namespace {

using Json = nlohmann::ordered_json;

Json length_json(const LevelAxis& axis, double length_x) {
  return json_number(std::abs(difference_at(axis, length_x)));
}

Json threshold_over_scenes_json(const ThresholdOverScenes& found, const LevelAxis& axis) {
  const bool known = found.reason.empty();
  Json json = {{"quantity", word(found.quantity)}};
  json["mean" + unit_suffix(axis)] =
      known ? json_number(level_at(axis, found.spreads.mean_x)) : Json(nullptr);
  json["reason"] = known ? Json(nullptr) : Json(found.reason);
  json["these_ci95"] = json_interval(found.these, axis);
  json["like_these_ci95"] = json_interval(found.like_these, axis);
  json["between_scenes"] = length_json(axis, found.spreads.between_scenes);
  return json;
}

}  // namespace

nlohmann::ordered_json scenes_json(const std::vector<CurveOverScenes>& curves, const LevelAxis& axis,
                                   bool conditions) {
  Json list = Json::array();
  for (const CurveOverScenes& curve : curves) {
    Json json = {{"artifact", word(curve.artifact)}};
    if (conditions) json["condition"] = curve.condition;
    json["scenes"] = curve.scenes;
    json["between_people"] = length_json(axis, curve.between_people);
    json["people_by_scenes"] = length_json(axis, curve.people_by_scenes);
    json["thresholds"] = Json::array();
    for (const ThresholdOverScenes& found : curve.thresholds)
      json["thresholds"].push_back(threshold_over_scenes_json(found, axis));
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace seamline::analysis
