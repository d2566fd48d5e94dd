#include "study/log_writer.h"

#include <fmt/core.h>

#include <cassert>
#include <chrono>

#include "stimuli/support/assets.h"
#include "study/log_database.h"

namespace seamline {
namespace fs = std::filesystem;
namespace {

std::int64_t now_unix_s() {
  using namespace std::chrono;
  return duration_cast<seconds>(system_clock::now().time_since_epoch()).count();
}

std::string kind_text(bool pilot, const std::string& observer, std::uint64_t seed) {
  if (!observer.empty()) return fmt::format("the simulated observer {} of seed {}", observer, seed);
  return pilot ? "a pilot participant" : "a participant";
}

void check_same(const fs::path& path, const char* field, const std::string& wanted,
                const std::string& found) {
  if (wanted == found) return;
  throw input_error({.file = path.string(),
                     .field = field,
                     .wanted = wanted + " (one log holds one set of one study; name another log file)",
                     .found = found});
}

void enter_stimuli(SQLite::Database& database, const std::vector<ManifestStimulus>& stimuli) {
  SQLite::Statement insert(database, "INSERT INTO stimuli VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (std::size_t i = 0; i < stimuli.size(); ++i) {
    const Stimulus& stimulus = stimuli[i].stimulus;
    run(insert, static_cast<std::int64_t>(i), stimuli[i].id, stimulus.scene,
        std::string(word(stimulus.artifact)), stimulus.object, stimulus.object_index,
        stimulus.condition.depth_width_px, stimulus.condition.yaw_texels, stimuli[i].sha256);
  }
}

void enter_study(SQLite::Database& database, const StudySet& set) {
  SQLite::Statement insert(database, "INSERT INTO study VALUES (1, ?, ?, ?, ?, ?, ?)");
  run(insert, set.study.name, set.manifest.study_hash, set.set_hash, set.folder.string(), set.study_text,
      program_version());
  enter_stimuli(database, set.manifest.stimuli);
}

/// The study and set of the log are those at hand. Writes where the set is now, which is the write test.
void claim_log(SQLite::Database& database, const fs::path& path, const StudySet& set) {
  SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
  SQLite::Statement row(database, "SELECT study_hash, set_hash FROM study");
  if (!row.executeStep())
    throw input_error({.file = path.string(), .field = "study", .wanted = "a study", .found = "none"});
  check_same(path, "study_hash", row.getColumn(0).getString(), set.manifest.study_hash);
  check_same(path, "set_hash", row.getColumn(1).getString(), set.set_hash);
  row.reset();
  SQLite::Statement moved(database, "UPDATE study SET set_folder = ?");
  run(moved, set.folder.string());
  transaction.commit();
}

}  // namespace

void check_participant_code(const std::string& code) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._-";
  if (!code.empty() && code.size() <= 64 && code.find_first_not_of(letters) == std::string::npos) return;
  throw input_error(
      {.field = "participant",
       .wanted = "a code of 1 to 64 letters A-Z a-z, digits, dots, dashes and underscores (never a name)",
       .found = "\"" + code + "\""});
}

struct LogWriter::Tables {
  explicit Tables(SQLite::Database opened) : database(std::move(opened)) {}

  SQLite::Database database;
  int depth = 0;  ///< of nested transactions; the outermost one counts
  SQLite::Statement find{database, R"sql(
      SELECT participant, slot, pilot, excluded, completed, observer, seed FROM participants WHERE code = ?)sql"};
  SQLite::Statement free_slot{database, R"sql(
      WITH taken AS (SELECT slot FROM participants
                     WHERE excluded = 0 AND pilot = ?1 AND (observer IS NOT NULL) = ?2)
      SELECT min(slot) FROM (SELECT 0 AS slot UNION ALL SELECT slot + 1 FROM taken) WHERE slot NOT IN taken)sql"};
  SQLite::Statement enter{
      database, "INSERT INTO participants (code, slot, pilot, observer, seed) VALUES (?, ?, ?, ?, ?)"};
  SQLite::Statement begin{
      database, "INSERT INTO sessions (participant, started_unix_s, program_version) VALUES (?, ?, ?)"};
  SQLite::Statement planned{database,
                            "SELECT stimulus FROM trials WHERE participant = ? ORDER BY trial_index"};
  SQLite::Statement answered{database, R"sql(
      SELECT trial_index, chosen_index, rating, choice_ns, rating_ns FROM answers
      WHERE participant = ? ORDER BY trial_index)sql"};
  SQLite::Statement plan{database,
                         "INSERT INTO trials (participant, trial_index, stimulus) VALUES (?, ?, ?)"};
  SQLite::Statement answer{database, R"sql(
      INSERT INTO answers (participant, trial_index, session, chosen_index, rating, choice_ns, rating_ns)
      VALUES (?, ?, ?, ?, ?, ?, ?))sql"};
  SQLite::Statement event{
      database,
      "INSERT INTO events (session, monotonic_ns, kind, trial_index, detail) VALUES (?, ?, ?, ?, ?)"};
  SQLite::Statement completed{database, "UPDATE participants SET completed = 1 WHERE participant = ?"};

  [[nodiscard]] std::optional<OpenSession> find_participant(const Enrolment& enrolment);
  [[nodiscard]] OpenSession enter_participant(const Enrolment& enrolment);
  [[nodiscard]] int slot_for(const Enrolment& enrolment);
  void read_progress(OpenSession& session, const fs::path& path);
};

std::optional<OpenSession> LogWriter::Tables::find_participant(const Enrolment& enrolment) {
  find.tryReset();
  SQLite::bind(find, enrolment.code);
  if (!find.executeStep()) return std::nullopt;
  const OpenSession session{.participant = find.getColumn(0).getInt64(),
                            .slot = find.getColumn(1).getInt(),
                            .completed = find.getColumn(4).getInt() != 0,
                            .excluded = find.getColumn(3).getInt() != 0};
  const bool pilot = find.getColumn(2).getInt() != 0;
  const std::string observer = find.getColumn(5).getString();
  const auto seed = static_cast<std::uint64_t>(find.getColumn(6).getInt64());
  find.tryReset();
  const Simulated wanted = enrolment.simulated.value_or(Simulated{});
  const std::string wanted_observer = enrolment.simulated ? std::string(word(wanted.observer)) : "";
  if (pilot != enrolment.pilot || observer != wanted_observer || (enrolment.simulated && seed != wanted.seed))
    throw input_error(
        {.file = database.getFilename(),
         .field = "participant " + enrolment.code,
         .wanted = kind_text(pilot, observer, seed) + ", as in the log (or another code or log)",
         .found = kind_text(enrolment.pilot, wanted_observer, wanted.seed)});
  return session;
}

int LogWriter::Tables::slot_for(const Enrolment& enrolment) {
  if (enrolment.slot) return *enrolment.slot;
  free_slot.tryReset();
  SQLite::bind(free_slot, enrolment.pilot ? 1 : 0, enrolment.simulated ? 1 : 0);
  free_slot.executeStep();
  const int slot = free_slot.getColumn(0).getInt();
  free_slot.tryReset();
  return slot;
}

OpenSession LogWriter::Tables::enter_participant(const Enrolment& enrolment) {
  const int slot = slot_for(enrolment);
  enter.tryReset();
  enter.clearBindings();
  SQLite::bind(enter, enrolment.code, slot, enrolment.pilot ? 1 : 0);
  if (enrolment.simulated) {
    enter.bind(4, std::string(word(enrolment.simulated->observer)));
    enter.bind(5, static_cast<std::int64_t>(enrolment.simulated->seed));
  }
  enter.exec();
  enter.tryReset();
  return {.participant = database.getLastInsertRowid(), .slot = slot};
}

void LogWriter::Tables::read_progress(OpenSession& session, const fs::path& path) {
  planned.tryReset();
  SQLite::bind(planned, session.participant);
  while (planned.executeStep()) session.planned.push_back(planned.getColumn(0).getInt());
  planned.tryReset();
  answered.tryReset();
  SQLite::bind(answered, session.participant);
  while (answered.executeStep())
    session.answers.push_back({.trial_index = answered.getColumn(0).getInt(),
                               .chosen_index = answered.getColumn(1).getInt(),
                               .rating = answered.getColumn(2).getInt(),
                               .choice_ns = answered.getColumn(3).getInt64(),
                               .rating_ns = answered.getColumn(4).getInt64()});
  answered.tryReset();
  session.answered = static_cast<int>(session.answers.size());
  const int expected_last = session.answers.empty() ? -1 : session.answers.back().trial_index;
  if (session.answered != expected_last + 1)
    throw input_error({.file = path.string(),
                       .field = "answers",
                       .wanted = "the first trials of a participant, without a gap",
                       .found = fmt::format("{} answers up to trial {}", session.answered, expected_last)});
}

LogWriter::LogWriter(fs::path path, const StudySet& set) : path_(std::move(path)) {
  const auto fill = [&](SQLite::Database& database) { enter_study(database, set); };
  SQLite::Database database = open_or_create_log_database(path_, fill);
  with_log_errors(path_, [&] {
    claim_log(database, path_, set);
    tables_ = std::make_unique<Tables>(std::move(database));
  });
}

LogWriter::~LogWriter() = default;

void LogWriter::transaction(const std::function<void()>& work) {
  if (tables_->depth > 0) return work();
  with_log_errors(path_, [&] {
    SQLite::Transaction transaction(tables_->database, SQLite::TransactionBehavior::IMMEDIATE);
    tables_->depth = 1;
    try {
      work();
      transaction.commit();
    } catch (...) {
      tables_->depth = 0;
      throw;
    }
    tables_->depth = 0;
  });
}

OpenSession LogWriter::open_session(const Enrolment& enrolment) {
  check_participant_code(enrolment.code);
  OpenSession session;
  transaction([&] {
    if (std::optional<OpenSession> found = tables_->find_participant(enrolment)) {
      session = *std::move(found);
      tables_->read_progress(session, path_);
    } else {
      session = tables_->enter_participant(enrolment);
    }
    if (session.completed || session.excluded) return;
    run(tables_->begin, session.participant, now_unix_s(), program_version());
    session.session = tables_->database.getLastInsertRowid();
  });
  return session;
}

void LogWriter::plan_trials(OpenSession& session, std::span<const int> stimuli) {
  transaction([&] {
    auto trial_index = static_cast<std::int64_t>(session.planned.size());
    for (const int stimulus : stimuli) run(tables_->plan, session.participant, trial_index++, stimulus);
  });
  session.planned.insert(session.planned.end(), stimuli.begin(), stimuli.end());
}

void LogWriter::append_answer(OpenSession& session, const TrialAnswer& answer) {
  assert(answer.trial_index == session.answered && session.session != 0);
  transaction([&] {
    run(tables_->answer, session.participant, answer.trial_index, session.session, answer.chosen_index,
        answer.rating, answer.choice_ns, answer.rating_ns);
  });
  session.answers.push_back(answer);
  ++session.answered;
}

void LogWriter::append_events(const OpenSession& session, std::span<const RawEvent> events) {
  transaction([&] {
    for (const RawEvent& event : events) {
      tables_->event.tryReset();
      tables_->event.clearBindings();
      SQLite::bind(tables_->event, session.session, event.monotonic_ns, event.kind);
      if (event.trial_index) tables_->event.bind(4, *event.trial_index);
      tables_->event.bind(5, event.detail);
      tables_->event.exec();
      tables_->event.tryReset();
    }
  });
}

void LogWriter::complete(OpenSession& session) {
  transaction([&] { run(tables_->completed, session.participant); });
  session.completed = true;
}

}  // namespace seamline
