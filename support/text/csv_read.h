#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "support/text/error.h"

namespace seamline {

// The one reader of CSV: RFC 4180 as libcsv (Debian: libcsv-dev) cuts it into values, and what a table of
// numbers must keep beside it. `csv.h` writes.

/// A line of a table, as far as somebody asked for it.
struct CsvRow {
  std::string file;                      ///< path as the user gave it
  std::span<const std::string> columns;  ///< the names that were asked for
  int line = 0;                          ///< of the file, from 1: where the row begins
  std::vector<std::string> values;       ///< one for each of `columns`, without blanks around it
};

/// What the header line says.
struct CsvHeader {
  std::vector<std::string> names;  ///< without blanks around them
  char separator = ',';            ///< what stands between the values: a comma, a semicolon or a tab
  int line = 0;                    ///< of the file, from 1
};

/// The header alone. Throws InputError as `read_csv` does for the lines up to its end, and for an empty file.
[[nodiscard]] CsvHeader read_csv_header(const std::string& file, const std::string& text);

/// Reads a table whose header line names each of `columns` once, in any order; other columns are ignored,
/// also those without a name. Hands row after row to `take`. Values may be quoted, and quoted ones may hold
/// commas, doubled quotes and line ends; lines end with "\n", "\r\n" or "\r"; a byte order mark and empty
/// lines are skipped. Where the header has semicolons and no commas, semicolons stand between the values;
/// where it has neither but tabs, tabs. Throws InputError with file and line when a name of the header is
/// missing or there twice, a row has not as many values as the header, quotes are not closed or stand inside
/// a value, the text holds a byte of 0, or there are more rows or columns than `limits` allows. `columns`
/// must outlive the call. Time and memory are linear in the bytes; of the rows only one is held.
void read_csv(const std::string& file, const std::string& text, std::span<const std::string> columns,
              const std::function<void(const CsvRow&)>& take);

/// The complaint "FILE: line N: COLUMN: wanted ..., found ...".
[[nodiscard]] InputError complaint_about(const CsvRow& row, std::size_t column, const std::string& wanted,
                                         const std::string& found);

/// The value as a finite number. A decimal comma and a comma between thousands are refused by name, because
/// nobody can tell one from the other.
[[nodiscard]] double number_at(const CsvRow& row, std::size_t column);

/// The value as a whole number from 0 to `most`, which must be exact as a double; `most_text` is how the
/// complaint writes it.
[[nodiscard]] std::int64_t count_at(const CsvRow& row, std::size_t column, std::int64_t most,
                                    const std::string& most_text);

}  // namespace seamline
