#include "analysis/report/tables/all_tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/report/tables/table_columns.h"

namespace seamline::analysis {
namespace {

CsvTable published_table(const Analysis& analysis) {
  const LevelAxis& axis = analysis.data.axis;
  const std::string unit = std::string(facts(axis.quantity).unit), suffix = unit_suffix(axis);
  const std::string length = length_key(axis);
  CsvTable table{
      .name = "published",
      .columns = {artifact_column,
                  {"quantity", "word", "threshold, as in thresholds_joint.csv"},
                  {"published" + suffix, unit, "published value; empty where none was reported"},
                  {"published_low" + suffix, unit,
                   "lower end of its 95 % interval; empty where taken as exact"},
                  {"published_high" + suffix, unit, "upper end of it"},
                  {"published_n", "", "participants behind it; empty where not known"},
                  {"published_source", "text", "where it stands"},
                  {"estimate" + suffix, unit, "of this study, by the joint model; empty when there is none"},
                  {"inside", "0 or 1", "whether the published value lies in the 95 % interval of this study"},
                  {"difference_" + length, length, "this study less published; positive: the larger level"},
                  {"difference_low_" + length, length, "lower end of its 95 % interval; empty when open"},
                  {"difference_high_" + length, length, "upper end of it; empty when open"},
                  {"margin_" + length, length, "within which thresholds are said to agree"},
                  {"verdict", "text", "agrees within the margin, differs, undecided, or why nothing is said"},
                  source_column},
      .rows = {}};
  std::vector<std::string> conditions;
  for (const ReplicatedThreshold& row : analysis.replication->thresholds) {
    conditions.push_back(row.published.condition);
    table.rows.push_back(
        {std::string(word(row.published.artifact)), row.published.quantity, number(row.published.level),
         number(row.published.low), number(row.published.high),
         row.published.participants ? CsvValue(whole(*row.published.participants)) : CsvValue(),
         row.published.source, number(level_of(row.here, axis)),
         row.difference ? CsvValue(whole(row.inside ? 1 : 0)) : CsvValue(), number(row.difference),
         number(row.low95), number(row.high95), analysis.replication->margin, std::string(word(row.verdict)),
         source_text(analysis)});
  }
  add_conditions(table, has_conditions(analysis.data), conditions);
  return table;
}

CsvTable published_orders_table(const Analysis& analysis) {
  CsvTable table{.name = "published_orders",
                 .columns = {{"quantity", "word", "threshold, as in thresholds_joint.csv"},
                             {"condition", "word", "of the study file; empty where the study has one"},
                             {"published_order", "words", "artifacts by rising published level"},
                             {"order", "words", "the same by rising level of this study"},
                             {"probability", "0 to 1",
                              "that people drawn anew from those of this study have the published order"}},
                 .rows = {}};
  for (const ReplicatedOrder& order : analysis.replication->orders)
    table.rows.push_back({order.quantity, order.condition, fmt::format("{}", fmt::join(order.artifacts, " ")),
                          fmt::format("{}", fmt::join(order.found, " ")), order.probability});
  return table;
}

}  // namespace

std::vector<CsvTable> replication_tables(const Analysis& analysis) {
  if (!analysis.replication) return {};
  return {published_table(analysis), published_orders_table(analysis)};
}

}  // namespace seamline::analysis
