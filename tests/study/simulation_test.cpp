#include "study/running/simulation.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <set>

#include "study/log/log.h"
#include "study/log/log_admin.h"
#include "study/log/log_writer.h"
#include "study/trials/catch_trials.h"
#include "study/trials/stimulus_order.h"
#include "support/text/error.h"
#include "temporary_set.h"

namespace seamline::study {
namespace {

namespace fs = std::filesystem;

/// Answers without the times, which are all 0: participant, trial, stimulus, choice, rating.
std::vector<std::string> lines_of(const fs::path& log) {
  std::vector<std::string> lines;
  for (const Answer& answer : read_log(log).answers)
    lines.push_back(fmt::format("{} {} {} {} {}", answer.participant, answer.trial_index, answer.stimulus_id,
                                answer.chosen_index, answer.rating));
  return lines;
}

class SimulationTest : public testing::Test {
 protected:
  TemporaryFolder folder;
  RenderedSet set = write_set(folder / "set");
  [[nodiscard]] SimulationRequest request(const std::string& log, ObserverKind kind, int count,
                                          std::uint64_t seed = 1) const {
    return {.set_folder = set.folder, .log = folder / log, .observer = kind, .count = count, .seed = seed};
  }
};

TEST_F(SimulationTest, EveryoneSeesEveryStimulusOnceInTheirOwnOrder) {
  const SimulationSummary summary = run_simulated_study(request("log", ObserverKind::perfect, 6));
  EXPECT_EQ(summary.participants_run, 6);
  EXPECT_EQ(summary.answers_added, 6 * 24);
  const LogContents log = read_log(folder / "log");
  std::map<std::string, std::vector<std::string>> seen;
  for (const Answer& answer : log.answers) {
    EXPECT_EQ(answer.noticeability(), 4);
    seen[answer.participant].push_back(answer.stimulus_id);
  }
  std::set<std::vector<std::string>> orders;
  for (auto& [code, ids] : seen) {
    orders.insert(ids);
    EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), 24U);
  }
  EXPECT_EQ(orders.size(), 6U);
  for (const ParticipantRecord& participant : log.participants)
    EXPECT_TRUE(participant.completed && participant.simulated && participant.observer == "perfect");
  EXPECT_EQ(log.participants[3].code, "sim-0004");
}

TEST_F(SimulationTest, SameSeedSameAnswersOtherSeedOthers) {
  run_simulated_study(request("a", ObserverKind::threshold, 5));
  run_simulated_study(request("b", ObserverKind::threshold, 5));
  run_simulated_study(request("c", ObserverKind::threshold, 5, 2));
  EXPECT_EQ(lines_of(folder / "a"), lines_of(folder / "b"));
  EXPECT_NE(lines_of(folder / "a"), lines_of(folder / "c"));
}

TEST_F(SimulationTest, RunningAgainAddsOnlyWhatIsMissing) {
  run_simulated_study(request("whole", ObserverKind::threshold, 8));
  run_simulated_study(request("parts", ObserverKind::threshold, 3));
  const SimulationSummary more = run_simulated_study(request("parts", ObserverKind::threshold, 8));
  EXPECT_EQ(more.participants_complete, 3);
  EXPECT_EQ(more.answers_added, 5 * 24);
  const SimulationSummary again = run_simulated_study(request("parts", ObserverKind::threshold, 8));
  EXPECT_EQ(again.answers_added, 0);
  EXPECT_EQ(lines_of(folder / "whole"), lines_of(folder / "parts"));
}

TEST_F(SimulationTest, AHalfFinishedParticipantGoesOnAsIfNothingHadHappened) {
  run_simulated_study(request("whole", ObserverKind::threshold, 1));
  const LogContents whole = read_log(folder / "whole");
  {
    LogWriter log(folder / "half", set);
    OpenSession place =
        log.open_session({.code = "sim-0001", .simulated = Simulated{ObserverKind::threshold, 1}});
    log.append_trials(place,
                      interleave(stimulus_order(24, {.study_seed = set.study.seed, .slot = place.slot}), {}));
    for (int trial = 0; trial < 10; ++trial) {
      const Answer& answer = whole.answers[static_cast<std::size_t>(trial)];
      log.append_answer(place,
                        {.trial_index = trial, .chosen_index = answer.chosen_index, .rating = answer.rating});
    }
  }
  EXPECT_EQ(run_simulated_study(request("half", ObserverKind::threshold, 1)).answers_added, 14);
  EXPECT_EQ(lines_of(folder / "whole"), lines_of(folder / "half"));
}

TEST_F(SimulationTest, AnotherKindOrSeedInTheSameLogIsRefused) {
  run_simulated_study(request("log", ObserverKind::threshold, 2));
  const auto before = lines_of(folder / "log");
  EXPECT_THROW(run_simulated_study(request("log", ObserverKind::guesser, 2)), InputError);
  EXPECT_THROW(run_simulated_study(request("log", ObserverKind::threshold, 2, 9)), InputError);
  EXPECT_EQ(lines_of(folder / "log"), before);
}

/// Starts the simulation in a process of its own.
pid_t start(const SimulationRequest& request) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  try {
    run_simulated_study(request);
    ::_exit(0);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    ::_exit(1);
  }
}

int status_of(pid_t child) {
  int status = 0;
  ::waitpid(child, &status, 0);
  return status;
}

TEST_F(SimulationTest, ThreeProgramsIntoOneLogMakeTheSameLogAsOne) {
  run_simulated_study(request("one", ObserverKind::threshold, 60));
  std::vector<pid_t> children;
  for (int i = 0; i < 3; ++i) children.push_back(start(request("three", ObserverKind::threshold, 60)));
  for (const pid_t child : children) EXPECT_EQ(status_of(child), 0);
  EXPECT_EQ(lines_of(folder / "one"), lines_of(folder / "three"));
}

TEST_F(SimulationTest, ProgramsThatBeginALogTogetherAllSucceed) {
  for (int round = 0; round < 15; ++round) {
    std::vector<pid_t> children;
    const std::string log = "together" + std::to_string(round);
    for (int i = 0; i < 4; ++i) children.push_back(start(request(log, ObserverKind::perfect, 1)));
    for (const pid_t child : children) EXPECT_EQ(status_of(child), 0);
    EXPECT_EQ(lines_of(folder / log).size(), 24U);
  }
}

TEST_F(SimulationTest, AKilledSimulationIsCompletedByTheNextRun) {
  run_simulated_study(request("whole", ObserverKind::threshold, 100));
  Random random(8);
  for (int kill = 0; kill < 6; ++kill) {
    const pid_t child = start(request("killed", ObserverKind::threshold, 100));
    ::usleep(static_cast<unsigned>(random.below(30000)));
    ::kill(child, SIGKILL);
    (void)status_of(child);
  }
  run_simulated_study(request("killed", ObserverKind::threshold, 100));
  EXPECT_EQ(lines_of(folder / "whole"), lines_of(folder / "killed"));
}

TEST_F(SimulationTest, ABadSetBeginsNoLog) {
  fs::create_directories(folder / "empty");
  SimulationRequest bad = request("log", ObserverKind::threshold, 2);
  bad.set_folder = folder / "empty";
  EXPECT_THROW(run_simulated_study(bad), InputError);
  EXPECT_FALSE(fs::exists(folder / "log"));
}

TEST_F(SimulationTest, ExcludedPeopleAreLeftAlone) {
  run_simulated_study(request("log", ObserverKind::threshold, 3));
  exclude_participant(folder / "log", "sim-0002");
  EXPECT_EQ(run_simulated_study(request("log", ObserverKind::threshold, 3)).answers_added, 0);
}

/// Through the whole chain of trials, session and log the means are the planted ones.
TEST(Simulation, TwoThousandObserversMeetTheirExpectationFast) {
  const TemporaryFolder folder;
  const RenderedSet set = write_set(folder / "set", paper_widths_px);
  ASSERT_EQ(set.manifest.stimuli.size(), 84U);
  const auto start = std::chrono::steady_clock::now();
  run_simulated_study({.set_folder = set.folder,
                       .log = folder / "log",
                       .observer = ObserverKind::threshold,
                       .count = 2000,
                       .seed = 4});
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::printf("2000 observers x 84 answers: %.2f s\n", seconds);
  EXPECT_LT(seconds, 60);
  std::map<std::pair<Artifact, int>, std::map<std::string, double>>
      means;  // a person's mean over three objects
  for (const Answer& answer : read_log(folder / "log").answers)
    means[{answer.artifact, answer.depth_width_px}][answer.participant] += answer.noticeability() / 3.0;
  ASSERT_EQ(means.size(), 28U);
  for (const auto& [cell, people] : means) {
    double sum = 0, squares = 0;
    for (const auto& [code, mean] : people) {
      sum += mean;
      squares += mean * mean;
    }
    const auto n = static_cast<double>(people.size());
    const double standard_error = std::sqrt((squares / n - sum / n * (sum / n)) / n);
    EXPECT_NEAR(sum / n, expected_noticeability(set.study.observer, cell.first, cell.second),
                4 * standard_error)
        << word(cell.first) << " " << cell.second;
  }
}

/// Orders that people share: simulated person n has order n - 1, counted around.
TEST_F(SimulationTest, PeopleShareOrdersWhereTheStudySaysSo) {
  std::string text = study_text("tiny", "64, 512");
  text.insert(text.find("break_every"), "orders = 2\n");
  set = write_set_of_text(folder / "shared", text);
  run_simulated_study(request("shared.sqlite", ObserverKind::perfect, 4));
  const LogContents log = read_log(folder / "shared.sqlite");
  std::map<std::string, std::vector<std::string>> order;
  for (const Answer& answer : log.answers) order[answer.participant].push_back(answer.stimulus_id);
  EXPECT_EQ(order["sim-0001"], order["sim-0003"]);
  EXPECT_EQ(order["sim-0002"], order["sim-0004"]);
  EXPECT_NE(order["sim-0001"], order["sim-0002"]);
}

}  // namespace
}  // namespace seamline::study
