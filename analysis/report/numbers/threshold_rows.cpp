#include "analysis/report/numbers/threshold_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
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

std::string edge_text(double log2_px, int smallest_px, int largest_px) {
  if (log2_px == below_every_width) return fmt::format("below {}", smallest_px);
  if (log2_px == above_every_width) return fmt::format("above {}", largest_px);
  return fmt::format("{:.0f}", std::exp2(log2_px));
}

std::string width_text(const WidthEstimate& estimate) {
  return estimate.log2_px ? fmt::format("{:.0f}", std::exp2(*estimate.log2_px)) : estimate.reason;
}

}  // namespace

std::vector<ThresholdRow> threshold_rows(const Analysis& analysis) {
  std::vector<ThresholdRow> rows;
  for (std::size_t i = 0; i < analysis.thresholds.size(); ++i) add_rows(analysis, i, rows);
  return rows;
}

std::string artifact_title(Artifact artifact) {
  std::string title(word(artifact));
  title.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(title.front())));
  if (const std::optional<PaperThresholds> paper = paper_thresholds(artifact))
    title += fmt::format(" (type {})", paper->type);
  return title;
}

std::string size_text(const WidthEstimate& estimate, const std::string& times) {
  if (!estimate.log2_px) return estimate.reason;
  const double width_px = std::exp2(*estimate.log2_px);
  return fmt::format("{:.0f} {} {:.0f}", width_px, times, width_px / 2);
}

std::string interval_text(const WidthInterval& interval, int smallest_px, int largest_px) {
  const std::string low = edge_text(interval.low_log2_px, smallest_px, largest_px);
  if (interval.low_log2_px == interval.high_log2_px && !std::isfinite(interval.low_log2_px)) return low;
  return low + " to " + edge_text(interval.high_log2_px, smallest_px, largest_px);
}

std::optional<double> bound_px(double log2_px) {
  return std::isfinite(log2_px) ? std::optional(std::exp2(log2_px)) : std::nullopt;
}

std::string estimate_text(const WidthEstimate& estimate, int smallest_px, int largest_px) {
  return fmt::format("{} ({})", width_text(estimate), interval_text(estimate.ci95, smallest_px, largest_px));
}

std::string aligned(const std::vector<std::vector<std::string>>& lines) {
  std::vector<std::size_t> widths(lines.front().size());
  for (const std::vector<std::string>& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  std::string text;
  for (const std::vector<std::string>& line : lines) {
    std::string row;
    for (std::size_t i = 0; i < line.size(); ++i) row += fmt::format("{:<{}}", line[i], widths[i] + 2);
    text += row.substr(0, row.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::string table_text(const Analysis& analysis) {
  const bool simulated = !analysis.planted.empty();
  std::vector<std::vector<std::string>> lines = {{"artifact", "", "here", "95 % interval (W)", "paper (W)"}};
  if (simulated) lines.front().emplace_back("planted (W)");
  for (const ThresholdRow& row : threshold_rows(analysis)) {
    lines.push_back({row.quantity == "PT" ? artifact_title(row.artifact) : "", row.quantity,
                     size_text(row.here, "x"), interval_text(row.here.ci95, row.smallest_px, row.largest_px),
                     row.paper_px ? std::to_string(*row.paper_px) : "-"});
    if (simulated) lines.back().push_back(row.planted ? width_text(*row.planted) : "");
  }
  std::string text =
      fmt::format("Depth map width W x height in px; {}\n", source_text(analysis)) + aligned(lines);
  text += "PT: mean noticeability 0.5; SN: 1.0; IP: inflection point. -: the paper gives no value.\n";
  if (simulated)
    text += "Planted values are what the simulated observers were made of; they are not the paper's.\n";
  return text;
}

}  // namespace seamline::analysis
