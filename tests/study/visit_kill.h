// SIGKILL at random instants of a program that runs visits: no answer that was accepted is lost, none is
// doubled, and the next visit goes on where the last one ended.
#pragma once
#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <map>
#include <vector>

#include "scripted_person.h"
#include "study/log/log.h"
#include "study/running/visit_store.h"
#include "study/trials/catch_trials.h"
#include "temporary_set.h"

namespace seamline::study {

/// What the visiting program says over a pipe: where a visit goes on, and, after its commit, each answer.
struct KillReport {
  bool begins = false;
  int person = 0, trial_index = 0, chosen_index = 0, rating = 0;
};

inline std::string kill_code(int person) {
  return fmt::format("p{:05}", person);
}

/// One person's visit to its end. The time of a picture is not waited for: only the log takes time.
inline void visit_to_the_end(const RenderedSet& set, const std::filesystem::path& path, int person,
                             int pipe_end) {
  const auto say = [&](const KillReport& report) {
    if (::write(pipe_end, &report, sizeof report) != sizeof report) ::_exit(3);
  };
  VisitStore store(set, path, {.code = kill_code(person)});
  ScriptedPerson script(static_cast<std::uint64_t>(person));
  Visit visit = store.begin();
  int answered = answered_trials(visit.session.trials);
  say({.begins = true, .person = person, .trial_index = answered});
  while (!is_over(visit)) {
    store.note({.monotonic_ns = answered, .kind = "event"});
    visit = store.step(std::move(visit), script.act(visit));
    if (const auto* stopped = std::get_if<StoppedScreen>(&visit.screen))
      throw std::runtime_error(stopped->message);
    if (answered_trials(visit.session.trials) == answered) continue;
    const TrialAnswer answer = script.answer_to(answered++);
    say({.begins = false,
         .person = person,
         .trial_index = answer.trial_index,
         .chosen_index = answer.chosen_index,
         .rating = answer.rating});
  }
}

/// Runs visits, one person after the other, in a process of its own and kills it after a while: at once, or
/// counted from its first report, so that a slow machine gets somewhere too.
inline std::vector<KillReport> visit_and_kill(const RenderedSet& set, const std::filesystem::path& path,
                                              int first_person, unsigned delay_us, bool at_once) {
  int ends[2] = {};
  if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(ends[0]);
    try {
      for (int person = first_person;; ++person) visit_to_the_end(set, path, person, ends[1]);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "visitor: %s\n", error.what());
    }
    ::_exit(2);
  }
  ::close(ends[1]);
  std::vector<KillReport> reports;
  KillReport first;
  if (!at_once && ::read(ends[0], &first, sizeof first) == sizeof first) reports.push_back(first);
  ::usleep(delay_us);
  ::kill(child, SIGKILL);
  for (KillReport report; ::read(ends[0], &report, sizeof report) == sizeof report;)
    reports.push_back(report);
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status)) << "the visits stopped by themselves: " << status;
  return reports;
}

/// Every answer in the log, of every kind, by participant and trial: chosen object and rating.
using StoredAnswers = std::map<std::pair<std::string, int>, std::pair<int, int>>;

inline StoredAnswers stored_answers(const LogContents& log) {
  StoredAnswers stored;
  const auto add = [&](const auto& answer) {
    const bool is_new =
        stored.insert({{answer.participant, answer.trial_index}, {answer.chosen_index, answer.rating}})
            .second;
    EXPECT_TRUE(is_new) << answer.participant << " trial " << answer.trial_index << " twice";
  };
  for (const Answer& answer : log.answers) add(answer);
  for (const CatchTrialAnswer& answer : log.catches) add(answer);
  return stored;
}

inline void expect_sound_file(const std::filesystem::path& path) {
  SQLite::Database database(path.string(), SQLite::OPEN_READWRITE, 1000);
  EXPECT_EQ(database.execAndGet("PRAGMA integrity_check").getString(), "ok");
  SQLite::Statement orphans(database, "PRAGMA foreign_key_check");
  EXPECT_FALSE(orphans.executeStep());
}

/// The trials of each person are 0, 1, 2, ... without a gap.
inline std::map<std::string, int> answers_of_each(const StoredAnswers& stored) {
  std::map<std::string, int> next_trial;
  for (const auto& [where, what] : stored) EXPECT_EQ(where.second, next_trial[where.first]++) << where.first;
  return next_trial;
}

inline void kill_visits(const std::string& study, int kills, std::uint64_t seed, int least_answers) {
  const TemporaryFolder folder;
  const RenderedSet set = write_set_of_text(folder / "set", study);
  const std::filesystem::path path = folder / "log.sqlite";
  std::map<std::pair<std::string, int>, std::pair<int, int>> accepted;
  std::map<std::string, int> stored_before;
  Random random(seed);
  int person = 1, resumed = 0;
  for (int kill = 0; kill < kills; ++kill) {
    const bool at_once = kill % 4 == 0;
    const auto delay_us = static_cast<unsigned>(random.below(at_once ? 12000 : 250000));
    for (const KillReport& report : visit_and_kill(set, path, person, delay_us, at_once)) {
      person = report.person;
      if (report.begins) {
        EXPECT_EQ(report.trial_index, stored_before[kill_code(person)]) << "goes on at another trial";
        resumed += report.trial_index > 0 ? 1 : 0;
        continue;
      }
      const bool is_new =
          accepted.insert({{kill_code(person), report.trial_index}, {report.chosen_index, report.rating}})
              .second;
      EXPECT_TRUE(is_new) << "asked twice: " << kill_code(person) << " trial " << report.trial_index;
    }
    if (!std::filesystem::exists(path)) continue;  // killed before the log was begun
    if (std::filesystem::file_size(path) == 0) continue;
    expect_sound_file(path);
    const LogContents log = read_log(path);
    const StoredAnswers stored = stored_answers(log);
    stored_before = answers_of_each(stored);
    for (const auto& [where, what] : accepted) {
      const auto found = stored.find(where);
      ASSERT_NE(found, stored.end()) << "lost: " << where.first << " trial " << where.second;
      EXPECT_EQ(found->second, what);
    }
    for (const ParticipantRecord& record : log.participants) {
      EXPECT_FALSE(record.in_progress) << "the claim outlived its process";
      if (record.code == kill_code(person) && record.completed) ++person;
    }
  }
  const StoredAnswers stored = stored_answers(read_log(path));
  std::printf("%d kills, %zu answers accepted, %zu stored, %d visits went on in the middle\n", kills,
              accepted.size(), stored.size(), resumed);
  EXPECT_GE(accepted.size(), static_cast<std::size_t>(least_answers));
  EXPECT_LE(stored.size(), accepted.size() + static_cast<std::size_t>(kills));  // committed, not yet said

  // Whoever was cut off ends the study, and has seen each stimulus once.
  int unused[2] = {};
  ASSERT_EQ(::pipe(unused), 0);
  visit_to_the_end(set, path, person, unused[1]);
  ::close(unused[0]);
  ::close(unused[1]);
  const LogContents log = read_log(path);
  std::map<std::string, std::map<std::string, int>> seen;
  for (const Answer& answer : log.answers) ++seen[answer.participant][answer.stimulus_id];
  for (const ParticipantRecord& record : log.participants) {
    EXPECT_TRUE(record.completed) << record.code;
    if (set.study.procedure.index() != 0) continue;
    EXPECT_EQ(seen[record.code].size(), set.manifest.stimuli.size());
    for (const auto& [stimulus, times] : seen[record.code]) EXPECT_EQ(times, 1) << stimulus;
  }
}

inline std::string kill_study_text() {
  return study_text("tiny", "64") +
         "[consent]\ntext = \"Our own text.\"\n[catch]\nattention = 1\nreference = 2\n";
}

}  // namespace seamline::study
