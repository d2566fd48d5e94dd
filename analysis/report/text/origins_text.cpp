#include "analysis/report/text/origins_text.h"

#include <fmt/format.h>

#include "analysis/report/text/threshold_text.h"
#include "support/text/counted.h"

namespace seamline::analysis {

namespace {

std::string p_or_empty(const std::optional<double>& p) {
  if (!p) return "";
  return *p < 0.001 ? "< 0.001" : fmt::format("{:.3f}", *p);
}

std::string difference_text(const std::optional<double>& difference) {
  if (!difference) return "";
  const std::string text = fmt::format("{:+.2f}", *difference);
  return text.starts_with('-') ? "−" + text.substr(1) : text;
}

/// PT or SN of a curve in words; empty where a group has no such curve.
std::string threshold_text(const std::vector<ArtifactThresholds>& thresholds, const OriginDifference& of,
                           const Analysis& analysis) {
  for (const ArtifactThresholds& one : thresholds)
    for (const ArtifactScores& scores : analysis.data.artifacts)
      if (one.artifact == of.artifact && one.condition == of.condition && scores.artifact == of.artifact &&
          scores.condition == of.condition)
        return estimate_text(
            of.quantity == "PT" ? one.estimates.perceptual : one.estimates.slightly_noticeable,
            tested_levels(scores));
  return "";
}

}  // namespace

std::vector<std::string> origin_titles(const Analysis& analysis) {
  return {"artifact", "",        "together", "lab", "web", "web − lab, " + length_unit(analysis.data.axis),
          "p",        "p (Holm)"};
}

std::vector<std::vector<std::string>> origin_lines(const Analysis& analysis) {
  std::vector<std::vector<std::string>> lines;
  if (!analysis.origins) return lines;
  for (const OriginDifference& found : analysis.origins->differences)
    lines.push_back({found.quantity == "PT" ? artifact_title(found.artifact, found.condition) : "",
                     found.quantity, threshold_text(analysis.thresholds, found, analysis),
                     threshold_text(analysis.origins->lab.thresholds, found, analysis),
                     threshold_text(analysis.origins->web.thresholds, found, analysis),
                     difference_text(found.difference), p_or_empty(found.p), p_or_empty(found.p_holm)});
  return lines;
}

std::string origin_sentence(const Analysis& analysis) {
  if (!analysis.origins) return "";
  const OriginComparison& origins = *analysis.origins;
  return fmt::format(
      "{} took part in the lab and {} in a browser. The difference of a threshold is tested by "
      "permuting "
      "participants between lab and web ({} permutations, seed {}); a threshold beyond the levels tested "
      "counts as at "
      "their end. Nobody was assigned to lab or web at random, so a difference may be one of the people.",
      counted(origins.lab.participants, "participant"), origins.web.participants, origins.permutations,
      analysis.resampling.seed);
}

std::string origins_text(const Analysis& analysis) {
  if (!analysis.origins) return "";
  std::vector<std::vector<std::string>> lines = origin_lines(analysis);
  lines.insert(lines.begin(), origin_titles(analysis));
  return "Lab and web\n" + aligned(lines) + origin_sentence(analysis) + "\n\n";
}

}  // namespace seamline::analysis
