#include "analysis/report/json/checks_json.h"

#include <cmath>

#include "analysis/report/json/json_values.h"
#include "analysis/thresholds/angular_resolution.h"

namespace seamline::analysis {

namespace {

using Json = nlohmann::ordered_json;

Json corrected_json(const CorrectedCurve& corrected) {
  const CurveThresholds& found = corrected.estimates;
  Json json = {{"perceptual_threshold_px", json_width(found.perceptual, 1)},
               {"slightly_noticeable_px", json_width(found.slightly_noticeable, 1)},
               {"inflection_px", json_width(found.inflection, 1)},
               {"expanded_percentile_ci95",
                {{"perceptual_threshold_px", json_interval(corrected.perceptual_bootstrap, 1)},
                 {"slightly_noticeable_px", json_interval(corrected.slightly_noticeable_bootstrap, 1)}}},
               {"above_chance", corrected.above_chance},
               {"curve", Json::array()}};
  for (std::size_t w = 0; w < corrected.cells.size(); ++w)
    json["curve"].push_back({{"width_px", corrected.width_px[w]},
                             {"saw", json_number(corrected.cells[w].saw)},
                             {"noticeability", json_number(corrected.cells[w].noticeability)}});
  return json;
}

Json objects_json(const ObjectInfluence& objects) {
  if (objects.without.empty()) return nullptr;
  Json json = {{"perceptual_threshold_px", json_interval(*objects.perceptual, 1)},
               {"slightly_noticeable_px", json_interval(*objects.slightly_noticeable, 1)},
               {"inflection_px", json_interval(*objects.inflection, 1)},
               {"without", Json::array()}};
  const auto px = [](const WidthEstimate& estimate) {
    return estimate.log2_px ? json_number(std::exp2(*estimate.log2_px)) : Json(nullptr);
  };
  for (const WithoutObject& without : objects.without)
    json["without"].push_back({{"scene", without.scene},
                               {"object", without.object},
                               {"object_index", without.object_index},
                               {"perceptual_threshold_px", px(without.thresholds.perceptual)},
                               {"slightly_noticeable_px", px(without.thresholds.slightly_noticeable)},
                               {"inflection_px", px(without.thresholds.inflection)}});
  return json;
}

Json view_json(const WidthEstimate& estimate, double field_of_view_deg) {
  if (!estimate.log2_px) return nullptr;
  const double width_px = std::exp2(*estimate.log2_px);
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
  for (Screen screen : every_screen) {
    const bool judged = screen != Screen::attention || screening.catch_trials;
    json[std::string(word(screen))] = {{"rule", rule_of(screen)},
                                       {"judged", judged},
                                       {"count", screening.named_by(screen).size()},
                                       {"named", screening.named_by(screen)}};
  }
  json["people"] = Json::array();
  for (const ScreenedPerson& person : screening.people) json["people"].push_back(person_json(person));
  return json;
}

Json screened_json(const ScreenedThresholds& result) {
  Json json = {{"who", result.who}, {"left_out", result.left_out}, {"artifacts", Json::array()}};
  for (const ArtifactThresholds& thresholds : result.thresholds)
    json["artifacts"].push_back(
        {{"artifact", word(thresholds.artifact)},
         {"perceptual_threshold_px", json_width(thresholds.estimates.perceptual, 1)},
         {"slightly_noticeable_px", json_width(thresholds.estimates.slightly_noticeable, 1)},
         {"inflection_px", json_width(thresholds.estimates.inflection, 1)}});
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
  Json json;
  json["logistic_thresholds"] = {
      {"perceptual_threshold_px", json_width(found.perceptual_logistic, 1)},
      {"slightly_noticeable_px", json_width(found.slightly_noticeable_logistic, 1)}};
  json["corrected_for_guessing"] = index < analysis.guessing.curves.size()
                                       ? corrected_json(analysis.guessing.curves[index])
                                       : Json(nullptr);
  json["one_object_left_out"] = index < analysis.object_influence.size()
                                    ? objects_json(analysis.object_influence[index])
                                    : Json(nullptr);
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
    json["thresholds_by_screen"].push_back(screened_json(result));
  json["exclude_screened"] = analysis.options.exclude_screened;
  json["sos_parameter"] = {
      {"a", json_number(analysis.sos.a)},
      {"ci95", {json_number(analysis.sos.ci95_low), json_number(analysis.sos.ci95_high)}},
      {"stimuli", analysis.sos.stimuli}};
  return json;
}

}  // namespace seamline::analysis
