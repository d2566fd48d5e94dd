// An adaptive study from the study file to the log and back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "study/log/log.h"
#include "study/log/log_writer.h"
#include "study/running/participant_session.h"
#include "study/running/quest_plus_results.h"
#include "study/running/simulation.h"
#include "support/text/error.h"
#include "temporary_set.h"

namespace seamline::study {
namespace {

namespace fs = std::filesystem;

constexpr const char* settings = "max_shows_per_image = 3\nmax_trials = 24\n";

std::string adaptive_text(const std::string& quest_plus, const std::string& more = "") {
  std::string text = study_text("adaptive", paper_widths_px);
  text.insert(text.find("seed ="), "procedure = \"quest_plus\"\n");
  text.insert(text.find("[session]"), "[quest_plus]\n" + quest_plus);
  return text + more;
}

class QuestPlusStudyTest : public testing::Test {
 protected:
  TemporaryFolder folder;

  [[nodiscard]] RenderedSet adaptive_set(const std::string& quest_plus = settings,
                                         const std::string& more = "") const {
    return write_set_of_text(folder / "set", adaptive_text(quest_plus, more));
  }
  [[nodiscard]] SimulationRequest request(const std::string& log, int count) const {
    return {.set_folder = folder / "set",
            .log = folder / log,
            .observer = ObserverKind::threshold,
            .count = count,
            .seed = 1};
  }
  [[nodiscard]] std::vector<std::string> lines_of(const std::string& log) const {
    std::vector<std::string> lines;
    for (const Answer& answer : read_log(folder / log).answers)
      lines.push_back(fmt::format("{} {} {} {} {}", answer.participant, answer.trial_index,
                                  answer.stimulus_id, answer.chosen_index, answer.rating));
    return lines;
  }
};

TEST_F(QuestPlusStudyTest, RunsEveryTrackAndKeepsToTheCap) {
  (void)adaptive_set();
  const SimulationSummary summary = run_simulated_study(request("log", 6));
  EXPECT_EQ(summary.participants_run, 6);
  EXPECT_EQ(summary.answers_added, 6 * 4 * 24);
  std::map<std::string, std::map<std::string, int>> shows;
  std::map<std::string, std::map<Artifact, int>> trials;
  for (const Answer& answer : read_log(folder / "log").answers) {
    EXPECT_LE(++shows[answer.participant][answer.stimulus_id], 3);
    ++trials[answer.participant][answer.artifact];
  }
  std::set<std::vector<std::string>> orders;
  for (const auto& [participant, by_artifact] : trials) {
    EXPECT_EQ(by_artifact.size(), 4U);
    for (const auto& [artifact, count] : by_artifact) EXPECT_EQ(count, 24);
  }
  for (const ParticipantRecord& participant : read_log(folder / "log").participants) {
    EXPECT_TRUE(participant.completed);
    EXPECT_EQ(participant.stimulus_trials, 96);
  }
}

TEST_F(QuestPlusStudyTest, SameSeedSameLogAndRunningAgainAddsOnlyWhatIsMissing) {
  (void)adaptive_set();
  run_simulated_study(request("whole", 4));
  run_simulated_study(request("parts", 2));
  EXPECT_EQ(run_simulated_study(request("parts", 4)).answers_added, 2 * 96);
  EXPECT_EQ(run_simulated_study(request("parts", 4)).answers_added, 0);
  EXPECT_EQ(lines_of("whole"), lines_of("parts"));
}

TEST_F(QuestPlusStudyTest, ABrokenOffSessionGoesOnAsIfNothingHadHappened) {
  const RenderedSet set = adaptive_set();
  run_simulated_study(request("whole", 1));
  const LogContents whole = read_log(folder / "whole");
  const TrialRules rules = make_trial_rules(set);
  for (const int broken_off_at : {1, 13, 40, 95})
    for (const bool image_was_shown : {false, true}) {
      const std::string name = fmt::format("half{}{}", broken_off_at, image_was_shown);
      {
        LogWriter log(folder / name, set);
        OpenSession place = log.open_session({.code = "sim-0001", .simulated = Simulated{.seed = 1}});
        TrialSequence trials = open_trials(rules, log, place);
        for (int trial = 0; trial < broken_off_at; ++trial) {
          store_due_trial(trials, log, place);
          const Answer& given = whole.answers[static_cast<std::size_t>(trial)];
          const TrialAnswer answer{
              .trial_index = trial, .chosen_index = given.chosen_index, .rating = given.rating};
          log.append_answer(place, answer);
          trials = after_answer(std::move(trials), answer);
        }
        if (image_was_shown) store_due_trial(trials, log, place);

        LogWriter reopened(folder / name, set);
        OpenSession again = reopened.open_session({.code = "sim-0001", .simulated = Simulated{.seed = 1}});
        const TrialSequence resumed = open_trials(rules, reopened, again);
        EXPECT_EQ(current_trial(resumed), current_trial(trials));
        EXPECT_EQ(std::get<QuestPlusProcedure>(resumed.procedure).tracks,
                  std::get<QuestPlusProcedure>(trials.procedure).tracks);
      }
      EXPECT_EQ(run_simulated_study(request(name, 1)).answers_added, 96 - broken_off_at);
      EXPECT_EQ(lines_of(name), lines_of("whole"));
    }
}

TEST_F(QuestPlusStudyTest, TheLogGivesBackThePlantedThresholds) {
  (void)adaptive_set("max_shows_per_image = 10\nmax_trials = 60\n",
                     "[observer]\npeople_sd_octaves = 0.4\n[observer.midpoint_width_px]\noverlap = 800\n");
  run_simulated_study(request("log", 30));
  const LogContents log = read_log(folder / "log");
  const std::vector<TrackEstimate> estimates = quest_plus_estimates(log);
  ASSERT_EQ(estimates.size(), 30U * 4);
  std::map<Artifact, double> mean;
  for (const TrackEstimate& estimate : estimates) {
    EXPECT_EQ(estimate.trials, 60);
    EXPECT_LT(estimate.low, estimate.threshold);
    EXPECT_GT(estimate.high, estimate.threshold);
    mean[estimate.artifact] += std::log2(estimate.threshold) / 30;
  }
  const ObserverDefinition observer = read_study_text(log.study_text, "study").observer;
  for (const auto& [artifact, log2_px] : mean)  // standard error of 30 people about 0.1 octave
    EXPECT_NEAR(log2_px, std::log2(observer.midpoint.at(artifact)), 0.4) << word(artifact);
  EXPECT_THAT(tracks_text(estimates), testing::HasSubstr("sim-0030     overlap"));
}

constexpr const char* rising_settings =
    "max_shows_per_image = 10\nmax_trials = 60\nnoticeability = \"rises\"\n"
    "threshold_px = { prior = { mean = 400, sd = 1.5 } }\nlapse = { prior = { a = 1, b = 20 } }\n";
constexpr const char* rising_people =
    "[observer]\nnoticeability = \"rises\"\npeople_sd_octaves = 0.4\n"
    "[observer.midpoint_width_px]\noverlap = 800\n";

TEST_F(QuestPlusStudyTest, TheLogGivesBackPlantedThresholdsOfNoticeabilityThatRises) {
  (void)adaptive_set(rising_settings, rising_people);
  run_simulated_study(request("log", 20));
  const LogContents log = read_log(folder / "log");
  std::map<Artifact, double> mean;
  const std::vector<TrackEstimate> estimates = quest_plus_estimates(log);
  for (const TrackEstimate& estimate : estimates) {
    EXPECT_EQ(estimate.direction, Direction::increasing);
    EXPECT_EQ(estimate.informed, (std::vector<Parameter>{Parameter::threshold, Parameter::lapse}));
    EXPECT_LT(estimate.low, estimate.threshold);
    EXPECT_GT(estimate.high, estimate.threshold);
    mean[estimate.artifact] += std::log2(estimate.threshold) / 20;
  }
  const ObserverDefinition observer = read_study_text(log.study_text, "study").observer;
  for (const auto& [artifact, log2_px] : mean)
    EXPECT_NEAR(log2_px, std::log2(observer.midpoint.at(artifact)), 0.4) << word(artifact);
  EXPECT_THAT(tracks_text(estimates), testing::StartsWith("Noticeability rises"));
}

TEST_F(QuestPlusStudyTest, EstimatesOnALinearAxisAreInPixels) {
  (void)adaptive_set(
      "max_shows_per_image = 10\nmax_trials = 60\naxis = \"linear\"\n"
      "threshold_px = { least = 32, most = 4096, count = 41, prior = { mean = 500, sd = 800 } }\n");
  run_simulated_study(request("log", 12));
  const LogContents log = read_log(folder / "log");
  const std::vector<TrackEstimate> estimates = quest_plus_estimates(log);
  std::map<Artifact, double> mean_px;
  for (const TrackEstimate& estimate : estimates) {
    EXPECT_EQ(estimate.axis, Axis::linear);
    EXPECT_LE(estimate.low, estimate.threshold);
    EXPECT_GE(estimate.high, estimate.threshold);
    EXPECT_GT(estimate.threshold_sd, 1);  // px
    mean_px[estimate.artifact] += estimate.threshold / 12;
  }
  EXPECT_LT(mean_px[Artifact::shadow], mean_px[Artifact::occlusion]);  // 180 and 620 px are planted
  EXPECT_NEAR(mean_px[Artifact::occlusion], 620, 250);
  EXPECT_THAT(tracks_text(estimates), testing::HasSubstr("scale_px"));
}

/// What was believed before the first answer is part of what a broken off session is rebuilt from, and of the
/// study that a log belongs to.
TEST_F(QuestPlusStudyTest, ASessionWithPriorsGoesOnAndKeepsToItsStudy) {
  const RenderedSet set = adaptive_set(rising_settings, rising_people);
  run_simulated_study(request("whole", 1));
  run_simulated_study(request("half", 1));
  const LogContents whole = read_log(folder / "whole");
  const TrialRules rules = make_trial_rules(set);
  LogWriter log(folder / "parts", set);
  OpenSession place = log.open_session({.code = "sim-0001", .simulated = Simulated{.seed = 1}});
  TrialSequence trials = open_trials(rules, log, place);
  for (int trial = 0; trial < 50; ++trial) {
    store_due_trial(trials, log, place);
    const Answer& given = whole.answers[static_cast<std::size_t>(trial)];
    const TrialAnswer answer{
        .trial_index = trial, .chosen_index = given.chosen_index, .rating = given.rating};
    log.append_answer(place, answer);
    trials = after_answer(std::move(trials), answer);
  }
  LogWriter reopened(folder / "parts", set);
  OpenSession again = reopened.open_session({.code = "sim-0001", .simulated = Simulated{.seed = 1}});
  const TrialSequence resumed = open_trials(rules, reopened, again);
  EXPECT_EQ(current_trial(resumed), current_trial(trials));
  EXPECT_EQ(std::get<QuestPlusProcedure>(resumed.procedure).tracks,
            std::get<QuestPlusProcedure>(trials.procedure).tracks);

  const std::string other =
      std::string(rising_settings).replace(std::string(rising_settings).find("1.5"), 3, "1.6");
  const RenderedSet changed = write_set_of_text(folder / "other", adaptive_text(other, rising_people));
  EXPECT_THROW(LogWriter(folder / "half", changed), InputError);
}

TEST_F(QuestPlusStudyTest, AThresholdBeyondTheGridIsReported) {
  const RenderedSet set = adaptive_set(
      settings, "[observer]\npeople_sd_octaves = 0\n[observer.midpoint_width_px]\nreceiver = 200000\n");
  EXPECT_GE(run_simulated_study(request("log", 3)).tracks_on_edge, 3);
  int alarms = 0;
  for (const TrackEstimate& estimate : quest_plus_estimates(read_log(folder / "log")))
    if (estimate.artifact == Artifact::receiver)
      for (const EdgeAlarm& alarm : estimate.alarms)
        alarms += alarm.parameter == Parameter::threshold && alarm.highest;
  EXPECT_EQ(alarms, 3);
}

TEST_F(QuestPlusStudyTest, EachObjectCanHaveATrackOfItsOwn) {
  (void)adaptive_set("track = \"object\"\nmax_shows_per_image = 2\nmax_trials = 10\n");
  EXPECT_EQ(run_simulated_study(request("log", 2)).answers_added, 2 * 12 * 10);
  EXPECT_EQ(quest_plus_estimates(read_log(folder / "log")).size(), 24U);
}

TEST_F(QuestPlusStudyTest, ALogOfConstantStimuliHasNoTracks) {
  (void)write_set(folder / "set");
  run_simulated_study(request("log", 1));
  EXPECT_THROW((void)quest_plus_estimates(read_log(folder / "log")), InputError);
}

}  // namespace
}  // namespace seamline::study
