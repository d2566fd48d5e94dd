// Frames of a clip that are sampled beside another one.
#include "renderer/estimators/fast/frame_sums.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "renderer/estimators/fast/scene_sums_bytes.h"
#include "tests/renderer/shapes.h"

namespace seamline::renderer {
namespace {

constexpr int frame_width_px = 80, frame_height_px = 64, frame_samples = 96;

/// A floor, a wall and two balls; the right one stands `moved_m` further to the left.
TruthScene frame_scene(float moved_m) {
  test::SceneParts parts;
  parts.background = {test::floor(-1, 6), test::box({-6, -2, -8}, {6, 4, -7.8F}, 0.6F)};
  parts.objects = {{test::sphere({-0.9F, -0.7F, -4}, 0.3F, 24, 0.3F, 1)},
                   {test::sphere({1.1F - moved_m, -0.7F, -4}, 0.3F, 24, 0.5F, 2)}};
  Light light;
  light.environment_radiance = Rgb(0.3F, 0.4F, 0.5F);
  light.suns = {{Eigen::Vector3f(0.5F, 1, 0.4F).normalized(), Rgb::Constant(1.5F), 0}};
  light.bounces = 2;
  TruthScene scene = test::scene_of(std::move(parts), std::move(light), frame_width_px, frame_height_px);
  scene.definition.objects.resize(2);
  scene.definition.objects[1].position_m.x() = -moved_m;
  return scene;
}

ScenePassOptions frame_pass(std::uint64_t seed = 3, int threads = 2) {
  return {.seed = seed, .threads = threads, .first_sky = FirstSky::apart, .who_is_in_front = true};
}

std::vector<int> in_every_block(int spp) {
  return std::vector<int>(empty_sums(frame_scene(0).camera, 2).spp.size(), spp);
}

FrameBase base_of_scene(const TruthScene& scene, std::uint64_t seed = 3) {
  return make_frame_base(scene, SceneGeometry(scene), {}, in_every_block(frame_samples), frame_pass(seed));
}

SceneSums all_samples(const TruthScene& scene, int spp, std::uint64_t seed = 3) {
  SceneSums sums = empty_sums(scene.camera, 2);
  add_samples(scene, SceneGeometry(scene), in_every_block(spp), frame_pass(seed), sums);
  return sums;
}

SceneSums sampled_beside(const FrameBase& base, const TruthScene& scene, FrameBlocks& blocks,
                         std::uint64_t seed = 3, int threads = 2) {
  SceneSums sums = empty_sums(scene.camera, 2);
  blocks = add_samples_beside(base, scene, SceneGeometry(scene), frame_pass(seed, threads), sums);
  return sums;
}

std::string sums_bytes(SceneSums& sums) {
  sums.counts = {};  // rays are what differs
  ByteWriter out;
  write_sums(sums, out);
  return out.bytes();
}

double mean_of_world(const SceneSums& sums, std::size_t world) {
  double sum = 0;
  for (std::size_t pixel = 0; pixel < std::size_t{frame_width_px} * frame_height_px; ++pixel)
    for (std::size_t half = 0; half < 2; ++half) sum += sums.seen(half, pixel, world).total().sum();
  return sum / (double{frame_samples} * frame_width_px * frame_height_px);
}

/// Mean squared difference of two pictures of so many samples.
double square_of_difference(const SceneSums& a, int spp_a, const SceneSums& b, int spp_b) {
  double sum = 0;
  for (std::size_t pixel = 0; pixel < std::size_t{frame_width_px} * frame_height_px; ++pixel) {
    const auto mean = [&](const SceneSums& of, int spp) {
      return Rgb((of.seen(0, pixel, 0).total() + of.seen(1, pixel, 0).total()) / static_cast<float>(spp));
    };
    sum += double{(mean(a, spp_a) - mean(b, spp_b)).square().sum()};
  }
  return sum / (3.0 * frame_width_px * frame_height_px);
}

TEST(FrameSums, AFrameThatEqualsItsBaseHasTheBytesOfAllSamples) {
  const TruthScene scene = frame_scene(0);
  FrameBlocks blocks;
  SceneSums found = sampled_beside(base_of_scene(scene), scene, blocks);
  SceneSums all = all_samples(scene, frame_samples);
  EXPECT_LT(found.counts.traced, all.counts.traced / 5);
  EXPECT_EQ(sums_bytes(found), sums_bytes(all));
  EXPECT_EQ(blocks.as_in_base, blocks.count());
}

TEST(FrameSums, BlocksOfWhatMovedAreSampledAnew) {
  const FrameBase base = base_of_scene(frame_scene(0));
  const TruthScene scene = frame_scene(0.2F);
  FrameBlocks blocks;
  const SceneSums found = sampled_beside(base, scene, blocks), all = all_samples(scene, frame_samples);
  EXPECT_GT(blocks.anew, 0);
  EXPECT_GT(blocks.beside_base + blocks.as_in_base, blocks.count() / 4);
  EXPECT_LT(found.counts.traced, all.counts.traced);
  int with_object = 0;
  for (int y = 0; y < frame_height_px; ++y)
    for (int x = 0; x < frame_width_px; ++x) {
      const auto tile = static_cast<std::size_t>(all.grid.square_of(x, y));
      const auto place = static_cast<std::size_t>(TileGrid::place(x, y));
      if (!all.objects[1][tile] || all.objects[1][tile]->halves[0][place].covered == 0) continue;
      ++with_object;
      for (std::size_t half = 0; half < 2; ++half)
        EXPECT_TRUE(
            (found.seen(half, found.index(x, y), 0).total() == all.seen(half, all.index(x, y), 0).total())
                .all());
    }
  EXPECT_GT(with_object, 30);
}

/// Over many seeds the mean is that of all samples, and a picture is as near to the truth.
TEST(FrameSums, AreNotBiasedAndNotMuchNoisier) {
  const TruthScene then = frame_scene(0), now = frame_scene(0.2F);
  const SceneSums truth = all_samples(now, 1024, 1000);
  double square_beside = 0, square_all = 0;
  constexpr std::uint64_t seeds = 6;
  std::array<std::vector<double>, 3> off;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    FrameBlocks blocks;
    const SceneSums found = sampled_beside(base_of_scene(then, seed), now, blocks, seed),
                    all = all_samples(now, frame_samples, seed);
    square_beside += square_of_difference(found, frame_samples, truth, 1024);
    square_all += square_of_difference(all, frame_samples, truth, 1024);
    for (std::size_t v = 0; v < 3; ++v) off[v].push_back(mean_of_world(found, v) - mean_of_world(all, v));
  }
  EXPECT_LT(square_beside, 1.1 * square_all);
  for (const double one : off[2]) EXPECT_EQ(one, 0);  // the world without what moved
  for (const auto& differences : off) {
    double mean = 0, square = 0;
    for (const double one : differences) mean += one / seeds, square += one * one / seeds;
    EXPECT_LE(std::abs(mean), 3.5 * std::sqrt(square / (seeds - 1)));
  }
}

TEST(FrameSums, AreTheSameWithAnyThreads) {
  const FrameBase base = base_of_scene(frame_scene(0));
  const TruthScene scene = frame_scene(0.2F);
  FrameBlocks blocks;
  SceneSums one = sampled_beside(base, scene, blocks, 3, 1), four = sampled_beside(base, scene, blocks, 3, 4);
  EXPECT_EQ(sums_bytes(one), sums_bytes(four));
}

TEST(FrameSums, ABaseDiffersInWhereObjectsStandAlone) {
  const FrameBase base = base_of_scene(frame_scene(0));
  SceneDefinition frame = frame_scene(0.2F).definition;
  EXPECT_TRUE(may_be_base(base, frame, {}));
  EXPECT_FALSE(may_be_base(base, frame, {.bounces = 1}));
  frame.albedo = 0.25;
  EXPECT_FALSE(may_be_base(base, frame, {}));
}

TEST(FrameSums, StepsAreSharesWithATailInEveryHalf) {
  EXPECT_EQ(samples_of_step(0, 96), 8);
  EXPECT_EQ(samples_of_step(1, 96), 24);
  EXPECT_EQ(samples_of_step(0, 16), 8);
  EXPECT_EQ(samples_of_step(0, 8), 8);  // no share: all of them
  EXPECT_EQ(samples_of_step(1, 12), 12);
}

}  // namespace
}  // namespace seamline::renderer
