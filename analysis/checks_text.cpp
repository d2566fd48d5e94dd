#include "analysis/checks_text.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/threshold_rows.h"

namespace seamline {

namespace {

std::string beside_table(const Analysis& analysis) {
  std::vector<std::vector<std::string>> lines = {
      {"artifact", "", "isotonic", "logistic", "corrected for guessing", "one object left out"}};
  for (const ThresholdRow& row : threshold_rows(analysis)) {
    const auto text = [&](const WidthEstimate& estimate) {
      return estimate_text(estimate, row.smallest_px, row.largest_px);
    };
    const bool inflection = row.quantity == "IP";
    lines.push_back(
        {row.quantity == "PT" ? artifact_title(row.artifact) : "", row.quantity,
         inflection ? "" : text(row.here),
         inflection     ? text(row.here)
         : row.logistic ? text(*row.logistic)
                        : "",
         text(row.corrected),
         row.object_range ? interval_text(*row.object_range, row.smallest_px, row.largest_px) : ""});
  }
  return "The same widths W in px, otherwise estimated (95 % interval)\n" + aligned(lines);
}

std::string screened_table(const Analysis& analysis) {
  std::vector<std::vector<std::string>> lines = {{"thresholds", "artifact", "PT", "SN", "IP"}};
  for (const ScreenedThresholds& result : analysis.screened)
    for (const ArtifactThresholds& thresholds : result.thresholds) {
      const ArtifactScores* scores = nullptr;
      for (const ArtifactScores& each : analysis.data.artifacts)
        if (each.artifact == thresholds.artifact) scores = &each;
      if (scores == nullptr) continue;
      const auto text = [&](const WidthEstimate& estimate) {
        return estimate_text(estimate, scores->width_px.front(), scores->width_px.back());
      };
      const bool first = &thresholds == &result.thresholds.front();
      lines.push_back({first ? who_text(result, analysis) : "", std::string(word(thresholds.artifact)),
                       text(thresholds.estimates.perceptual), text(thresholds.estimates.slightly_noticeable),
                       text(thresholds.estimates.inflection)});
    }
  return aligned(lines);
}

}  // namespace

std::string who_text(const ScreenedThresholds& result, const Analysis& analysis) {
  if (result.left_out.empty()) return fmt::format("{} ({})", result.who, analysis.screening.people.size());
  std::string codes;
  for (const std::string& code : result.left_out) codes += (codes.empty() ? "" : ", ") + code;
  return fmt::format("{} ({} left out: {})", result.who, result.left_out.size(), codes);
}

std::string guessers_text(const GuessCorrection& correction) {
  const Guessers& guessers = correction.guessers;
  if (!guessers.known()) return "Nobody chose wrong: there are no guesses to learn from.";
  return fmt::format(
      "Guessers choose left, middle and right in {:.0f}, {:.0f} and {:.0f} %{} and rate {:.2f} on average "
      "(from "
      "{:.0f} wrong choices and {:.0f} reference trials), so that uncorrected noticeability does not fall "
      "below "
      "{:.2f}.",
      100 * guessers.position[0], 100 * guessers.position[1], 100 * guessers.position[2],
      guessers.position_estimated ? "" : " (assumed)", guessers.mean_rating(), guessers.wrong_answers,
      guessers.reference_answers, correction.floor);
}

std::string screening_sentence(const Screening& screening) {
  std::string text;
  for (Screen screen : every_screen) {
    const bool judged = screen != Screen::attention || screening.catch_trials;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", word(screen),
                        judged ? fmt::format("names {}", screening.named_by(screen).size())
                               : std::string("is not judged (no catch trials)"));
  }
  return fmt::format("Screening of {} participants: {}.", screening.people.size(), text);
}

std::string checks_text(const Analysis& analysis) {
  std::string text;
  if (!analysis.guessing.curves.empty())
    text = beside_table(analysis) + guessers_text(analysis.guessing) + "\n\n";
  text += screening_sentence(analysis.screening) + "\n";
  if (analysis.screened.size() > 1) text += screened_table(analysis);
  if (std::isnan(analysis.sos.a)) return text;
  return text + fmt::format("SOS parameter a = {:.3f} ({:.3f} to {:.3f}) over {} stimuli.\n", analysis.sos.a,
                            analysis.sos.ci95_low, analysis.sos.ci95_high, analysis.sos.stimuli);
}

}  // namespace seamline
