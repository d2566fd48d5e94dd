#include "support/text/csv.h"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <cstdlib>

#include "support/text/printable.h"

namespace seamline {

namespace {

std::string safe_text(std::string_view outside) {
  const std::string text = clean_text(outside);
  std::string safe;
  if (!text.empty() && std::string_view("=+-@\t\r\n").find(text.front()) != std::string_view::npos)
    safe = "'";
  safe += text;
  if (safe.find_first_of(",\"\n\r") == std::string::npos) return safe;
  std::string quoted = "\"";
  for (char c : safe) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + "\"";
}

struct CsvCellText {
  std::string operator()(std::monostate) const { return ""; }
  std::string operator()(const std::string& text) const { return safe_text(text); }
  std::string operator()(double number) const { return std::isfinite(number) ? number_text(number) : ""; }
  std::string operator()(std::int64_t number) const { return std::to_string(number); }
};

}  // namespace

std::string number_text(double value) {
  if (std::isnan(value)) return "NaN";
  return fmt::format("{:.6g}", value);
}

double six_digits(double value) {
  return std::isfinite(value) ? std::strtod(number_text(value).c_str(), nullptr) : value;
}

std::string csv_text(const CsvTable& table) {
  std::string text;
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    text += (i == 0 ? "" : ",") + safe_text(table.columns[i].name);
  text += "\n";
  for (const std::vector<CsvValue>& row : table.rows) {
    assert(row.size() == table.columns.size());
    for (std::size_t i = 0; i < row.size(); ++i)
      text += (i == 0 ? "" : ",") + std::visit(CsvCellText{}, row[i]);
    text += "\n";
  }
  return text;
}

CsvTable data_dictionary(const std::vector<CsvTable>& tables) {
  CsvTable dictionary{.name = "data_dictionary",
                      .columns = {{"file", "", "the file that the column is in"},
                                  {"column", "", "its name in the header line"},
                                  {"unit", "", "unit or kind of value"},
                                  {"meaning", "", "what the value says"}},
                      .rows = {}};
  for (const CsvTable& table : tables)
    for (const CsvColumn& column : table.columns)
      dictionary.rows.push_back({table.name + ".csv", column.name, column.unit, column.meaning});
  return dictionary;
}

}  // namespace seamline
