#include "support/text/csv.h"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <cstdlib>

#include "support/text/printable.h"

namespace seamline {

namespace {

std::string without_formula(std::string_view outside) {
  const std::string text = clean_text(outside);
  const bool formula =
      !text.empty() && std::string_view("=+-@\t\r\n").find(text.front()) != std::string_view::npos;
  return (formula ? "'" : "") + text;
}

std::string safe_text(std::string_view outside) {
  const std::string safe = without_formula(outside);
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

struct TsvCellText {
  std::string operator()(const std::string& text) const {
    std::string safe = without_formula(text);
    for (char& c : safe)
      if (c == '\t' || c == '\n' || c == '\r') c = ' ';
    return or_none(safe);
  }
  template <class Other>
  std::string operator()(const Other& other) const {
    return or_none(CsvCellText{}(other));
  }
  static std::string or_none(const std::string& text) { return text.empty() ? "n/a" : text; }
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

std::string tsv_text(const CsvTable& table) {
  std::string text;
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    text += (i == 0 ? "" : "\t") + TsvCellText{}(table.columns[i].name);
  text += "\n";
  for (const std::vector<CsvValue>& row : table.rows) {
    assert(row.size() == table.columns.size());
    for (std::size_t i = 0; i < row.size(); ++i)
      text += (i == 0 ? "" : "\t") + std::visit(TsvCellText{}, row[i]);
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
