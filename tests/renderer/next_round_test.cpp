#include "renderer/estimators/fast/next_round.h"

#include <gtest/gtest.h>

#include "renderer/estimators/fast/filtered_bounce.h"

namespace seamline::renderer {
namespace {

constexpr int tiles = 5, blocks = 10;

/// Ten blocks in five tiles, all alike, and a filter that takes nine tenths of the noise away.
struct Situation {
  Situation() {
    photograph.tiles.assign(tiles, {.noise = 1e-6, .bias = 0});
    photograph.blocks.assign(blocks, {.noise = 1e-6, .bias = 0});
    photograph.image = {.noise = 1e-6, .bias = 0};
    judged.error = photograph;
    judged.unfiltered = photograph;
    for (SquaredError& tile : judged.error.tiles) tile.noise = 5e-6;
    for (SquaredError& block : judged.error.blocks) block.noise = 5e-6;
    for (SquaredError& tile : judged.unfiltered->tiles) tile.noise = 4e-5;
    for (SquaredError& block : judged.unfiltered->blocks) block.noise = 4e-5;
    judged.error.image.noise = 5e-6;
  }
  void set_bias(std::size_t tile, double square) {
    judged.error.tiles[tile].bias = square;
    judged.error.image.bias += square / tiles;
  }
  [[nodiscard]] NextRound plan() const {
    return next_round({.grid = {tiles * TileGrid::side_px, BlockGrid::side_px},
                       .photograph = photograph,
                       .photograph_spp = photograph_spp,
                       .asked_spp = asked_spp,
                       .filtered = filtered,
                       .judged = judged,
                       .target = {.rmse = 0.0039},
                       .choices = choices});
  }

  ErrorEstimate photograph;
  StimulusJudgement judged;
  std::vector<int> photograph_spp = std::vector<int>(blocks, 64), asked_spp = std::vector<int>(blocks, 4);
  TileSet filtered = TileSet(tiles, 1);
  EstimatorChoices choices = estimator_choices(Estimator::fast, {.bounces = 4}, 0, {.error = 0.0039});
};

TEST(NextRound, ATileThatItsBiasMakesTooWrongGoesWithoutTheFilter) {
  Situation now;
  now.set_bias(3, 3e-4);
  const NextRound plan = now.plan();
  EXPECT_EQ(plan.unfiltered, std::vector<std::size_t>{3});
  EXPECT_EQ(plan.next_spp[6], 64);  // as many as the photograph has
  EXPECT_EQ(plan.next_spp[7], 64);
  EXPECT_EQ(plan.next_spp[0], 4);
}

TEST(NextRound, WhatIsGoodEnoughKeepsItsFilterAndABiasThatMayBeNoneDoesToo) {
  Situation now;
  now.set_bias(1, 7e-6);  // a sixth of the tile's unfiltered noise
  EXPECT_TRUE(now.plan().unfiltered.empty());
  EXPECT_EQ(now.plan().next_spp, now.asked_spp);
}

TEST(NextRound, AWholePictureTooBiasedLosesTheFilterWhereItPaysMost) {
  Situation now;
  now.set_bias(0, 2.5e-5);
  now.set_bias(2, 6e-5);
  now.set_bias(4, 2e-5);
  const NextRound plan = now.plan();
  ASSERT_FALSE(plan.unfiltered.empty());
  EXPECT_EQ(plan.unfiltered.front(), 2U);
}

TEST(NextRound, WithoutALookAtTheBiasOnlySamplesArePlanned) {
  Situation now;
  now.judged.unfiltered.reset();
  now.judged.error.image.noise = 3e-5;
  for (SquaredError& block : now.judged.error.blocks) block.noise = 3e-5;
  const NextRound plan = now.plan();
  EXPECT_TRUE(plan.unfiltered.empty());
  for (const int spp : plan.next_spp) EXPECT_TRUE(spp > 4 && spp <= 16) << spp;
}

/// Two tiles side by side, of which the left one is shown without filter.
TEST(LentShares, ATileWithoutFilterLendsAsManySamplesAsTheLeastAskedOfTheOthers) {
  DepthAnswers depth;
  depth.grid = {2 * TileGrid::side_px, TileGrid::side_px};
  // Rows of four blocks, two of each tile.
  depth.spp.uncovered = {64, 128, 4, 8, 2, 0, 16, 0};
  EXPECT_EQ(sample_shares_of_tiles(depth, {0, 1}),
            (std::vector<float>{1.0F / 16, 1.0F / 32, 1, 1, 1, 1, 1, 1}));
  EXPECT_TRUE(sample_shares_of_tiles(depth, {1, 1}).empty());
  EXPECT_TRUE(sample_shares_of_tiles(depth, {}).empty());
}

}  // namespace
}  // namespace seamline::renderer
