#include "analysis/report/tables/all_tables.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "analysis/report/tables/table_columns.h"
#include "analysis/report/text/threshold_text.h"
#include "analysis/scores/level_words.h"
#include "analysis/thresholds/angular_resolution.h"

namespace seamline::analysis {

namespace {

const std::vector<CsvColumn> mean_columns = {
    {"n", "participants", "participants in the mean"},
    {"mean", "noticeability 0 to 4", "mean over participants; 0 is a wrong choice, else the rating"},
    {"sem", "noticeability", "standard error of the mean over participants; empty with one participant"},
    {"correct", "share 0 to 1", "share of right choices; 1/3 is chance"}};

std::vector<CsvColumn> with_means(std::vector<CsvColumn> columns) {
  columns.insert(columns.end(), mean_columns.begin(), mean_columns.end());
  return columns;
}

CsvTable cells_table(const Analysis& analysis) {
  const LevelAxis& axis = analysis.data.axis;
  std::vector<std::string> conditions;
  CsvTable table{
      .name = "cells",
      .columns = with_means({artifact_column, scene_column, object_column, index_column, level_column(axis)}),
      .rows = {}};
  table.columns.push_back(source_column);
  for (const ObjectCurve& object : analysis.data.objects)
    for (const CellMean& cell : object.cells) {
      table.rows.push_back({std::string(word(object.artifact)), object.scene, object.object,
                            whole(object.object_index), level_value(axis, cell.level), whole(cell.n),
                            cell.mean, cell.sem, cell.correct, source_text(analysis)});
      conditions.push_back(object.condition);
    }
  add_conditions(table, has_conditions(analysis.data), conditions);
  return table;
}

CsvTable curves_table(const Analysis& analysis) {
  const LevelAxis& axis = analysis.data.axis;
  const LevelWords words = level_words(axis);
  std::vector<std::string> conditions;
  CsvTable table{.name = "curves", .columns = with_means({artifact_column, level_column(axis)}), .rows = {}};
  table.columns.push_back({"isotonic", "noticeability",
                           fmt::format("{} isotonic fit, linear between {} in {}", words.monotone,
                                       words.levels, words.short_axis)});
  table.columns.push_back(
      {"logistic", "noticeability", "least-squares four-parameter logistic in " + words.short_axis});
  table.columns.push_back(source_column);
  for (std::size_t i = 0; i < analysis.thresholds.size(); ++i) {
    const ArtifactScores& scores = analysis.data.artifacts[i];
    const CurveThresholds& fits = analysis.thresholds[i].estimates;
    for (std::size_t w = 0; w < scores.cells.size(); ++w) {
      const CellMean& cell = scores.cells[w];
      const bool apart = stands_apart(axis, cell.level);
      table.rows.push_back({std::string(word(scores.artifact)), level_value(axis, cell.level), whole(cell.n),
                            cell.mean, cell.sem, cell.correct,
                            apart ? CsvValue(std::monostate{}) : CsvValue(fits.isotonic.value[w]),
                            apart ? CsvValue(std::monostate{})
                                  : CsvValue(value_at(fits.logistic.curve, x_of(axis, cell.level))),
                            source_text(analysis)});
      conditions.push_back(scores.condition);
    }
  }
  add_conditions(table, has_conditions(analysis.data), conditions);
  return table;
}

CsvTable people_curves_table(const Analysis& analysis) {
  const LevelAxis& axis = analysis.data.axis;
  std::vector<std::string> conditions;
  CsvTable table{.name = "curves_people",
                 .columns = {participant_column,
                             artifact_column,
                             level_column(axis),
                             {"mean", "noticeability 0 to 4", "the participant's mean over objects"}},
                 .rows = {}};
  for (const ArtifactScores& scores : analysis.data.artifacts)
    for (std::size_t person = 0; person < scores.people.size(); ++person)
      for (std::size_t w = 0; w < scores.level.size(); ++w) {
        const double mean =
            scores.noticeability(static_cast<Eigen::Index>(person), static_cast<Eigen::Index>(w));
        if (std::isnan(mean)) continue;
        table.rows.push_back({scores.people[person], std::string(word(scores.artifact)),
                              level_value(axis, scores.level[w]), mean});
        conditions.push_back(scores.condition);
      }
  add_conditions(table, has_conditions(analysis.data), conditions);
  return table;
}

CsvTable thresholds_table(const Analysis& analysis) {
  const LevelAxis& axis = analysis.data.axis;
  const std::string suffix = unit_suffix(axis), unit(facts(axis.quantity).unit);
  std::vector<std::string> conditions;
  // Where the level itself is texels per degree, the estimate has that name.
  const std::string per_degree = of_depth_widths(axis) ? "estimate_texels_per_degree" : "of no width";
  CsvTable table{
      .name = "thresholds",
      .columns =
          {artifact_column,
           {"quantity", "word", "PT perceptual threshold, SN slightly noticeable, IP inflection point"},
           {"level", "noticeability", "mean noticeability at the threshold; empty for IP"},
           {"estimate" + suffix, unit, level_words(axis).symbol + "; empty when there is none, see reason"},
           {"ci95_low" + suffix, unit, "lower end of the 95 % interval; empty when open, see ci95_text"},
           {"ci95_high" + suffix, unit, "upper end of the 95 % interval; empty when open, see ci95_text"},
           {"ci95_text", "text", "the interval in words"},
           {"reason", "text", "why there is no estimate"},
           {per_degree, "1/degree", "W / 360"},
           {"paper_px", "px", "published value (Table 1 of the paper); empty where it has a dash"},
           {"planted" + suffix, unit,
            "where simulated observers' expected mean truly crosses; not the paper's"},
           {"planted_limit" + suffix, unit,
            "what the estimate approaches with ever more of them; less planted: the design's bias"},
           source_column},
      .rows = {}};
  for (const ThresholdRow& row : threshold_rows(analysis)) {
    const std::optional<double> estimate = level_of(row.here, axis);
    const LevelRange ci95 = range_at(axis, row.here.ci95);
    table.rows.push_back({std::string(word(row.artifact)), row.quantity, number(row.level), number(estimate),
                          number(closed(ci95.low)), number(closed(ci95.high)),
                          interval_text(row.here.ci95, row.tested), reason_text(row.here, axis),
                          estimate ? number(texels_per_degree(*estimate)) : CsvValue(std::monostate{}),
                          row.paper_px ? CsvValue(whole(*row.paper_px)) : CsvValue(std::monostate{}),
                          number(planted_level(row)), number(row.limit, axis), source_text(analysis)});
    conditions.push_back(row.condition);
  }
  if (!of_depth_widths(axis)) drop_column(table, per_degree);
  if (!beside_the_paper(analysis)) drop_column(table, "paper_px");
  add_conditions(table, has_conditions(analysis.data), conditions);
  return table;
}

CsvTable answers_table(const Analysis& analysis) {
  CsvTable table{.name = "answers",
                 .columns = {participant_column,
                             {"use", "word", "what became of the participant, see participants.csv"},
                             {"trial_index", "count", "0-based place in the participant's order"},
                             {"stimulus_id", "text", "id in the set's manifest"},
                             scene_column,
                             artifact_column,
                             object_column,
                             index_column,
                             level_column(analysis.data.axis),
                             {"chosen_index", "from 1", "the object that was chosen"},
                             {"rating", "1 to 4", "asked on every trial"},
                             {"correct", "0 or 1", "whether the inserted object was chosen"},
                             {"noticeability", "0 to 4", "0 when the choice is wrong, else the rating"},
                             {"choice_s", "s", "from the image to the choice; 0 when simulated"},
                             {"rating_s", "s", "from the image to the rating; 0 when simulated"}},
                 .rows = {}};
  std::vector<std::string> conditions;
  std::map<std::string, Use> use_of;
  for (const ParticipantUse& person : analysis.people) use_of[person.record.code] = person.use;
  for (const study::Answer& answer : analysis.log.answers) {
    conditions.push_back(answer.condition);
    table.rows.push_back({answer.participant, std::string(word(use_of[answer.participant])),
                          whole(answer.trial_index), answer.stimulus_id, answer.scene,
                          std::string(word(answer.artifact)), answer.object, whole(answer.object_index),
                          level_value(analysis.data.axis, answer.level), whole(answer.chosen_index),
                          whole(answer.rating), whole(answer.correct() ? 1 : 0),
                          whole(answer.noticeability()), answer.choice_ns * 1e-9, answer.rating_ns * 1e-9});
  }
  add_conditions(table, has_conditions(analysis.data), conditions);
  return table;
}

}  // namespace

std::vector<CsvTable> noticeability_tables(const Analysis& analysis) {
  return {cells_table(analysis), curves_table(analysis), people_curves_table(analysis),
          thresholds_table(analysis), answers_table(analysis)};
}

}  // namespace seamline::analysis
