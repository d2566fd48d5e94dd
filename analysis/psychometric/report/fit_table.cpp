#include "analysis/psychometric/report/fit_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>

#include "support/files/atomic_file.h"
#include "support/running/interrupt.h"
#include "support/text/csv_read.h"
#include "support/text/error.h"
#include "support/text/limits.h"
#include "support/text/printable.h"
#include "support/text/request_name.h"

namespace seamline::analysis {

namespace {

/// What a column can be of.
namespace column_of {
enum Role : std::size_t { level, correct, trials, times, participant, group, roles };
}
using column_of::Role;
using column_of::roles;

/// What is known of a role: its option, and the names by which its column is found without it.
struct ColumnFacts {
  const char* member;  ///< of FitColumns
  const char* holds;
  std::vector<std::string> names;
};

const std::array<ColumnFacts, roles>& column_facts() {
  static const std::array<ColumnFacts, roles> facts = {
      ColumnFacts{"level", "the levels", {"level", "x", "intensity", "stimulus"}},
      ColumnFacts{
          "correct", "the right (or yes) answers", {"correct", "k", "right", "yes", "n_correct", "response"}},
      ColumnFacts{"trials", "the trials", {"trials", "n", "n_trials", "total"}},
      ColumnFacts{"times", "how often an answer was given", {}},
      ColumnFacts{"participant", "the participants", {}},
      ColumnFacts{"group", "the groups", {}}};
  return facts;
}

constexpr std::array<const char*, 5> participant_names = {"participant", "person", "subject", "observer",
                                                          "subj"};
constexpr std::array<const char*, 3> group_names = {"group", "condition", "cond"};

std::string in_small_letters(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// The header of a file with what was made of it.
struct TableHeader {
  std::string file;
  CsvHeader csv;
  std::array<std::string, roles> column;  ///< the name of each role's column, or empty

  [[nodiscard]] InputError complaint(const std::string& wanted, const std::string& found) const {
    return input_error(
        {.file = file, .field = fmt::format("line {}", csv.line), .wanted = wanted, .found = found});
  }
  [[nodiscard]] std::string all_names() const {
    return "'" + printable(fmt::format("{}", fmt::join(csv.names, ","))) + "'";
  }
};

/// The column of a role by its usual names, or empty.
std::string usual_column(const TableHeader& header, Role role) {
  const ColumnFacts& facts = column_facts()[role];
  std::vector<std::string> found;
  for (const std::string& usual : facts.names) {
    for (const std::string& name : header.csv.names) {
      if (name == facts.names.front()) return name;
      if (in_small_letters(name) == usual) found.push_back(name);
    }
  }
  if (found.size() > 1)
    throw header.complaint(fmt::format("one column that may be the {}, or {} COLUMN", facts.names.front(),
                                       request_name(facts.member)),
                           "'" + printable(found[0]) + "' and '" + printable(found[1]) + "'");
  return found.empty() ? "" : found.front();
}

void find_columns(TableHeader& header, const FitColumns& columns) {
  const std::array<const std::string*, roles> named = {&columns.level, &columns.correct,     &columns.trials,
                                                       &columns.times, &columns.participant, &columns.group};
  std::map<std::string, std::string> taken;
  for (std::size_t role = 0; role < roles; ++role) {
    const std::string& name = *named[role];
    if (name.empty()) continue;
    const std::string option = request_name(column_facts()[role].member);
    if (std::find(header.csv.names.begin(), header.csv.names.end(), name) == header.csv.names.end())
      throw header.complaint(fmt::format("a column '{}' ({})", printable(name), option), header.all_names());
    if (!taken.emplace(name, option).second)
      throw header.complaint(fmt::format("a column of its own for {}", option),
                             fmt::format("'{}', which {} names too", printable(name), taken[name]));
    header.column[role] = name;
  }
  if (!columns.times.empty() && !columns.trials.empty())
    throw input_error({.field = request_name("times"),
                       .wanted = "either " + request_name("trials") + " or " + request_name("times"),
                       .found = "both"});
  for (const Role role : {column_of::level, column_of::correct, column_of::trials})
    if (header.column[role].empty() && !(role == column_of::trials && !columns.times.empty())) {
      const std::string usual = usual_column(header, role);
      if (!taken.contains(usual)) header.column[role] = usual;
    }
  for (const Role role : {column_of::level, column_of::correct})
    if (header.column[role].empty())
      throw header.complaint(
          "a header with the columns level,correct,trials, or " + request_name(column_facts()[role].member) +
              " COLUMN",
          fmt::format("no column '{}' in {}", column_facts()[role].names.front(), header.all_names()));
}

/// The places of the roles among the values that are read.
struct ColumnPlaces {
  std::vector<std::string> columns;
  std::array<std::optional<std::size_t>, roles> of;
};

ColumnPlaces places_of_roles(const TableHeader& header) {
  ColumnPlaces places;
  for (std::size_t role = 0; role < roles; ++role)
    if (!header.column[role].empty()) {
      places.of[role] = places.columns.size();
      places.columns.push_back(header.column[role]);
    }
  return places;
}

/// Whether commas are decimal signs. Only asked where commas do not stand between values.
bool has_decimal_commas(const TableHeader& header, const std::string& text, const ColumnPlaces& places) {
  int point_line = 0, comma_line = 0;
  std::size_t mixed_column = 0;
  read_csv(header.file, text, places.columns, [&](const CsvRow& row) {
    for (const Role role : {column_of::level, column_of::correct, column_of::trials, column_of::times}) {
      if (!places.of[role]) continue;
      const std::string& value = row.values[*places.of[role]];
      if (point_line == 0 && value.find('.') != std::string::npos) point_line = row.line;
      if (value.find(',') == std::string::npos) continue;
      if (comma_line == 0) comma_line = row.line;
      mixed_column = *places.of[role];
    }
    if (point_line > 0 && comma_line > 0)
      throw complaint_about(row, mixed_column, "decimal points or decimal commas in all of a file",
                            fmt::format("a point in line {} and a comma in line {}", point_line, comma_line));
  });
  return comma_line > 0;
}

/// An answer that is one row: 1 or 0, also in words.
std::int64_t answer_at(const CsvRow& row, std::size_t place) {
  const std::string word = in_small_letters(row.values[place]);
  if (word == "1" || word == "yes" || word == "true") return 1;
  if (word == "0" || word == "no" || word == "false") return 0;
  throw complaint_about(row, place, "0 or 1, as a row without a column of trials is one answer",
                        "'" + printable(row.values[place]) + "'");
}

/// Numbers names in the order in which they come.
class NumberedNames {
 public:
  NumberedNames(std::vector<std::string>& names, std::size_t most, const char* what)
      : names_(names), most_(most), what_(what) {}
  std::size_t of(const CsvRow& row, std::size_t place) {
    const std::string& name = row.values[place];
    if (name.empty()) throw complaint_about(row, place, std::string("the name of a ") + what_, "nothing");
    const auto [at, is_new] = index_.emplace(name, names_.size());
    if (is_new) {
      if (names_.size() >= most_)
        throw complaint_about(row, place, fmt::format("at most {} {}s", most_, what_), "more");
      names_.push_back(name);
    }
    return at->second;
  }

 private:
  std::vector<std::string>& names_;
  std::size_t most_;
  const char* what_;
  std::map<std::string, std::size_t> index_;
};

LevelCounts row_counts(const CsvRow& row, const ColumnPlaces& places, study::Axis axis) {
  constexpr std::int64_t most = 1'000'000'000'000;  // sums over a file's rows stay exact
  constexpr const char* most_text = "1e12";
  const std::size_t at_correct = *places.of[column_of::correct];
  LevelCounts read{.level = number_at(row, *places.of[column_of::level]), .correct = 0, .trials = 1};
  if (axis == study::Axis::log2 && read.level < 0)
    throw complaint_about(row, *places.of[column_of::level],
                          "a positive number on a log2 axis, or 0 for no stimulus (" + request_name("axis") +
                              " linear takes any)",
                          row.values[*places.of[column_of::level]]);
  if (places.of[column_of::trials]) {
    read.correct = count_at(row, at_correct, most, most_text);
    read.trials = count_at(row, *places.of[column_of::trials], most, most_text);
  } else {
    if (places.of[column_of::times])
      read.trials = count_at(row, *places.of[column_of::times], most, most_text);
    read.correct = answer_at(row, at_correct) * read.trials;
  }
  if (read.correct > read.trials)
    throw complaint_about(row, at_correct, fmt::format("at most the {} trials", read.trials),
                          std::to_string(read.correct));
  return read;
}

/// Rows that each hold 0 or 1 right of many, at every level: most likely answers with how often they were
/// given, which would be misread.
void require_counts(const TableHeader& header, const FitTable& table) {
  if (header.column[column_of::trials].empty()) return;
  const auto& rows = table.rows;
  const auto several =
      std::count_if(rows.begin(), rows.end(), [](const FitRow& row) { return row.counts.trials > 1; });
  const auto ones =
      std::count_if(rows.begin(), rows.end(), [](const FitRow& row) { return row.counts.correct == 1; });
  const bool all_01 =
      std::all_of(rows.begin(), rows.end(), [](const FitRow& row) { return row.counts.correct <= 1; });
  const auto size = static_cast<std::ptrdiff_t>(rows.size());
  if (all_01 && size >= 8 && 3 * ones >= size && 2 * several >= size)
    throw header.complaint(
        fmt::format("how many of the trials were right, or {} {} where a row is an answer and how often "
                    "it was given",
                    request_name("times"), printable(header.column[column_of::trials])),
        fmt::format("0 or 1 in every row of '{}'", printable(header.column[column_of::correct])));
}

void add_remarks(const TableHeader& header, const ColumnPlaces& places, bool decimal_commas,
                 FitTable& table) {
  for (const std::string& name : header.csv.names)
    if (std::find(places.columns.begin(), places.columns.end(), name) == places.columns.end())
      table.ignored.push_back(name.empty() ? "(without a name)" : printable(name));
  for (const Role role : {column_of::level, column_of::correct, column_of::trials})
    if (const std::string& name = header.column[role];
        !name.empty() && name != column_facts()[role].names.front())
      table.remarks.push_back(
          fmt::format("the column '{}' holds {}", printable(name), column_facts()[role].holds));
  if (header.column[column_of::trials].empty() && header.column[column_of::times].empty())
    table.remarks.push_back("there is no column of trials: a row is one answer");
  if (decimal_commas) table.remarks.push_back("commas are decimal signs");
  const auto hint = [&](Role role, const auto& usual, const char* what) {
    if (!header.column[role].empty()) return;
    for (const char* name : usual)
      for (const std::string& ignored : table.ignored)
        if (in_small_letters(ignored) == name)
          table.remarks.push_back(
              fmt::format("{} {} fits {}", request_name(column_facts()[role].member), ignored, what));
  };
  hint(column_of::participant, participant_names, "a model of people who differ");
  hint(column_of::group, group_names, "a function to each group");
}

}  // namespace

FitTable read_fit_table(const std::filesystem::path& file, const FitColumns& columns, study::Axis axis) {
  const std::string text = read_file(file, limits::largest_csv_bytes);
  TableHeader header{.file = file.string(), .csv = read_csv_header(file.string(), text), .column = {}};
  find_columns(header, columns);
  const ColumnPlaces places = places_of_roles(header);
  const bool decimal_commas = header.csv.separator != ',' && has_decimal_commas(header, text, places);
  FitTable table;
  NumberedNames people(table.participants, most_fit_participants, "participant");
  NumberedNames groups(table.groups, most_fit_groups, "group");
  read_csv(header.file, text, places.columns, [&](const CsvRow& given) {
    stop_if_interrupted();
    CsvRow row = given;
    if (decimal_commas)
      for (const Role role : {column_of::level, column_of::correct, column_of::trials, column_of::times})
        if (places.of[role])
          std::replace(row.values[*places.of[role]].begin(), row.values[*places.of[role]].end(), ',', '.');
    FitRow read{.counts = row_counts(row, places, axis)};
    if (places.of[column_of::participant])
      read.participant = people.of(row, *places.of[column_of::participant]);
    if (places.of[column_of::group]) read.group = groups.of(row, *places.of[column_of::group]);
    table.rows.push_back(read);
  });
  const auto is_positive = [](const FitRow& row) { return row.counts.level != 0; };
  if (table.rows.empty())
    throw input_error(
        {.file = header.file, .field = "", .wanted = "at least one line of counts", .found = "none"});
  if (axis == study::Axis::log2 && std::none_of(table.rows.begin(), table.rows.end(), is_positive))
    throw input_error(
        {.file = header.file,
         .field = header.column[column_of::level],
         .wanted = "a level that is positive on a log2 axis (" + request_name("axis") + " linear takes any)",
         .found = "only 0, which is no stimulus"});
  require_counts(header, table);
  add_remarks(header, places, decimal_commas, table);
  return table;
}

std::vector<LevelCounts> counts_of(const FitTable& table, std::optional<std::size_t> group) {
  std::vector<LevelCounts> counts;
  for (const FitRow& row : table.rows)
    if (!group || row.group == *group) counts.push_back(row.counts);
  return counts;
}

}  // namespace seamline::analysis
