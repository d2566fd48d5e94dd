// Who is in the log, and how far they have come.
#include <fmt/core.h>

#include "study/log/log_tables.h"
#include "study/log/log_values.h"
#include "support/files/assets.h"
#include "support/text/counted.h"

namespace seamline::study {
namespace {

/// What a participant is, for the sentence that refuses another.
std::string kind_text(bool pilot, const std::string& observer, std::uint64_t seed,
                      const std::optional<double>& gain) {
  if (!observer.empty())
    return fmt::format("the simulated observer {} of seed {}{}", observer, seed,
                       gain ? fmt::format(" and gain {}", *gain) : "");
  return pilot ? "a pilot participant" : "a participant";
}

std::string kind_text(const Enrolment& enrolment) {
  if (!enrolment.simulated) return kind_text(enrolment.pilot, "", 0, {});
  const Simulated& simulated = *enrolment.simulated;
  return kind_text(false, std::string(word(simulated.observer)), simulated.seed, simulated.image_gain);
}

}  // namespace

std::optional<OpenSession> LogWriter::Tables::find_participant(const Enrolment& enrolment) {
  SQLite::Statement row(database, R"sql(
      SELECT participant, slot, pilot, excluded, completed, observer, seed, image_gain,
             EXISTS (SELECT 1 FROM consents WHERE consents.participant = participants.participant),
             EXISTS (SELECT 1 FROM form_answers WHERE form_answers.participant = participants.participant)
      FROM participants WHERE code = ?)sql");
  SQLite::bind(row, enrolment.code);
  if (!row.executeStep()) return std::nullopt;
  OpenSession session{.participant = row.getColumn(0).getInt64(),
                      .slot = row.getColumn(1).getInt(),
                      .completed = row.getColumn(4).getInt() != 0,
                      .excluded = row.getColumn(3).getInt() != 0,
                      .consented = row.getColumn(8).getInt() != 0,
                      .form_done = row.getColumn(9).getInt() != 0};
  std::optional<double> gain;
  if (!row.getColumn(7).isNull()) gain = row.getColumn(7).getDouble();
  const std::string in_log = kind_text(row.getColumn(2).getInt() != 0, row.getColumn(5).getString(),
                                       static_cast<std::uint64_t>(row.getColumn(6).getInt64()), gain);
  if (in_log != kind_text(enrolment))
    throw input_error({.file = path.string(),
                       .field = "participant " + enrolment.code,
                       .wanted = in_log + ", as in the log (or another code or log)",
                       .found = kind_text(enrolment)});
  check_not_in_a_browser(enrolment.code);
  read_trials(session);
  read_answers(session);
  return session;
}

/// Their messages come numbered from the browser, which would know nothing of answers given here.
void LogWriter::Tables::check_not_in_a_browser(const std::string& code) {
  if (!has_online_tables(schema_version_of(database))) return;
  SQLite::Statement row(
      database,
      "SELECT origin FROM online_participants JOIN participants USING (participant) WHERE code = ?");
  SQLite::bind(row, code);
  if (!row.executeStep()) return;
  throw input_error({.file = path.string(),
                     .field = "participant " + code,
                     .wanted = "a participant of the window",
                     .found = "one who takes part in a browser (" + row.getColumn(0).getString() + ")"});
}

OpenSession LogWriter::Tables::enter_participant(const Enrolment& enrolment) {
  SQLite::Statement enter(
      database,
      "INSERT INTO participants (code, slot, pilot, observer, seed, image_gain) VALUES (?, ?, ?, ?, ?, ?)");
  SQLite::bind(enter, enrolment.code, enrolment.slot, enrolment.pilot ? 1 : 0);
  if (enrolment.simulated) {
    enter.bind(4, std::string(word(enrolment.simulated->observer)));
    enter.bind(5, static_cast<std::int64_t>(enrolment.simulated->seed));
    if (enrolment.simulated->image_gain) enter.bind(6, *enrolment.simulated->image_gain);
  }
  enter.exec();
  return {.participant = database.getLastInsertRowid(), .slot = enrolment.slot};
}

void LogWriter::Tables::read_trials(OpenSession& session) {
  SQLite::Statement row(
      database, has_right_index ? "SELECT kind, stimulus, right_index FROM trials WHERE participant = ? "
                                  "ORDER BY trial_index"
                                : "SELECT kind, stimulus, 0 AS right_index FROM trials WHERE "
                                  "participant = ? ORDER BY trial_index");
  SQLite::bind(row, session.participant);
  const LogValues values(row, path, "trials");
  while (row.executeStep())
    session.trials.push_back(
        {.kind = values.kind(0), .stimulus = values.number(1, 0), .right_index = values.number(2, 0, 3)});
}

void LogWriter::Tables::read_answers(OpenSession& session) {
  SQLite::Statement row(database, R"sql(
      SELECT trial_index, chosen_index, rating, choice_ns, rating_ns FROM answers
      WHERE participant = ? ORDER BY trial_index)sql");
  SQLite::bind(row, session.participant);
  const LogValues values(row, path, "answers");
  while (row.executeStep())
    session.answers.push_back({.trial_index = values.number(0, 0),
                               .chosen_index = values.number(1, 1, most_objects_of_scene),
                               .rating = values.number(2, 1, 4),
                               .choice_ns = values.time(3),
                               .rating_ns = values.time(4)});
  session.answered = static_cast<int>(session.answers.size());
  const int last = session.answers.empty() ? -1 : session.answers.back().trial_index;
  if (session.answered != last + 1)
    throw input_error({.file = path.string(),
                       .field = "answers",
                       .wanted = "the first trials of a participant, without a gap",
                       .found = fmt::format("{} up to trial {}", counted(session.answered, "answer"), last)});
}

std::optional<KnownParticipant> LogWriter::find(const Enrolment& enrolment) {
  check_participant_code(enrolment.code);
  tables_->claims.open();  // before anybody sees anything
  return with_log_errors(path_, [&]() -> std::optional<KnownParticipant> {
    const std::optional<OpenSession> found = tables_->find_participant(enrolment);
    if (!found) return std::nullopt;
    return KnownParticipant{.answered = found->answered,
                            .consented = found->consented,
                            .completed = found->completed,
                            .excluded = found->excluded,
                            .in_progress = tables_->claims.claimed_elsewhere(found->participant)};
  });
}

std::vector<HeldSlot> LogWriter::held_slots(const Enrolment& enrolment) {
  return with_log_errors(path_, [&] {
    SQLite::Statement row(tables_->database, R"sql(
        SELECT slot, completed FROM participants
        WHERE excluded = 0 AND pilot = ? AND (observer IS NOT NULL) = ?)sql");
    SQLite::bind(row, enrolment.pilot ? 1 : 0, enrolment.simulated ? 1 : 0);
    const LogValues values(row, path_, "participants");
    std::vector<HeldSlot> held;
    while (row.executeStep())
      held.push_back({.slot = values.number(0, 0), .completed = row.getColumn(1).getInt() != 0});
    return held;
  });
}

OpenSession LogWriter::open_session(const Enrolment& enrolment) {
  check_participant_code(enrolment.code);
  OpenSession session;
  transaction([&] {
    if (std::optional<OpenSession> found = tables_->find_participant(enrolment))
      session = *std::move(found);
    else
      session = tables_->enter_participant(enrolment);
    if (!enrolment.simulated && !tables_->claims.claim(session.participant))
      throw input_error(
          {.file = path_.string(),
           .field = "participant " + enrolment.code,
           .wanted = "a participant who is not in a session",
           .found = "a session of theirs that is open in another window or on another machine"});
    session.simulated = enrolment.simulated.has_value();
    if (session.completed || session.excluded) return;
    run(tables_->begin, session.participant, now_unix_s(), program_version());
    session.session = tables_->database.getLastInsertRowid();
  });
  return session;
}

}  // namespace seamline::study
