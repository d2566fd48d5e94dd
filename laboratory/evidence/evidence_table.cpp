#include "laboratory/evidence/evidence_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <sstream>

#include "support/files/atomic_file.h"
#include "support/text/csv_read.h"
#include "support/text/error.h"
#include "support/text/number_option.h"

namespace seamline::laboratory {
namespace {

namespace fs = std::filesystem;

constexpr const char* no_value = "–";

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\n;\t") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + "\"";
}

/// Whole numbers of five digits or more with commas between thousands.
std::string readable_cell(const std::string& cell) {
  constexpr std::size_t short_number = 4, thousand = 3;
  if (cell.size() <= short_number || cell.find_first_not_of("0123456789") != std::string::npos) return cell;
  std::string grouped;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    if (i > 0 && (cell.size() - i) % thousand == 0) grouped += ',';
    grouped += cell[i];
  }
  return grouped;
}

std::string markdown_line(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + readable_cell(cell) + " |";
  return line + "\n";
}

bool holds_numbers(const TextTable& table, std::size_t column) {
  return std::all_of(table.rows.begin(), table.rows.end(), [&](const std::vector<std::string>& row) {
    std::string digits = row[column];
    std::erase(digits, ',');
    return digits == no_value || decimal_number(digits).has_value();
  });
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string> split(const std::string& line, const std::string& separator) {
  std::vector<std::string> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(separator, begin), line.size());
    cells.push_back(trimmed(line.substr(begin, end - begin)));
    begin = end + separator.size();
  }
  return cells;
}

std::vector<std::string> printed_cells(std::string line) {
  line = trimmed(line);
  if (line.find('|') == std::string::npos) {
    if (line.find("  ") == std::string::npos && line.find(',') != std::string::npos) return split(line, ",");
    std::vector<std::string> cells = split(line, "  ");
    std::erase(cells, "");
    return cells;
  }
  if (line.starts_with('|')) line.erase(0, 1);
  if (line.ends_with('|')) line.pop_back();
  return split(line, "|");
}

/// A row of a file that is summarised: by what it is named, and its values by column.
struct SourceRow {
  std::string name;
  std::vector<std::string> values;
};

std::size_t place_of(const std::vector<std::string>& columns, const std::string& column,
                     const fs::path& file) {
  const auto found = std::find(columns.begin(), columns.end(), column);
  if (found == columns.end())
    throw input_error({.file = file.string(), .wanted = "a column " + column, .found = "none of that name"});
  return static_cast<std::size_t>(found - columns.begin());
}

/// The rows of one file.
struct SourceTable {
  TextTable table;
  fs::path file;

  [[nodiscard]] const std::string& value(const std::vector<std::string>& row,
                                         const std::string& column) const {
    return row[place_of(table.columns, column, file)];
  }
  [[nodiscard]] bool passes(const std::vector<std::string>& row, const RowFilter& filter) const {
    return std::all_of(filter.begin(), filter.end(),
                       [&](const auto& wanted) { return value(row, wanted.first) == wanted.second; });
  }
  [[nodiscard]] bool holds_any(const std::vector<std::string>& row, const RowFilter& filter) const {
    return std::any_of(filter.begin(), filter.end(),
                       [&](const auto& unwanted) { return value(row, unwanted.first) == unwanted.second; });
  }
};

std::string row_name(const EvidenceTable& table, const TableSource& source, const SourceTable& rows,
                     const std::vector<std::string>& row) {
  if (table.row_of.empty()) return source.label;
  std::vector<std::string> parts;
  for (const std::string& column : table.row_of) parts.push_back(rows.value(row, column));
  const std::string name = fmt::format("{}", fmt::join(parts, ", "));
  return table.to_comma ? name.substr(0, name.find(',')) : name;
}

std::string range_text(double low, double high, int decimals) {
  const std::string from = fmt::format("{:.{}f}", low, decimals), to = fmt::format("{:.{}f}", high, decimals);
  return from == to ? from : from + " to " + to;
}

std::string summary_of(const SummaryColumn& column, const std::vector<std::string>& cells,
                       const std::string& of) {
  if (column.shows == Summary::rows) return std::to_string(cells.size());
  if (cells.empty()) return no_value;
  if (column.shows == Summary::text) {
    if (std::any_of(cells.begin(), cells.end(),
                    [&](const std::string& cell) { return cell != cells.front(); }))
      throw input_error({.field = of + ", " + column.heading, .wanted = "one value", .found = "several"});
    return cells.front().empty() ? no_value : cells.front();
  }
  double sum = 0;
  std::vector<double> numbers;
  for (const std::string& cell : cells)
    if (const std::optional<double> number = decimal_number(cell)) {
      numbers.push_back(*number);
      sum += *number;
    }
  if (numbers.empty()) return no_value;
  const auto [low, high] = std::minmax_element(numbers.begin(), numbers.end());
  const double mean = sum / numbers.size();
  switch (column.shows) {
    case Summary::mean:
      return fmt::format("{:.{}f}", mean, column.decimals);
    case Summary::mean_of_3_digits:
      return fmt::format("{:.3g}", mean);
    case Summary::mean_and_lowest:
      return fmt::format("{:.{}f} ({:.0f})", mean, column.decimals, *low);
    case Summary::lowest:
      return fmt::format("{:.{}f}", *low, column.decimals);
    case Summary::highest:
      return fmt::format("{:.{}f}", *high, column.decimals);
    case Summary::range:
      return range_text(*low, *high, column.decimals);
    case Summary::sum:
      return fmt::format("{:.{}f}", sum, column.decimals);
    case Summary::text:
    case Summary::rows:
      break;
  }
  return no_value;
}

/// A heading has none, but where it is the table's own ("s a 10,000 answers").
bool has_numbers(const std::vector<std::string>& cells) {
  return std::any_of(cells.begin() + 1, cells.end(), [](const std::string& cell) {
    return cell.find_first_of("0123456789") != std::string::npos;
  });
}

}  // namespace

TextTable read_table(const fs::path& file) {
  const std::string text = read_file(file);
  TextTable table{.columns = read_csv_header(file.string(), text).names, .rows = {}};
  read_csv(file.string(), text, table.columns, [&](const CsvRow& row) { table.rows.push_back(row.values); });
  return table;
}

std::string csv_of(const TextTable& table) {
  std::string text;
  const auto add = [&](const std::vector<std::string>& cells) {
    std::vector<std::string> written;
    for (const std::string& cell : cells) written.push_back(csv_cell(cell));
    text += fmt::format("{}\n", fmt::join(written, ","));
  };
  add(table.columns);
  for (const std::vector<std::string>& row : table.rows) add(row);
  return text;
}

std::string markdown_of(const TextTable& table) {
  std::vector<std::string> rule;
  for (std::size_t column = 0; column < table.columns.size(); ++column)
    rule.emplace_back(column > 0 && holds_numbers(table, column) ? "---:" : "---");
  std::string text = markdown_line(table.columns) + markdown_line(rule);
  for (const std::vector<std::string>& row : table.rows) text += markdown_line(row);
  return text;
}

TextTable summarised(const EvidenceTable& table, const fs::path& folder) {
  std::vector<std::string> names;
  std::vector<std::vector<std::vector<std::string>>> cells;  // by row, by column
  for (const TableSource& source : table.from) {
    const SourceTable rows{.table = read_table(folder / source.file), .file = folder / source.file};
    for (const std::vector<std::string>& row : rows.table.rows) {
      if (!rows.passes(row, table.where) || rows.holds_any(row, table.but_not)) continue;
      const std::string name = row_name(table, source, rows, row);
      const auto found = std::find(names.begin(), names.end(), name);
      const std::size_t place = found - names.begin();
      if (found == names.end()) {
        names.push_back(name);
        cells.emplace_back(table.columns.size());
      }
      for (std::size_t i = 0; i < table.columns.size(); ++i)
        if (rows.passes(row, table.columns[i].where))
          cells[place][i].push_back(table.columns[i].of.empty() ? "" : rows.value(row, table.columns[i].of));
    }
  }
  TextTable made{.columns = {table.heading}, .rows = {}};
  for (const SummaryColumn& column : table.columns) made.columns.push_back(column.heading);
  for (std::size_t row = 0; row < names.size(); ++row) {
    made.rows.push_back({names[row]});
    for (std::size_t i = 0; i < table.columns.size(); ++i)
      made.rows.back().push_back(summary_of(table.columns[i], cells[row][i], table.file + ", " + names[row]));
  }
  return made;
}

TextTable printed_table(const PrintedTable& table, const std::string& printed) {
  TextTable made{.columns = table.columns, .rows = {}};
  std::istringstream lines(printed);
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> cells = printed_cells(line);
    if (cells.size() + 1 == table.columns.size() && table.columns.back() == "note") cells.emplace_back();
    if (cells.size() != table.columns.size() || cells == table.columns || !has_numbers(cells)) continue;
    if (table.last_of_a_name)
      std::erase_if(made.rows, [&](const std::vector<std::string>& row) { return row[0] == cells[0]; });
    made.rows.push_back(cells);
  }
  return made;
}

}  // namespace seamline::laboratory
