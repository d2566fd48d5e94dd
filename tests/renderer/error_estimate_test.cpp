#include "raytracer/error/error_estimate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "raytracer/error/refined_errors.h"
#include "raytracer/error/sampling_rounds.h"
#include "renderer/picture/bounce_filter.h"
#include "support/arithmetic/random.h"

namespace seamline::renderer {
namespace {

/// A grey picture with planted noise in each half, filtered and as sampled, and a planted common bias.
HalfPictures planted(double noise, double sampled_noise, double bias) {
  Random random(3);
  HalfPictures pictures;
  for (std::size_t half = 0; half < 2; ++half) {
    pictures.filtered[half] = Image(128, 96, 3);
    pictures.sampled[half] = Image(128, 96, 3);
    for (std::size_t i = 0; i < pictures.filtered[half].values.size(); ++i) {
      const double own = random.normal(), more = random.normal();
      pictures.filtered[half].values[i] = static_cast<float>(0.3 + bias + noise * own);
      pictures.sampled[half].values[i] = static_cast<float>(0.3 + noise * own + sampled_noise * more);
    }
  }
  return pictures;
}

constexpr double slope = 0.8906;  // of the sRGB curve at 0.3

TEST(ErrorEstimate, FindsPlantedNoiseAndBias) {
  const ErrorEstimate estimate = estimate_error(planted(0.01, 0.05, 0.004), 0.0, 2);
  EXPECT_NEAR(std::sqrt(estimate.image.noise), slope * 0.01 / std::sqrt(2.0), 2e-4);
  EXPECT_NEAR(std::sqrt(estimate.image.bias), slope * 0.004, 1e-3);
  EXPECT_EQ(estimate.tiles.size(), 12U);
  EXPECT_EQ(estimate.blocks.size(), 48U);
  EXPECT_GE(estimate.worst_tile(), estimate.rmse());
}

TEST(ErrorEstimate, WithoutBiasItIsZeroOnAverage) {
  const ErrorEstimate estimate = estimate_error(planted(0.01, 0.05, 0.0), 0.0, 1);
  EXPECT_NEAR(estimate.image.bias, 0.0, 4 * 0.05 * 0.05 / std::sqrt(128.0 * 96 * 3));
}

/// A block after another changes in one picture or another: the errors are those of all pictures anew.
TEST(RefinedErrors, AreThoseOfTheWholePicturesAnew) {
  HalfPictures now = planted(0.01, 0.05, 0.004);
  now.whole = now.filtered[0];
  RefinedErrors refined(0.5, false);
  Random random(5);
  const auto change = [&](Image& picture) {
    picture.values[static_cast<std::size_t>(random.uniform() * static_cast<double>(picture.values.size()))] +=
        0.1F;
  };
  const auto same = [](const ErrorEstimate& found, const ErrorEstimate& wanted) {
    EXPECT_EQ(found.rmse(), wanted.rmse());
    for (std::size_t b = 0; b < wanted.blocks.size(); ++b) {
      ASSERT_EQ(found.blocks[b].noise, wanted.blocks[b].noise) << b;
      ASSERT_EQ(found.blocks[b].bias, wanted.blocks[b].bias) << b;
    }
  };
  for (int round = 0; round < 12; ++round) {
    for (std::size_t half = 0; half < 2; ++half) refined.take_filtered(half, now.filtered[half]);
    refined.take_whole(now.whole);
    const bool looks_for_bias = round % 3 != 1;
    if (looks_for_bias)
      for (std::size_t half = 0; half < 2; ++half) refined.take_sampled(half, now.sampled[half]);
    HalfPictures wanted = now;
    if (!looks_for_bias) wanted.sampled = wanted.filtered;
    same(refined.of_filtered(looks_for_bias, 2), estimate_error(wanted, 0.5, 1));
    if (looks_for_bias)
      same(refined.of_sampled(2), estimate_error({.filtered = now.sampled, .sampled = now.sampled}, 0.5, 1));
    for (Image* picture : {&now.filtered[0], &now.filtered[1], &now.sampled[0], &now.sampled[1], &now.whole})
      if (random.uniform() < 0.5) change(*picture);
  }
}

/// Estimated and true squared error of a picture of 0.2 whose pixels have specks, at any rate alike.
struct Specks {
  double estimated = 0, truth = 0;
};
Specks specks_of(double brightness) {
  constexpr int width = 512, height = 256;
  Random random(7);
  HalfPictures pictures;
  for (Image& half : pictures.filtered) half = Image(width, height, 3, 0.2F);
  double truth = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      // Specks expected in the whole: from one in a million to ten, log-uniform.
      const double expected = 1e-6 * std::pow(1e7, random.uniform());
      double shown = 0;
      for (Image& half : pictures.filtered) {
        int specks = 0;
        for (double product = random.uniform(); product > std::exp(-0.5 * expected);
             product *= random.uniform())
          ++specks;
        for (int c = 0; c < 3; ++c) half.at(x, y, c) += static_cast<float>(2 * brightness * specks);
        shown += brightness * specks;
      }
      const auto display = [](double linear) { return double{srgb_from_linear(static_cast<float>(linear))}; };
      truth += std::pow(display(0.2 + shown) - display(0.2 + expected * brightness), 2);
    }
  pictures.sampled = pictures.filtered;
  return {estimate_error(pictures, 0.0, 2).image.noise, truth / (width * height)};
}

TEST(ErrorEstimate, CountsTheSpecksThatPixelsHaveNotHadYet) {
  for (const double brightness : {3.0, 10.0, 30.0}) {
    const Specks specks = specks_of(brightness);
    EXPECT_NEAR(std::sqrt(specks.estimated / specks.truth), 1, 0.1) << brightness;
  }
  EXPECT_EQ(unseen_specks(2.0F), 1.0F);
  EXPECT_NEAR(unseen_specks(2.3F), 1, 0.05);
}

/// Where a rule makes a pixel black in the whole and in one half, and leaves it in the other.
TEST(ErrorEstimate, SeesARuleThatTakesEitherSide) {
  HalfPictures pictures;
  for (std::size_t half = 0; half < 2; ++half)
    pictures.filtered[half] = pictures.sampled[half] = Image(32, 32, 3, half == 0 ? 0.0F : 0.3F);
  pictures.whole = Image(32, 32, 3, 0.0F);
  EXPECT_NEAR(std::sqrt(estimate_error(pictures, 0.0, 1).image.noise), srgb_from_linear(0.3F), 1e-5);
}

/// Ten blocks in five tiles.
SamplingState ten_blocks(double noise, double rest, double image_square) {
  return {.grid = {10 * BlockGrid::side_px, BlockGrid::side_px},
          .blocks = std::vector<BlockState>(10, {.noise = noise, .spp = 16, .most_spp = 1024}),
          .tile_residual = std::vector<double>(5, rest),
          .image_square = image_square};
}

TEST(SamplingRounds, GrowsUntilTheTargetIsExpectedAndNotBeyondTheLimit) {
  SamplingState state = ten_blocks(4e-4, 0, 4.36e-3);
  state.blocks[3].most_spp = 16;
  state.blocks[7].noise = 4e-2;
  const std::vector<int> wanted = next_samples(state, {.rmse = 0.02}).next;
  EXPECT_EQ(wanted[3], 16);
  EXPECT_EQ(wanted[7], 64);
  for (const int spp : wanted) EXPECT_TRUE(spp >= 16 && spp <= 64 && spp % 2 == 0);
  EXPECT_EQ(next_samples(ten_blocks(1e-5, 0, 1e-5), {.rmse = 0.02}).next, std::vector<int>(10, 16));
}

TEST(SamplingRounds, ATileIsGoodEnoughAsAWhole) {
  SamplingState state = ten_blocks(1e-4, 0, 3e-4);
  state.blocks[4].noise = 5e-3;  // with its neighbour below 9 * 4e-4
  EXPECT_EQ(next_samples(state, {.rmse = 0.02}).next, std::vector<int>(10, 16));
  state.blocks[4].noise = 9e-3;
  const std::vector<int> wanted = next_samples(state, {.rmse = 0.02}).next;
  EXPECT_GT(wanted[4], 16);
  EXPECT_EQ(std::count(wanted.begin(), wanted.end(), 16), 9);
}

/// A floor with a wall: left half of the picture and right half, seen from 2 m.
std::vector<Surface> floor_and_wall(int width_px, int height_px) {
  std::vector<Surface> surfaces;
  for (int y = 0; y < height_px; ++y)
    for (int x = 0; x < width_px; ++x)
      surfaces.push_back({.normal = x < width_px / 2 ? Eigen::Vector3f::UnitY() : Eigen::Vector3f::UnitX(),
                          .position_m = {x < width_px / 2 ? 0.01F * static_cast<float>(x) : 0.0F,
                                         x < width_px / 2 ? 0.0F : 0.01F * static_cast<float>(x),
                                         0.01F * static_cast<float>(y)},
                          .distance_m = 2.0F});
  return surfaces;
}

TEST(BounceFilter, AveragesLikeSurfacesAndNeverMixesUnlikeOnes) {
  const int width_px = 32, height_px = 32;
  std::vector<BounceTexel> texels(static_cast<std::size_t>(width_px * height_px));
  for (std::size_t i = 0; i < texels.size(); ++i)
    for (std::size_t half = 0; half < 2; ++half) {
      texels[i].without_object(half) =
          Rgb::Constant(static_cast<int>(i) % width_px < width_px / 2 ? 8.0F : 2.0F);
      texels[i].without_samples(half) = 4.0F;
    }
  filter_bounce(floor_and_wall(width_px, height_px), TileGrid{width_px, height_px}, {.levels = 3}, 2, texels);
  for (std::size_t i = 0; i < texels.size(); ++i)
    ASSERT_NEAR(texels[i].without_object(1)[0] / texels[i].without_samples(1),
                static_cast<int>(i) % width_px < width_px / 2 ? 2.0F : 0.5F, 1e-5F);
}

TEST(SamplingRounds, TheWholePicturesErrorDecidesNotTheTilesBiases) {
  EXPECT_EQ(next_samples(ten_blocks(1e-4, 5e-4, 2e-4), {.rmse = 0.02}).next, std::vector<int>(10, 16));
  EXPECT_NE(next_samples(ten_blocks(1e-4, 5e-4, 6e-4), {.rmse = 0.02}).next, std::vector<int>(10, 16));
}

TEST(BounceFilter, WhereAskedForItIsTheSameAsEverywhere) {
  const TileGrid grid{160, 160};
  const std::vector<Surface> surfaces = floor_and_wall(grid.width_px, grid.height_px);
  Random random(5);
  std::vector<BounceTexel> sampled(surfaces.size());
  for (BounceTexel& texel : sampled) {
    texel.without_object(0) = Rgb::Constant(static_cast<float>(random.uniform()));
    texel.without_object(1) = Rgb::Constant(1.0F);
    texel.without_samples(0) = texel.without_samples(1) = 2.0F;
  }
  TileSet changed(static_cast<std::size_t>(grid.count()), 0);
  constexpr int middle = 12;
  changed[middle] = 1;
  const FilterStrength strength{.levels = 3};
  std::vector<BounceTexel> everywhere = sampled, there = sampled;
  filter_bounce(surfaces, grid, strength, 2, everywhere);
  filter_bounce(surfaces, grid, strength, 2, there, with_neighbours(grid, changed));
  const TileGrid::Rectangle r = grid.rectangle(middle);
  const int reach_px = filter_radius_px(strength);
  for (int y = r.top - reach_px; y < r.bottom + reach_px; ++y)
    for (int x = r.left - reach_px; x < r.right + reach_px; ++x) {
      const auto i = static_cast<std::size_t>(y * grid.width_px + x);
      ASSERT_EQ(there[i].without_object(0)[0], everywhere[i].without_object(0)[0]) << x << ", " << y;
    }
  EXPECT_EQ(there[0].without_object(0)[0], sampled[0].without_object(0)[0]);
  EXPECT_NE(everywhere[0].without_object(0)[0], sampled[0].without_object(0)[0]);
}

TEST(BounceFilter, ReachesNoFartherThanBounceLightIsAlike) {
  const int width_px = 32, height_px = 32;
  std::vector<Surface> surfaces = floor_and_wall(width_px, height_px);
  for (Surface& surface : surfaces) surface.inverse_reach = 1000.0F;  // a crease: 1 mm
  std::vector<BounceTexel> texels(surfaces.size());
  for (std::size_t i = 0; i < texels.size(); ++i)
    texels[i].without_samples(0) = texels[i].without_samples(1) = 1.0F;
  texels[8 * 32 + 8].without_object(0) = Rgb::Constant(1.0F);
  filter_bounce(surfaces, TileGrid{width_px, height_px}, {.levels = 2, .reach_divisor = 2.0F}, 1, texels);
  EXPECT_EQ(texels[8 * 32 + 9].without_object(0)[0], 0.0F);
  EXPECT_NEAR(texels[8 * 32 + 8].without_object(0)[0] / texels[8 * 32 + 8].without_samples(0), 1.0F, 1e-6F);
}

/// A landscape of creases: normals, distances and reaches that change from pixel to pixel, and holes.
std::vector<Surface> rough_ground(const TileGrid& grid, Random& random) {
  std::vector<Surface> surfaces;
  for (int y = 0; y < grid.height_px; ++y)
    for (int x = 0; x < grid.width_px; ++x) {
      const auto tilt = static_cast<float>(0.4 * random.uniform());
      Surface surface{
          .normal = Eigen::Vector3f(tilt, 1, -tilt).normalized(),
          .position_m = {0.01F * static_cast<float>(x), 0.004F * static_cast<float>(random.uniform()),
                         0.01F * static_cast<float>(y)},
          .distance_m = 1.0F + static_cast<float>(random.uniform())};
      surface.inverse_reach = static_cast<float>(20 * random.uniform());
      surfaces.push_back(random.uniform() < 0.1 ? Surface{} : surface);
    }
  return surfaces;
}

TEST(BounceFilter, KeepsTheSumOfAllLight) {
  const TileGrid grid{80, 70};
  Random random(11);
  const std::vector<Surface> surfaces = rough_ground(grid, random);
  std::vector<BounceTexel> texels(surfaces.size());
  const auto light = [&] {
    Eigen::Array<double, 16, 1> sum = Eigen::Array<double, 16, 1>::Zero();
    for (const BounceTexel& texel : texels) sum += texel.sums.cast<double>();
    return sum;
  };
  for (std::size_t i = 0; i < texels.size(); ++i)
    for (std::size_t half = 0; half < 2; ++half) {
      if (surfaces[i].normal.isZero()) continue;
      // Creases are dark.
      texels[i].without_object(half) =
          Rgb::Constant(static_cast<float>(random.uniform()) / (1 + surfaces[i].inverse_reach));
      texels[i].change(half) = Rgb::Constant(static_cast<float>(random.uniform()) - 0.5F);
      texels[i].without_samples(half) = texels[i].change_samples(half) = 3.0F;
    }
  const auto before = light();
  const std::vector<BounceTexel> sampled = texels;
  filter_bounce(surfaces, grid, {.levels = 2, .reach_divisor = 2.0F}, 2, texels);
  EXPECT_LT(((light() - before) / before.abs().max(1)).abs().maxCoeff(), 1e-5);
  double changed = 0;
  for (std::size_t i = 0; i < texels.size(); ++i) {
    changed += static_cast<double>((texels[i].sums - sampled[i].sums).abs().maxCoeff());
    if (surfaces[i].normal.isZero()) continue;
    EXPECT_NEAR(texels[i].without_samples(0), 3.0F, 1e-4F);
  }
  EXPECT_GT(changed, 1) << "it does filter";
}

}  // namespace
}  // namespace seamline::renderer
