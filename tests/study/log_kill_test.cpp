// SIGKILL at random instants of a program that writes a log: nothing reported as stored is lost, and nothing
// is doubled.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <map>

#include "sound_log.h"
#include "study/log/log.h"
#include "study/log/log_writer.h"
#include "study/running/participant_session.h"
#include "study/trials/catch_trials.h"
#include "study/trials/stimulus_order.h"
#include "support/arithmetic/random.h"
#include "temporary_set.h"

namespace seamline::study {
namespace {

/// What the writer reports after an answer's transaction has been committed.
struct Report {
  int participant = 0, trial_index = 0, chosen_index = 0, rating = 0;
};

TrialAnswer answer_to(int participant, int trial_index) {
  Random random(static_cast<std::uint64_t>(participant), static_cast<std::uint64_t>(trial_index));
  return {.trial_index = trial_index,
          .chosen_index = 1 + static_cast<int>(random.below(3)),
          .rating = 1 + static_cast<int>(random.below(4))};
}

void write_participant(LogWriter& log, const RenderedSet& set, int participant, int pipe_end) {
  OpenSession place = enter_session(log, {.code = fmt::format("p{:05}", participant)}, 0);
  if (place.completed) return;
  if (place.trials.empty())
    log.append_trials(
        place,
        interleave(stimulus_order(static_cast<int>(set.manifest.stimuli.size()), {.slot = place.slot}), {}));
  while (place.answered < static_cast<int>(place.trials.size())) {
    const TrialAnswer answer = answer_to(participant, place.answered);
    log.append_answer(place, answer);
    const Report report{participant, answer.trial_index, answer.chosen_index, answer.rating};
    if (::write(pipe_end, &report, sizeof report) != sizeof report) ::_exit(3);
  }
  log.complete(place);
}

/// Resumes everyone in turn until it is killed.
[[noreturn]] void write_until_killed(const std::filesystem::path& path, const RenderedSet& set,
                                     int pipe_end) {
  try {
    LogWriter log(path, set);
    for (int participant = 1;; ++participant) write_participant(log, set, participant, pipe_end);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "writer: %s\n", error.what());
    ::_exit(2);
  }
}

/// Forks a writer, kills it after a while, and returns what it had reported by then.
std::vector<Report> run_and_kill(const std::filesystem::path& path, const RenderedSet& set,
                                 unsigned delay_us) {
  int ends[2] = {};
  if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(ends[0]);
    write_until_killed(path, set, ends[1]);
  }
  ::close(ends[1]);
  ::usleep(delay_us);
  ::kill(child, SIGKILL);
  std::vector<Report> reports;
  for (Report report; ::read(ends[0], &report, sizeof report) == sizeof report;) reports.push_back(report);
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status)) << "the writer stopped by itself: " << status;
  return reports;
}

TEST(LogKill, NothingStoredIsLostAndNothingIsDoubled) {
  constexpr int kills = 20;
  const TemporaryFolder folder;
  const RenderedSet set = write_set(folder / "set", "64");
  const std::filesystem::path path = folder / "log.sqlite";
  std::map<std::pair<std::string, int>, Report> reported;
  Random random(6);
  for (int kill = 0; kill < kills; ++kill) {
    // The first ones hit the making of the log; later ones answers, trials and the resumption of a
    // participant.
    const auto delay_us = static_cast<unsigned>(random.below(kill < 5 ? 8000 : 250000));
    for (const Report& report : run_and_kill(path, set, delay_us)) {
      const bool is_new =
          reported.insert({{fmt::format("p{:05}", report.participant), report.trial_index}, report}).second;
      EXPECT_TRUE(is_new) << "answered twice: " << report.participant << " trial " << report.trial_index;
    }
    if (!std::filesystem::exists(path)) continue;  // killed before the log was begun
    expect_sound(path);
  }
  { LogWriter log(path, set); }  // whatever the last one left, a session can begin
  std::map<std::string, int> next_trial;
  std::size_t found = 0;
  for (const Answer& answer : read_log(path).answers) {
    EXPECT_EQ(answer.trial_index, next_trial[answer.participant]++);
    const auto report = reported.find({answer.participant, answer.trial_index});
    if (report == reported.end()) continue;  // committed, but killed before it could say so
    ++found;
    EXPECT_EQ(answer.chosen_index, report->second.chosen_index);
    EXPECT_EQ(answer.rating, report->second.rating);
  }
  EXPECT_EQ(found, reported.size());
  std::printf("%d kills, %zu answers reported as stored, %zu found\n", kills, reported.size(), found);
  EXPECT_GT(reported.size(), 5U);  // a busy machine is slow
}

}  // namespace
}  // namespace seamline::study
