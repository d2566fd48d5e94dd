#include "analysis/log_analysis/threshold_rows.h"

#include <algorithm>
#include <cmath>

#include "analysis/log_analysis/task_words.h"
#include "analysis/thresholds/paper_values.h"

namespace seamline::analysis {

namespace {

void add_rows(const Analysis& analysis, std::size_t index, std::vector<ThresholdRow>& rows) {
  const ArtifactThresholds& thresholds = analysis.thresholds[index];
  const ArtifactScores& scores = analysis.data.artifacts[index];
  const PlantedValues& planted = analysis.planted;
  // Neither is computed of adaptive logs, which have no curves.
  const ObjectInfluence objects =
      index < analysis.object_influence.size() ? analysis.object_influence[index] : ObjectInfluence{};
  CorrectedCurve corrected;
  if (index < analysis.guessing.curves.size())
    corrected = analysis.guessing.curves[index];
  else
    for (auto width :
         {&CurveThresholds::perceptual, &CurveThresholds::slightly_noticeable, &CurveThresholds::inflection})
      (corrected.estimates.*width).reason = (thresholds.estimates.*width).reason;
  const std::optional<PaperThresholds> paper =
      beside_the_paper(analysis) ? paper_thresholds(thresholds.artifact) : std::nullopt;
  const auto found = planted.find({thresholds.artifact, thresholds.condition});
  const PlantedThresholds* known = found == planted.end() ? nullptr : &found->second;
  const auto row = [&](const char* quantity, const char* key, const ThresholdEstimate& here) {
    return ThresholdRow{.artifact = thresholds.artifact,
                        .condition = thresholds.condition,
                        .tested = tested_levels(scores),
                        .quantity = quantity,
                        .key = key,
                        .level = {},
                        .here = here,
                        .bootstrap = {},
                        .paper_px = {},
                        .planted_x = {},
                        .limit = {},
                        .logistic = {},
                        .object_range = {},
                        .corrected = {},
                        .corrected_bootstrap = {}};
  };
  ThresholdRow pt = row("PT", "perceptual_threshold", thresholds.estimates.perceptual);
  ThresholdRow sn = row("SN", "slightly_noticeable", thresholds.estimates.slightly_noticeable);
  ThresholdRow ip = row("IP", "inflection", thresholds.estimates.inflection);
  pt.level = perceptual_level;
  sn.level = slight_level;
  pt.bootstrap = thresholds.perceptual_bootstrap;
  sn.bootstrap = thresholds.slightly_noticeable_bootstrap;
  pt.logistic = thresholds.estimates.perceptual_logistic;
  sn.logistic = thresholds.estimates.slightly_noticeable_logistic;
  pt.object_range = objects.perceptual;
  sn.object_range = objects.slightly_noticeable;
  ip.object_range = objects.inflection;
  pt.corrected = corrected.estimates.perceptual;
  sn.corrected = corrected.estimates.slightly_noticeable;
  ip.corrected = corrected.estimates.inflection;
  pt.corrected_bootstrap = corrected.perceptual_bootstrap;
  sn.corrected_bootstrap = corrected.slightly_noticeable_bootstrap;
  if (paper) {
    pt.paper_px = paper->perceptual_px;
    sn.paper_px = paper->slightly_noticeable_px;
    ip.paper_px = paper->inflection_px;
  }
  if (known != nullptr) {
    pt.planted_x = known->perceptual_x;
    sn.planted_x = known->slightly_noticeable_x;
    ip.planted_x = known->inflection_x;
    pt.limit = known->limit.perceptual;
    sn.limit = known->limit.slightly_noticeable;
    ip.limit = known->limit.inflection;
  }
  rows.insert(rows.end(), {pt, sn, ip});
}

}  // namespace

std::vector<ThresholdRow> threshold_rows(const Analysis& analysis) {
  std::vector<ThresholdRow> rows;
  if (!asks_ratings(analysis.log)) return rows;
  for (std::size_t i = 0; i < analysis.thresholds.size(); ++i) add_rows(analysis, i, rows);
  return rows;
}

TestedLevels tested_levels(const ArtifactScores& scores) {
  TestedLevels tested{.axis = scores.axis, .smallest = 0, .largest = 0};
  bool some = false;
  for (const double level : scores.level) {
    if (stands_apart(scores.axis, level)) continue;
    tested.smallest = some ? std::min(tested.smallest, level) : level;
    tested.largest = some ? std::max(tested.largest, level) : level;
    some = true;
  }
  return tested;
}

bool beside_the_paper(const Analysis& analysis) {
  return of_depth_widths(analysis.data.axis) && !has_conditions(analysis.data) &&
         is_papers_task(analysis.log);
}

std::optional<double> level_of(const ThresholdEstimate& estimate, const LevelAxis& axis) {
  return estimate.level_x ? std::optional(level_at(axis, *estimate.level_x)) : std::nullopt;
}

std::optional<double> planted_level(const ThresholdRow& row) {
  return row.planted_x ? std::optional(level_at(row.tested.axis, *row.planted_x)) : std::nullopt;
}

std::optional<double> design_bias_x(const ThresholdRow& row) {
  if (!row.planted_x || !row.limit || !row.limit->level_x) return std::nullopt;
  return *row.limit->level_x - *row.planted_x;
}

std::optional<double> closed(double bound) {
  return std::isfinite(bound) ? std::optional(bound) : std::nullopt;
}

}  // namespace seamline::analysis
