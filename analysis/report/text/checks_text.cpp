#include "analysis/report/text/checks_text.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/log_analysis/task_words.h"
#include "analysis/report/text/origins_text.h"
#include "support/text/counted.h"

namespace seamline::analysis {

namespace {

std::string beside_text(const Analysis& analysis) {
  std::vector<std::vector<std::string>> lines = {
      {"artifact", "", "isotonic", "logistic", "corrected for guessing", "one object left out"}};
  for (const ThresholdRow& row : threshold_rows(analysis)) lines.push_back(otherwise_estimated_cells(row));
  return (of_depth_widths(analysis.data.axis) ? std::string("The same widths W in px")
                                              : "The same thresholds, " + axis_title(analysis.data.axis)) +
         ", otherwise estimated (95 % interval)\n" + aligned(lines);
}

std::string screened_text(const Analysis& analysis) {
  std::vector<std::vector<std::string>> lines = screened_lines(analysis);
  lines.insert(lines.begin(), {"thresholds", "artifact", "PT", "SN", "IP"});
  return aligned(lines);
}

}  // namespace

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
  return fmt::format("a = {:.3f} ({}) over {}", sos.a,
                     known ? fmt::format("{:.3f} to {:.3f}", sos.ci95_low, sos.ci95_high)
                           : "no interval from fewer than three people",
                     counted(sos.stimuli, "stimulus", "stimuli"));
}

namespace {

/// How guesses fall on the alternatives of the task.
std::string guesses_text(const Guessers& guessers) {
  const auto percent = [&](std::size_t place) {
    return fmt::format("{:.0f}", 100 * guessers.position[place]);
  };
  const std::string assumed = guessers.position_estimated ? "" : " (assumed)";
  if (guessers.task.right_is_yes)
    return fmt::format("People see something in {} % of the pictures into which nothing was inserted",
                       percent(0));
  const bool in_a_row = guessers.task.pictures > 1;
  if (guessers.task.alternatives > usual_objects) {
    std::string shares;
    for (std::size_t place = 0; place < guessers.position.size(); ++place)
      shares += (place == 0 ? "" : place + 1 == guessers.position.size() ? " and " : ", ") + percent(place);
    return fmt::format("Guessers choose the objects from left to right in {} %{}", shares, assumed);
  }
  if (guessers.task.alternatives == 2)
    return fmt::format("Guessers choose {} in {} and {} %{}",
                       in_a_row ? "first and second" : "left and right", percent(0), percent(1), assumed);
  return fmt::format("Guessers choose {} in {}, {} and {} %{}",
                     in_a_row ? "first, second and third" : "left, middle and right", percent(0), percent(1),
                     percent(2), assumed);
}

}  // namespace

std::string guessers_text(const GuessCorrection& correction) {
  const Guessers& guessers = correction.guessers;
  if (!guessers.known()) return "Nobody chose wrong: there are no guesses to learn from.";
  if (!guessers.task.rates)
    return fmt::format(
        "{} (from {:.0f} wrong choices and {:.0f} reference trials), so that a share of right answers below {:.2f} is not "
        "expected.",
        guesses_text(guessers), guessers.wrong_answers, guessers.reference_answers, correction.floor);
  return fmt::format(
      "{} and rate {:.2f} on average (from {:.0f} wrong choices and {:.0f} reference trials), so that uncorrected noticeability is not "
      "expected below {:.2f}.",
      guesses_text(guessers), guessers.mean_rating(), guessers.wrong_answers, guessers.reference_answers,
      correction.floor);
}

std::string screening_sentence(const Screening& screening) {
  std::string text;
  for (ScreeningRule rule : every_screening_rule) {
    text += text.empty() ? "" : "; ";
    text += word(rule);
    if (rule == ScreeningRule::correlation && !screening.people.empty())
      text += fmt::format(" (limit {})", limit_text(screening));
    if (!screening.judged(rule)) {
      text += fmt::format(" is not judged ({})", why_not_judged(screening, rule));
      continue;
    }
    text += fmt::format(" names {}", screening.named_by(rule).size());
    if (rule != ScreeningRule::attention)
      text += fmt::format(" (it would name {} of honest people)", honest_share_text(screening.honest, rule));
  }
  return fmt::format("Screening of {}: {}.", counted(screening.people.size(), "participant"), text);
}

std::string checks_text(const Analysis& analysis) {
  std::string text;
  if (analysis.origins) text = origins_text(analysis);
  if (!analysis.guessing.curves.empty())
    text += (asks_ratings(analysis.log) ? beside_text(analysis) : std::string()) +
            guessers_text(analysis.guessing) + "\n\n";
  text += screening_sentence(analysis.screening) + "\n";
  if (analysis.screened.size() > 1) text += screened_text(analysis);
  if (std::isnan(analysis.sos.a)) return text;
  return text + "SOS parameter " + sos_text(analysis.sos) + ".\n";
}

}  // namespace seamline::analysis
