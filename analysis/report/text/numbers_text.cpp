#include "analysis/report/text/numbers_text.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/report/text/joint_text.h"
#include "analysis/report/text/replication_text.h"
#include "analysis/report/text/threshold_text.h"

namespace seamline::analysis {

namespace {

std::string choices_text(const ReportNumbers& numbers) {
  const LevelAxis& axis = numbers.axis;
  std::vector<std::vector<std::string>> lines = {{"right choices", "threshold" + unit_suffix(axis), "95 %",
                                                  "width_" + length_key(axis), "lapse", "deviance p",
                                                  "verdict"}};
  std::string missing;
  for (const ChoiceCurve& curve : numbers.choices) {
    if (!curve.pooled) {
      missing += curve.missing + "\n";
      continue;
    }
    const PooledFit& pooled = *curve.pooled;
    const bool known = has_threshold(curve);
    lines.push_back({std::string(word(curve.artifact)) + in_condition(curve.condition),
                     pooled.threshold ? estimated_text(axis, *pooled.threshold) : "-",
                     pooled.threshold ? estimated_text(axis, pooled.threshold_ci95.low) + " to " +
                                            estimated_text(axis, pooled.threshold_ci95.high)
                                      : "-",
                     known ? fmt::format("{:.2f}", pooled.fit.width) : "-",
                     known ? fmt::format("{:.3f}", pooled.fit.function.lapse) : "-",
                     std::isnan(curve.deviance_p) ? "-" : fmt::format("{:.3f}", curve.deviance_p),
                     pooled.verdict.text});
  }
  return (lines.size() > 1 ? aligned(lines) : "") + missing;
}

std::string comparisons_text(const Analysis& analysis, const ReportNumbers& numbers) {
  if (!analysis.joint || analysis.adaptive) {
    std::string text = numbers.comparisons_missing + "\n";
    for (const std::string& sentence : joint_check_sentences(analysis)) text += sentence + "\n";
    return text;
  }
  std::string text;
  for (const std::string& sentence : joint_conclusions(analysis, numbers)) text += "  " + sentence + "\n";
  if (!text.empty()) text = "Comparisons (joint model, adjusted p):\n" + text + "\n";
  for (const std::string& sentence : joint_check_sentences(analysis)) text += sentence + "\n";
  return text + trend_sentence(numbers.order) + "\n";
}

std::string times_text(const ReportNumbers& numbers) {
  if (!numbers.times.missing.empty()) return numbers.times.missing + "\n";
  std::vector<std::vector<std::string>> lines = {{"response times", "answers", "median_s", "quartiles_s"}};
  for (const ResponseTime& row : numbers.times.rows)
    if (!row.artifact && row.which == TimedAnswers::all)
      lines.push_back({level_text(numbers.axis.quantity, row.level), std::to_string(row.answers),
                       fmt::format("{:.2f}", row.choice.median_s),
                       fmt::format("{:.2f} to {:.2f}", row.choice.lower_s, row.choice.upper_s)});
  return aligned(lines);
}

}  // namespace

std::string numbers_text(const Analysis& analysis, const ReportNumbers& numbers) {
  std::string text = choices_text(numbers);
  if (!numbers.tracks.empty()) text += "\n" + study::tracks_text(numbers.tracks);
  return text + "\n" + replication_text(analysis) + comparisons_text(analysis, numbers) + "\n" +
         times_text(numbers);
}

}  // namespace seamline::analysis
