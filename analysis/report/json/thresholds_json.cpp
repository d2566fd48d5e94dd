#include "analysis/report/json/thresholds_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/log_analysis/headline_rows.h"
#include "analysis/report/json/json_values.h"
#include "analysis/report/json/thresholds_parts.h"
#include "analysis/report/text/threshold_text.h"
#include "analysis/scores/rows_of_curves.h"
#include "analysis/thresholds/threshold_rules.h"
#include "support/files/assets.h"

namespace seamline::analysis {

namespace {

using Json = nlohmann::ordered_json;

Json estimate_json(const ThresholdEstimate& estimate, const ThresholdRow& row, double divisor) {
  Json json = json_estimate(estimate, row.tested.axis, divisor);
  if (divisor == 1) json["ci95_text"] = interval_text(estimate.ci95, row.tested);
  return json;
}

Json cell_json(const CellMean& cell, const LevelAxis& axis) {
  return {{level_key(axis), json_level(axis, cell.level)},
          {"n", cell.n},
          {"mean", json_number(cell.mean)},
          {"sem", json_number(cell.sem)},
          {"correct", json_number(cell.correct)}};
}

Json curve_json(const ArtifactScores& scores, const CurveThresholds& fits) {
  Json curve = Json::array();
  for (std::size_t i = 0; i < scores.cells.size(); ++i) {
    Json point = cell_json(scores.cells[i], scores.axis);
    const double level = scores.cells[i].level;
    if (stands_apart(scores.axis, level)) {
      point["isotonic"] = point["logistic"] = nullptr;
      curve.push_back(point);
      continue;
    }
    point["isotonic"] = json_number(fits.isotonic.value[i]);
    point["logistic"] = json_number(value_at(fits.logistic.curve, x_of(scores.axis, level)));
    curve.push_back(point);
  }
  return curve;
}

Json cells_json(const NoticeabilityData& data, Artifact artifact, const std::string& condition) {
  Json cells = Json::array();
  for (const ObjectCurve& object : data.objects) {
    if (object.artifact != artifact || object.condition != condition) continue;
    for (const CellMean& cell : object.cells) {
      Json json = {{"artifact", word(artifact)},
                   {"scene", object.scene},
                   {"object", object.object},
                   {"object_index", object.object_index}};
      json.update(cell_json(cell, data.axis));
      cells.push_back(json);
    }
  }
  return cells;
}

Json logistic_json(const Logistic4Fit& fit, const LevelAxis& axis) {
  return {{"upper", json_number(fit.curve.upper)},
          {"lower", json_number(fit.curve.lower)},
          {"centre" + unit_suffix(axis), json_number(level_at(axis, fit.curve.centre_x))},
          {"scale_" + length_key(axis), json_number(std::abs(difference_at(axis, fit.curve.scale_x)))},
          {"residual_sum_of_squares", json_number(fit.residual_sum_of_squares)},
          {"identified", fit.verdict == Centre::identified}};
}

Json differences_json(const Analysis& analysis) {
  Json differences = Json::array();
  for (const ThresholdDifference& found : analysis.differences)
    differences.push_back({{"artifact", word(found.artifact)},
                           {"quantity", found.quantity},
                           {"condition", found.condition},
                           {"to", found.to},
                           {"participants", found.participants},
                           {"estimate", json_number(found.estimate)},
                           {"bounds", {json_number(found.bounds.low), json_number(found.bounds.high)}},
                           {"ci95", {json_number(found.ci95.low), json_number(found.ci95.high)}},
                           {"text", found.text}});
  return differences;
}

/// The thresholds of record of a curve, by key and unit.
Json headline_json(const Analysis& analysis, const std::vector<const HeadlineRow*>& rows) {
  Json json;
  for (const HeadlineRow* row : rows) {
    Json one = json_estimate(row->here, row->tested.axis);
    one["ci95_text"] = interval_text(row->here.ci95, row->tested);
    one["simultaneous_ci95"] = json_interval(row->simultaneous, row->tested.axis);
    one["beyond_levels"] = row->beyond_levels;
    one["differs"] = row->differs.empty() ? Json(nullptr) : Json(row->differs);
    json[row->rule->key + unit_suffix(analysis.data.axis)] = std::move(one);
  }
  return json;
}

/// What the joint model was fitted to and how well it fits.
Json joint_json(const JointAnalysis& joint) {
  Json json;
  json["verdict"] = verdict_text(joint.fit.verdict);
  json["explanation"] = joint.fit.explanation.empty() ? Json(nullptr) : Json(joint.fit.explanation);
  json["participants"] = joint.fit.people;
  json["answers"] = json_number(joint.fit.answers);
  const bool known = joint.fit.estimated();
  json["log_likelihood"] = known ? json_number(joint.fit.log_likelihood) : Json(nullptr);
  json["people_sd"] =
      known ? json_number(std::abs(difference_at(joint.axis, joint.people.shift_sd))) : Json(nullptr);
  json["people_by_curve_sd"] =
      known ? json_number(std::abs(difference_at(joint.axis, joint.people.curve_sd))) : Json(nullptr);
  const bool tested = joint.goodness && joint.goodness->replicates > 0;
  json["choices_p"] = tested ? json_number(joint.goodness->choices_p) : Json(nullptr);
  json["ratings_p"] = tested ? json_number(joint.goodness->ratings_p) : Json(nullptr);
  json["replicates"] = tested ? joint.goodness->replicates : 0;
  return json;
}

/// What stands in one curve's part of the file.
struct CurveRows {
  RowsOfCurves<ThresholdRow> paper_way;
  RowsOfCurves<HeadlineRow> of_record;
};

Json artifact_json(const Analysis& analysis, std::size_t index, const CurveRows& rows) {
  const ArtifactThresholds& thresholds = analysis.thresholds[index];
  Json json;
  json["artifact"] = word(thresholds.artifact);
  if (has_conditions(analysis.data)) json["condition"] = thresholds.condition;
  json["participants"] = thresholds.participants;
  json["participants_at_fewest"] = thresholds.fewest;
  const LevelAxis& axis = analysis.data.axis;
  const std::string unit = unit_suffix(axis);
  Json planted, limit, paper, bootstrap;
  for (const ThresholdRow* of_curve : rows_of(rows.paper_way, thresholds)) {
    const ThresholdRow& row = *of_curve;
    json[row.key + unit] = estimate_json(row.here, row, 1);
    if (of_depth_widths(axis)) json[row.key + "_texels_per_degree"] = estimate_json(row.here, row, 360);
    paper[row.key + "_px"] = row.paper_px ? Json(*row.paper_px) : Json(nullptr);
    if (row.planted_x) planted[row.key + unit] = json_number(planted_level(row));
    if (row.limit) limit[row.key + unit] = json_number(level_of(*row.limit, axis));
    if (row.bootstrap) bootstrap[row.key + unit] = json_interval(*row.bootstrap, axis);
  }
  if (analysis.joint) json["joint"] = headline_json(analysis, rows_of(rows.of_record, thresholds));
  json["planted"] = planted;
  json["planted_limit"] = limit;
  if (beside_the_paper(analysis)) json["paper"] = paper;
  json["expanded_percentile_ci95"] = bootstrap;
  json["logistic"] = logistic_json(thresholds.estimates.logistic, axis);
  json["curve"] = curve_json(analysis.data.artifacts[index], thresholds.estimates);
  json["cells"] = cells_json(analysis.data, thresholds.artifact, thresholds.condition);
  json.update(artifact_checks_json(analysis, index));
  return json;
}

}  // namespace

std::string thresholds_json(const Analysis& analysis, const std::vector<CurveOverScenes>& over_scenes) {
  const ParticipantCounts& counts = analysis.counts;
  Json json;
  json["format"] = thresholds_format;
  json["version"] = thresholds_version;
  json["program_version"] = program_version();
  json["study"] = {{"name", analysis.log.study_name}, {"hash", analysis.log.study_hash}};
  json["set"] = {{"hash", analysis.log.set_hash}};
  json["source"] = source_text(analysis);
  json["simulated"] = counts.simulated > 0;
  json["observer"] =
      common_observer(analysis.people).empty() ? Json(nullptr) : Json(common_observer(analysis.people));
  json["participants"] = {{"in_log", counts.in_log},
                          {"used", counts.used},
                          {"excluded", counts.excluded},
                          {"pilot_left_out", counts.pilot},
                          {"incomplete", counts.incomplete},
                          {"screened", counts.screened},
                          {"vision", counts.vision},
                          {"simulated", counts.simulated},
                          {"forgotten", analysis.log.forgotten_participants}};
  json["include_pilot"] = analysis.include_pilot;
  json["bootstrap"] = {{"replicates", analysis.resampling.replicates}, {"seed", analysis.resampling.seed}};
  json["intervals"] = intervals_in_short();
  json["headline"] = analysis.joint ? "joint" : "paper_way";
  if (analysis.joint) json["joint"] = joint_json(*analysis.joint);
  json["notes"] = analysis.notes;
  const LevelAxis& axis = analysis.data.axis;
  if (!of_depth_widths(axis))
    json["level"] = {{"quantity", facts(axis.quantity).key},
                     {"axis", is_linear(axis) ? "linear" : "log2"},
                     {"noticeability", noticeability_word(axis.noticeability)}};
  if (has_conditions(analysis.data)) json["conditions"] = analysis.data.conditions;
  const std::vector<ThresholdRow> paper_way = threshold_rows(analysis);
  const std::vector<HeadlineRow> of_record = headline_rows(analysis);
  const CurveRows rows{.paper_way = rows_of_curves(paper_way), .of_record = rows_of_curves(of_record)};
  json["artifacts"] = Json::array();
  for (std::size_t i = 0; i < analysis.thresholds.size(); ++i)
    json["artifacts"].push_back(artifact_json(analysis, i, rows));
  if (!over_scenes.empty()) json["scenes"] = scenes_json(over_scenes, axis, has_conditions(analysis.data));
  json.update(checks_json(analysis));
  if (has_conditions(analysis.data)) json["differences"] = differences_json(analysis);
  if (analysis.origins) json["origins"] = origins_json(analysis);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace seamline::analysis
