#include "analysis/report/tables/tables.h"

#include <cmath>
#include <map>

#include "analysis/report/numbers/threshold_rows.h"
#include "analysis/report/tables/table_columns.h"

namespace seamline::analysis {

namespace {

const std::vector<CsvColumn> mean_columns = {
    {"n", "participants", "participants in the mean"},
    {"mean", "noticeability 0 to 4", "mean over participants; 0 is a wrong choice, else the rating"},
    {"sem", "noticeability", "standard error of the mean over participants; empty with one participant"},
    {"correct", "share 0 to 1", "share of right choices; 1/3 is chance"}};

CsvValue px(std::optional<double> value) {
  return value ? CsvValue(*value) : CsvValue(std::monostate{});
}

CsvValue px(const std::optional<WidthEstimate>& estimate) {
  return estimate && estimate->log2_px ? CsvValue(std::exp2(*estimate->log2_px)) : CsvValue(std::monostate{});
}

std::vector<CsvColumn> with_means(std::vector<CsvColumn> columns) {
  columns.insert(columns.end(), mean_columns.begin(), mean_columns.end());
  return columns;
}

CsvTable cells_table(const Analysis& analysis) {
  CsvTable table{
      .name = "cells",
      .columns = with_means({artifact_column, scene_column, object_column, index_column, width_column}),
      .rows = {}};
  table.columns.push_back(source_column);
  for (const ObjectCurve& object : analysis.data.objects)
    for (const CellMean& cell : object.cells)
      table.rows.push_back({std::string(word(object.artifact)), object.scene, object.object,
                            whole(object.object_index), whole(cell.width_px), whole(cell.n), cell.mean,
                            cell.sem, cell.correct, source_text(analysis)});
  return table;
}

CsvTable curves_table(const Analysis& analysis) {
  CsvTable table{.name = "curves", .columns = with_means({artifact_column, width_column}), .rows = {}};
  table.columns.push_back(
      {"isotonic", "noticeability", "non-increasing isotonic fit, linear between widths in log2 W"});
  table.columns.push_back({"logistic", "noticeability", "least-squares four-parameter logistic in log2 W"});
  table.columns.push_back(source_column);
  for (std::size_t i = 0; i < analysis.thresholds.size(); ++i) {
    const ArtifactScores& scores = analysis.data.artifacts[i];
    const CurveThresholds& fits = analysis.thresholds[i].estimates;
    for (std::size_t w = 0; w < scores.cells.size(); ++w) {
      const CellMean& cell = scores.cells[w];
      table.rows.push_back({std::string(word(scores.artifact)), whole(cell.width_px), whole(cell.n),
                            cell.mean, cell.sem, cell.correct, fits.isotonic.value[w],
                            value_at(fits.logistic.curve, std::log2(cell.width_px)), source_text(analysis)});
    }
  }
  return table;
}

CsvTable thresholds_table(const Analysis& analysis) {
  CsvTable table{
      .name = "thresholds",
      .columns = {artifact_column,
                  {"quantity", "word",
                   "PT perceptual threshold, SN slightly noticeable, IP inflection point"},
                  {"level", "noticeability", "mean noticeability at the threshold; empty for IP"},
                  {"estimate_px", "px", "width W; empty when there is none, see reason"},
                  {"ci95_low_px", "px", "lower end of the 95 % interval; empty when open, see ci95_text"},
                  {"ci95_high_px", "px", "upper end of the 95 % interval; empty when open, see ci95_text"},
                  {"ci95_text", "text", "the interval in words"},
                  {"reason", "text", "why there is no estimate"},
                  {"estimate_texels_per_degree", "1/degree", "W / 360"},
                  {"paper_px", "px", "published value (Table 1 of the paper); empty where it has a dash"},
                  {"planted_px", "px", "what simulated observers were made of; not the paper's"},
                  source_column},
      .rows = {}};
  for (const ThresholdRow& row : threshold_rows(analysis)) {
    const std::optional<double> estimate =
        row.here.log2_px ? std::optional(std::exp2(*row.here.log2_px)) : std::nullopt;
    table.rows.push_back({std::string(word(row.artifact)), row.quantity, px(row.level), px(estimate),
                          px(bound_px(row.here.ci95.low_log2_px)), px(bound_px(row.here.ci95.high_log2_px)),
                          interval_text(row.here.ci95, row.smallest_px, row.largest_px), row.here.reason,
                          estimate ? px(*estimate / 360) : CsvValue(std::monostate{}),
                          row.paper_px ? CsvValue(whole(*row.paper_px)) : CsvValue(std::monostate{}),
                          px(row.planted), source_text(analysis)});
  }
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
                             width_column,
                             {"chosen_index", "1 to 3", "the object that was chosen"},
                             {"rating", "1 to 4", "asked on every trial"},
                             {"correct", "0 or 1", "whether the inserted object was chosen"},
                             {"noticeability", "0 to 4", "0 when the choice is wrong, else the rating"},
                             {"choice_s", "s", "from the image to the choice; 0 when simulated"},
                             {"rating_s", "s", "from the image to the rating; 0 when simulated"}},
                 .rows = {}};
  std::map<std::string, Use> use_of;
  for (const ParticipantUse& person : analysis.people) use_of[person.record.code] = person.use;
  for (const study::Answer& answer : analysis.log.answers)
    table.rows.push_back(
        {answer.participant, std::string(word(use_of[answer.participant])), whole(answer.trial_index),
         answer.stimulus_id, answer.scene, std::string(word(answer.artifact)), answer.object,
         whole(answer.object_index), whole(answer.depth_width_px), whole(answer.chosen_index),
         whole(answer.rating), whole(answer.correct() ? 1 : 0), whole(answer.noticeability()),
         static_cast<double>(answer.choice_ns) * 1e-9, static_cast<double>(answer.rating_ns) * 1e-9});
  return table;
}

}  // namespace

std::vector<CsvTable> report_tables(const Analysis& analysis) {
  return {cells_table(analysis), curves_table(analysis), thresholds_table(analysis), answers_table(analysis)};
}

}  // namespace seamline::analysis
