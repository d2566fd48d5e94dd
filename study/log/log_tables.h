#pragma once

#include "study/log/log_database.h"
#include "study/log/log_place.h"
#include "study/log/log_writer.h"
#include "study/log/now.h"
#include "study/log/session_claims.h"

// Inside the log only: what a LogWriter holds, and the statements that every answer needs.
namespace seamline::study {

struct LogWriter::Tables {
  Tables(SQLite::Database opened, const std::filesystem::path& log)
      : path(log),
        place(place_of(opened)),
        claims(place),
        file(file_identity(place)),
        ahead(file_identity(ahead_file(place))),
        database(std::move(opened)) {}

  std::filesystem::path path;   ///< as it was given, for people
  std::filesystem::path place;  ///< where the open file is; a link may lead elsewhere by now
  SessionClaims claims;
  std::optional<FileIdentity> file, ahead;  ///< of the log and its write-ahead log, as they were opened
  SQLite::Database database;
  bool has_right_index = knows_tasks(schema_version_of(database));  ///< of trials
  int depth = 0;  ///< of nested transactions; the outermost one counts
  SQLite::Statement begin{
      database,
      "INSERT INTO sessions (participant, started_unix_s, last_unix_s, program_version) VALUES (?1, ?2, ?2, "
      "?3)"};
  SQLite::Statement trial{
      database, has_right_index
                    ? "INSERT INTO trials (participant, trial_index, kind, stimulus, right_index) VALUES "
                      "(?, ?, ?, ?, ?)"
                    : "INSERT INTO trials (participant, trial_index, kind, stimulus) VALUES (?, ?, ?, ?)"};
  SQLite::Statement answer{database, R"sql(
      INSERT INTO answers (participant, trial_index, session, chosen_index, rating, choice_ns, rating_ns, image_scale)
      VALUES (?, ?, ?, ?, ?, ?, ?, ?))sql"};
  SQLite::Statement seen{database, "UPDATE sessions SET last_unix_s = ? WHERE session = ?"};
  SQLite::Statement event{database,
                          "INSERT INTO events (session, monotonic_ns, kind, trial_index, detail, swap) "
                          "VALUES (?, ?, ?, ?, ?, ?)"};

  /// The participant of a code, with their progress, unless there is none. Throws InputError when the code is
  /// of another kind.
  [[nodiscard]] std::optional<OpenSession> find_participant(const Enrolment& enrolment);
  [[nodiscard]] OpenSession enter_participant(const Enrolment& enrolment);

  /// Throws InputError when the log or its write-ahead log was deleted or moved: SQLite would go on writing
  /// into a file that nobody can find again.
  void check_still_there() const;

  void read_trials(OpenSession& session);

  /// Of a match, an event `matched` with the id of the stimulus at which the participant stopped; of a slider
  /// an event `slid` with its place; nothing of other answers. Its time is that of the answer, from the
  /// picture's onset. Call it in the transaction of the answer.
  void note_where(std::int64_t session, const TrialAnswer& given);

 private:
  void check_not_in_a_browser(const std::string& code);
  void read_answers(OpenSession& session);
};

/// The study of a set; its stimuli that the log does not have, and how many those were.
void enter_study_row(SQLite::Database& database, const RenderedSet& set);
std::int64_t enter_missing_stimuli(SQLite::Database& database, const std::vector<ManifestStimulus>& stimuli);

}  // namespace seamline::study
