// Catch trials from the study file to the log, with simulated people.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "study/log/log.h"
#include "study/log/log_admin.h"
#include "study/log/log_writer.h"
#include "study/running/participant_session.h"
#include "study/running/quest_plus_results.h"
#include "study/running/simulation.h"
#include "study/trials/catch_trials.h"
#include "temporary_set.h"

namespace seamline::study {
namespace {

namespace fs = std::filesystem;

std::string catches(int attention, int reference) {
  return fmt::format("[catch]\nattention = {}\nreference = {}\n", attention, reference);
}

std::string adaptive_text() {
  std::string text = study_text("tiny", paper_widths_px);
  text.insert(text.find("[session]"), "procedure = \"quest_plus\"\n");
  return text + "[quest_plus]\nmax_shows_per_image = 2\nmax_trials = 15\n";
}

class CatchStudyTest : public testing::Test {
 protected:
  TemporaryFolder folder;

  LogContents simulate(const std::string& name, const std::string& text, ObserverKind observer, int count) {
    (void)write_set_of_text(folder / (name + "-set"), text);
    run_simulated_study({.set_folder = folder / (name + "-set"),
                         .log = folder / name,
                         .observer = observer,
                         .count = count,
                         .seed = 4});
    return read_log(folder / name);
  }
};

TEST_F(CatchStudyTest, AStudyWithoutCatchTrialsHasNone) {
  const LogContents log = simulate("log", study_text("tiny", "64, 512"), ObserverKind::perfect, 2);
  EXPECT_EQ(log.answers.size(), 48U);
  EXPECT_TRUE(log.catches.empty());
}

TEST_F(CatchStudyTest, AnswersAreKeptApartByKind) {
  const LogContents log =
      simulate("log", study_text("tiny", "64, 512") + catches(3, 4), ObserverKind::perfect, 5);
  EXPECT_EQ(log.answers.size(), 5U * 24);
  ASSERT_EQ(log.catches.size(), 5U * 7);
  std::map<std::string, std::set<int>> trials;
  for (const Answer& answer : log.answers) {
    EXPECT_EQ(answer.noticeability(), 4);
    EXPECT_TRUE(trials[answer.participant].insert(answer.trial_index).second);
  }
  int right = 0, attention = 0, reference = 0;
  for (const CatchTrialAnswer& answer : log.catches) {
    EXPECT_TRUE(trials[answer.participant].insert(answer.trial_index).second);
    EXPECT_GT(answer.trial_index, 0);
    if (answer.kind == TrialKind::attention) {
      ++attention;
      right += answer.right() ? 1 : 0;
      EXPECT_TRUE(answer.right_index >= 1 && answer.right_index <= 3);
      EXPECT_EQ(answer.rating, 4);
    } else {
      ++reference;
      EXPECT_EQ(answer.right_index, 0);
      EXPECT_EQ(answer.rating, 1);
      EXPECT_FALSE(answer.right());
    }
  }
  EXPECT_EQ(attention, 15);
  EXPECT_EQ(reference, 20);
  EXPECT_EQ(right, 15);
  for (const ParticipantRecord& participant : log.participants) {
    EXPECT_EQ(participant.stimulus_trials, 24);
    EXPECT_EQ(trials[participant.code].size(), 31U);
    EXPECT_EQ(*trials[participant.code].rbegin(), 30);
  }
}

TEST_F(CatchStudyTest, SeeingObserversPassAndGuessersGuess) {
  const std::string text = study_text("tiny", "64") + catches(6, 6);
  std::map<int, int> chosen_on_references;
  for (const ObserverKind kind : {ObserverKind::threshold, ObserverKind::guesser}) {
    const LogContents log = simulate("log-" + std::string(word(kind)), text, kind, 200);
    int attention = 0, right = 0;
    for (const CatchTrialAnswer& answer : log.catches) {
      attention += answer.kind == TrialKind::attention ? 1 : 0;
      right += answer.right() ? 1 : 0;
      if (answer.kind == TrialKind::reference) ++chosen_on_references[answer.chosen_index];
    }
    ASSERT_EQ(attention, 1200);
    if (kind == ObserverKind::threshold)
      EXPECT_EQ(right, 1200);
    else
      EXPECT_NEAR(right, 400, 4 * std::sqrt(1200 * 2.0 / 9));
  }
  for (const auto& [chosen, count] : chosen_on_references)
    EXPECT_NEAR(count, 800, 4 * std::sqrt(2400 * 2.0 / 9)) << chosen;
}

/// Broken off anywhere, also before and after a catch trial, the session goes on as if nothing had happened.
TEST_F(CatchStudyTest, ResumesExactlyWithCatchTrialsInBothProcedures) {
  for (const std::string& base : {study_text("tiny", "64, 512"), adaptive_text()}) {
    const std::string text = base + catches(4, 4);
    const std::string name = base == adaptive_text() ? "adaptive" : "constant";
    const RenderedSet set = write_set_of_text(folder / (name + "-set"), text);
    const TrialRules rules = make_trial_rules(set);
    const auto answer = [](int trial) {
      return TrialAnswer{.trial_index = trial, .chosen_index = 1 + trial % 3, .rating = 1 + trial % 4};
    };
    LogWriter log(folder / name, set);
    OpenSession place = log.open_session({.code = "whole"});
    TrialSequence trials = open_trials(rules, log, place);
    while (current_trial(trials)) {
      store_due_trial(trials, log, place);
      log.append_answer(place, answer(place.answered));
      trials = after_answer(std::move(trials), place.answers.back());
    }
    ASSERT_GT(catch_trials_of(place.trials).size(), 4U);
    // The same slot, and a new session before every trial; sometimes after the picture was shown.
    exclude_participant(folder / name, "whole");
    int shown = 0;
    for (;;) {
      OpenSession part = log.open_session({.code = "parts"});
      ASSERT_EQ(part.slot, place.slot);
      const TrialSequence resumed = open_trials(rules, log, part);
      if (!current_trial(resumed)) {
        EXPECT_EQ(part.trials, place.trials);
        break;
      }
      store_due_trial(resumed, log, part);
      if (++shown % 3 == 0) continue;
      log.append_answer(part, answer(part.answered));
    }
  }
}

/// An adaptive procedure learns from its own trials alone: without the catch trials the same answers to the
/// same stimuli leave the same beliefs, and choose the same stimuli.
TEST_F(CatchStudyTest, QuestPlusLearnsFromStimuliOnly) {
  const RenderedSet with = write_set_of_text(folder / "with", adaptive_text() + catches(5, 5));
  const RenderedSet without = write_set_of_text(folder / "without", adaptive_text());
  const auto run = [&](const RenderedSet& set, const std::string& name) {
    const TrialRules rules = make_trial_rules(set);
    LogWriter log(folder / name, set);
    OpenSession place = log.open_session({.code = "p"});
    TrialSequence trials = open_trials(rules, log, place);
    while (const std::optional<Trial> due = current_trial(trials)) {
      store_due_trial(trials, log, place);
      const int own = answered_trials(trials.procedure);
      log.append_answer(place, {.trial_index = place.answered,
                                .chosen_index = due->kind == TrialKind::stimulus ? 1 + own % 3 : 3,
                                .rating = due->kind == TrialKind::stimulus ? 1 + own % 4 : 4});
      trials = after_answer(std::move(trials), place.answers.back());
    }
    log.complete(place);
    return std::pair(std::get<QuestPlusProcedure>(trials.procedure), place.trials);
  };
  const auto [learnt, shown] = run(with, "log-with");
  const auto [bare, bare_shown] = run(without, "log-without");
  EXPECT_EQ(learnt.tracks, bare.tracks);
  EXPECT_EQ(shown.size(), bare_shown.size() + 10);
  std::vector<Trial> stimuli;
  for (const Trial& trial : shown)
    if (trial.kind == TrialKind::stimulus) stimuli.push_back(trial);
  EXPECT_EQ(stimuli, bare_shown);
  EXPECT_EQ(tracks_text(quest_plus_estimates(read_log(folder / "log-with"))),
            tracks_text(quest_plus_estimates(read_log(folder / "log-without"))));
}

}  // namespace
}  // namespace seamline::study
