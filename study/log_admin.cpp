#include "study/log_admin.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <map>

#include "study/log_database.h"

namespace seamline {
namespace fs = std::filesystem;
namespace {

InputError unknown_code(const fs::path& log, const std::string& code) {
  return input_error({.file = log.string(),
                      .field = "participant",
                      .wanted = "a code that is in the log",
                      .found = "\"" + code + "\""});
}

std::string who(const ParticipantRecord& participant) {
  if (participant.simulated) return fmt::format("simulated ({})", participant.observer);
  return participant.pilot ? "pilot" : "person";
}

std::string state(const ParticipantRecord& participant, int answered) {
  if (participant.excluded) return "excluded";
  if (participant.completed) return "complete";
  return answered == 0 ? "not begun" : "unfinished";
}

std::int64_t now_unix_s() {
  using namespace std::chrono;
  return duration_cast<seconds>(system_clock::now().time_since_epoch()).count();
}

void delete_rows(SQLite::Database& database, const fs::path& log, const std::string& code) {
  SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
  SQLite::Statement record(database, R"sql(
      INSERT INTO deletions (deleted_unix_s, answers)
      SELECT ?, (SELECT count(*) FROM answers WHERE answers.participant = participants.participant)
      FROM participants WHERE code = ?)sql");
  run(record, now_unix_s(), code);
  SQLite::Statement forget(database, "DELETE FROM participants WHERE code = ?");
  run(forget, code);  // trials, answers, sessions and events go with it
  if (forget.getChanges() == 0) throw unknown_code(log, code);
  transaction.commit();
}

/// Writes every page anew and empties the write-ahead log, so that no deleted byte is left in either file.
void erase_free_pages(SQLite::Database& database) {
  database.exec("VACUUM");
  database.execAndGet("PRAGMA wal_checkpoint(TRUNCATE)");
}

}  // namespace

std::string status_text(const LogContents& log) {
  std::map<std::string, int> answered;
  for (const Answer& answer : log.answers) ++answered[answer.participant];
  std::size_t width = 4;
  for (const ParticipantRecord& participant : log.participants)
    width = std::max(width, participant.code.size());
  std::string text =
      fmt::format("{}: study {}, {} participants, {} answers, {} forgotten\n", log.file.string(),
                  log.study_name, log.participants.size(), log.answers.size(), log.forgotten_participants);
  for (const ParticipantRecord& participant : log.participants) {
    const int done = answered[participant.code];
    text += fmt::format("{:<{}}  {:<22}  {:>4} of {:>4}  {}\n", participant.code, width, who(participant),
                        done, participant.planned_trials, state(participant, done));
  }
  return text;
}

void exclude_participant(const fs::path& log, const std::string& code) {
  SQLite::Database database = open_log_database(log, LogAccess::write);
  with_log_errors(log, [&] {
    SQLite::Statement exclude(database, "UPDATE participants SET excluded = 1 WHERE code = ?");
    run(exclude, code);
    if (exclude.getChanges() == 0) throw unknown_code(log, code);
  });
}

void forget_participant(const fs::path& log, const std::string& code) {
  SQLite::Database database = open_log_database(log, LogAccess::alone);
  with_log_errors(log, [&] {
    delete_rows(database, log, code);
    erase_free_pages(database);
  });
}

}  // namespace seamline
