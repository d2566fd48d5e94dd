#include "study/log/recovery/log_rows.h"

#include <algorithm>

namespace seamline::study {
namespace {

/// Version 3 put its columns behind those that were there.
void fill_behind(LogRow& row, std::size_t columns_before, const LogRow& missing) {
  if (row.size() < columns_before) return;  // no row of a log's
  row.resize(std::max(row.size(), columns_before + missing.size()));
  for (std::size_t i = 0; i < missing.size(); ++i)
    if (std::holds_alternative<std::monostate>(row[columns_before + i])) row[columns_before + i] = missing[i];
}

}  // namespace

LogRow row_of(SQLite::Statement& statement) {
  LogRow row;
  for (int i = 0; i < statement.getColumnCount(); ++i) {
    const SQLite::Column column = statement.getColumn(i);
    if (column.isNull())
      row.emplace_back();
    else if (column.isInteger())
      row.emplace_back(column.getInt64());
    else if (column.isFloat())
      row.emplace_back(column.getDouble());
    else
      row.emplace_back(column.getString());
  }
  return row;
}

void bind_row(SQLite::Statement& statement, const LogRow& row) {
  statement.reset();
  statement.clearBindings();
  for (std::size_t i = 0; i < row.size(); ++i) {
    const int place = static_cast<int>(i) + 1;
    if (const auto* whole = std::get_if<std::int64_t>(&row[i])) statement.bind(place, *whole);
    if (const auto* real = std::get_if<double>(&row[i])) statement.bind(place, *real);
    if (const auto* text = std::get_if<std::string>(&row[i])) statement.bind(place, *text);
  }
}

LogRow row_of_today(const std::string& table, LogRow row) {
  constexpr std::size_t study_columns = 7, stimuli_columns = 9, width = 6;
  if (table == "study")
    fill_behind(row, study_columns, {std::string("depth_width_px"), std::string("falls")});
  if (table == "stimuli" && row.size() >= stimuli_columns) {
    const auto* width_px = std::get_if<std::int64_t>(&row[width]);
    fill_behind(row, stimuli_columns,
                {std::string(), width_px == nullptr ? LogValue() : static_cast<double>(*width_px)});
  }
  return row;
}

const std::vector<LogTable>& log_tables() {
  static const std::vector<LogTable> tables = {
      {"study", {"id"}},
      {"stimuli", {"stimulus"}},
      {"participants", {"participant"}},
      {"sessions", {"session"}},
      {"displays", {"session"}},
      {"consent_texts", {"text_sha256"}},
      {"consents", {"participant"}},
      {"declines", {"decline"}},
      {"form_answers", {"participant", "field"}},
      {"trials", {"participant", "trial_index"}},
      {"answers", {"participant", "trial_index"}},
      {"training_answers", {"session", "training_index"}},
      {"set_aside_answers", {"participant", "attempt", "trial_index"}},
      {"events", {"event"}},
      {"deletions", {"deletion"}}};
  return tables;
}

const std::vector<LogTable>& online_log_tables() {
  static const std::vector<LogTable> tables = {{"online_participants", {"participant"}},
                                               {"online_messages", {"id"}},
                                               {"online_sittings", {"session"}},
                                               {"online_tokens", {"token_sha256"}}};
  return tables;
}

std::vector<LogTable> log_tables_with(bool online) {
  std::vector<LogTable> tables = log_tables();
  if (online) tables.insert(tables.end(), online_log_tables().begin(), online_log_tables().end());
  return tables;
}

}  // namespace seamline::study
