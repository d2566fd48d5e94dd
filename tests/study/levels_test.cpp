// Studies whose levels are no widths, and that have conditions: who sees what, what is asked, and what the
// log keeps of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "study/log/log.h"
#include "study/observers/observer.h"
#include "study/placement/quest_plus_design.h"
#include "study/running/quest_plus_results.h"
#include "study/running/simulation.h"
#include "study/trials/catch_trials.h"
#include "study/trials/training_trials.h"
#include "support/text/error.h"
#include "temporary_set.h"
#include "tests/complaint.h"

namespace seamline::study {
namespace {

using testing::HasSubstr;

/// A study of one scene with the artifacts receiver and overlap; `varied` may end in tables.
std::string text_of(const std::string& top, const std::string& tables) {
  std::string text =
      "format = \"seamline study 1\"\nname = \"tiny\"\nseed = 7\n" + top + "\n" + tables +
      "\n[[scene]]\nname = \"room\"\nfile = \"none.glb\"\nartifacts = [\"receiver\", \"overlap\"]\n"
      "[scene.sun]\nto_sun = [0, 1, 0]\nirradiance_w_m2 = [1, 1, 1]\n";
  for (const char* object : {"a", "b", "c"})
    text += fmt::format("[[scene.object]]\nname = \"{}\"\nfile = \"none.glb\"\n", object);
  return text;
}

constexpr const char* tolerances =
    "[level]\nquantity = \"mesh_tolerance\"\nvalues = [0, 0.001, 0.01, 0.1]\n"
    "[observer.midpoint]\nreceiver = 0.01\noverlap = 0.003\n";
constexpr const char* lights =
    "[[condition]]\nname = \"hard\"\nsun_radius_deg = 0.0\n[[condition]]\nname = \"soft\"\nsun_radius_deg = "
    "2.0\n"
    "[observer.condition_midpoint.soft]\nreceiver = 100\n";

double mean_score(const ObserverDefinition& definition, const Stimulus& stimulus, int people) {
  double sum = 0;
  for (int person = 0; person < people; ++person) {
    Random random(5, static_cast<std::uint64_t>(person));
    const Observer observer = make_observer(ObserverKind::threshold, definition, random);
    const Response response = respond(observer, stimulus, random);
    sum += response.chosen_index == stimulus.object_index ? response.rating : 0;
  }
  return sum / people;
}

TEST(Levels, NoneIsNeverSeenWhereNoticeabilityRisesAndAlwaysWhereItFalls) {
  Stimulus none;
  none.object_index = 2;
  none.quantity = Quantity::mesh_tolerance;
  none.artifact = Artifact::receiver;
  ObserverDefinition definition{.midpoint = {{Artifact::receiver, 0.01}}, .direction = Direction::increasing};
  EXPECT_NEAR(expected_noticeability(definition, place_of(none)), 1.0 / 3, 1e-15);
  EXPECT_NEAR(mean_score(definition, none, 20000), 1.0 / 3, 0.02);
  definition.direction = Direction::decreasing;
  EXPECT_EQ(expected_noticeability(definition, place_of(none)), 4);
  EXPECT_EQ(mean_score(definition, none, 100), 4);
  // It is the limit of ever smaller levels.
  Stimulus small = none;
  small.level = 1e-12;
  EXPECT_NEAR(expected_noticeability(definition, place_of(small)), 4, 1e-9);
}

TEST(Levels, OnALinearAxisPeopleDifferInTheLevelsUnit) {
  ObserverDefinition definition{.midpoint = {{Artifact::overlap, 3}}};
  definition.scale_linear = 0.7;
  definition.people_sd_linear = 0.9;
  for (const double level : {0.0, 2.0, 3.0, 5.5}) {
    Stimulus stimulus;
    stimulus.artifact = Artifact::overlap;
    stimulus.object_index = 1;
    stimulus.quantity = Quantity::sun_radius_deg;
    stimulus.level = level;
    const double expected = expected_noticeability(definition, place_of(stimulus));
    EXPECT_NEAR(mean_score(definition, stimulus, 40000), expected, 0.03) << level;
    // A shift of level and midpoint changes nothing on a linear axis.
    ObserverDefinition shifted = definition;
    shifted.midpoint[Artifact::overlap] += 4;
    stimulus.level += 4;
    EXPECT_NEAR(expected_noticeability(shifted, place_of(stimulus)), expected, 1e-12);
  }
}

TEST(Levels, AConditionHasItsOwnMidpointsWholeAndAMissingOneIsNamed) {
  ObserverDefinition definition;
  definition.condition_midpoint["soft"] = {{Artifact::receiver, 100}};
  const LevelPlace hard{.artifact = Artifact::receiver, .condition = "hard", .level = 100};
  LevelPlace soft = hard;
  soft.condition = "soft";
  EXPECT_EQ(expected_noticeability(definition, hard),
            expected_noticeability(definition, Artifact::receiver, 100));
  EXPECT_EQ(expected_noticeability(definition, soft),
            expected_noticeability(definition, Artifact::receiver, 300));  // each at its own midpoint
}

TEST(Levels, AMissingMidpointIsNamedByItsKey) {
  ObserverDefinition definition;
  definition.midpoint.clear();
  definition.condition_midpoint["soft"] = {};
  const auto said = [&](const LevelPlace& place) {
    return test::complaint_of([&] { (void)expected_noticeability(definition, place); });
  };
  EXPECT_THAT(said({.artifact = Artifact::overlap, .level = 64}),
              HasSubstr("observer.midpoint_width_px.overlap: wanted the depth map width"));
  EXPECT_THAT(said({.artifact = Artifact::overlap, .quantity = Quantity::mesh_tolerance, .level = 1}),
              HasSubstr("observer.midpoint.overlap: wanted the mesh tolerance"));
  EXPECT_THAT(said({.artifact = Artifact::overlap, .condition = "soft", .level = 64}),
              HasSubstr("observer.condition_midpoint.soft.overlap"));
}

TEST(Levels, TheLogKeepsQuantityLevelAndDirection) {
  const TemporaryFolder folder;
  const RenderedSet set = write_set_of_text(folder / "set", text_of("depth_width_px = 1024", tolerances));
  run_simulated_study({.set_folder = folder / "set", .log = folder / "log", .count = 3});
  run_simulated_study({.set_folder = folder / "set", .log = folder / "log", .count = 4});  // goes on
  const LogContents log = read_log(folder / "log");
  EXPECT_EQ(log.quantity, Quantity::mesh_tolerance);
  EXPECT_EQ(log.noticeability, Direction::increasing);
  ASSERT_EQ(log.answers.size(), 4U * 24);
  std::set<double> levels;
  for (const Answer& answer : log.answers) {
    EXPECT_EQ(answer.depth_width_px, 1024);
    EXPECT_EQ(answer.condition, "");
    levels.insert(answer.level);
  }
  EXPECT_EQ(levels, (std::set<double>{0, 0.001, 0.01, 0.1}));
}

TEST(Levels, TheLogKeepsConditions) {
  const TemporaryFolder folder;
  const RenderedSet set = write_set_of_text(folder / "set", text_of("depth_width_px = [64, 512]", lights));
  run_simulated_study({.set_folder = folder / "set", .log = folder / "log", .count = 2});
  std::map<std::string, int> answers;
  for (const Answer& answer : read_log(folder / "log").answers) {
    EXPECT_THAT(answer.stimulus_id, HasSubstr(answer.condition));
    EXPECT_EQ(answer.level, answer.depth_width_px);
    ++answers[answer.condition];
  }
  EXPECT_EQ(answers, (std::map<std::string, int>{{"hard", 24}, {"soft", 24}}));
}

TEST(Levels, PracticeBeginsWithWhatIsNoticedMost) {
  const TemporaryFolder folder;
  const RenderedSet rising =
      write_set_of_text(folder / "rising", text_of("depth_width_px = 1024", tolerances));
  const RenderedSet falling =
      write_set_of_text(folder / "falling", text_of("depth_width_px = [64, 512]", ""));
  for (const auto& [set, level] : {std::pair(&rising, 0.1), std::pair(&falling, 64.0)})
    for (const Trial& trial : training_trials(*set))
      EXPECT_EQ(set->manifest.stimuli[static_cast<std::size_t>(trial.stimulus)].stimulus.level, level);
}

TEST(Levels, CatchTrialsGoThroughEveryLight) {
  const TemporaryFolder folder;
  const RenderedSet set = write_set_of_text(folder / "set", text_of("depth_width_px = [64, 512]", lights));
  std::vector<Stimulus> stimuli;
  for (const ManifestStimulus& record : set.manifest.stimuli) stimuli.push_back(record.stimulus);
  std::map<std::string, int> shown;
  for (const CatchTrial& trial : draw_catch_trials({.attention = 0, .reference = 8}, stimuli, 24, {}))
    ++shown[truth_of(stimuli[static_cast<std::size_t>(trial.trial.stimulus)])];
  ASSERT_EQ(shown.size(), 2U);
  for (const auto& [truth, times] : shown) EXPECT_EQ(times, 4) << truth;
}

TEST(Levels, EachConditionHasATrackOfItsOwnAndNeverSharesImages) {
  const TemporaryFolder folder;
  const std::string quest = "procedure = \"quest_plus\"\n";
  const RenderedSet set = write_set_of_text(
      folder / "set",
      text_of(quest + "depth_width_px = [64, 256, 1024]",
              std::string("[quest_plus]\nmax_shows_per_image = 9\nmax_trials = 12\n") + lights));
  std::vector<Stimulus> stimuli;
  for (const ManifestStimulus& record : set.manifest.stimuli) stimuli.push_back(record.stimulus);
  const QuestPlusDesign design =
      make_quest_plus_design(std::get<QuestPlusDefinition>(set.study.procedure), stimuli);
  ASSERT_EQ(design.tracks.size(), 4U);
  EXPECT_EQ(name_of(design.tracks[0]), "receiver hard");
  EXPECT_EQ(name_of(design.tracks[3]), "overlap soft");
  for (const TrackDesign& track : design.tracks)
    for (const std::vector<int>& images : track.images)
      for (const int image : images)
        EXPECT_EQ(stimuli[static_cast<std::size_t>(image)].condition, track.condition);
  run_simulated_study({.set_folder = folder / "set", .log = folder / "log", .count = 2});
  const std::vector<TrackEstimate> estimates = quest_plus_estimates(read_log(folder / "log"));
  ASSERT_EQ(estimates.size(), 8U);
  for (const TrackEstimate& estimate : estimates) EXPECT_EQ(estimate.trials, 12);
  EXPECT_EQ(estimates[1].condition, "soft");
  EXPECT_THAT(tracks_text(estimates), HasSubstr("threshold_px"));
}

TEST(Levels, TracksOfTolerancesRiseAndFindThePlantedOnes) {
  const TemporaryFolder folder;
  const RenderedSet set = write_set_of_text(
      folder / "set",
      text_of(
          "procedure = \"quest_plus\"\ndepth_width_px = 1024",
          "[level]\nquantity = \"mesh_tolerance\"\nvalues = [0.0003, 0.001, 0.003, 0.01, 0.03, 0.1]\n"
          "[quest_plus]\nmax_shows_per_image = 20\nmax_trials = 60\n"
          "[observer]\npeople_sd_octaves = 0.2\n[observer.midpoint]\nreceiver = 0.01\noverlap = 0.002\n"));
  run_simulated_study({.set_folder = folder / "set", .log = folder / "log", .count = 12});
  const std::vector<TrackEstimate> estimates = quest_plus_estimates(read_log(folder / "log"));
  std::map<Artifact, double> mean_log2;
  for (const TrackEstimate& estimate : estimates) {
    EXPECT_EQ(estimate.direction, Direction::increasing);
    EXPECT_EQ(estimate.quantity, Quantity::mesh_tolerance);
    EXPECT_LT(estimate.low, estimate.threshold);
    mean_log2[estimate.artifact] += std::log2(estimate.threshold) / 12;
  }
  EXPECT_NEAR(mean_log2[Artifact::receiver], std::log2(0.01), 0.5);
  EXPECT_NEAR(mean_log2[Artifact::overlap], std::log2(0.002), 0.5);
  const std::string text = tracks_text(estimates);
  EXPECT_THAT(text, HasSubstr("Noticeability rises with the mesh tolerance."));
  EXPECT_EQ(text.find("px"), std::string::npos) << text;
}

}  // namespace
}  // namespace seamline::study
