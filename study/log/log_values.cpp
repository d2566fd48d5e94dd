#include "study/log/log_values.h"

#include <fmt/core.h>

#include <cmath>
#include <limits>

#include "study/log/log_writer.h"
#include "support/text/error.h"
#include "support/text/printable.h"

namespace seamline::study {
namespace {

InputError out_of_range(const std::filesystem::path& log, const char* table, const SQLite::Column& column,
                        const std::string& wanted) {
  return input_error({.file = log.string(),
                      .field = fmt::format("{}.{}", table, column.getName()),
                      .wanted = wanted,
                      .found = "\"" + printable(column.getString(), 40) + "\""});
}

}  // namespace

int LogValues::number(int column, int least, int most) const {
  const SQLite::Column value = row_.getColumn(column);
  const std::int64_t number = value.getInt64();
  if (!value.isInteger() || number < least || number > most)
    throw out_of_range(log_, table_, value, fmt::format("a whole number from {} to {}", least, most));
  return static_cast<int>(number);
}

std::int64_t LogValues::time(int column, std::int64_t least) const {
  const SQLite::Column value = row_.getColumn(column);
  if (!value.isInteger() || value.getInt64() < least)
    throw out_of_range(log_, table_, value, fmt::format("a whole number of at least {}", least));
  return value.getInt64();
}

double LogValues::positive(int column) const {
  const SQLite::Column value = row_.getColumn(column);
  const double number = value.getDouble();
  if (!(number > 0) || !std::isfinite(number))
    throw out_of_range(log_, table_, value, "a finite number above 0");
  return number;
}

double LogValues::real(int column, double least, double most) const {
  const SQLite::Column value = row_.getColumn(column);
  const double number = value.getDouble();
  if (!value.isFloat() || !(number >= least && number <= most))
    throw out_of_range(log_, table_, value, fmt::format("a number from {} to {}", least, most));
  return number;
}

std::string LogValues::text(int column) const {
  return printable(row_.getColumn(column).getString());
}

std::string LogValues::code(int column) const {
  const SQLite::Column value = row_.getColumn(column);
  const std::string code = value.getString();
  if (!is_code(code))
    throw out_of_range(log_, table_, value,
                       "a code of 1 to 64 letters, digits, dots, dashes and underscores");
  return code;
}

TrialKind LogValues::kind(int column) const {
  const SQLite::Column value = row_.getColumn(column);
  const std::optional<TrialKind> kind = trial_kind_from_word(value.getString());
  if (!kind) throw out_of_range(log_, table_, value, "a known kind of trial");
  return *kind;
}

}  // namespace seamline::study
