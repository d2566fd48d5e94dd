#include "study/log/log.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "log_fixture.h"
#include "study/log/log_admin.h"
#include "study/log/log_writer.h"
#include "study/trials/catch_trials.h"
#include "study/trials/stimulus_order.h"
#include "support/text/error.h"

namespace seamline::study {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

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
  EXPECT_EQ(log.quantity, set.study.level.quantity);
  EXPECT_EQ(log.noticeability, set.study.level.noticeability);
  ASSERT_EQ(log.participants.size(), 3U);
  const ParticipantRecord& person = log.participants[0];
  EXPECT_TRUE(person.code == "P-01" && person.completed && !person.pilot && !person.simulated &&
              !person.excluded);
  EXPECT_EQ(person.stimulus_trials, 24);
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
    EXPECT_EQ(found.depth_width_px, record.stimulus.depth.width_px);
    EXPECT_EQ(found.condition, record.stimulus.condition);
    EXPECT_EQ(found.level, record.stimulus.level);
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
  EXPECT_EQ(database.execAndGet("PRAGMA user_version").getInt(), 3);
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
  EXPECT_EQ(again.trials, all_trials(0));
  EXPECT_FALSE(again.completed);
  while (again.answered < 24) log.append_answer(again, answer(again.answered));
  log.complete(again);
  const OpenSession finished = log.open_session({.code = "p1"});
  EXPECT_TRUE(finished.completed);
  EXPECT_EQ(finished.session, 0);
}

TEST_F(LogTest, FindsTheSetWhereItWasLast) {
  { LogWriter log(path, set); }
  fs::rename(folder / "set", folder / "moved");
  { LogWriter log(path, load_rendered_set(folder / "moved")); }
  EXPECT_EQ(read_log(path).set_folder, folder / "moved");
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
  const auto slot = [&](const Enrolment& enrolment) { return enter_session(log, enrolment, 0).slot; };
  EXPECT_EQ(slot({.code = "a"}), 0);
  EXPECT_EQ(slot({.code = "b"}), 1);
  EXPECT_EQ(slot({.code = "test", .pilot = true}), 0);
  EXPECT_EQ(slot({.code = "c"}), 2);
  exclude_participant(path, "b");
  EXPECT_EQ(slot({.code = "d"}), 1);
  EXPECT_EQ(slot({.code = "e"}), 3);
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

/// Of version 4 is a log whose study asks for it; all others are what they were.
TEST_F(LogTest, AStudyOfReflectionsHasALogOfVersion4) {
  const auto version_of = [](const fs::path& log) {
    SQLite::Database database(log.string(), SQLite::OPEN_READONLY);
    return database.execAndGet("PRAGMA user_version").getInt();
  };
  for (ManifestStimulus& one : set.manifest.stimuli) one.stimulus.artifact = Artifact::reflection;
  {
    LogWriter log(path, set);
    (void)enter(log, {.code = "p1"}, 3);
  }
  EXPECT_EQ(version_of(path), 4);
  {
    LogWriter log(path, set);  // goes on
    (void)enter(log, {.code = "p2"}, 2);
  }
  const LogContents contents = read_log(path);
  ASSERT_EQ(contents.answers.size(), 5U);
  EXPECT_EQ(contents.answers.front().artifact, Artifact::reflection);
}

}  // namespace
}  // namespace seamline::study
