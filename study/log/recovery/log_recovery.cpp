#include "study/log/recovery/log_recovery.h"

#include <fmt/core.h>
#include <sqlite3.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>

#include "study/log/log_create.h"
#include "study/log/log_database.h"
#include "study/log/log_place.h"
#include "study/log/log_tables.h"
#include "study/log/recovery/log_salvage.h"
#include "study/log/recovery/new_log.h"
#include "study/trials/rendered_set.h"
#include "support/files/temporary_folder.h"
#include "support/text/request_name.h"

namespace seamline::study {
namespace fs = std::filesystem;
namespace {

std::int64_t number(const LogRow& row, std::size_t column) {
  if (column >= row.size()) return -1;
  const auto* value = std::get_if<std::int64_t>(&row[column]);
  return value == nullptr ? -1 : *value;
}

bool has_browsers(const SalvagedLog& log) {
  return std::any_of(online_log_tables().begin(), online_log_tables().end(), [&](const LogTable& table) {
    const auto rows = log.find(table.name);
    return rows != log.end() && !rows->second.empty();
  });
}

/// Fills a new log with the rows that were read.
class Refill {
 public:
  Refill(SQLite::Database& database, const SalvagedLog& log, LogRecovery& recovery)
      : database_(database), log_(log), recovery_(recovery) {}

  void fill(const std::optional<RenderedSet>& set) {
    for (const LogTable& table : log_tables_with(has_browsers(log_))) {
      if (std::string(table.name) == "trials") enter_lost_participants();
      if (std::string(table.name) == "answers") enter_lost_sessions();
      if (std::string(table.name) == "stimuli" && set)
        enter_from_set(*set);
      else
        for (const LogRow& row : rows(table.name)) enter(table.name, row);
    }
  }

 private:
  [[nodiscard]] const std::vector<LogRow>& rows(const std::string& table) const {
    static const std::vector<LogRow> none;
    const auto found = log_.find(table);
    return found == log_.end() ? none : found->second;
  }

  /// The table's own rules decide whether a row is sound.
  bool try_insert(const std::string& table, const LogRow& row) {
    stop_if_interrupted();
    try {
      std::string places;
      for (std::size_t i = 0; i < row.size(); ++i) places += i == 0 ? "?" : ", ?";
      SQLite::Statement insert(database_, fmt::format("INSERT INTO {} VALUES ({})", table, places));
      for (std::size_t i = 0; i < row.size(); ++i) {
        const int place = static_cast<int>(i) + 1;
        if (const auto* whole = std::get_if<std::int64_t>(&row[i])) insert.bind(place, *whole);
        if (const auto* real = std::get_if<double>(&row[i])) insert.bind(place, *real);
        if (const auto* text = std::get_if<std::string>(&row[i])) insert.bind(place, *text);
      }
      insert.exec();
      return true;
    } catch (const SQLite::Exception& error) {
      const int code = error.getErrorCode() & 0xff;
      if (code != SQLITE_CONSTRAINT && code != SQLITE_MISMATCH && code != SQLITE_ERROR &&
          code != SQLITE_TOOBIG)
        throw;
      return false;
    }
  }

  void enter(const std::string& table, const LogRow& row) {
    ++(try_insert(table, row) ? recovery_.saved : recovery_.refused)[table];
  }

  /// The manifest that the log was made from says what its rows of stimuli said.
  void enter_from_set(const RenderedSet& set) {
    SQLite::Statement same(database_, "SELECT 1 FROM study WHERE set_hash = ? AND study_hash = ?");
    SQLite::bind(same, set.set_hash, set.manifest.study_hash);
    if (!same.executeStep()) {
      database_.exec("DELETE FROM study");
      enter_study_row(database_, set);
      recovery_.study_from_set = true;
    }
    const std::int64_t stimuli = enter_missing_stimuli(database_, set.manifest.stimuli);
    recovery_.stimuli_from_set = stimuli - std::min<std::int64_t>(stimuli, std::ssize(rows("stimuli")));
  }

  bool has(const char* table, const char* key, std::int64_t value) {
    SQLite::Statement found(database_, fmt::format("SELECT 1 FROM {} WHERE {} = ?", table, key));
    found.bind(1, value);
    return found.executeStep();
  }

  /// Answers of somebody whose row is gone are kept under a new code, out of the analysis.
  void enter_lost_participants() {
    std::set<std::int64_t> wanted;
    for (const char* table : {"trials", "answers"})
      for (const LogRow& row : rows(table)) wanted.insert(number(row, 0));
    for (const std::int64_t participant : wanted) {
      if (participant < 1 || has("participants", "participant", participant)) continue;
      const LogRow row = {participant,
                          fmt::format("recovered-{}", participant),
                          std::int64_t{0},
                          std::int64_t{0},
                          std::int64_t{1},
                          std::int64_t{0},
                          {},
                          {},
                          {}};
      recovery_.participants_without_row += try_insert("participants", row) ? 1 : 0;
    }
  }

  void enter_lost_sessions() {
    for (const LogRow& answer : rows("answers")) {
      const std::int64_t participant = number(answer, 0), session = number(answer, 2);
      if (session < 1 || has("sessions", "session", session)) continue;
      const LogRow row = {session,         participant,     std::int64_t{0},    std::int64_t{0},
                          std::int64_t{0}, std::int64_t{0}, std::string("lost")};
      recovery_.sessions_without_row += try_insert("sessions", row) ? 1 : 0;
    }
  }

  SQLite::Database& database_;
  const SalvagedLog& log_;
  LogRecovery& recovery_;
};

/// Trials before the last answer, or all of a completed participant, must have had an answer.
std::vector<LostAnswers> lost_answers(SQLite::Database& database) {
  std::vector<LostAnswers> people;
  SQLite::Statement person(database, R"sql(
      SELECT participant, code, completed,
             (SELECT count(*) FROM trials WHERE trials.participant = participants.participant),
             (SELECT count(*) FROM answers WHERE answers.participant = participants.participant),
             (SELECT coalesce(max(trial_index), -1) FROM answers WHERE answers.participant = participants.participant),
             (SELECT coalesce(max(trial_index), -1) FROM trials WHERE trials.participant = participants.participant)
      FROM participants ORDER BY participant)sql");
  SQLite::Statement answered(database, "SELECT 1 FROM answers WHERE participant = ? AND trial_index = ?");
  while (person.executeStep()) {
    stop_if_interrupted();
    LostAnswers lost{.code = person.getColumn(1).getString(),
                     .completed = person.getColumn(2).getInt() != 0,
                     .trials = person.getColumn(3).getInt(),
                     .answered = person.getColumn(4).getInt()};
    const int last = lost.completed ? person.getColumn(6).getInt() : person.getColumn(5).getInt();
    for (int trial = 0; trial <= last; ++trial) {
      answered.tryReset();
      SQLite::bind(answered, person.getColumn(0).getInt64(), trial);
      if (!answered.executeStep()) lost.missing_trials.push_back(trial);
    }
    people.push_back(std::move(lost));
  }
  return people;
}

std::optional<RenderedSet> find_set(const SalvagedLog& log, const fs::path& given) {
  if (!given.empty()) return load_rendered_set(given);
  const auto study = log.find("study");
  if (study == log.end() || study->second.empty() || study->second.front().size() < 5) return std::nullopt;
  const LogRow& row = study->second.front();
  const auto* hash = std::get_if<std::string>(&row[3]);
  const auto* folder = std::get_if<std::string>(&row[4]);
  if (hash == nullptr || folder == nullptr) return std::nullopt;
  try {
    RenderedSet set = load_rendered_set(*folder);
    if (set.set_hash == *hash) return set;
  } catch (const InputError&) {
    // moved or gone: the log's own rows must do
  }
  return std::nullopt;
}

constexpr std::size_t trials_columns = 4;  ///< of a study that names no task

/// Whether a trial says what is right in it.
bool has_tasks(const SalvagedLog& log) {
  const auto trials = log.find("trials");
  return trials != log.end() &&
         std::any_of(trials->second.begin(), trials->second.end(), [](const LogRow& row) {
           return row.size() > trials_columns && !std::holds_alternative<std::monostate>(row[trials_columns]);
         });
}

/// Whether a scene has more objects than the usual three.
bool has_many_objects(const SalvagedLog& log) {
  constexpr std::size_t object_index_column = 5;
  const auto stimuli = log.find("stimuli");
  return stimuli != log.end() &&
         std::any_of(stimuli->second.begin(), stimuli->second.end(), [](const LogRow& row) {
           const auto* index = row.size() > object_index_column
                                   ? std::get_if<std::int64_t>(&row[object_index_column])
                                   : nullptr;
           return index != nullptr && *index > usual_objects;
         });
}

/// What the recovered log is made of: its artifacts, objects and task decide, and whether anybody took part
/// in a browser.
int schema_version_for(const SalvagedLog& log) {
  const bool online = has_browsers(log), task = has_tasks(log), many = has_many_objects(log);
  const std::string word_of_4(word(Artifact::reflection));
  if (const auto stimuli = log.find("stimuli"); stimuli != log.end())
    for (const LogRow& row : stimuli->second)
      for (const auto& value : row)
        if (const auto* text = std::get_if<std::string>(&value); text != nullptr && *text == word_of_4)
          return log_schema_version_with(online, true, task, many);
  return log_schema_version_with(online, false, task, many);
}

void check_whole_study(SQLite::Database& database, const fs::path& damaged) {
  if (database.execAndGet("SELECT count(*) FROM study").getInt() == 1 &&
      database.execAndGet("SELECT count(*) FROM stimuli").getInt() > 0)
    return;
  throw input_error({.file = damaged.string(),
                     .wanted = fmt::format("a log whose study can still be read (or its set: {} FOLDER)",
                                           request_name("set")),
                     .found = "none"});
}

}  // namespace

LogRecovery recover_log(const fs::path& damaged, const fs::path& out, const fs::path& set_folder) {
  check_is_file(damaged, EmptyFile::refuse);
  check_is_free(out);
  const TemporaryFolder scratch(out);
  SalvagedLog log = salvage_log(damaged, scratch.path());
  if (!has_tasks(log))  // read by the words of a log that has them
    for (LogRow& row : log["trials"]) row.resize(std::min(row.size(), trials_columns));
  const std::optional<RenderedSet> set = find_set(log, set_folder);
  LogRecovery recovery;
  const fs::path made = scratch.path() / "recovered.sqlite";
  with_log_errors(out, [&] {
    SQLite::Database database = open_or_create_log_database(
        made, [&](SQLite::Database& fresh) { Refill(fresh, log, recovery).fill(set); }, out,
        schema_version_for(log));
    check_whole_study(database, damaged);
    recovery.participants = lost_answers(database);
    database.exec("PRAGMA journal_mode = DELETE");  // one file, whole; the next session makes it WAL again
  });
  take_name(made, out);
  return recovery;
}

}  // namespace seamline::study
