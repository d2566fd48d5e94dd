#include "study/log/log.h"

#include <fmt/core.h>

#include <map>

#include "stimuli/study_file/parts/study_file_condition_task.h"
#include "stimuli/study_file/parts/study_file_task.h"
#include "study/log/log_database.h"
#include "study/log/log_values.h"
#include "study/log/session_claims.h"
#include "support/text/printable.h"

namespace seamline::study {
namespace fs = std::filesystem;
namespace {

Quantity quantity_of(const std::string& text, const fs::path& file) {
  const std::optional<Quantity> quantity = quantity_from_key(text);
  if (!quantity)
    throw input_error({.file = file.string(),
                       .field = "study.quantity",
                       .wanted = "a known quantity",
                       .found = "\"" + printable(text, 40) + "\""});
  return *quantity;
}

Direction noticeability_of(const std::string& text, const fs::path& file) {
  for (const Direction direction : {Direction::decreasing, Direction::increasing})
    if (text == noticeability_word(direction)) return direction;
  throw input_error({.file = file.string(),
                     .field = "study.noticeability",
                     .wanted = "\"falls\" or \"rises\"",
                     .found = "\"" + printable(text, 40) + "\""});
}

void read_study_row(SQLite::Database& database, LogContents& log) {
  const bool since_3 = schema_version_of(database) >= 3;
  SQLite::Statement row(database, since_3
                                      ? "SELECT study_name, study_hash, set_hash, set_folder, study_text, "
                                        "quantity, noticeability FROM study"
                                      : "SELECT study_name, study_hash, set_hash, set_folder, study_text, "
                                        "'depth_width_px' AS quantity, 'falls' AS noticeability FROM study");
  if (!row.executeStep())
    throw input_error({.file = log.file.string(), .field = "study", .wanted = "a study", .found = "none"});
  const LogValues values(row, log.file, "study");
  log.study_name = values.text(0);
  log.study_hash = values.text(1);
  log.set_hash = values.text(2);
  log.set_folder = row.getColumn(3).getString();
  log.study_text = row.getColumn(4).getString();
  log.quantity = quantity_of(row.getColumn(5).getString(), log.file);
  log.noticeability = noticeability_of(row.getColumn(6).getString(), log.file);
}

std::vector<FormAnswer> read_form(SQLite::Database& database, std::int64_t participant) {
  SQLite::Statement row(database,
                        "SELECT field, value FROM form_answers WHERE participant = ? ORDER BY field");
  SQLite::bind(row, participant);
  std::vector<FormAnswer> form;
  while (row.executeStep())
    form.push_back({.field = clean_text(row.getColumn(0).getString()),
                    .value = clean_text(row.getColumn(1).getString())});
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
  const LogValues values(row, file, "participants");
  while (row.executeStep()) {
    const std::int64_t number = row.getColumn(7).getInt64();
    participants.push_back({.code = values.code(0),
                            .pilot = values.flag(1),
                            .excluded = values.flag(2),
                            .simulated = !row.getColumn(3).isNull(),
                            .observer = values.text(3),
                            .completed = values.flag(4),
                            .seed = static_cast<std::uint64_t>(row.getColumn(5).getInt64()),
                            .stimulus_trials = row.getColumn(6).getInt(),
                            .slot = values.number(8, 0),
                            .sessions = row.getColumn(10).getInt(),
                            .restarts = row.getColumn(12).getInt(),
                            .last_seen_unix_s = values.time(11)});
    ParticipantRecord& record = participants.back();
    if (!row.getColumn(9).isNull()) record.image_gain = values.positive(9);
    record.form = read_form(database, number);
    if (!record.simulated) record.in_progress = is_claimed(file, number);
  }
  return participants;
}

/// In a log that knows browsers.
void read_origins(SQLite::Database& database, const fs::path& file,
                  std::vector<ParticipantRecord>& participants) {
  if (!has_online_tables(schema_version_of(database))) return;
  SQLite::Statement row(database,
                        "SELECT code, origin FROM online_participants JOIN participants USING (participant)");
  std::map<std::string, Origin> origin_of;
  while (row.executeStep()) {
    const std::optional<Origin> origin = origin_from_word(row.getColumn(1).getString());
    if (!origin)
      throw input_error({.file = file.string(),
                         .field = "online_participants.origin",
                         .wanted = "a known origin",
                         .found = "\"" + printable(row.getColumn(1).getString(), 40) + "\""});
    origin_of[row.getColumn(0).getString()] = *origin;
  }
  for (ParticipantRecord& participant : participants)
    if (const auto found = origin_of.find(participant.code); found != origin_of.end())
      participant.origin = found->second;
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

/// Which alternative was right; 0 where the study names no task.
const char* right_column(int version) {
  return knows_tasks(version) ? "right_index" : "0 AS right_index";
}

constexpr const char* answers_sql = R"sql(
      SELECT code, trial_index, stimulus_id, scene, artifact, object, object_index, depth_width_px,
             chosen_index, rating, choice_ns, rating_ns, image_scale, condition, level, {}
      FROM answers JOIN trials USING (participant, trial_index) JOIN stimuli USING (stimulus)
                   JOIN participants USING (participant)
      WHERE kind = 'stimulus'
      ORDER BY participant, trial_index)sql";

/// The widths are the levels.
constexpr const char* answers_sql_of_version_2 = R"sql(
      SELECT code, trial_index, stimulus_id, scene, artifact, object, object_index, depth_width_px,
             chosen_index, rating, choice_ns, rating_ns, image_scale, '' AS condition,
             CAST(depth_width_px AS REAL) AS level, {}
      FROM answers JOIN trials USING (participant, trial_index) JOIN stimuli USING (stimulus)
                   JOIN participants USING (participant)
      WHERE kind = 'stimulus'
      ORDER BY participant, trial_index)sql";

std::vector<Answer> read_answers(SQLite::Database& database, const fs::path& file, Quantity quantity) {
  const int version = schema_version_of(database);
  SQLite::Statement row(database,
                        fmt::format(fmt::runtime(version >= 3 ? answers_sql : answers_sql_of_version_2),
                                    right_column(version)));
  const LogValues values(row, file, "answers");
  const QuantityFacts& level = facts(quantity);
  std::vector<Answer> answers;
  while (row.executeStep())
    answers.push_back({.participant = values.text(0),
                       .trial_index = values.number(1, 0),
                       .stimulus_id = values.text(2),
                       .scene = values.text(3),
                       .artifact = artifact_of(row.getColumn(4).getString(), file),
                       .object = values.text(5),
                       .object_index = values.number(6, 1, most_objects_of_scene),
                       .depth_width_px = values.number(7, 2),
                       .condition = values.text(13),
                       .level = values.real(14, level.least, level.most),
                       .chosen_index = values.number(8, 1, most_objects_of_scene),
                       .rating = values.number(9, 1, 4),
                       .choice_ns = values.time(10),
                       .rating_ns = values.time(11),
                       .image_scale = values.positive(12),
                       .right_index = values.number(15, 0, most_objects_of_scene)});
  return answers;
}

std::vector<CatchTrialAnswer> read_catches(SQLite::Database& database, const fs::path& file) {
  const int version = schema_version_of(database);
  const char* right = right_column(version);
  SQLite::Statement row(database, fmt::format(R"sql(
      SELECT code, trial_index, kind, scene, object_index, chosen_index, rating, choice_ns, rating_ns, {}, {}
      FROM answers JOIN trials USING (participant, trial_index) JOIN stimuli USING (stimulus)
                   JOIN participants USING (participant)
      WHERE kind <> 'stimulus'
      ORDER BY participant, trial_index)sql",
                                              right, version >= 3 ? "condition" : "'' AS condition"));
  const LogValues values(row, file, "answers");
  std::vector<CatchTrialAnswer> catches;
  while (row.executeStep()) {
    const TrialKind kind = values.kind(2);
    const int right_index = values.number(9, 0, most_objects_of_scene);
    catches.push_back({.participant = values.text(0),
                       .trial_index = values.number(1, 0),
                       .kind = kind,
                       .scene = values.text(3),
                       .right_index = right_index != 0 ? right_index
                                      : kind == TrialKind::attention
                                          ? values.number(4, 1, most_objects_of_scene)
                                          : 0,
                       .chosen_index = values.number(5, 1, most_objects_of_scene),
                       .rating = values.number(6, 1, 4),
                       .choice_ns = values.time(7),
                       .rating_ns = values.time(8),
                       .condition = values.text(10)});
  }
  return catches;
}

LogContents read_tables(SQLite::Database& database, const fs::path& path) {
  const SQLite::Transaction one_moment(database);  // a session may be writing meanwhile
  check_undamaged(database, path);
  LogContents log;
  log.file = path;
  read_study_row(database, log);
  if (knows_tasks(schema_version_of(database))) {
    log.task = read_task_text(log.study_text, path);
    log.own_tasks = read_condition_tasks_text(log.study_text, path);
  }
  log.participants = read_participants(database, path);
  read_origins(database, path, log.participants);
  log.answers = read_answers(database, path, log.quantity);
  log.catches = read_catches(database, path);
  log.forgotten_participants = database.execAndGet("SELECT count(*) FROM deletions").getInt();
  log.declined_visits = database.execAndGet("SELECT count(*) FROM declines").getInt();
  return log;
}

}  // namespace

std::shared_ptr<const TaskDefinition> task_of(const LogContents& log, const std::string& condition) {
  const auto own = log.own_tasks.find(condition);
  return own == log.own_tasks.end() ? log.task : own->second;
}

LogContents read_log(const fs::path& path) {
  SQLite::Database database = open_log_database(path, LogAccess::read);
  return with_log_errors(path, [&] { return read_tables(database, path); });
}

}  // namespace seamline::study
