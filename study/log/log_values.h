#pragma once
#include <SQLiteCpp/SQLiteCpp.h>

#include <filesystem>
#include <limits>
#include <string>

#include "study/placement/trial.h"

// Inside the log only.
namespace seamline::study {

/// Values of a row, checked again while they are read. The tables' own CHECKs hold for what is written
/// through them; a file that was damaged or made by another hand may hold anything, and the analysis counts
/// with these numbers as places in arrays. Every function throws InputError naming the log, table and column.
class LogValues {
 public:
  LogValues(const SQLite::Statement& row, const std::filesystem::path& log, const char* table)
      : row_(row), log_(log), table_(table) {}

  [[nodiscard]] int number(int column, int least, int most = std::numeric_limits<int>::max()) const;
  /// Nanoseconds or seconds: 0 or more.
  [[nodiscard]] std::int64_t time(int column, std::int64_t least = 0) const;
  [[nodiscard]] double positive(int column) const;
  [[nodiscard]] double real(int column, double least, double most) const;
  [[nodiscard]] bool flag(int column) const { return number(column, 0, 1) != 0; }
  /// A text that is shown to people: as `printable` has it.
  [[nodiscard]] std::string text(int column) const;
  /// A code as check_participant_code has it.
  [[nodiscard]] std::string code(int column) const;
  [[nodiscard]] TrialKind kind(int column) const;

 private:
  const SQLite::Statement& row_;
  const std::filesystem::path& log_;
  const char* table_;
};

}  // namespace seamline::study
