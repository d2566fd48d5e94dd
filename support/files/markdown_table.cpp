#include "support/files/markdown_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace seamline {
namespace {

struct MarkdownCellText {
  int digits;
  std::string operator()(std::monostate) const { return "–"; }
  std::string operator()(const std::string& text) const {
    std::string safe;
    for (const char c : text) safe += c == '|' ? "\\|" : std::string(1, c == '\n' ? ' ' : c);
    return safe;
  }
  std::string operator()(double number) const {
    return std::isfinite(number) ? fmt::format("{:.{}g}", number, digits) : "–";
  }
  std::string operator()(std::int64_t number) const { return std::to_string(number); }
};

bool is_text(const CsvTable& table, std::size_t column) {
  return std::any_of(table.rows.begin(), table.rows.end(), [&](const std::vector<CsvValue>& row) {
    return std::holds_alternative<std::string>(row[column]);
  });
}

/// Characters, not bytes: UTF-8 continuation bytes do not count.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

}  // namespace

std::string markdown_table(const CsvTable& table, int digits) {
  std::vector<std::string> lines(table.rows.size() + 2, "|");
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    const CsvColumn& head = table.columns[column];
    const bool text = is_text(table, column);
    std::vector<std::string> cells = {head.unit.empty() ? head.name : head.name + " (" + head.unit + ")", ""};
    for (const std::vector<CsvValue>& row : table.rows)
      cells.push_back(std::visit(MarkdownCellText{digits}, row[column]));
    std::size_t width = 3;
    for (const std::string& cell : cells) width = std::max(width, width_of(cell));
    cells[1] = text ? std::string(width, '-') : std::string(width - 1, '-') + ":";
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string padding(width - width_of(cells[i]), ' ');
      lines[i] += text ? " " + cells[i] + padding + " |" : " " + padding + cells[i] + " |";
    }
  }
  std::string all;
  for (const std::string& line : lines) all += line + "\n";
  return all;
}

}  // namespace seamline
