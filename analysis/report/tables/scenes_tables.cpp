#include "analysis/report/tables/all_tables.h"

#include "analysis/report/tables/table_columns.h"
#include "analysis/scores/level_words.h"

namespace seamline::analysis {
namespace {

CsvValue spread_cell(const LevelAxis& axis, double length_x) {
  return finite(std::abs(difference_at(axis, length_x)));
}

CsvTable thresholds_over_scenes_table(const Analysis& analysis, const ReportNumbers& numbers) {
  const LevelAxis& axis = numbers.axis;
  const std::string suffix = unit_suffix(axis), unit(facts(axis.quantity).unit), length = length_key(axis);
  CsvTable table{
      .name = "thresholds_over_scenes",
      .columns = {artifact_column,
                  {"quantity", "word", "threshold, as in thresholds_joint.csv"},
                  {"scenes", "count", "in which the artifact was shown"},
                  {"participants", "count", "on the curve"},
                  {"mean" + suffix, unit,
                   "mean of the scenes' thresholds along the axis; empty when there is none, see reason"},
                  {"these_low" + suffix, unit,
                   "lower end of its 95 % interval over participants, for these scenes; empty when open"},
                  {"these_high" + suffix, unit, "upper end of it"},
                  {"like_these_low" + suffix, unit,
                   "lower end of its 95 % interval over participants and scenes; empty when open"},
                  {"like_these_high" + suffix, unit, "upper end of it"},
                  {"between_scenes_" + length, length,
                   "standard deviation of thresholds between scenes, without the noise of people"},
                  {"between_people_" + length, length,
                   "standard deviation of a person's thresholds, alike in all scenes"},
                  {"people_by_scenes_" + length, length,
                   "standard deviation of a person's threshold from scene to scene beside both"},
                  {"degrees_of_freedom", "count", "of the interval over participants and scenes"},
                  {"reason", "text", "why there is no number"},
                  source_column},
      .rows = {}};
  std::vector<std::string> conditions;
  for (const CurveOverScenes& curve : numbers.over_scenes)
    for (const ThresholdOverScenes& found : curve.thresholds) {
      const LevelRange these = range_at(axis, found.these), like = range_at(axis, found.like_these);
      const bool known = found.reason.empty();
      table.rows.push_back(
          {std::string(word(curve.artifact)), std::string(word(found.quantity)), whole(curve.scenes.size()),
           whole(curve.people), known ? finite(level_at(axis, found.spreads.mean_x)) : finite(nan),
           number(closed(these.low)), number(closed(these.high)), number(closed(like.low)),
           number(closed(like.high)), spread_cell(axis, found.spreads.between_scenes),
           spread_cell(axis, curve.between_people), spread_cell(axis, curve.people_by_scenes),
           finite(found.spreads.degrees), found.reason, source_text(analysis)});
      conditions.push_back(curve.condition);
    }
  add_conditions(table, numbers.conditions, conditions);
  return table;
}

CsvTable thresholds_scenes_table(const ReportNumbers& numbers) {
  const LevelAxis& axis = numbers.axis;
  const std::string suffix = unit_suffix(axis), unit(facts(axis.quantity).unit);
  CsvTable table{.name = "thresholds_scenes",
                 .columns = {artifact_column,
                             scene_column,
                             {"quantity", "word", "threshold, as in thresholds_joint.csv"},
                             {"estimate" + suffix, unit,
                              "threshold in this scene; empty when there is none, see reason"},
                             {"ci95_low" + suffix, unit,
                              "lower end of its 95 % interval over participants; empty when open"},
                             {"ci95_high" + suffix, unit, "upper end of it"},
                             {"reason", "text", "why there is no estimate"}},
                 .rows = {}};
  std::vector<std::string> conditions;
  for (const CurveOverScenes& curve : numbers.over_scenes)
    for (const ThresholdOverScenes& found : curve.thresholds)
      for (const SceneThreshold& one : found.scenes) {
        const LevelRange ci95 = range_at(axis, one.here.ci95);
        table.rows.push_back({std::string(word(curve.artifact)), one.scene, std::string(word(found.quantity)),
                              number(level_of(one.here, axis)), number(closed(ci95.low)),
                              number(closed(ci95.high)), reason_text(one.here, axis)});
        conditions.push_back(curve.condition);
      }
  add_conditions(table, numbers.conditions, conditions);
  return table;
}

}  // namespace

std::vector<CsvTable> scenes_tables(const Analysis& analysis, const ReportNumbers& numbers) {
  if (numbers.over_scenes.empty()) return {};
  return {thresholds_over_scenes_table(analysis, numbers), thresholds_scenes_table(numbers)};
}

}  // namespace seamline::analysis
