#include "analysis/foresight/plan_scenes.h"

#include <fmt/format.h>

#include "analysis/over_scenes/two_spreads.h"
#include "analysis/statistics/distributions.h"
#include "support/files/markdown_table.h"
#include "support/text/counted.h"

namespace seamline::analysis {
namespace {

/// The standard error of which a 95 % interval by Student's t has that length.
double error_of_length(double length, int people) {
  return length / 2 / student_with_above(people - 1.0, (1 - confidence) / 2);
}

CsvTable scenes_plan_table(const StudyPlan& plan) {
  CsvTable table{.name = "scenes",
                 .columns = {{"threshold", "", ""}, {"people", "", ""}, {"these scenes alone", "", ""}},
                 .rows = {}};
  for (const int scenes : planned_scenes) table.columns.push_back({counted(scenes, "scene"), "", ""});
  for (const PlanRow& row : plan.rows) {
    const PlanTarget& target = plan.targets[row.target];
    if (row.level_set != 0 || target.against || !row.interval.within) continue;
    std::vector<CsvValue> cells = {name_of(target, plan.curves), std::to_string(row.participants)};
    const std::optional<double>& length = row.interval.median_length;
    cells.emplace_back(length ? fmt::format("{:.2f}", *length) : std::string("open"));
    for (const int scenes : planned_scenes) {
      if (!length) {
        cells.emplace_back(std::string("open"));
        continue;
      }
      const TwoSpreads spreads = expected_spreads(error_of_length(*length, row.participants),
                                                  row.participants, plan.request.between_scenes, scenes);
      cells.emplace_back(fmt::format("{:.2f}", 2 * spreads.half_like_these()));
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

}  // namespace

std::string scenes_assumed_text(const PlanRequest& request, const LevelAxis& axis) {
  if (!(request.between_scenes > 0)) return "";
  return fmt::format("Assumed of scenes: their thresholds have a standard deviation of {:g} {}.",
                     request.between_scenes, length_unit(axis));
}

std::string scenes_plan_text(const StudyPlan& plan) {
  if (!(plan.request.between_scenes > 0)) return "";
  return fmt::format(
             "\nScenes: length ({}) of the 95 % interval of the mean threshold of scenes like these, over people and "
             "scenes, with the study's {}s.\n",
             length_unit(plan.axis), level_word(plan.axis)) +
         markdown_table(scenes_plan_table(plan)) +
         "With one scene an artifact a study may claim what that scene needs, whatever the number of its objects: "
         "of other scenes it has no interval. Three scenes leave an interval little more than two degrees of freedom, so "
         "more people hardly shorten it.\n";
}

}  // namespace seamline::analysis
