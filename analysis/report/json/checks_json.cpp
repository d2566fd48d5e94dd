#include "analysis/report/json/thresholds_parts.h"

#include <cmath>

#include "analysis/report/json/json_values.h"
#include "analysis/thresholds/angular_resolution.h"

namespace seamline::analysis {

namespace {

using Json = nlohmann::ordered_json;

Json corrected_json(const CorrectedCurve& corrected, const LevelAxis& axis) {
  const std::string unit = unit_suffix(axis);
  const CurveThresholds& found = corrected.estimates;
  Json json = {
      {"perceptual_threshold" + unit, json_estimate(found.perceptual, axis)},
      {"slightly_noticeable" + unit, json_estimate(found.slightly_noticeable, axis)},
      {"inflection" + unit, json_estimate(found.inflection, axis)},
      {"expanded_percentile_ci95",
       {{"perceptual_threshold" + unit, json_interval(corrected.perceptual_bootstrap, axis)},
        {"slightly_noticeable" + unit, json_interval(corrected.slightly_noticeable_bootstrap, axis)}}},
      {"above_chance", corrected.above_chance},
      {"curve", Json::array()}};
  for (std::size_t w = 0; w < corrected.cells.size(); ++w)
    json["curve"].push_back({{level_key(axis), json_level(axis, corrected.level[w])},
                             {"saw", json_number(corrected.cells[w].saw)},
                             {"noticeability", json_number(corrected.cells[w].noticeability)}});
  return json;
}

Json objects_json(const ObjectInfluence& objects, const LevelAxis& axis) {
  const std::string unit = unit_suffix(axis);
  if (objects.without.empty()) return nullptr;
  Json json = {{"perceptual_threshold" + unit, json_interval(*objects.perceptual, axis)},
               {"slightly_noticeable" + unit, json_interval(*objects.slightly_noticeable, axis)},
               {"inflection" + unit, json_interval(*objects.inflection, axis)},
               {"without", Json::array()}};
  const auto level = [&](const ThresholdEstimate& estimate) {
    return estimate.level_x ? json_number(level_at(axis, *estimate.level_x)) : Json(nullptr);
  };
  for (const WithoutObject& without : objects.without)
    json["without"].push_back({{"scene", without.scene},
                               {"object", without.object},
                               {"object_index", without.object_index},
                               {"perceptual_threshold" + unit, level(without.thresholds.perceptual)},
                               {"slightly_noticeable" + unit, level(without.thresholds.slightly_noticeable)},
                               {"inflection" + unit, level(without.thresholds.inflection)}});
  return json;
}

Json view_json(const ThresholdEstimate& estimate, double field_of_view_deg) {
  if (!estimate.level_x) return nullptr;
  const double width_px = std::exp2(*estimate.level_x);
  return {{"equirectangular_px", json_number(width_in_field_of_view_px(width_px, field_of_view_deg))},
          {"pinhole_px", json_number(pinhole_width_px(width_px, field_of_view_deg))}};
}

Json person_json(const ScreenedPerson& person) {
  return {
      {"participant", person.code},
      {"catch_trials", {{"shown", person.attention.shown}, {"right", person.attention.right}}},
      {"kurtosis",
       {{"P", person.kurtosis.above}, {"Q", person.kurtosis.below}, {"stimuli", person.kurtosis.stimuli}}},
      {"correlation",
       {{"stimuli", json_number(person.correlation.stimuli)},
        {"conditions", json_number(person.correlation.conditions)},
        {"critical", json_number(person.correlation.critical)},
        {"below_p913", person.correlation.below_p913}}}};
}

Json screening_json(const Screening& screening) {
  Json json;
  for (ScreeningRule rule : every_screening_rule) {
    Json& of_rule = json[std::string(word(rule))];
    of_rule = {{"rule", rule_of(rule)},
               {"judged", screening.judged(rule)},
               {"not_judged_because", why_not_judged(screening, rule)},
               {"count", screening.named_by(rule).size()},
               {"named", screening.named_by(rule)}};
    if (rule == ScreeningRule::attention) continue;
    of_rule["honest_named"] =
        screening.honest.simulated > 0 ? json_number(honest_share(screening.honest, rule)) : Json(nullptr);
    if (rule == ScreeningRule::correlation) {
      const auto [most, least] = screening.critical_correlations();
      of_rule["limit"] = {json_number(least), json_number(most)};
    }
  }
  json["honest_simulated"] = screening.honest.simulated;
  json["people"] = Json::array();
  for (const ScreenedPerson& person : screening.people) json["people"].push_back(person_json(person));
  return json;
}

Json screened_json(const ScreenedThresholds& result, const LevelAxis& axis, bool conditions) {
  const std::string unit = unit_suffix(axis);
  Json json = {{"who", result.who}, {"left_out", result.left_out}, {"artifacts", Json::array()}};
  for (const ArtifactThresholds& thresholds : result.thresholds) {
    Json artifact = {{"artifact", word(thresholds.artifact)}};
    if (conditions) artifact["condition"] = thresholds.condition;
    artifact["perceptual_threshold" + unit] = json_estimate(thresholds.estimates.perceptual, axis);
    artifact["slightly_noticeable" + unit] = json_estimate(thresholds.estimates.slightly_noticeable, axis);
    artifact["inflection" + unit] = json_estimate(thresholds.estimates.inflection, axis);
    json["artifacts"].push_back(artifact);
  }
  return json;
}

Json guessing_json(const GuessCorrection& correction) {
  const Guessers& guessers = correction.guessers;
  if (!guessers.known()) return nullptr;
  return {{"position_probability", guessers.position},
          {"position_estimated", guessers.position_estimated},
          {"rating_probability", guessers.rating},
          {"mean_rating", json_number(guessers.mean_rating())},
          {"floor", json_number(correction.floor)},
          {"wrong_choices", json_number(guessers.wrong_answers)},
          {"reference_trials", json_number(guessers.reference_answers)}};
}

}  // namespace

Json artifact_checks_json(const Analysis& analysis, std::size_t index) {
  const CurveThresholds& found = analysis.thresholds[index].estimates;
  const double view_deg = analysis.options.field_of_view_deg;
  const LevelAxis& axis = analysis.data.axis;
  const std::string unit = unit_suffix(axis);
  Json json;
  json["logistic_thresholds"] = {
      {"perceptual_threshold" + unit, json_estimate(found.perceptual_logistic, axis)},
      {"slightly_noticeable" + unit, json_estimate(found.slightly_noticeable_logistic, axis)}};
  json["corrected_for_guessing"] = index < analysis.guessing.curves.size()
                                       ? corrected_json(analysis.guessing.curves[index], axis)
                                       : Json(nullptr);
  json["one_object_left_out"] = index < analysis.object_influence.size()
                                    ? objects_json(analysis.object_influence[index], axis)
                                    : Json(nullptr);
  if (!of_depth_widths(axis)) return json;
  json["field_of_view"] = {{"degrees", json_number(view_deg)},
                           {"perceptual_threshold", view_json(found.perceptual, view_deg)},
                           {"slightly_noticeable", view_json(found.slightly_noticeable, view_deg)},
                           {"inflection", view_json(found.inflection, view_deg)}};
  return json;
}

Json checks_json(const Analysis& analysis) {
  Json json;
  json["guessing"] = guessing_json(analysis.guessing);
  json["screening"] = screening_json(analysis.screening);
  json["thresholds_by_screen"] = Json::array();
  for (const ScreenedThresholds& result : analysis.screened)
    json["thresholds_by_screen"].push_back(
        screened_json(result, analysis.data.axis, has_conditions(analysis.data)));
  json["exclude_screened"] = analysis.options.exclude_screened;
  json["exclude_inattentive"] = analysis.options.exclude_inattentive;
  json["exclude_uncorrected"] = analysis.options.exclude_uncorrected;
  json["sos_parameter"] = {
      {"a", json_number(analysis.sos.a)},
      {"ci95", {json_number(analysis.sos.ci95_low), json_number(analysis.sos.ci95_high)}},
      {"stimuli", analysis.sos.stimuli}};
  return json;
}

}  // namespace seamline::analysis
