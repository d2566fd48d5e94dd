#include "analysis/report/text/scenes_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/report/text/threshold_text.h"

namespace seamline::analysis {
namespace {

std::string end_text(const LevelAxis& axis, double level) {
  return std::isfinite(level) ? estimated_text(axis, level) : "open";
}

std::string mean_range_text(const LevelAxis& axis, const LevelInterval& interval) {
  const LevelRange range = range_at(axis, interval);
  return end_text(axis, range.low) + " to " + end_text(axis, range.high);
}

std::string length_text(const LevelAxis& axis, double length_x) {
  return std::isfinite(length_x) ? fmt::format("{:.2f}", std::abs(difference_at(axis, length_x))) : "–";
}

std::string scenes_curve_name(const CurveOverScenes& curve) {
  return std::string(word(curve.artifact)) + in_condition(curve.condition);
}

/// "receiver: thresholds of people differ by 0.50 octaves ..."; empty without a fit.
std::string spread_sentence(const CurveOverScenes& curve, const LevelAxis& axis) {
  if (!std::isfinite(curve.between_people)) return "";
  return fmt::format(
      "{}: the thresholds of {} people have a standard deviation of {} {}, and from scene to scene a person's "
      "differs by {} beside what scenes do to everybody.",
      scenes_curve_name(curve), curve.people, length_text(axis, curve.between_people), length_unit(axis),
      length_text(axis, curve.people_by_scenes));
}

}  // namespace

std::vector<std::string> scenes_titles(const LevelAxis& axis) {
  return {"artifact",
          "threshold",
          "scenes",
          "mean" + unit_suffix(axis),
          "these scenes (95 %)",
          "scenes like these (95 %)",
          "between scenes, " + length_unit(axis)};
}

std::vector<std::vector<std::string>> scenes_lines(const ReportNumbers& numbers) {
  const LevelAxis& axis = numbers.axis;
  std::vector<std::vector<std::string>> lines;
  for (const CurveOverScenes& curve : numbers.over_scenes)
    for (const ThresholdOverScenes& found : curve.thresholds) {
      std::vector<std::string> line = {scenes_curve_name(curve), std::string(word(found.quantity)),
                                       std::to_string(curve.scenes.size())};
      if (found.reason.empty())
        line.insert(line.end(), {estimated_text(axis, level_at(axis, found.spreads.mean_x)),
                                 mean_range_text(axis, found.these), mean_range_text(axis, found.like_these),
                                 length_text(axis, found.spreads.between_scenes)});
      else
        line.insert(line.end(), {found.reason, "–", "–", "–"});
      lines.push_back(std::move(line));
    }
  return lines;
}

std::vector<std::string> scenes_sentences(const ReportNumbers& numbers) {
  if (numbers.over_scenes.empty()) return {};
  std::vector<std::string> sentences;
  for (const CurveOverScenes& curve : numbers.over_scenes)
    if (std::string sentence = spread_sentence(curve, numbers.axis); !sentence.empty())
      sentences.push_back(std::move(sentence));
  sentences.emplace_back(
      "What may be claimed: the interval of these scenes is of people, and says nothing of other scenes. The "
      "interval of scenes like these is of the mean over all scenes from which these are a fair sample. One "
      "further scene may lie farther off: one in three lies more than the standard deviation between scenes "
      "from the mean.");
  return sentences;
}

std::string scenes_method(const ReportNumbers& numbers) {
  if (numbers.over_scenes.empty()) return "";
  return fmt::format(
      "Where an artifact was shown in {} scenes or more, its scenes were taken as a sample of scenes like them. The "
      "joint model was fitted to the artifact with a threshold for each scene and everything else in common. Of these "
      "thresholds stand the mean (along the axis of levels), the standard deviation between scenes with the noise of "
      "people taken out, and two intervals of the mean: over people for these scenes, and over people and scenes. The "
      "second has the variance over people and that over scenes less their common part (Cameron, Gelbach and Miller, "
      "2011), and Student's t with Satterthwaite's degrees of freedom.",
      fewest_scenes);
}

std::string scenes_text(const ReportNumbers& numbers) {
  if (numbers.over_scenes.empty()) return "";
  std::vector<std::vector<std::string>> lines = {scenes_titles(numbers.axis)};
  for (std::vector<std::string>& line : scenes_lines(numbers)) lines.push_back(std::move(line));
  std::string text = "\nThresholds over scenes\n" + aligned(lines);
  for (const std::string& sentence : scenes_sentences(numbers)) text += sentence + "\n";
  return text;
}

}  // namespace seamline::analysis
