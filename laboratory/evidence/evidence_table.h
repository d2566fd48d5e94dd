#pragma once
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace seamline::laboratory {

// Tables of a page, computed from the tables that its steps write.

/// A table as text: every row has as many cells as `columns`.
struct TextTable {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

/// Reads a CSV file. Throws InputError as `read_csv` does.
[[nodiscard]] TextTable read_table(const std::filesystem::path& file);

/// RFC 4180, cells as they are.
[[nodiscard]] std::string csv_of(const TextTable& table);

/// Markdown; columns of numbers stand to the right, large whole numbers have commas.
[[nodiscard]] std::string markdown_of(const TextTable& table);

/// The rows whose columns hold these values.
using RowFilter = std::vector<std::pair<std::string, std::string>>;

/// What a cell says of all rows that it stands for; `mean_of_3_digits` beside numbers of all sizes. Rows
/// without a number count only for `rows` and `text`.
enum class Summary { text, mean, mean_of_3_digits, mean_and_lowest, lowest, highest, range, sum, rows };

struct SummaryColumn {
  std::string heading;
  std::string of;        ///< the column that is summarised; none for `rows`
  RowFilter where = {};  ///< besides that of the table
  Summary shows = Summary::text;
  int decimals = 0;
};

/// A file that is read; `label` names its row where rows are files.
struct TableSource {
  std::string label, file;
};

/// A table with a row for each value of a column, or for each file.
struct EvidenceTable {
  std::string file;                 ///< that is written, .csv
  std::vector<TableSource> from;    ///< of the page's folder
  std::string heading;              ///< of the first column
  std::vector<std::string> row_of;  ///< columns whose values, joined by commas, name a row; none: the labels
  std::vector<SummaryColumn> columns;
  RowFilter where = {};
  RowFilter but_not = {};  ///< rows that hold one of these are left out
  bool to_comma = false;   ///< a row's name ends before its first comma
};

/// Computes the table from the files in `folder`; rows are in the order of their first appearance, a cell
/// that no row stands for is "–". Throws InputError where a file has not the columns, or a cell of
/// `Summary::text` stands for rows that differ.
[[nodiscard]] TextTable summarised(const EvidenceTable& table, const std::filesystem::path& folder);

/// What a step printed as a table: its lines of as many cells as `columns`, of which some after the first has
/// a digit. Cells stand between bars, else between two or more blanks, else between commas.
struct PrintedTable {
  std::string file;  ///< that is written, .csv
  std::string step;
  std::vector<std::string> columns;  ///< the last may be "note", which lines need not have
  bool last_of_a_name = false;       ///< of lines with the same first cell only the last counts
};

[[nodiscard]] TextTable printed_table(const PrintedTable& table, const std::string& printed);

}  // namespace seamline::laboratory
