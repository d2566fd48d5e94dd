#include "study/log.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "stimuli/support/error.h"
#include "study/catch_plan.h"
#include "study/log_admin.h"
#include "study/log_writer.h"
#include "study/plan.h"
#include "temporary_set.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// The sentence of the InputError that `work` throws; empty when it throws none.
template <class Work>
std::string complaint_of(Work&& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

class LogTest : public testing::Test {
 protected:
  TemporaryFolder folder;
  StudySet set = write_set(folder / "set");
  fs::path path = folder / "log.sqlite";

  [[nodiscard]] std::vector<int> order(int slot) const {
    return plan_order(static_cast<int>(set.manifest.stimuli.size()),
                      {.study_seed = set.study.seed, .slot = slot});
  }
  [[nodiscard]] std::vector<PlannedTrial> plan(int slot) const { return interleave(order(slot), {}); }
  OpenSession enter(LogWriter& log, const Enrolment& enrolment, int answers) const {
    OpenSession session = log.open_session(enrolment);
    if (session.planned.empty()) log.plan_trials(session, plan(session.slot));
    for (int i = 0; i < answers; ++i) log.append_answer(session, answer(session.answered));
    return session;
  }
  [[nodiscard]] static TrialAnswer answer(int trial_index) {
    return {.trial_index = trial_index,
            .chosen_index = 1 + trial_index % 3,
            .rating = 1 + trial_index % 4,
            .choice_ns = 1000 + trial_index,
            .rating_ns = 3000000000LL + trial_index};
  }
};

TEST_F(LogTest, ReadsBackWhatWasWritten) {
  {
    LogWriter log(path, set);
    OpenSession first = enter(log, {.code = "P-01"}, 24);
    log.complete(first);
    (void)enter(log, {.code = "p.02", .pilot = true}, 3);
    (void)enter(log, {.code = "sim-0001", .simulated = Simulated{ObserverKind::guesser, ~0ULL}}, 0);
  }
  const LogContents log = read_log(path);
  EXPECT_EQ(log.file, path);
  EXPECT_EQ(log.study_name, "tiny");
  EXPECT_EQ(log.study_hash, set.manifest.study_hash);
  EXPECT_EQ(log.set_hash, set.set_hash);
  EXPECT_EQ(log.set_folder, set.folder);
  EXPECT_EQ(log.study_text, study_text("tiny", "64, 512"));
  ASSERT_EQ(log.participants.size(), 3U);
  const ParticipantRecord& person = log.participants[0];
  EXPECT_TRUE(person.code == "P-01" && person.completed && !person.pilot && !person.simulated &&
              !person.excluded);
  EXPECT_EQ(person.planned_trials, 24);
  EXPECT_TRUE(log.participants[1].pilot && !log.participants[1].completed);
  const ParticipantRecord& simulated = log.participants[2];
  EXPECT_TRUE(simulated.simulated && simulated.observer == "guesser" && simulated.seed == ~0ULL);
  ASSERT_EQ(log.answers.size(), 27U);
  for (int trial = 0; trial < 24; ++trial) {
    const Answer& found = log.answers[static_cast<std::size_t>(trial)];
    const auto& record =
        set.manifest.stimuli[static_cast<std::size_t>(order(0)[static_cast<std::size_t>(trial)])];
    const TrialAnswer wanted = answer(trial);
    EXPECT_EQ(found.participant, "P-01");
    EXPECT_EQ(found.trial_index, trial);
    EXPECT_EQ(found.stimulus_id, record.id);
    EXPECT_EQ(found.scene, record.stimulus.scene);
    EXPECT_EQ(found.artifact, record.stimulus.artifact);
    EXPECT_EQ(found.object, record.stimulus.object);
    EXPECT_EQ(found.object_index, record.stimulus.object_index);
    EXPECT_EQ(found.depth_width_px, record.stimulus.condition.depth_width_px);
    EXPECT_EQ(found.chosen_index, wanted.chosen_index);
    EXPECT_EQ(found.rating, wanted.rating);
    EXPECT_EQ(found.choice_ns, wanted.choice_ns);
    EXPECT_EQ(found.rating_ns, wanted.rating_ns);
  }
}

TEST_F(LogTest, IsWrittenSafely) {
  LogWriter log(path, set);
  SQLite::Database database(path.string(), SQLite::OPEN_READWRITE);
  EXPECT_EQ(database.execAndGet("PRAGMA journal_mode").getString(), "wal");
  EXPECT_EQ(database.execAndGet("PRAGMA user_version").getInt(), 2);
  EXPECT_EQ(database.execAndGet("PRAGMA application_id").getInt(), 0x5345414d);
}

TEST_F(LogTest, IsReadWhileASessionWrites) {
  LogWriter log(path, set);
  OpenSession session = enter(log, {.code = "p1"}, 5);
  EXPECT_EQ(read_log(path).answers.size(), 5U);
  log.append_answer(session, answer(5));
  EXPECT_EQ(read_log(path).answers.size(), 6U);
}

TEST_F(LogTest, ResumesWhereTheParticipantStopped) {
  {
    LogWriter log(path, set);
    (void)enter(log, {.code = "p1"}, 7);
  }
  LogWriter log(path, set);
  OpenSession again = log.open_session({.code = "p1"});
  EXPECT_EQ(again.answered, 7);
  EXPECT_EQ(again.planned, plan(0));
  EXPECT_FALSE(again.completed);
  while (again.answered < 24) log.append_answer(again, answer(again.answered));
  log.complete(again);
  const OpenSession finished = log.open_session({.code = "p1"});
  EXPECT_TRUE(finished.completed);
  EXPECT_EQ(finished.session, 0);
}

TEST_F(LogTest, AnAbandonedTransactionLeavesNothing) {
  LogWriter log(path, set);
  OpenSession session = enter(log, {.code = "p1"}, 2);
  EXPECT_THROW(log.transaction([&] {
    log.append_answer(session, answer(2));
    throw std::runtime_error("power");
  }),
               std::runtime_error);
  EXPECT_EQ(read_log(path).answers.size(), 2U);
  OpenSession again = log.open_session({.code = "p1"});
  log.append_answer(again, answer(2));
  EXPECT_EQ(read_log(path).answers.size(), 3U);
}

TEST_F(LogTest, KeepsRawEvents) {
  LogWriter log(path, set);
  const OpenSession session = enter(log, {.code = "p1"}, 1);
  const std::vector<RawEvent> events = {
      {.monotonic_ns = 5, .kind = "shown", .trial_index = 0, .detail = "swap 3"},
      {.monotonic_ns = 9, .kind = "pause"}};
  log.append_events(session, events);
  SQLite::Database database(path.string());
  SQLite::Statement row(database,
                        "SELECT monotonic_ns, kind, trial_index, detail FROM events ORDER BY event");
  ASSERT_TRUE(row.executeStep());
  EXPECT_EQ(row.getColumn(1).getString(), "shown");
  EXPECT_EQ(row.getColumn(2).getInt(), 0);
  EXPECT_EQ(row.getColumn(3).getString(), "swap 3");
  ASSERT_TRUE(row.executeStep());
  EXPECT_TRUE(row.getColumn(2).isNull());
}

TEST_F(LogTest, SlotsAreFilledFromBelowAndFreedByExclusion) {
  LogWriter log(path, set);
  EXPECT_EQ(log.open_session({.code = "a"}).slot, 0);
  EXPECT_EQ(log.open_session({.code = "b"}).slot, 1);
  EXPECT_EQ(log.open_session({.code = "test", .pilot = true}).slot, 0);
  EXPECT_EQ(log.open_session({.code = "c"}).slot, 2);
  exclude_participant(path, "b");
  EXPECT_EQ(log.open_session({.code = "d"}).slot, 1);
  EXPECT_EQ(log.open_session({.code = "e"}).slot, 3);
  EXPECT_TRUE(log.open_session({.code = "b"}).excluded);
}

TEST_F(LogTest, RefusesNamesAndParticipantsOfAnotherKind) {
  LogWriter log(path, set);
  for (const char* code : {"", "Ada Lovelace", "p'; DROP TABLE answers; --", "p\n", "\xc3\xa4"})
    EXPECT_THROW((void)log.open_session({.code = code}), InputError) << code;
  EXPECT_THROW((void)log.open_session({.code = std::string(65, 'a')}), InputError);
  (void)log.open_session({.code = "a"});
  EXPECT_THAT(complaint_of([&] { (void)log.open_session({.code = "a", .pilot = true}); }),
              HasSubstr("pilot"));
  const Enrolment simulated{.code = "s", .simulated = Simulated{ObserverKind::threshold, 1}};
  (void)log.open_session(simulated);
  EXPECT_THROW((void)log.open_session({.code = "s"}), InputError);
  EXPECT_THROW((void)log.open_session({.code = "s", .simulated = Simulated{ObserverKind::threshold, 2}}),
               InputError);
  EXPECT_THROW((void)log.open_session({.code = "s", .simulated = Simulated{ObserverKind::perfect, 1}}),
               InputError);
  EXPECT_NO_THROW((void)log.open_session(simulated));
  EXPECT_EQ(read_log(path).participants.size(), 2U);
}

TEST_F(LogTest, TheTablesRefuseValuesOutOfRange) {
  {
    LogWriter log(path, set);
    (void)enter(log, {.code = "p1"}, 1);
  }
  SQLite::Database database(path.string(), SQLite::OPEN_READWRITE);
  database.exec("PRAGMA foreign_keys = ON");
  const auto answer_row = [](const std::string& trial, const std::string& rest) {
    return "INSERT INTO answers VALUES (1, " + trial + ", 1, " + rest + ", 1.0)";
  };
  const auto participant_row = [](const std::string& values) {
    return "INSERT INTO participants (code, slot, pilot, observer, seed) VALUES (" + values + ")";
  };
  for (const std::string& bad : {
           answer_row("1", "0, 1, 0, 0"),
           answer_row("1", "4, 1, 0, 0"),
           answer_row("1", "NULL, 1, 0, 0"),
           answer_row("1", "1, 0, 0, 0"),
           answer_row("1", "1, 5, 0, 0"),
           answer_row("1", "1, 1.5, 0, 0"),
           answer_row("1", "1, 'x', 0, 0"),
           answer_row("1", "1, 1, -1, 0"),
           answer_row("1", "1, 1, 5, 4"),
           answer_row("0", "1, 1, 0, 0"),   // answered already
           answer_row("24", "1, 1, 0, 0"),  // not planned
           std::string("INSERT INTO answers VALUES (9, 1, 1, 1, 1, 0, 0, 1.0)"),
           std::string("INSERT INTO answers VALUES (1, 1, 9, 1, 1, 0, 0, 1.0)"),
           std::string("INSERT INTO answers VALUES (1, 1, 1, 1, 1, 0, 0, 0.0)"),
           std::string("INSERT INTO trials VALUES (1, 24, 'stimulus', 24)"),
           std::string("INSERT INTO trials VALUES (1, -1, 'stimulus', 0)"),
           std::string("INSERT INTO trials VALUES (1, 24, 'practice', 0)"),
           participant_row("'p1', 1, 0, NULL, NULL"),
           participant_row("'a b', 1, 0, NULL, NULL"),
           participant_row("'p2', -1, 0, NULL, NULL"),
           participant_row("'p2', 1, 2, NULL, NULL"),
           participant_row("'p2', 1, 0, 'perfect', NULL"),
           participant_row("'p2', 1, 0, NULL, 3"),
           std::string("INSERT INTO study SELECT 2, study_name, study_hash, set_hash, '', '', '' FROM study"),
           std::string("UPDATE stimuli SET artifact = 'glow'"),
           std::string("UPDATE stimuli SET object_index = 4"),
           std::string("UPDATE stimuli SET depth_width_px = 7"),
           std::string("UPDATE sessions SET started_unix_s = -1"),
           std::string("INSERT INTO events VALUES (1, 1, -1, 'shown', 0, '', NULL)"),
           std::string("INSERT INTO events VALUES (1, 1, 0, '', 0, '', NULL)"),
       })
    EXPECT_THROW(database.exec(bad), SQLite::Exception) << bad;
  EXPECT_NO_THROW(database.exec(answer_row("1", "3, 4, 5, 5")));
}

TEST_F(LogTest, ALogOfAnotherStudyOrSetIsRefusedAndUnharmed) {
  { LogWriter log(path, set); }
  const StudySet other_study = write_set(folder / "other", "64, 512", "another");
  EXPECT_THAT(complaint_of([&] { LogWriter log(path, other_study); }), HasSubstr("study_hash"));
  Manifest rendered_again = set.manifest;
  rendered_again.stimuli[0].sha256 = std::string(64, '1');
  write_manifest(folder / "set", rendered_again);
  EXPECT_THAT(complaint_of([&] { LogWriter log(path, load_study_set(folder / "set")); }),
              HasSubstr("set_hash"));
  EXPECT_EQ(read_log(path).set_hash, set.set_hash);
}

TEST_F(LogTest, FindsTheSetWhereItWasLast) {
  { LogWriter log(path, set); }
  fs::rename(folder / "set", folder / "moved");
  { LogWriter log(path, load_study_set(folder / "moved")); }
  EXPECT_EQ(read_log(path).set_folder, folder / "moved");
}

TEST_F(LogTest, FilesThatAreNotLogsAreRefused) {
  const auto refused = [&](const char* reason) {
    EXPECT_THAT(complaint_of([&] { (void)read_log(path); }), HasSubstr(reason));
    EXPECT_THAT(complaint_of([&] { exclude_participant(path, "p1"); }), HasSubstr(reason));
    EXPECT_THAT(complaint_of([&] { LogWriter log(path, set); }), HasSubstr(reason));
    EXPECT_TRUE(fs::exists(path));
    fs::remove_all(path);
  };
  EXPECT_THAT(complaint_of([&] { (void)read_log(path); }), HasSubstr("no such file"));
  for (const std::string& text :
       {std::string("x"), std::string("level,correct,trials\n"), std::string(100000, 'x')}) {
    std::ofstream(path) << text;
    refused("not SQLite");
  }
  fs::create_directory(path);
  refused("not a file");
  SQLite::Database(path.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
      .exec("CREATE TABLE other (x)");
  refused("another SQLite database");
  { LogWriter log(path, set); }
  SQLite::Database(path.string(), SQLite::OPEN_READWRITE).exec("PRAGMA user_version = 1");
  refused("written by an older seamline");
  { LogWriter log(path, set); }
  SQLite::Database(path.string(), SQLite::OPEN_READWRITE).exec("PRAGMA user_version = 3");
  refused("written by a newer seamline");
  { LogWriter log(path, set); }
  SQLite::Database(path.string(), SQLite::OPEN_READWRITE)
      .exec("ALTER TABLE answers RENAME COLUMN rating TO stars");
  refused("other tables");
}

TEST_F(LogTest, ATruncatedLogIsRefused) {
  {
    LogWriter log(path, set);
    (void)enter(log, {.code = "p1"}, 24);
  }
  const auto whole = fs::file_size(path);
  for (const auto bytes : {whole / 2, whole - 4096, std::uintmax_t{4096}, std::uintmax_t{1000}}) {
    const fs::path cut = folder / "cut.sqlite";
    fs::copy_file(path, cut, fs::copy_options::overwrite_existing);
    fs::resize_file(cut, bytes);
    EXPECT_NE(complaint_of([&] { (void)read_log(cut); }), "") << bytes << " of " << whole;
    for (const char* suffix : {"-wal", "-shm"}) fs::remove(cut.string() + suffix);
  }
}

TEST_F(LogTest, AnEmptyFileBecomesALogButIsNotReadAsOne) {
  std::ofstream(path).flush();
  EXPECT_THAT(complaint_of([&] { (void)read_log(path); }), HasSubstr("empty"));
  { LogWriter log(path, set); }
  EXPECT_EQ(read_log(path).study_name, "tiny");
}

TEST_F(LogTest, AnUnwritableLocationIsRefusedAndNothingIsLeft) {
  std::ofstream(folder / "file") << "x";
  for (const fs::path& bad :
       {folder / "none/log.sqlite", folder / "file/log.sqlite", fs::path("/proc/log.sqlite")}) {
    EXPECT_THAT(complaint_of([&] { LogWriter log(bad, set); }), HasSubstr("log")) << bad;
    EXPECT_FALSE(fs::exists(folder / "none"));
  }
}

TEST_F(LogTest, WhatBeganBadlyIsRemoved) {
  Manifest wrong = set.manifest;
  wrong.stimuli[1].id = wrong.stimuli[0].id;
  StudySet twice = set;
  twice.manifest = wrong;
  EXPECT_ANY_THROW(LogWriter(path, twice));
  for (const char* suffix : {"", "-wal", "-shm"}) EXPECT_FALSE(fs::exists(path.string() + suffix)) << suffix;
}

TEST_F(LogTest, ASetWithoutManifestOrWithAnotherStudyIsRefused) {
  fs::create_directories(folder / "empty");
  EXPECT_THROW((void)load_study_set(folder / "empty"), InputError);
  EXPECT_THROW((void)load_study_set(folder / "nowhere"), InputError);
  write_file_atomically(folder / "set/study.toml", study_text("edited", "64, 512"));
  EXPECT_THAT(complaint_of([&] { (void)load_study_set(folder / "set"); }), HasSubstr("render the set again"));
  fs::remove(folder / "set/study.toml");
  EXPECT_THROW((void)load_study_set(folder / "set"), InputError);
}

std::string bytes_of(const fs::path& file) {
  return fs::exists(file) ? read_file(file) : std::string();
}

TEST_F(LogTest, ForgettingLeavesNoByteOfTheCode) {
  {
    LogWriter log(path, set);
    (void)enter(log, {.code = "keep-me"}, 4);
    const OpenSession session = enter(log, {.code = "zzqforgotten"}, 9);
    const std::vector<RawEvent> events = {{.kind = "shown", .detail = "seen by zzqforgotten"}};
    log.append_events(session, events);
  }
  ASSERT_THAT(bytes_of(path), HasSubstr("zzqforgotten"));
  forget_participant(path, "zzqforgotten");
  for (const char* suffix : {"", "-wal", "-shm"})
    EXPECT_EQ(bytes_of(path.string() + suffix).find("zzqforgotten"), std::string::npos) << suffix;
  const LogContents log = read_log(path);
  ASSERT_EQ(log.participants.size(), 1U);
  EXPECT_EQ(log.answers.size(), 4U);
  EXPECT_EQ(log.forgotten_participants, 1);
  EXPECT_THROW(forget_participant(path, "zzqforgotten"), InputError);
  EXPECT_EQ(read_log(path).forgotten_participants, 1);
}

TEST_F(LogTest, NobodyIsForgottenWhileASessionRuns) {
  LogWriter log(path, set);
  OpenSession session = enter(log, {.code = "p1"}, 4);
  EXPECT_THAT(complaint_of([&] { forget_participant(path, "p1"); }), HasSubstr("in use"));
  log.append_answer(session, answer(4));
  EXPECT_EQ(read_log(path).answers.size(), 5U);
}

TEST_F(LogTest, StatusSaysWhoHasDoneWhat) {
  {
    LogWriter log(path, set);
    OpenSession whole = enter(log, {.code = "p1"}, 24);
    log.complete(whole);
    (void)enter(log, {.code = "p2"}, 3);
    (void)enter(log, {.code = "p3"}, 5);
    (void)enter(log, {.code = "sim-0001", .simulated = Simulated{ObserverKind::perfect, 1}}, 0);
  }
  exclude_participant(path, "p3");
  EXPECT_THROW(exclude_participant(path, "p9"), InputError);
  const std::string text = status_text(read_log(path));
  for (const char* line : {"study tiny, 4 participants, 32 answers", "complete", "   3 of   24  unfinished",
                           "   5 of   24  excluded", "simulated (perfect)"})
    EXPECT_THAT(text, HasSubstr(line));
}

}  // namespace
}  // namespace seamline
