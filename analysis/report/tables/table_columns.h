#pragma once
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/log_analysis/threshold_rows.h"
#include "support/text/csv.h"

namespace seamline::analysis {

// Columns and values that several tables of the report share, so that they are explained once and alike.

inline const CsvColumn artifact_column{"artifact", "word",
                                       "receiver, shadow, occlusion or overlap (types 1 to 4 of the paper)"};
inline const CsvColumn quantity_column{
    "quantity", "word", "PT perceptual threshold, SN slightly noticeable, IP inflection point"};
inline const CsvColumn scene_column{"scene", "text", "name of the scene in the study file"};
inline const CsvColumn object_column{"object", "text", "name of the inserted object"};
inline const CsvColumn index_column{"object_index", "from 1",
                                    "its place from the left: of three, 1 left, 2 middle, 3 right"};
[[nodiscard]] inline CsvColumn level_column(const LevelAxis& axis) {
  if (of_depth_widths(axis)) return {"width_px", "px", "width W of the depth map; its height is W / 2"};
  const QuantityFacts& about = facts(axis.quantity);
  return {level_key(axis), std::string(about.unit),
          std::string(about.name) + (is_linear(axis) ? "" : "; 0 is none")};
}
[[nodiscard]] inline CsvValue level_value(const LevelAxis& axis, double level) {
  return facts(axis.quantity).whole ? CsvValue(static_cast<std::int64_t>(level)) : CsvValue(level);
}
inline const CsvColumn participant_column{"participant", "text", "code"};
inline const CsvColumn source_column{"source", "text", "who answered: participants or simulated observers"};

[[nodiscard]] inline std::int64_t whole(auto value) {
  return static_cast<std::int64_t>(value);
}

/// Puts a column with a condition a row behind the column `artifact`; nothing where the study has one.
inline void add_conditions(CsvTable& table, bool several, const std::vector<std::string>& condition_of_row) {
  if (!several) return;
  std::size_t place = 0;
  while (table.columns[place].name != "artifact") ++place;
  ++place;
  const auto offset = static_cast<std::ptrdiff_t>(place);
  table.columns.insert(table.columns.begin() + offset, {"condition", "word", "of the study file"});
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    table.rows[row].insert(table.rows[row].begin() + offset, CsvValue(condition_of_row[row]));
}

/// Takes out a column that says nothing of this study.
inline void drop_column(CsvTable& table, const std::string& name) {
  for (std::size_t place = 0; place < table.columns.size(); ++place) {
    if (table.columns[place].name != name) continue;
    const auto offset = static_cast<std::ptrdiff_t>(place);
    table.columns.erase(table.columns.begin() + offset);
    for (std::vector<CsvValue>& row : table.rows) row.erase(row.begin() + offset);
    return;
  }
}

/// The number, or an empty cell when it is NaN or infinite (an open end).
[[nodiscard]] inline CsvValue finite(double value) {
  return std::isfinite(value) ? CsvValue(value) : CsvValue(std::monostate{});
}

/// The number, or an empty cell where there is none.
[[nodiscard]] inline CsvValue number(std::optional<double> value) {
  return value ? CsvValue(*value) : CsvValue(std::monostate{});
}

/// The level of an estimate, or an empty cell where there is none.
[[nodiscard]] inline CsvValue number(const std::optional<ThresholdEstimate>& estimate,
                                     const LevelAxis& axis) {
  return number(estimate ? level_of(*estimate, axis) : std::nullopt);
}

}  // namespace seamline::analysis
