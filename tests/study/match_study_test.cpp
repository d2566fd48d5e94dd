// A match (method of adjustment) from the study file to the log, with simulated people.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "stimuli/definition/parts/task_definition.h"
#include "study/exchange/match_records.h"
#include "study/log/log_database.h"
#include "study/running/simulation.h"
#include "study/trials/level_ladders.h"
#include "study/trials/participant_trials.h"
#include "study/visit/session.h"
#include "temporary_set.h"
#include "tests/complaint.h"

namespace seamline::study {
namespace {

constexpr const char* fine_widths_px = "16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192";

RenderedSet match_set(const std::filesystem::path& folder, const std::string& more = "",
                      const std::string& widths = paper_widths_px) {
  return write_set_of_text(folder, study_text("matched", widths) + "[task]\nkind = \"match\"\n" + more);
}

Session session_of_match(const RenderedSet& set, int slot = 0) {
  const TrialRules rules = make_trial_rules(set);
  const std::vector<Trial> trials = decided_trials(rules, slot, {});
  return begin_session(trial_sequence(rules, {.slot = slot, .trials = trials, .answers = {}}),
                       {.task = {.facts = rules.task, .ladders = rules.ladders}});
}

Session step_taken(Session session, MatchStep step, std::int64_t now_ns) {
  return next(std::move(session), ObjectChosen{.index = static_cast<int>(step), .now_ns = now_ns});
}

TEST(MatchStudy, ALadderHoldsWhatDiffersInTheLevelAlone) {
  const TemporaryFolder folder;
  const RenderedSet set = match_set(folder / "set");
  const TrialRules rules = make_trial_rules(set);
  const LevelLadders& ladders = *rules.ladders;
  ASSERT_EQ(ladders.ladders.size(), 12U);  // four artifacts of three objects
  for (const std::vector<int>& ladder : ladders.ladders) {
    ASSERT_EQ(ladder.size(), 7U);
    const Stimulus& first = rules.stimuli[static_cast<std::size_t>(ladder.front())];
    double level = 0;
    for (const int rung : ladder) {
      const Stimulus& stimulus = rules.stimuli[static_cast<std::size_t>(rung)];
      EXPECT_EQ(stimulus.object, first.object);
      EXPECT_EQ(stimulus.artifact, first.artifact);
      EXPECT_GT(stimulus.level, level);  // the small width shows most
      level = stimulus.level;
    }
    EXPECT_FALSE(next_rung(ladders, ladder.front(), -1));
    EXPECT_FALSE(next_rung(ladders, ladder.back(), 1));
    EXPECT_EQ(next_rung(ladders, ladder[2], 2), ladder[4]);
  }
  EXPECT_EQ(*std::max_element(ladders.curves.begin(), ladders.curves.end()), 3);
}

TEST(MatchStudy, WhereNoticeabilityRisesTheLargestLevelComesFirst) {
  std::vector<Stimulus> stimuli(3);
  for (std::size_t i = 0; i < stimuli.size(); ++i) stimuli[i].level = std::exp2(i);
  EXPECT_EQ(make_level_ladders(stimuli, Direction::decreasing).ladders.front(), (std::vector{0, 1, 2}));
  EXPECT_EQ(make_level_ladders(stimuli, Direction::increasing).ladders.front(), (std::vector{2, 1, 0}));
  stimuli[0].level = 0;  // "none" has no place on the axis
  const LevelLadders ladders = make_level_ladders(stimuli, Direction::decreasing);
  EXPECT_EQ(ladders.ladders.front(), (std::vector{1, 2}));
  EXPECT_EQ(ladders.places.front().ladder, -1);
}

TEST(MatchStudy, StartsAreBalancedOverRepetitionsObjectsAndParticipants) {
  const TemporaryFolder folder;
  const RenderedSet set = match_set(folder / "set");
  const LevelLadders ladders = *make_trial_rules(set).ladders;
  const int count = static_cast<int>(ladders.ladders.size());
  for (int slot = 0; slot < 4; ++slot) {
    const std::vector<int> starts = match_starts(ladders, 4, {.study_seed = 7, .slot = slot});
    EXPECT_EQ(starts, match_starts(ladders, 4, {.study_seed = 7, .slot = slot}));
    ASSERT_EQ(starts.size(), static_cast<std::size_t>(4 * count));
    std::map<int, int> clear, all, clear_of_first_round;
    for (std::size_t i = 0; i < starts.size(); ++i) {
      const LevelLadders::Place& place = ladders.places[static_cast<std::size_t>(starts[i])];
      EXPECT_NE(place.rung, 3) << "the middle of seven is in neither half";
      EXPECT_EQ(begins_clear(ladders, starts[i]), place.rung < 3);
      ++all[place.ladder];
      clear[place.ladder] += place.rung < 3 ? 1 : 0;
      if (static_cast<int>(i) < count)
        clear_of_first_round[ladders.curves[static_cast<std::size_t>(place.ladder)]] +=
            place.rung < 3 ? 1 : 0;
    }
    for (const auto& [ladder, times] : all) {
      EXPECT_EQ(times, 4);
      EXPECT_EQ(clear[ladder], 2) << "ladder " << ladder << " of slot " << slot;
    }
    // Of three objects, two begin clear for one participant and one for the next.
    for (const auto& [curve, times] : clear_of_first_round) EXPECT_EQ(times, slot % 2 == 0 ? 2 : 1) << curve;
  }
  std::set<std::vector<int>> orders;
  std::map<int, int> rungs;
  for (int slot = 0; slot < 50; ++slot) {
    orders.insert(match_starts(ladders, 1, {.study_seed = 7, .slot = slot}));
    for (const int start : *orders.rbegin()) ++rungs[ladders.places[static_cast<std::size_t>(start)].rung];
  }
  EXPECT_EQ(orders.size(), 50U);
  EXPECT_EQ(rungs.size(), 6U) << "every rung but the middle is a start";
}

TEST(MatchStudy, StepsMoveThePictureAndStopAtTheEnds) {
  const TemporaryFolder folder;
  const RenderedSet set = match_set(folder / "set");
  Session session = next(session_of_match(set), ImageShown{.now_ns = 1000});
  const LevelLadders& ladders = *session.pace.task.ladders;
  const Trial trial = current_trial(session.trials).value();
  EXPECT_EQ(picture_on_screen(session), trial);
  const auto rung = [&] {
    return ladders.places[static_cast<std::size_t>(picture_on_screen(session)->stimulus)].rung;
  };
  for (int press = 0; press < 10; ++press) session = step_taken(std::move(session), MatchStep::fainter, 1100);
  EXPECT_EQ(rung(), 6);
  for (int press = 0; press < 2; ++press) session = step_taken(std::move(session), MatchStep::clearer, 1200);
  EXPECT_EQ(rung(), 4);
  EXPECT_EQ(current_trial(session.trials), trial) << "the trial stays the one that was planned";
  EXPECT_TRUE(
      std::holds_alternative<Choosing>(next(session, RatingGiven{.rating = 1, .now_ns = 2000}).phase));
  const int stopped_at = picture_on_screen(session)->stimulus;
  const Session stored = step_taken(session, MatchStep::just_seen, 5000);
  ASSERT_TRUE(std::holds_alternative<Storing>(stored.phase));
  EXPECT_EQ(std::get<Storing>(stored.phase).answer, (TrialAnswer{.trial_index = 0,
                                                                 .chosen_index = 3,
                                                                 .rating = 1,
                                                                 .matched = stopped_at,
                                                                 .choice_ns = 4000,
                                                                 .rating_ns = 4000}));
  const Session after_pause = next(next(session, PictureTaken{}), ImageShown{.now_ns = 9000});
  EXPECT_EQ(picture_on_screen(after_pause), trial) << "a pause begins the match again";
}

TEST(MatchStudy, SimulatedPeopleStopWhereTheirPsychometricFunctionSays) {
  const TemporaryFolder folder;
  const RenderedSet set =
      match_set(folder / "set", "repetitions = 40\n[observer]\npeople_sd_octaves = 0\n", fine_widths_px);
  run_simulated_study({.set_folder = folder / "set",
                       .log = folder / "log",
                       .observer = ObserverKind::threshold,
                       .count = 4,
                       .seed = 3});
  const LogContents log = read_log(folder / "log");
  std::map<Artifact, std::vector<double>> octaves;
  for (const MatchRecord& match : read_matches(log))
    octaves[match.artifact].push_back(std::log2(match.level));
  ASSERT_EQ(octaves.size(), 4U);
  const ObserverDefinition& observer = set.study.observer;
  // Of a logistic distribution of scale s, rounded to levels an octave apart.
  const double sd = std::sqrt(std::pow(observer.scale_octaves * std::numbers::pi, 2) / 3 + 1.0 / 12);
  for (const auto& [artifact, values] : octaves) {
    const auto n = static_cast<double>(values.size());
    ASSERT_EQ(n, 4 * 40 * 3);
    double mean = 0, squares = 0;
    for (const double value : values) mean += value / n;
    for (const double value : values) squares += (value - mean) * (value - mean) / n;
    EXPECT_NEAR(mean, std::log2(observer.midpoint.at(artifact)), 4 * sd / std::sqrt(n)) << word(artifact);
    EXPECT_NEAR(std::sqrt(squares), sd, 0.12) << word(artifact);
  }
}

TEST(MatchStudy, WhoSeesEverythingStopsAtTheFaintestAndAGuesserAnywhere) {
  const TemporaryFolder folder;
  (void)match_set(folder / "set");
  for (const ObserverKind kind : {ObserverKind::perfect, ObserverKind::guesser}) {
    const std::filesystem::path path = folder / std::string(word(kind));
    run_simulated_study(
        {.set_folder = folder / "set", .log = path, .observer = kind, .count = 20, .seed = 3});
    std::map<double, int> times;
    int at_end = 0;
    const std::vector<MatchRecord> matches = read_matches(read_log(path));
    ASSERT_EQ(matches.size(), 240U);
    for (const MatchRecord& match : matches) {
      ++times[match.level];
      at_end += match.at_end ? 1 : 0;
    }
    if (kind == ObserverKind::perfect) {
      EXPECT_EQ(times, (std::map<double, int>{{4096, 240}}));
      EXPECT_EQ(at_end, 240);
    } else {
      EXPECT_EQ(times.size(), 7U);
      EXPECT_NEAR(at_end, 240 * 2 / 7.0, 4 * std::sqrt(240 * 2 / 7.0 * 5 / 7));
    }
  }
}

TEST(MatchStudy, ASessionThatBreaksOffGoesOnWithTheSameMatches) {
  const TemporaryFolder folder;
  (void)match_set(folder / "set", "repetitions = 2\n");
  const auto simulate = [&](const char* name, int count) {
    run_simulated_study({.set_folder = folder / "set",
                         .log = folder / name,
                         .observer = ObserverKind::threshold,
                         .count = count,
                         .seed = 5});
    return csv_text(match_table(read_log(folder / name)).value());
  };
  const std::string whole = simulate("whole", 3);
  (void)simulate("again", 1);
  EXPECT_EQ(simulate("again", 3), whole);
}

TEST(MatchStudy, AnAnswerWithoutItsLevelIsNamed) {
  const TemporaryFolder folder;
  (void)match_set(folder / "set");
  run_simulated_study({.set_folder = folder / "set",
                       .log = folder / "log",
                       .observer = ObserverKind::threshold,
                       .count = 1,
                       .seed = 5});
  {
    SQLite::Database database((folder / "log").string(), SQLite::OPEN_READWRITE);
    EXPECT_EQ(database.exec("DELETE FROM events WHERE kind = 'matched' AND trial_index = 4"), 1);
  }
  EXPECT_THAT(test::complaint_of([&] { (void)read_matches(read_log(folder / "log")); }),
              testing::HasSubstr("the match of trial 4 of sim-0001"));
}

TEST(MatchStudy, OtherStudiesHaveNoMatches) {
  const TemporaryFolder folder;
  (void)write_set(folder / "set");
  run_simulated_study({.set_folder = folder / "set",
                       .log = folder / "log",
                       .observer = ObserverKind::threshold,
                       .count = 1,
                       .seed = 5});
  EXPECT_FALSE(match_table(read_log(folder / "log")));
  SQLite::Database database((folder / "log").string());
  EXPECT_EQ(database.execAndGet("SELECT count(*) FROM events").getInt(), 0);
}

}  // namespace
}  // namespace seamline::study
