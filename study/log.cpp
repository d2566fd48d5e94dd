#include "study/log.h"

#include "study/log_database.h"
#include "study/session_claims.h"

namespace seamline {
namespace fs = std::filesystem;
namespace {

void read_study_row(SQLite::Database& database, LogContents& log) {
  SQLite::Statement row(database,
                        "SELECT study_name, study_hash, set_hash, set_folder, study_text FROM study");
  if (!row.executeStep())
    throw input_error({.file = log.file.string(), .field = "study", .wanted = "a study", .found = "none"});
  log.study_name = row.getColumn(0).getString();
  log.study_hash = row.getColumn(1).getString();
  log.set_hash = row.getColumn(2).getString();
  log.set_folder = row.getColumn(3).getString();
  log.study_text = row.getColumn(4).getString();
}

std::vector<FormAnswer> read_form(SQLite::Database& database, std::int64_t participant) {
  SQLite::Statement row(database,
                        "SELECT field, value FROM form_answers WHERE participant = ? ORDER BY field");
  SQLite::bind(row, participant);
  std::vector<FormAnswer> form;
  while (row.executeStep())
    form.push_back({.field = row.getColumn(0).getString(), .value = row.getColumn(1).getString()});
  return form;
}

std::vector<ParticipantRecord> read_participants(SQLite::Database& database, const fs::path& file) {
  SQLite::Statement row(database, R"sql(
      SELECT code, pilot, excluded, observer, completed, seed,
             (SELECT count(*) FROM trials
              WHERE trials.participant = participants.participant AND kind = 'stimulus'),
             participant, slot, image_gain,
             (SELECT count(*) FROM sessions WHERE sessions.participant = participants.participant),
             (SELECT coalesce(max(last_unix_s), 0) FROM sessions
              WHERE sessions.participant = participants.participant),
             (SELECT coalesce(max(attempt), 0) FROM set_aside_answers
              WHERE set_aside_answers.participant = participants.participant)
      FROM participants ORDER BY participant)sql");
  std::vector<ParticipantRecord> participants;
  while (row.executeStep()) {
    const std::int64_t number = row.getColumn(7).getInt64();
    participants.push_back({.code = row.getColumn(0).getString(),
                            .pilot = row.getColumn(1).getInt() != 0,
                            .excluded = row.getColumn(2).getInt() != 0,
                            .simulated = !row.getColumn(3).isNull(),
                            .observer = row.getColumn(3).getString(),
                            .completed = row.getColumn(4).getInt() != 0,
                            .seed = static_cast<std::uint64_t>(row.getColumn(5).getInt64()),
                            .planned_trials = row.getColumn(6).getInt(),
                            .slot = row.getColumn(8).getInt(),
                            .sessions = row.getColumn(10).getInt(),
                            .restarts = row.getColumn(12).getInt(),
                            .last_seen_unix_s = row.getColumn(11).getInt64()});
    ParticipantRecord& record = participants.back();
    if (!row.getColumn(9).isNull()) record.image_gain = row.getColumn(9).getDouble();
    if (record.simulated) continue;
    record.in_progress = is_claimed(file, number);
    record.form = read_form(database, number);
  }
  return participants;
}

Artifact artifact_of(const std::string& text, const fs::path& file) {
  const std::optional<Artifact> artifact = artifact_from_word(text);
  if (!artifact)
    throw input_error({.file = file.string(),
                       .field = "stimuli.artifact",
                       .wanted = "a known artifact",
                       .found = "\"" + text + "\""});
  return *artifact;
}

std::vector<Answer> read_answers(SQLite::Database& database, const fs::path& file) {
  SQLite::Statement row(database, R"sql(
      SELECT code, trial_index, stimulus_id, scene, artifact, object, object_index, depth_width_px,
             chosen_index, rating, choice_ns, rating_ns, image_scale
      FROM answers JOIN trials USING (participant, trial_index) JOIN stimuli USING (stimulus)
                   JOIN participants USING (participant)
      WHERE kind = 'stimulus'
      ORDER BY participant, trial_index)sql");
  std::vector<Answer> answers;
  while (row.executeStep())
    answers.push_back({.participant = row.getColumn(0).getString(),
                       .trial_index = row.getColumn(1).getInt(),
                       .stimulus_id = row.getColumn(2).getString(),
                       .scene = row.getColumn(3).getString(),
                       .artifact = artifact_of(row.getColumn(4).getString(), file),
                       .object = row.getColumn(5).getString(),
                       .object_index = row.getColumn(6).getInt(),
                       .depth_width_px = row.getColumn(7).getInt(),
                       .chosen_index = row.getColumn(8).getInt(),
                       .rating = row.getColumn(9).getInt(),
                       .choice_ns = row.getColumn(10).getInt64(),
                       .rating_ns = row.getColumn(11).getInt64(),
                       .image_scale = row.getColumn(12).getDouble()});
  return answers;
}

std::vector<CatchTrialAnswer> read_catches(SQLite::Database& database) {
  SQLite::Statement row(database, R"sql(
      SELECT code, trial_index, kind, scene, object_index, chosen_index, rating, choice_ns, rating_ns
      FROM answers JOIN trials USING (participant, trial_index) JOIN stimuli USING (stimulus)
                   JOIN participants USING (participant)
      WHERE kind <> 'stimulus'
      ORDER BY participant, trial_index)sql");
  std::vector<CatchTrialAnswer> catches;
  while (row.executeStep()) {
    const TrialKind kind =
        trial_kind_from_word(row.getColumn(2).getString()).value();  // by the table's CHECK
    catches.push_back({.participant = row.getColumn(0).getString(),
                       .trial_index = row.getColumn(1).getInt(),
                       .kind = kind,
                       .scene = row.getColumn(3).getString(),
                       .right_index = kind == TrialKind::attention ? row.getColumn(4).getInt() : 0,
                       .chosen_index = row.getColumn(5).getInt(),
                       .rating = row.getColumn(6).getInt(),
                       .choice_ns = row.getColumn(7).getInt64(),
                       .rating_ns = row.getColumn(8).getInt64()});
  }
  return catches;
}

LogContents read_tables(SQLite::Database& database, const fs::path& path) {
  const SQLite::Transaction one_moment(database);  // a session may be writing meanwhile
  check_undamaged(database, path);
  LogContents log;
  log.file = path;
  read_study_row(database, log);
  log.participants = read_participants(database, path);
  log.answers = read_answers(database, path);
  log.catches = read_catches(database);
  log.forgotten_participants = database.execAndGet("SELECT count(*) FROM deletions").getInt();
  log.declined_visits = database.execAndGet("SELECT count(*) FROM declines").getInt();
  return log;
}

}  // namespace

LogContents read_log(const fs::path& path) {
  SQLite::Database database = open_log_database(path, LogAccess::read);
  return with_log_errors(path, [&] { return read_tables(database, path); });
}

}  // namespace seamline
