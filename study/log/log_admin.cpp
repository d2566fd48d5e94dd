#include "study/log/log_admin.h"

#include <fmt/core.h>

#include <algorithm>
#include <ctime>
#include <map>

#include "study/log/log_database.h"
#include "study/log/log_place.h"
#include "study/log/now.h"
#include "support/text/counted.h"

namespace seamline::study {
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

/// What a participant has answered.
struct AnswerCounts {
  int answered = 0;  ///< stimuli
  int attention = 0, attention_right = 0, references = 0;
};

void count(AnswerCounts& done, const CatchTrialAnswer& answer) {
  if (answer.kind == TrialKind::reference) ++done.references;
  if (answer.kind != TrialKind::attention) return;
  ++done.attention;
  done.attention_right += answer.right() ? 1 : 0;
}

/// 2026-01-31 13:45, in universal time.
std::string minute_text(std::int64_t unix_s) {
  const std::time_t time = unix_s;
  std::tm parts = {};
  ::gmtime_r(&time, &parts);
  return fmt::format("{:04}-{:02}-{:02} {:02}:{:02}", parts.tm_year + 1900, parts.tm_mon + 1, parts.tm_mday,
                     parts.tm_hour, parts.tm_min);
}

/// What is said only where there is something to say.
std::string more(const ParticipantRecord& participant, const AnswerCounts& done) {
  std::string text;
  if (done.attention > 0) text += fmt::format("  attention {} of {}", done.attention_right, done.attention);
  if (done.references > 0) text += fmt::format("  references {}", done.references);
  if (participant.simulated) return text;
  text += fmt::format("  order {}  last seen {} UTC", participant.slot,
                      minute_text(participant.last_seen_unix_s));
  if (participant.sessions > 1) text += fmt::format("  {} sessions", participant.sessions);
  if (participant.restarts > 0) text += "  began again " + counted(participant.restarts, "time");
  if (participant.in_progress)
    text += participant.completed ? "  the last page still open" : "  in a session now";
  return text;
}

bool took_part_in_browser(SQLite::Database& database, const std::string& code) {
  if (!has_online_tables(schema_version_of(database))) return false;
  SQLite::Statement row(
      database, "SELECT 1 FROM online_participants JOIN participants USING (participant) WHERE code = ?");
  SQLite::bind(row, code);
  return row.executeStep();
}

void delete_rows(SQLite::Database& database, const fs::path& log, const std::string& code) {
  SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
  SQLite::Statement record(database, R"sql(
      INSERT INTO deletions (deleted_unix_s, answers)
      SELECT ?, (SELECT count(*) FROM answers WHERE answers.participant = participants.participant)
      FROM participants WHERE code = ?)sql");
  run(record, now_unix_s(), code);
  SQLite::Statement forget(database, "DELETE FROM participants WHERE code = ?");
  run(forget, code);  // everything that hangs on the participant goes with it
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
  std::map<std::string, AnswerCounts> done;
  for (const Answer& answer : log.answers) ++done[answer.participant].answered;
  for (const CatchTrialAnswer& answer : log.catches) count(done[answer.participant], answer);
  std::size_t width = 4;
  for (const ParticipantRecord& participant : log.participants)
    width = std::max(width, participant.code.size());
  std::string text =
      fmt::format("{}: study {}, {}, {}, {} forgotten, {} declined\n", log.file.string(), log.study_name,
                  counted(log.participants.size(), "participant"), counted(log.answers.size(), "answer"),
                  log.forgotten_participants, log.declined_visits);
  for (const ParticipantRecord& participant : log.participants) {
    const AnswerCounts& own = done[participant.code];
    text += fmt::format("{:<{}}  {:<22}  {:>4} of {:>4}  {:<10}{}\n", participant.code, width,
                        who(participant), own.answered, participant.stimulus_trials,
                        state(participant, own.answered), more(participant, own));
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

bool has_participant(const fs::path& log, const std::string& code) {
  SQLite::Database database = open_log_database(log, LogAccess::read);
  return with_log_errors(log, [&] {
    SQLite::Statement row(database, "SELECT 1 FROM participants WHERE code = ?");
    SQLite::bind(row, code);
    return row.executeStep();
  });
}

bool forget_participant(const fs::path& log, const std::string& code) {
  SQLite::Database database = open_log_database(log, LogAccess::alone);
  return with_log_errors(log, [&] {
    const bool in_browser = took_part_in_browser(database, code);
    delete_rows(database, log, code);
    erase_free_pages(database);
    fs::remove(claims_file(log));  // nobody has it open: the log is ours alone
    return in_browser;
  });
}

}  // namespace seamline::study
