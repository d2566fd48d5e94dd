#include "analysis/report/tables/all_tables.h"

#include <fmt/format.h>

#include "analysis/report/tables/table_columns.h"

namespace seamline::analysis {

CsvTable order_table(const Analysis& analysis, const ReportNumbers& numbers) {
  const SessionOrder& order = numbers.order;
  CsvTable table{
      .name = "order",
      .columns = {{"part", "word",
                   "third or tenth of a participant's answers; last_less_first: last third less first; "
                   "trend: last answer less first, by a straight line"},
                  {"from", "share 0 to 1", "beginning of the part, as a share of the session"},
                  {"to", "share 0 to 1", "its end"},
                  {"answers", "count", "answers in it"},
                  {"mean", "noticeability",
                   "mean score, or difference, what was shown and who was asked being equal"},
                  {"low", "noticeability", "lower end of the 95 % interval over participants"},
                  {"high", "noticeability", "upper end of it"},
                  source_column},
      .rows = {}};
  const auto add = [&](const char* part, const std::vector<SessionPart>& parts) {
    for (const SessionPart& one : parts)
      table.rows.push_back({std::string(part), one.from, one.to, whole(one.answers), one.mean,
                            finite(one.ci95.low), finite(one.ci95.high), source_text(analysis)});
  };
  if (!order.missing.empty()) return table;
  add("third", order.thirds);
  add("tenth", order.tenths);
  for (const auto& [part, value, ci95] :
       {std::tuple{"last_less_first", order.last_less_first, order.last_less_first_ci95},
        std::tuple{"trend", order.trend, order.trend_ci95}})
    table.rows.push_back({std::string(part), 0.0, 1.0, whole(order.answers), value, finite(ci95.low),
                          finite(ci95.high), source_text(analysis)});
  return table;
}

CsvTable residuals_table(const ReportNumbers& numbers) {
  const SessionOrder& order = numbers.order;
  std::vector<std::string> conditions;
  CsvTable table{
      .name = "residuals",
      .columns = {{"what", "word", "participant or object"},
                  {"name", "text", "the participant's code, or the object's name"},
                  artifact_column,
                  scene_column,
                  index_column,
                  {"answers", "count", "answers behind it"},
                  {"mean", "noticeability",
                   "mean residual: of a participant, less the mean over participants at the same "
                   "stimuli; of an object, less the mean over the artifact's objects at the same levels"},
                  {"low", "noticeability",
                   "lower end of its 95 % interval: over the participant's answers, or over participants"},
                  {"high", "noticeability", "upper end of it"}},
      .rows = {}};
  for (const MeanResidual& one : order.people_residuals) {
    table.rows.push_back({std::string("participant"), one.name, std::string(), std::string(),
                          CsvValue(std::monostate{}), whole(one.answers), one.mean, finite(one.ci95.low),
                          finite(one.ci95.high)});
    conditions.emplace_back();
  }
  for (const MeanResidual& one : order.object_residuals) {
    table.rows.push_back({std::string("object"), one.name, std::string(word(one.artifact)), one.scene,
                          whole(one.object_index), whole(one.answers), one.mean, finite(one.ci95.low),
                          finite(one.ci95.high)});
    conditions.push_back(one.condition);
  }
  add_conditions(table, numbers.conditions, conditions);
  return table;
}

}  // namespace seamline::analysis
