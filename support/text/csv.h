#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace seamline {

/// A value of a table. `monostate` is an empty cell: the value does not exist; the table says why in another
/// column.
using CsvValue = std::variant<std::monostate, std::string, double, std::int64_t>;

/// A column and what a data dictionary says about it.
struct CsvColumn {
  std::string name;
  std::string unit;
  std::string meaning;
};

struct CsvTable {
  std::string name;  ///< of the file, without `.csv`
  std::vector<CsvColumn> columns;
  std::vector<std::vector<CsvValue>> rows;  ///< as many values as columns
};

/// RFC 4180 with a header line, "\n" line ends. Text is quoted where needed, and text that a spreadsheet
/// would run as a formula (it begins with = + - @, tab or a line end) gets a leading apostrophe; what cannot
/// be shown is replaced and what is endless is shortened (`clean_text`). Numbers have 6 significant digits;
/// one that is infinite or not a number is an empty cell, as what does not exist.
[[nodiscard]] std::string csv_text(const CsvTable& table);

/// The same with tabs between the cells, as BIDS wants it: what has no value is "n/a", and tabs and line ends
/// within text are blanks, because nothing is quoted.
[[nodiscard]] std::string tsv_text(const CsvTable& table);

/// The columns of several tables as a table of their own: file, column, unit, meaning.
[[nodiscard]] CsvTable data_dictionary(const std::vector<CsvTable>& tables);

/// A number with at most 6 significant digits, for sentences about input: "NaN" and "inf" in words.
[[nodiscard]] std::string number_text(double value);

/// `value` rounded to 6 significant digits.
[[nodiscard]] double six_digits(double value);

}  // namespace seamline
