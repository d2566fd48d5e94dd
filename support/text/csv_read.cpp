#include "support/text/csv_read.h"

#include <csv.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <exception>
#include <string_view>
#include <system_error>

#include "support/text/limits.h"

namespace seamline {

namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

/// The values of the row that is being read, as libcsv hands them out.
struct Cells {
  std::vector<std::string> values;
  bool too_many = false;
  bool row_ended = false;
  std::exception_ptr thrown;  ///< nothing may be thrown through the frames of C
};

void take_value(void* bytes, std::size_t size, void* data) {
  Cells& cells = *static_cast<Cells*>(data);
  cells.too_many = static_cast<std::int64_t>(cells.values.size()) >= limits::largest_csv_columns;
  if (cells.too_many || cells.thrown) return;
  try {
    cells.values.emplace_back(static_cast<const char*>(bytes), size);
  } catch (...) {
    cells.thrown = std::current_exception();
  }
}

void end_row(int, void* data) {
  static_cast<Cells*>(data)->row_ended = true;
}

InputError complaint_at(const std::string& file, int line, const std::string& wanted,
                        const std::string& found) {
  return input_error({.file = file, .field = fmt::format("line {}", line), .wanted = wanted, .found = found});
}

/// libcsv's parser, fed with one line of the file after the other, so that every complaint knows its line.
class Parser {
 public:
  Parser(const std::string& file, char separator, std::size_t text_size) : file_(file) {
    csv_init(&parser_, CSV_STRICT | CSV_STRICT_FINI);
    csv_set_delim(&parser_, static_cast<unsigned char>(separator));
    // As large as the longest value can be: memory is taken where it is written to, and never copied.
    csv_set_blk_size(&parser_, text_size + 1);
  }
  ~Parser() { csv_free(&parser_); }
  Parser(const Parser&) = delete;
  Parser& operator=(const Parser&) = delete;

  /// Whether a row ended with this line of the file, which holds its own line end.
  bool feed(std::string_view line_text, int line) {
    cells_.row_ended = false;
    const bool complete = csv_parse(&parser_, line_text.data(), line_text.size(), take_value, end_row,
                                    &cells_) == line_text.size();
    require_good(complete, line, "a quote inside a value that has none around it");
    return cells_.row_ended;
  }

  /// The same for the end of the file; the row that is open began in `line`.
  bool finish(int line) {
    cells_.row_ended = false;
    require_good(csv_fini(&parser_, take_value, end_row, &cells_) == 0, line, "a quote that is not closed");
    return cells_.row_ended;
  }

  std::vector<std::string>& values() { return cells_.values; }

 private:
  void require_good(bool complete, int line, const std::string& fault) {
    if (cells_.thrown) std::rethrow_exception(cells_.thrown);
    if (cells_.too_many)
      throw complaint_at(file_, line, fmt::format("at most {} columns", limits::largest_csv_columns), "more");
    if (complete) return;
    if (csv_error(&parser_) != CSV_EPARSE) throw std::bad_alloc();
    throw complaint_at(file_, line, "quotes around a whole value, doubled inside it", fault);
  }

  const std::string& file_;
  csv_parser parser_ = {};
  Cells cells_;
};

/// The text up to and with the first line end at or after `begin`.
std::string_view line_at(std::string_view text, std::size_t begin) {
  std::size_t end = text.find_first_of("\r\n", begin);
  if (end == std::string_view::npos) return text.substr(begin);
  if (text[end] == '\r' && end + 1 < text.size() && text[end + 1] == '\n') ++end;
  return text.substr(begin, end + 1 - begin);
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r\n") + 1 - first);
}

bool is_blank(std::string_view text) {
  return text.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

/// What stands between the names of the header: a comma, where there is none a semicolon, or else a tab.
char separator_of(std::string_view text) {
  bool quoted = false, semicolon = false, tab = false, begun = false;
  for (const char c : text) {
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (c == ',') return ',';
    if ((c == '\n' || c == '\r') && begun) break;
    semicolon = semicolon || c == ';';
    tab = tab || (c == '\t' && begun);
    begun = begun || !is_blank({&c, 1});
  }
  return semicolon ? ';' : tab ? '\t' : ',';
}

/// Where the header names each of the columns.
std::vector<std::size_t> places_of(const std::string& file, int line, const std::vector<std::string>& header,
                                   std::span<const std::string> columns) {
  const std::string wanted = fmt::format("a header with the columns {}", fmt::join(columns, ","));
  std::vector<std::string> names;
  for (const std::string& name : header) names.push_back(trimmed(name));
  std::vector<std::string> sorted = names;
  std::sort(sorted.begin(), sorted.end());
  const auto twice =
      std::adjacent_find(sorted.begin(), sorted.end(),
                         [](const std::string& a, const std::string& b) { return a == b && !a.empty(); });
  if (twice != sorted.end())
    throw complaint_at(file, line, "a header that names every column once", "two columns '" + *twice + "'");
  std::vector<std::size_t> places;
  for (const std::string& column : columns) {
    const auto found = std::find(names.begin(), names.end(), column);
    if (found == names.end())
      throw complaint_at(file, line, wanted,
                         fmt::format("no column '{}' in '{}'", column, fmt::join(names, ",")));
    places.push_back(static_cast<std::size_t>(found - names.begin()));
  }
  return places;
}

/// Hands the rows to the header first, and to `take` after it.
class Table {
 public:
  Table(const std::string& file, std::span<const std::string> columns,
        const std::function<void(const CsvRow&)>& take)
      : take_(take),
        row_{
            .file = file, .columns = columns, .line = 0, .values = std::vector<std::string>(columns.size())} {
  }

  void add(const std::vector<std::string>& values, int line) {
    if (!has_header()) {
      places_ = places_of(row_.file, line, values, row_.columns);
      width_ = values.size();
      return;
    }
    if (values.size() != width_)
      throw complaint_at(
          row_.file, line, fmt::format("{} values, as the header has columns", width_),
          fmt::format("{}{}", values.size(),
                      values.size() > width_ ? " (numbers have a decimal point, no comma)" : ""));
    if (++rows_ > limits::largest_csv_rows)
      throw complaint_at(row_.file, line, fmt::format("at most {} rows", limits::largest_csv_rows), "more");
    row_.line = line;
    for (std::size_t i = 0; i < places_.size(); ++i) row_.values[i] = trimmed(values[places_[i]]);
    take_(row_);
  }

  [[nodiscard]] bool has_header() const { return width_ > 0; }

 private:
  const std::function<void(const CsvRow&)>& take_;
  CsvRow row_;
  std::vector<std::size_t> places_;
  std::size_t width_ = 0;
  std::int64_t rows_ = 0;
};

std::string_view without_mark(std::string_view text) {
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  return text;
}

/// Hands over the values of row after row, the header first, until `take` says that it has enough.
void for_each_row(const std::string& file, const std::string& text,
                  const std::function<bool(const std::vector<std::string>& values, int line)>& take) {
  const std::string_view rest = without_mark(text);
  const char separator = separator_of(rest);
  Parser parser(file, separator, text.size());
  int line = 0, begun_in = 0;  // begun_in: line in which the row that is open began, or 0
  const auto goes_on = [&] {
    const bool more = take(parser.values(), begun_in);
    parser.values().clear();
    begun_in = 0;
    return more;
  };
  for (std::size_t begin = 0; begin < rest.size();) {
    const std::string_view line_text = line_at(rest, begin);
    begin += line_text.size();
    ++line;
    if (line_text.find('\0') != std::string_view::npos)
      throw complaint_at(file, line, "text in UTF-8", "a byte of 0, as files of UTF-16 have them");
    if (begun_in == 0 && (!is_blank(line_text) || line_text.find(separator) != std::string_view::npos))
      begun_in = line;
    if (parser.feed(line_text, line) && !goes_on()) return;
  }
  if (parser.finish(begun_in)) (void)goes_on();
}

}  // namespace

CsvHeader read_csv_header(const std::string& file, const std::string& text) {
  CsvHeader header;
  for_each_row(file, text, [&](const std::vector<std::string>& values, int line) {
    for (const std::string& name : values) header.names.push_back(trimmed(name));
    header.line = line;
    return false;
  });
  if (header.names.empty()) throw complaint_at(file, 1, "a header that names the columns", "an empty file");
  header.separator = separator_of(without_mark(text));
  return header;
}

void read_csv(const std::string& file, const std::string& text, std::span<const std::string> columns,
              const std::function<void(const CsvRow&)>& take) {
  Table table(file, columns, take);
  for_each_row(file, text, [&](const std::vector<std::string>& values, int line) {
    table.add(values, line);
    return true;
  });
  if (!table.has_header())
    throw complaint_at(file, 1, fmt::format("a header with the columns {}", fmt::join(columns, ",")),
                       "an empty file");
}

InputError complaint_about(const CsvRow& row, std::size_t column, const std::string& wanted,
                           const std::string& found) {
  return input_error({.file = row.file,
                      .field = fmt::format("line {}: {}", row.line, row.columns[column]),
                      .wanted = wanted,
                      .found = found});
}

double number_at(const CsvRow& row, std::size_t column) {
  const std::string& text = row.values[column];
  if (text.empty()) throw complaint_about(row, column, "a number", "nothing");
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, value);
  if (error == std::errc::result_out_of_range && stopped == end)
    throw complaint_about(row, column, "a number of at least 4.9e-324 and at most 1.8e308 in size",
                          "'" + text + "'");
  const bool is_number = error == std::errc() && stopped == end && std::isfinite(value);
  if (!is_number && text.find_first_not_of("0123456789.,+-eE") == std::string::npos &&
      text.find(',') != std::string::npos)
    throw complaint_about(row, column, "a number with a decimal point and no comma", "'" + text + "'");
  if (!is_number) throw complaint_about(row, column, "a number", "'" + text + "'");
  return value;
}

std::int64_t count_at(const CsvRow& row, std::size_t column, std::int64_t most,
                      const std::string& most_text) {
  const double value = number_at(row, column);
  if (!(value >= 0 && value <= static_cast<double>(most)) || value != std::floor(value))
    throw complaint_about(row, column, "a whole number from 0 to " + most_text,
                          "'" + row.values[column] + "'");
  return static_cast<std::int64_t>(value);
}

}  // namespace seamline
