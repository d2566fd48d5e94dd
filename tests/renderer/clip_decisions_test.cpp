// How clips are sampled where an error is asked for.
#include "sets/clips/clip_decisions.h"

#include <gtest/gtest.h>

#include "sets/clips/decision_file.h"
#include "sets/clips/frame_changes.h"
#include "support/files/atomic_file.h"

namespace seamline::renderer {
namespace {

namespace fs = std::filesystem;

TEST(ClipDecisions, FramesThatDecideStandEvenly) {
  std::vector<std::string> frames;
  for (int i = 0; i < 48; ++i) frames.push_back(std::to_string(i));
  EXPECT_EQ(evenly(frames, 4), (std::vector<std::string>{"6", "18", "30", "42"}));
  EXPECT_EQ(evenly({"a", "b"}, 4), (std::vector<std::string>{"a", "b"}));
}

TEST(ClipDecisions, ABlockHasTheMostSamplesAndAFilterOnlyWhereAllHaveIt) {
  PhotographDecision photograph;
  join_decisions(PhotographDecision{{2, 16}, 3}, photograph);
  join_decisions(PhotographDecision{{4, 8}, 4}, photograph);
  EXPECT_EQ(photograph.spp, (std::vector<int>{4, 16}));
  EXPECT_EQ(photograph.strength, 3U);
  StimulusDecision stimulus;
  join_decisions(StimulusDecision{{2, 8}, {0, 4}, {1, 0}}, stimulus);
  join_decisions(StimulusDecision{{4, 2}, {8, 0}, {1, 1}}, stimulus);
  EXPECT_EQ(stimulus.uncovered, (std::vector<int>{4, 8}));
  EXPECT_EQ(stimulus.object, (std::vector<int>{8, 4}));
  EXPECT_EQ(stimulus.filtered, (TileSet{1, 0}));
}

TEST(ClipDecisions, AreReadAgainAndOnlyOfTheSameInputs) {
  const fs::path set = fs::path(testing::TempDir()) / "clip_decisions";
  fs::create_directories(set / "records");
  write_decision(set, "truth-room", "abc", PhotographDecision{{2, 16}, 3});
  write_decision(set, "room-shadow-ball-0064", "abc", StimulusDecision{{2, 8}, {0, 4}, {1, 0}});
  EXPECT_EQ(read_photograph_decision(set, "truth-room", "abc")->spp, (std::vector<int>{2, 16}));
  EXPECT_EQ(read_stimulus_decision(set, "room-shadow-ball-0064", "abc")->filtered, (TileSet{1, 0}));
  EXPECT_FALSE(read_photograph_decision(set, "truth-room", "abd"));
  EXPECT_FALSE(read_photograph_decision(set, "truth-hall", "abc"));
  EXPECT_FALSE(read_stimulus_decision(set, "truth-room", "abc"));
  write_file_atomically(set / "records" / "decision-truth-room.json", "{\"inputs\": \"abc\", \"spp\": 3}");
  EXPECT_FALSE(read_photograph_decision(set, "truth-room", "abc"));
}

TEST(ClipDecisions, ErrorsAreEstimatedOfTwoNeighboursOfEveryEight) {
  std::vector<int> judged;
  for (int frame = 0; frame < 20; ++frame)
    if (is_judged("room+slow@0" + std::to_string(100 + frame).substr(1), 48)) judged.push_back(frame);
  EXPECT_EQ(judged, (std::vector<int>{0, 1, 8, 9, 16, 17}));
  EXPECT_TRUE(is_judged("room@010", 16));
  EXPECT_TRUE(is_judged("room", 48));
}

TEST(ClipChangeErrors, AreMeansOverTheKnownChangesAndAStandingPictureHasNone) {
  const FrameChangeErrors errors = {{{"b", "a"}, 4e-6}, {{"c", "b"}, 8e-6}};
  const ClipChangeError error = clip_change_error({"a", "a", "b", "c", "d"}, errors);
  EXPECT_EQ(error.changes, 4);
  EXPECT_EQ(error.known, 3);
  EXPECT_NEAR(error.squared, 4e-6, 1e-12);
}

}  // namespace
}  // namespace seamline::renderer
