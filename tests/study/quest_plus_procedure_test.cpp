// Tracks: what may be shown, in which order, when it ends, and that a session can be taken up again.
#include "study/placement/quest_plus_procedure.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "quest_plus_task.h"
#include "study/observers/observer.h"
#include "study/placement/procedure.h"
#include "support/arithmetic/random.h"

namespace seamline::study {
namespace {

/// A set of two artifacts with three objects each; of `overlap` only some widths are rendered.
std::vector<Stimulus> rendered() {
  std::vector<Stimulus> stimuli;
  for (const Artifact artifact : {Artifact::receiver, Artifact::overlap})
    for (int object = 1; object <= 3; ++object)
      for (const int width_px : seven_widths_px) {
        if (artifact == Artifact::overlap && (width_px == 256 || (width_px == 512 && object == 2))) continue;
        stimuli.push_back({.scene = "room",
                           .artifact = artifact,
                           .object = std::string(1, static_cast<char>('a' + object)),
                           .object_index = object,
                           .level = 1.0 * width_px,
                           .depth = {.width_px = width_px}});
      }
  return stimuli;
}

struct Person {
  Observer observer;
  std::uint64_t seed = 1;

  [[nodiscard]] TrialAnswer answer(const Stimulus& stimulus, int trial) const {
    Random random(seed, static_cast<std::uint64_t>(trial) + 1);
    const Response response = respond(observer, stimulus, random);
    return {.trial_index = trial, .chosen_index = response.chosen_index, .rating = response.rating};
  }
};

class QuestPlusProcedureTest : public testing::Test {
 protected:
  std::vector<Stimulus> stimuli = rendered();
  Person person{.observer = ThresholdObserver{}};

  [[nodiscard]] QuestPlusProcedure begin(const QuestPlusDefinition& definition,
                                         std::uint64_t seed = 5) const {
    return begin_quest_plus(std::make_shared<QuestPlusDesign>(make_quest_plus_design(definition, stimuli)),
                            seed);
  }
  static QuestPlusDefinition definition(int shows = 4) {
    QuestPlusDefinition made = definition_for(seven_widths_px);
    made.max_shows_per_image = shows;
    return made;
  }
  /// Runs to the end; which stimuli were shown and answered how.
  struct Run {
    QuestPlusProcedure end;
    std::vector<int> shown;
    std::vector<TrialAnswer> answers;
    std::vector<QuestPlusProcedure> before;  ///< each trial
  };
  [[nodiscard]] Run run(QuestPlusProcedure procedure, bool keep = false) const {
    Run result;
    while (procedure.due) {
      if (keep) result.before.push_back(procedure);
      const int stimulus = *procedure.due;
      result.shown.push_back(stimulus);
      result.answers.push_back(
          person.answer(stimuli[static_cast<std::size_t>(stimulus)], procedure.answered));
      procedure = after_answer(std::move(procedure), result.answers.back());
    }
    result.end = std::move(procedure);
    return result;
  }
};

TEST_F(QuestPlusProcedureTest, TracksHoldWhatIsRendered) {
  QuestPlusDefinition by_object = definition();
  by_object.track = PlacementTrack::object;
  const QuestPlusDesign one = make_quest_plus_design(definition(), stimuli);
  ASSERT_EQ(one.tracks.size(), 2U);
  EXPECT_EQ(one.tracks[0].levels, std::vector<double>(seven_widths_px.begin(), seven_widths_px.end()));
  EXPECT_EQ(one.tracks[1].levels, (std::vector<double>{64, 128, 512, 1024, 2048, 4096}));
  EXPECT_EQ(one.tracks[1].images[2].size(), 2U);
  EXPECT_EQ(name_of(one.tracks[1]), "overlap");
  const QuestPlusDesign other = make_quest_plus_design(by_object, stimuli);
  ASSERT_EQ(other.tracks.size(), 6U);
  EXPECT_EQ(name_of(other.tracks[4]), "overlap room c");
  EXPECT_EQ(other.tracks[4].levels, (std::vector<double>{64, 128, 1024, 2048, 4096}));
  EXPECT_EQ(other.tracks[0].tables, other.tracks[1].tables) << "same widths, same tables";
  for (const QuestPlusDesign* design : {&one, &other})
    for (std::size_t i = 0; i < stimuli.size(); ++i) {
      const TrackPlace& place = design->places[i];
      const TrackDesign& track = design->tracks[static_cast<std::size_t>(place.track)];
      EXPECT_EQ(track.artifact, stimuli[i].artifact);
      EXPECT_EQ(track.levels[static_cast<std::size_t>(place.level)], stimuli[i].level);
      EXPECT_EQ(place.object_index, stimuli[i].object_index);
    }
}

TEST_F(QuestPlusProcedureTest, NobodySeesAnImageMoreThanKTimes) {
  for (const PlacementTrack track : {PlacementTrack::artifact, PlacementTrack::object})
    for (const int shows : {1, 2, 5}) {
      QuestPlusDefinition many = definition(shows);
      many.track = track;
      many.max_trials = 10000;
      const Run all = run(begin(many));
      std::map<int, int> count;
      for (const int stimulus : all.shown) ++count[stimulus];
      EXPECT_EQ(count.size(), stimuli.size());
      for (const auto& [stimulus, times] : count) EXPECT_EQ(times, shows) << stimulus;
      for (const QuestPlusTrack& end : all.end.tracks) EXPECT_EQ(end.stopped, StopReason::images_used);
      EXPECT_EQ(most_trials(all.end), static_cast<int>(all.shown.size()));
    }
}

TEST_F(QuestPlusProcedureTest, ImagesOfAWidthTakeTurns) {
  const Run all = run(begin(definition()), true);
  for (std::size_t trial = 0; trial < all.shown.size(); ++trial) {
    const QuestPlusProcedure& before = all.before[trial];
    const TrackPlace& place = before.design->places[static_cast<std::size_t>(all.shown[trial])];
    for (const int image : before.design->tracks[static_cast<std::size_t>(place.track)]
                               .images[static_cast<std::size_t>(place.level)])
      EXPECT_GE(before.shows[static_cast<std::size_t>(image)],
                before.shows[static_cast<std::size_t>(all.shown[trial])]);
  }
}

TEST_F(QuestPlusProcedureTest, TheWidthIsTheOneThatLeavesTheLeastEntropy) {
  const Run all = run(begin(definition(1000)), true);
  for (std::size_t trial = 0; trial < all.shown.size(); ++trial) {
    const QuestPlusProcedure& before = all.before[trial];
    const TrackPlace& place = before.design->places[static_cast<std::size_t>(all.shown[trial])];
    const std::vector<double> expected =
        expected_entropies_nats(*before.design->tracks[static_cast<std::size_t>(place.track)].tables,
                                before.tracks[static_cast<std::size_t>(place.track)].posterior);
    EXPECT_EQ(std::min_element(expected.begin(), expected.end()) - expected.begin(), place.level);
  }
}

TEST_F(QuestPlusProcedureTest, EveryRoundVisitsEachTrackOnceInAnyOrder) {
  QuestPlusDefinition by_object = definition();
  by_object.track = PlacementTrack::object;
  by_object.max_trials = 12;
  std::set<std::vector<int>> orders;
  std::vector<int> firsts(6, 0);
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Run all = run(begin(by_object, seed));
    ASSERT_EQ(all.shown.size(), 6U * 12);
    for (std::size_t round = 0; round < 12; ++round) {
      std::vector<int> order;
      for (std::size_t i = 0; i < 6; ++i)
        order.push_back(all.end.design->places[static_cast<std::size_t>(all.shown[round * 6 + i])].track);
      ++firsts[static_cast<std::size_t>(order[0])];
      EXPECT_EQ(std::set<int>(order.begin(), order.end()).size(), 6U);
      orders.insert(order);
    }
  }
  EXPECT_GT(orders.size(), 500U) << "of 720, in 1200 rounds";
  for (const int first : firsts) EXPECT_NEAR(first, 200, 60);
}

TEST_F(QuestPlusProcedureTest, SameSeedAndAnswersSameTrials) {
  const Run one = run(begin(definition(), 9)), same = run(begin(definition(), 9)),
            other = run(begin(definition(), 10));
  EXPECT_EQ(one.shown, same.shown);
  EXPECT_EQ(one.end.tracks, same.end.tracks);
  EXPECT_NE(one.shown, other.shown);
}

TEST_F(QuestPlusProcedureTest, ResumesBitForBitAtEveryTrial) {
  for (const PlacementOutcome outcome : {PlacementOutcome::correct, PlacementOutcome::noticeability}) {
    QuestPlusDefinition wanted = definition();
    wanted.outcome = outcome;
    wanted.stop_interval = 1.5;
    wanted.max_trials = 18;
    const QuestPlusProcedure fresh = begin(wanted);
    const Run all = run(fresh, true);
    for (std::size_t trial = 0; trial < all.before.size(); ++trial) {
      const std::vector<TrialAnswer> answers(all.answers.begin(),
                                             all.answers.begin() + static_cast<std::ptrdiff_t>(trial));
      std::vector<int> decided(all.shown.begin(), all.shown.begin() + static_cast<std::ptrdiff_t>(trial));
      for (const bool was_shown : {false, true}) {
        if (was_shown) decided.push_back(all.shown[trial]);
        const QuestPlusProcedure again = resume_quest_plus(fresh, decided, answers);
        ASSERT_EQ(again.tracks, all.before[trial].tracks);  // the masses' every bit
        ASSERT_EQ(again.due, all.before[trial].due);
        ASSERT_EQ(again.shows, all.before[trial].shows);
        ASSERT_EQ(again.answered, static_cast<int>(trial));
      }
    }
  }
}

/// On another machine the choice may round differently; what a person saw stays what they saw.
TEST_F(QuestPlusProcedureTest, WhatTheLogShowedCountsEvenIfItWouldBeChosenDifferently) {
  const QuestPlusProcedure fresh = begin(definition());
  const int shown = (*fresh.due + 1) % static_cast<int>(stimuli.size());
  const QuestPlusProcedure again = resume_quest_plus(fresh, {shown}, {});
  EXPECT_EQ(again.due, shown);
}

TEST_F(QuestPlusProcedureTest, StopsForEachOfItsReasons) {
  const auto end_of = [&](const QuestPlusDefinition& wanted) { return run(begin(wanted)).end; };
  QuestPlusDefinition capped = definition(1000);
  capped.max_trials = 17;
  for (const QuestPlusTrack& track : end_of(capped).tracks)
    EXPECT_TRUE(track.stopped == StopReason::trials && track.answered == 17);

  QuestPlusDefinition narrow = definition(1000);
  narrow.max_trials = 2000;
  narrow.stop_interval = 0.8;
  const QuestPlusProcedure narrowed = end_of(narrow);
  for (const QuestPlusTrack& track : narrowed.tracks) {
    EXPECT_EQ(track.stopped, StopReason::interval);
    const CredibleInterval interval =
        interval95(narrowed.design->grid, track.posterior, Parameter::threshold);
    EXPECT_LE(interval.high - interval.low, 0.8);
    EXPECT_LT(track.answered, 300);
  }

  QuestPlusDefinition sure = definition(1000);
  sure.max_trials = 2000;
  sure.stop_entropy_nats = 4.5;
  for (const QuestPlusTrack& track : end_of(sure).tracks) {
    EXPECT_EQ(track.stopped, StopReason::entropy);
    EXPECT_LE(entropy_nats(track.posterior.mass), 4.5);
  }

  QuestPlusDefinition lazy = definition(1000);
  lazy.stop_interval = 100;
  lazy.min_trials = 6;
  for (const QuestPlusTrack& track : end_of(lazy).tracks)
    EXPECT_TRUE(track.stopped == StopReason::interval && track.answered == 6);
}

TEST_F(QuestPlusProcedureTest, IsAProcedureLikeAnyOther) {
  QuestPlusDefinition wanted = definition(1);
  wanted.max_trials = 5;
  Procedure procedure = begin(wanted);
  EXPECT_EQ(most_trials(procedure), 10);
  for (int trial = 0; trial < 10; ++trial) {
    ASSERT_EQ(answered_trials(procedure), trial);
    const std::optional<int> due = current_stimulus(procedure);
    ASSERT_TRUE(due);
    procedure =
        after_answer(std::move(procedure), person.answer(stimuli[static_cast<std::size_t>(*due)], trial));
  }
  EXPECT_EQ(current_stimulus(procedure), std::nullopt);
  EXPECT_EQ(most_trials(procedure), 10);
}

}  // namespace
}  // namespace seamline::study
