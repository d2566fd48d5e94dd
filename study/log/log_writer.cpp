#include "study/log/log_writer.h"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <exception>

#include "stimuli/definition/looks/condition_tasks.h"
#include "stimuli/set/manifest_pictures.h"
#include "stimuli/set/set_study.h"
#include "stimuli/study_file/study_file.h"
#include "study/log/log_create.h"
#include "study/log/log_tables.h"
#include "support/files/assets.h"
#include "support/text/printable.h"

namespace seamline::study {
namespace fs = std::filesystem;
namespace {

/// A sound log, but of another study or set.
struct OtherStudy : InputError {
  explicit OtherStudy(const InputError& error) : InputError(error) {}
};

/// A hash, and whose it is, in words that people know.
std::string named_hash(const std::string& hash, const std::string& study, const std::string& set_folder) {
  return fmt::format("{} of study \"{}\", set {}", hash, printable(study, 80), printable(set_folder));
}

}  // namespace

std::int64_t enter_missing_stimuli(SQLite::Database& database, const std::vector<ManifestStimulus>& stimuli) {
  SQLite::Statement insert(
      database,
      "INSERT INTO stimuli VALUES (?, ?, ?, ?, ?, ?, ?, "
      "CASE WHEN ?8 = CAST(?8 AS INTEGER) THEN CAST(?8 AS INTEGER) ELSE ?8 END, "  // whole yaws as ever
      "?, ?, ?) ON CONFLICT (stimulus) DO NOTHING");
  std::int64_t entered = 0;
  for (std::size_t i = 0; i < stimuli.size(); ++i) {
    const Stimulus& stimulus = stimuli[i].stimulus;
    run(insert, static_cast<std::int64_t>(i), stimuli[i].id, stimulus.scene,
        std::string(word(stimulus.artifact)), stimulus.object, stimulus.object_index, stimulus.depth.width_px,
        stimulus.depth.yaw_texels, shown_sha256(stimuli[i]), stimulus.condition, stimulus.level);
    entered += insert.getChanges();
  }
  return entered;
}

void enter_study_row(SQLite::Database& database, const RenderedSet& set) {
  SQLite::Statement insert(database, "INSERT INTO study VALUES (1, ?, ?, ?, ?, ?, ?, ?, ?)");
  run(insert, set.study.name, set.manifest.study_hash, set.set_hash, set.folder.string(), set.study_text,
      program_version(), std::string(facts(set.study.level.quantity).key),
      std::string(noticeability_word(set.study.level.noticeability)));
}

namespace {

void enter_study(SQLite::Database& database, const RenderedSet& set) {
  enter_study_row(database, set);
  const std::int64_t wanted = set.manifest.stimuli.size();
  const std::int64_t entered = enter_missing_stimuli(database, set.manifest.stimuli);
  if (entered != wanted)
    throw input_error({.file = (set.folder / "manifest.json").string(),
                       .field = "stimuli",
                       .wanted = "each stimulus id once",
                       .found = std::to_string(entered) + " different ones among " + std::to_string(wanted)});
}

/// Whose log it is.
struct LogIdentity {
  std::string study_name, study_hash, set_hash, set_folder, study_text;
};

LogIdentity identity_of(SQLite::Database& database, const fs::path& path) {
  SQLite::Statement row(database,
                        "SELECT study_name, study_hash, set_hash, set_folder, study_text FROM study");
  if (!row.executeStep())
    throw input_error({.file = path.string(), .field = "study", .wanted = "a study", .found = "none"});
  return {.study_name = row.getColumn(0).getString(),
          .study_hash = row.getColumn(1).getString(),
          .set_hash = row.getColumn(2).getString(),
          .set_folder = row.getColumn(3).getString(),
          .study_text = row.getColumn(4).getString()};
}

/// Trials name stimuli by their place in the manifest.
void check_stimuli(SQLite::Database& database, const fs::path& path,
                   const std::vector<ManifestStimulus>& wanted) {
  SQLite::Statement row(database, R"sql(
      SELECT stimulus, stimulus_id, scene, artifact, object, object_index, depth_width_px, yaw_texels, sha256,
             condition, level
      FROM stimuli ORDER BY stimulus)sql");
  std::size_t same = 0;
  while (row.executeStep() && same < wanted.size()) {
    const ManifestStimulus& record = wanted[same];
    const Stimulus& stimulus = record.stimulus;
    if (row.getColumn(0).getInt64() != static_cast<std::int64_t>(same) ||
        row.getColumn(1).getString() != record.id || row.getColumn(2).getString() != stimulus.scene ||
        row.getColumn(3).getString() != word(stimulus.artifact) ||
        row.getColumn(4).getString() != stimulus.object ||
        row.getColumn(5).getInt64() != stimulus.object_index ||
        row.getColumn(6).getInt64() != stimulus.depth.width_px ||
        row.getColumn(7).getDouble() != stimulus.depth.yaw_texels ||
        row.getColumn(8).getString() != shown_sha256(record) ||
        row.getColumn(9).getString() != stimulus.condition || row.getColumn(10).getDouble() != stimulus.level)
      break;
    ++same;
  }
  if (same == wanted.size() && row.isDone()) return;
  throw input_error(
      {.file = path.string(),
       .field = "stimuli",
       .wanted = "the stimuli of the set that the log names (`seamline log recover LOG OUT --set SET` takes "
                 "them from it)",
       .found = fmt::format("other ones from place {} on", same)});
}

/// Whether the log's set is this one but for the [observer] of its study, which is part of both hashes. The
/// stimuli are compared one by one (`check_stimuli`).
bool is_set_but_observer(const LogIdentity& log, const RenderedSet& set) {
  try {
    return set_hash_as(set.folder, log.study_hash) == log.set_hash &&
           same_but_observer(read_study_text(log.study_text, "the log's study"), set.study);
  } catch (const InputError&) {
    return false;  // a text of another program's time
  }
}

/// The study and set of the log are those at hand. Writes where the set is now, which is the write test.
void claim_log(SQLite::Database& database, const fs::path& path, const RenderedSet& set) {
  SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
  const LogIdentity log = identity_of(database, path);
  const bool is_other = log.study_hash != set.manifest.study_hash && is_set_but_observer(log, set);
  const auto check = [&](const char* field, const std::string& wanted, const std::string& found) {
    if (wanted == found) return;
    throw OtherStudy(input_error({.file = path.string(),
                                  .field = field,
                                  .wanted = named_hash(wanted, log.study_name, log.set_folder) +
                                            " (one log holds one set of one study; name another log file)",
                                  .found = named_hash(found, set.study.name, set.folder.string())}));
  };
  if (!is_other) {
    check("study_hash", log.study_hash, set.manifest.study_hash);
    check("set_hash", log.set_hash, set.set_hash);
  }
  check_stimuli(database, path, set.manifest.stimuli);
  SQLite::Statement moved(database, "UPDATE study SET set_folder = ?");
  run(moved, is_other ? log.set_folder : set.folder.string());
  transaction.commit();
}

/// Whether a log's text of the study means what the set's does, [observer] and all.
bool means_the_same(const std::string& log_text, const RenderedSet& set) {
  if (log_text == set.study_text) return true;
  try {
    return canonical_text(read_study_text(log_text, "the log's study")) ==
           canonical_text(read_study_text(set.study_text, set.folder / set.manifest.study_file));
  } catch (const InputError&) {
    return true;  // a text of another program's time: nobody can tell
  }
}

bool is_there(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

}  // namespace

LogWriter::LogWriter(fs::path path, const RenderedSet& set)
    : path_(std::move(path)), begun_here_(!is_there(path_)), exceptions_(std::uncaught_exceptions()) {
  try {
    open(set);
  } catch (const OtherStudy&) {
    if (!remove_log_of_nobody(path_)) throw;
    open(set);  // what a session left that stored nothing belongs to no study
  } catch (...) {
    if (begun_here_) (void)remove_log_of_nobody(path_);
    throw;
  }
}

void LogWriter::open(const RenderedSet& set) {
  const auto fill = [&](SQLite::Database& database) { enter_study(database, set); };
  const auto& stimuli = set.manifest.stimuli;
  const bool mirrors = std::any_of(stimuli.begin(), stimuli.end(), [](const auto& one) {
    return one.stimulus.artifact == Artifact::reflection;
  });
  SQLite::Database database = open_or_create_log_database(
      path_, fill, {},
      log_schema_version_with(false, mirrors, set.study.task || has_own_tasks(set.study),
                              objects_of(set.study) > usual_objects));
  with_log_errors(path_, [&] {
    check_undamaged(database, path_);
    claim_log(database, path_, set);
    tables_ = std::make_unique<Tables>(std::move(database), path_);
  });
}

LogWriter::~LogWriter() {
  tables_.reset();
  if (begun_here_ && std::uncaught_exceptions() > exceptions_) (void)remove_log_of_nobody(path_);
}

void LogWriter::take_observer(const RenderedSet& set) {
  transaction([&] {
    if (means_the_same(identity_of(tables_->database, path_).study_text, set)) return;
    SQLite::Statement simulated(tables_->database, "SELECT 1 FROM participants WHERE observer IS NOT NULL");
    if (simulated.executeStep())
      throw input_error({.file = (set.folder / set.manifest.study_file).string(),
                         .field = "observer",
                         .wanted = "that of the simulated observers in " + path_.string() +
                                   " (to simulate others name another log file)",
                         .found = "another one"});
    SQLite::Statement taken(tables_->database, "UPDATE study SET study_text = ?");
    run(taken, set.study_text);
  });
}

void LogWriter::Tables::check_still_there() const {
  if (file_identity(place) == file && file_identity(ahead_file(place)) == ahead) return;
  throw input_error({.file = path.string(),
                     .wanted = "the log where it was when the session began",
                     .found = "nothing or another file: it was deleted or moved meanwhile"});
}

void LogWriter::transaction(const std::function<void()>& work) {
  if (tables_->depth > 0) return work();
  with_log_errors(path_, [&] {
    SQLite::Transaction transaction(tables_->database, SQLite::TransactionBehavior::IMMEDIATE);
    tables_->depth = 1;
    try {
      work();
      tables_->check_still_there();
      transaction.commit();
    } catch (...) {
      tables_->depth = 0;
      throw;
    }
    tables_->depth = 0;
  });
}

void LogWriter::append_trials(OpenSession& session, std::span<const Trial> trials) {
  transaction([&] {
    auto trial_index = static_cast<std::int64_t>(session.trials.size());
    for (const Trial& trial : trials)
      if (tables_->has_right_index)
        run(tables_->trial, session.participant, trial_index++, std::string(word(trial.kind)), trial.stimulus,
            trial.right_index);
      else
        run(tables_->trial, session.participant, trial_index++, std::string(word(trial.kind)),
            trial.stimulus);
  });
  session.trials.insert(session.trials.end(), trials.begin(), trials.end());
}

void LogWriter::Tables::note_where(std::int64_t session, const TrialAnswer& given) {
  if (given.position >= 0) {
    SQLite::Statement slid(database, R"sql(
        INSERT INTO events (session, monotonic_ns, kind, trial_index, detail) VALUES (?, ?, 'slid', ?, ?))sql");
    run(slid, session, given.rating_ns, given.trial_index, std::to_string(given.position));
  }
  if (given.matched < 0) return;
  SQLite::Statement matched(database, R"sql(
      INSERT INTO events (session, monotonic_ns, kind, trial_index, detail)
      SELECT ?, ?, 'matched', ?, stimulus_id FROM stimuli WHERE stimulus = ?)sql");
  run(matched, session, given.choice_ns, given.trial_index, given.matched);
}

void LogWriter::append_answer(OpenSession& session, const TrialAnswer& answer) {
  assert(answer.trial_index == session.answered && session.session != 0);
  transaction([&] {
    run(tables_->answer, session.participant, answer.trial_index, session.session, answer.chosen_index,
        answer.rating, answer.choice_ns, answer.rating_ns, session.image_scale);
    tables_->note_where(session.session, answer);
    if (!session.simulated) run(tables_->seen, now_unix_s(), session.session);
  });
  session.answers.push_back(answer);
  ++session.answered;
}

void LogWriter::restart(OpenSession& session) {
  transaction([&] {
    SQLite::Statement set_aside(tables_->database, R"sql(
        INSERT INTO set_aside_answers
        SELECT participant, 1 + (SELECT coalesce(max(attempt), 0) FROM set_aside_answers WHERE participant = ?1),
               trial_index, kind, stimulus, session, chosen_index, rating, choice_ns, rating_ns, image_scale
        FROM answers JOIN trials USING (participant, trial_index) WHERE participant = ?1)sql");
    run(set_aside, session.participant);
    SQLite::Statement trials(tables_->database, "DELETE FROM trials WHERE participant = ?");
    run(trials, session.participant);  // the answers go with it
  });
  session.trials.clear();
  session.answers.clear();
  session.answered = 0;
}

void LogWriter::complete(OpenSession& session) {
  transaction([&] {
    SQLite::Statement completed(tables_->database,
                                "UPDATE participants SET completed = 1 WHERE participant = ?");
    run(completed, session.participant);
  });
  session.completed = true;
}

}  // namespace seamline::study
