#include "analysis/log_analysis/threshold_rows.h"

#include <cmath>

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
  const std::optional<PaperThresholds> paper = paper_thresholds(thresholds.artifact);
  const auto found = planted.find(thresholds.artifact);
  const CurveThresholds* known = found == planted.end() ? nullptr : &found->second;
  const auto row = [&](const char* quantity, const char* key, const WidthEstimate& here) {
    return ThresholdRow{.artifact = thresholds.artifact,
                        .quantity = quantity,
                        .key = key,
                        .level = {},
                        .here = here,
                        .bootstrap = {},
                        .smallest_px = scores.width_px.front(),
                        .largest_px = scores.width_px.back(),
                        .paper_px = {},
                        .planted = {},
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
    pt.planted = known->perceptual;
    sn.planted = known->slightly_noticeable;
    ip.planted = known->inflection;
  }
  rows.insert(rows.end(), {pt, sn, ip});
}

}  // namespace

std::vector<ThresholdRow> threshold_rows(const Analysis& analysis) {
  std::vector<ThresholdRow> rows;
  for (std::size_t i = 0; i < analysis.thresholds.size(); ++i) add_rows(analysis, i, rows);
  return rows;
}

std::optional<double> bound_px(double log2_px) {
  return std::isfinite(log2_px) ? std::optional(std::exp2(log2_px)) : std::nullopt;
}

}  // namespace seamline::analysis
