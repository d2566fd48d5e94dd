#include "analysis/report/page/checks_lines.h"

#include <fmt/format.h>

#include <cmath>

namespace seamline::analysis {

std::vector<std::string> otherwise_estimated_cells(const ThresholdRow& row) {
  const auto text = [&](const ThresholdEstimate& estimate) { return estimate_text(estimate, row.tested); };
  const bool inflection = row.quantity == "IP";  // which is the logistic's own
  std::string logistic;
  if (inflection)
    logistic = text(row.here);
  else if (row.logistic)
    logistic = text(*row.logistic);
  return {row.quantity == "PT" ? artifact_title(row.artifact, row.condition) : "",
          row.quantity,
          inflection ? "" : text(row.here),
          logistic,
          text(row.corrected),
          row.object_range ? interval_text(*row.object_range, row.tested) : ""};
}

std::vector<std::vector<std::string>> screened_lines(const Analysis& analysis) {
  std::vector<std::vector<std::string>> lines;
  for (const ScreenedThresholds& result : analysis.screened)
    for (const ArtifactThresholds& thresholds : result.thresholds)
      for (const ArtifactScores& scores : analysis.data.artifacts) {
        if (scores.artifact != thresholds.artifact || scores.condition != thresholds.condition) continue;
        const auto text = [&](const ThresholdEstimate& estimate) {
          return estimate_text(estimate, tested_levels(scores));
        };
        const bool first = &thresholds == &result.thresholds.front();
        lines.push_back({first ? who_text(result, analysis) : "",
                         std::string(word(thresholds.artifact)) + in_condition(thresholds.condition),
                         text(thresholds.estimates.perceptual),
                         text(thresholds.estimates.slightly_noticeable),
                         text(thresholds.estimates.inflection)});
      }
  return lines;
}

std::string who_text(const ScreenedThresholds& result, const Analysis& analysis) {
  if (result.left_out.empty()) return fmt::format("{} ({})", result.who, analysis.screening.people.size());
  std::string codes;
  for (const std::string& code : result.left_out) codes += (codes.empty() ? "" : ", ") + code;
  return fmt::format("{} ({} left out: {})", result.who, result.left_out.size(), codes);
}

std::string sos_text(const SosParameter& sos) {
  const bool known = std::isfinite(sos.ci95_low) && std::isfinite(sos.ci95_high);
  return fmt::format("a = {:.3f} ({}) over {} stimuli", sos.a,
                     known ? fmt::format("{:.3f} to {:.3f}", sos.ci95_low, sos.ci95_high)
                           : "no interval from fewer than three people",
                     sos.stimuli);
}

}  // namespace seamline::analysis
