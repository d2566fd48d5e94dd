#include "analysis/report/json/thresholds_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/report/json/checks_json.h"
#include "analysis/report/json/json_values.h"
#include "analysis/report/numbers/threshold_rows.h"
#include "support/files/assets.h"

namespace seamline::analysis {

namespace {

using Json = nlohmann::ordered_json;

Json width(const WidthEstimate& estimate, const ThresholdRow& row, double px_per_unit) {
  Json json = json_width(estimate, px_per_unit);
  if (px_per_unit == 1) json["ci95_text"] = interval_text(estimate.ci95, row.smallest_px, row.largest_px);
  return json;
}

Json cell_json(const CellMean& cell) {
  return {{"width_px", cell.width_px},
          {"n", cell.n},
          {"mean", json_number(cell.mean)},
          {"sem", json_number(cell.sem)},
          {"correct", json_number(cell.correct)}};
}

Json curve_json(const ArtifactScores& scores, const CurveThresholds& fits) {
  Json curve = Json::array();
  const std::vector<double> log2_px = log2_widths(scores.width_px);
  for (std::size_t i = 0; i < scores.cells.size(); ++i) {
    Json point = cell_json(scores.cells[i]);
    point["isotonic"] = json_number(fits.isotonic.value[i]);
    point["logistic"] = json_number(value_at(fits.logistic.curve, log2_px[i]));
    curve.push_back(point);
  }
  return curve;
}

Json cells_json(const NoticeabilityData& data, Artifact artifact) {
  Json cells = Json::array();
  for (const ObjectCurve& object : data.objects) {
    if (object.artifact != artifact) continue;
    for (const CellMean& cell : object.cells) {
      Json json = {{"artifact", word(artifact)},
                   {"scene", object.scene},
                   {"object", object.object},
                   {"object_index", object.object_index}};
      json.update(cell_json(cell));
      cells.push_back(json);
    }
  }
  return cells;
}

Json logistic_json(const Logistic4Fit& fit) {
  return {{"upper", json_number(fit.curve.upper)},
          {"lower", json_number(fit.curve.lower)},
          {"centre_px", json_number(std::exp2(fit.curve.centre_log2_px))},
          {"scale_octaves", json_number(fit.curve.scale_octaves)},
          {"residual_sum_of_squares", json_number(fit.residual_sum_of_squares)},
          {"identified", fit.verdict == Centre::identified}};
}

Json artifact_json(const Analysis& analysis, std::size_t index, const std::vector<ThresholdRow>& rows) {
  const ArtifactThresholds& thresholds = analysis.thresholds[index];
  Json json;
  json["artifact"] = word(thresholds.artifact);
  json["participants"] = thresholds.participants;
  Json planted, paper, bootstrap;
  for (const ThresholdRow& row : rows) {
    if (row.artifact != thresholds.artifact) continue;
    json[row.key + "_px"] = width(row.here, row, 1);
    json[row.key + "_texels_per_degree"] = width(row.here, row, 360);
    paper[row.key + "_px"] = row.paper_px ? Json(*row.paper_px) : Json(nullptr);
    if (row.planted)
      planted[row.key + "_px"] =
          row.planted->log2_px ? json_number(std::exp2(*row.planted->log2_px)) : Json(nullptr);
    if (row.bootstrap) bootstrap[row.key + "_px"] = json_interval(*row.bootstrap, 1);
  }
  json["planted"] = planted;
  json["paper"] = paper;
  json["expanded_percentile_ci95"] = bootstrap;
  json["logistic"] = logistic_json(thresholds.estimates.logistic);
  json["curve"] = curve_json(analysis.data.artifacts[index], thresholds.estimates);
  json["cells"] = cells_json(analysis.data, thresholds.artifact);
  json.update(artifact_checks_json(analysis, index));
  return json;
}

}  // namespace

std::string thresholds_json(const Analysis& analysis) {
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
  json["participants"] = {
      {"in_log", counts.in_log},         {"used", counts.used},
      {"excluded", counts.excluded},     {"pilot_left_out", counts.pilot},
      {"incomplete", counts.incomplete}, {"screened", counts.screened},
      {"simulated", counts.simulated},   {"forgotten", analysis.log.forgotten_participants}};
  json["include_pilot"] = analysis.include_pilot;
  json["bootstrap"] = {{"replicates", analysis.resampling.replicates}, {"seed", analysis.resampling.seed}};
  json["intervals"] =
      "95 %: PT and SN by an inverted score test, IP by the expanded percentile bootstrap over participants";
  json["notes"] = analysis.notes;
  const std::vector<ThresholdRow> rows = threshold_rows(analysis);
  json["artifacts"] = Json::array();
  for (std::size_t i = 0; i < analysis.thresholds.size(); ++i)
    json["artifacts"].push_back(artifact_json(analysis, i, rows));
  json.update(checks_json(analysis));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace seamline::analysis
