#include "analysis/report/page/checks_text.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/report/numbers/threshold_rows.h"
#include "analysis/report/page/checks_lines.h"

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

std::string guessers_text(const GuessCorrection& correction) {
  const Guessers& guessers = correction.guessers;
  if (!guessers.known()) return "Nobody chose wrong: there are no guesses to learn from.";
  return fmt::format(
      "Guessers choose left, middle and right in {:.0f}, {:.0f} and {:.0f} %{} and rate {:.2f} on average "
      "(from {:.0f} wrong choices and {:.0f} reference trials), so that uncorrected noticeability does not "
      "fall below {:.2f}.",
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
    text = beside_text(analysis) + guessers_text(analysis.guessing) + "\n\n";
  text += screening_sentence(analysis.screening) + "\n";
  if (analysis.screened.size() > 1) text += screened_text(analysis);
  if (std::isnan(analysis.sos.a)) return text;
  return text + "SOS parameter " + sos_text(analysis.sos) + ".\n";
}

}  // namespace seamline::analysis
