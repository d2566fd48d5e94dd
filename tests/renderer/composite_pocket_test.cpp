// Denominators that are no light: sealed pockets, wells, and pixels that few paths reach.
#include <gtest/gtest.h>

#include <cmath>

#include "renderer/picture/composite.h"

namespace seamline::renderer {
namespace {

TEST(Composite, TinyDenominatorsGiveNeitherSpecksNorNumbersThatAreNotNumbers) {
  StimulusSums sums{.width_px = 3, .height_px = 1, .spp = 2};
  for (auto& half : sums.halves) half.resize(3);
  sums.depth_lights_uncovered = true;
  // Three surfaces that have nothing in common, so that no pocket borrows from another.
  sums.guides = {
      {Eigen::Vector3f(0, 1, 0), 1.0F}, {Eigen::Vector3f(1, 0, 0), 1.0F}, {Eigen::Vector3f(0, 0, 1), 1.0F}};
  for (std::size_t i = 0; i < 3; ++i) {
    StimulusPixel& pixel = sums.halves[0][i];
    pixel.uncovered_surfaces = 2;
    pixel.background = Rgb::Constant(2.0F);
    pixel.without_object = pixel.with_object = Rgb::Constant(2.0F);
  }
  sums.halves[0][1].without_object =
      Rgb::Zero();  // sealed pocket: no light at all, but the object brings some
  sums.halves[0][1].with_object = Rgb::Constant(1e-3F);
  sums.halves[0][2].without_object = Rgb::Constant(0.1F);  // brightened far beyond the clamp
  sums.halves[0][2].with_object = Rgb::Constant(5.0F);
  sums.halves[0][2].background = Rgb::Constant(0.2F);  // as dark in the photograph: believed
  const Composite composite = compose(sums);
  EXPECT_EQ(composite.ratio.at(0, 0), 1.0F);
  EXPECT_EQ(composite.ratio.at(1, 0), 1.0F);
  EXPECT_EQ(composite.ratio.at(2, 0), 4.0F);
  EXPECT_EQ(composite.tiny_denominators.floored_pixels, 1);
  EXPECT_EQ(composite.tiny_denominators.clamped_pixels, 1);
  for (const float value : composite.picture.values) EXPECT_TRUE(std::isfinite(value));
}

TEST(Composite, PocketsThatFewPathsFindGetTheirNeighboursRatioAndNoSpecks) {
  // A dark strip of depth mesh before a bright photograph: one path in 16 finds light, and the object takes a
  // third of those.
  StimulusSums sums{.width_px = 32, .height_px = 32, .spp = 16};
  sums.depth_lights_uncovered = true;
  for (auto& half : sums.halves) half.resize(32 * 32);
  sums.guides.resize(32 * 32, {Eigen::Vector3f(0, 0, 1), 2.0F});
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      StimulusPixel& pixel = sums.halves[0][static_cast<std::size_t>(y * 32 + x)];
      const bool pocket = x >= 24;
      const int number = y * 8 + x;
      pixel.uncovered_surfaces = 16;
      pixel.background = Rgb::Constant(pocket ? 1.0F : 16.0F);
      pixel.without_object = Rgb::Constant(pocket ? (number % 2 == 0 ? 1.0F : 0.0F) : 16.0F);
      pixel.with_object = pocket && number % 6 == 0 ? Rgb::Zero() : pixel.without_object;
    }
  const Composite composite = compose(sums);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 24; ++x) EXPECT_EQ(composite.ratio.at(x, y), 1.0F);
  for (int y = 6; y < 26; ++y)
    for (int x = 24; x < 32; ++x) EXPECT_NEAR(composite.ratio.at(x, y), 2.0 / 3, 0.2) << x << " " << y;
}

TEST(Composite, WellsThatTheDepthMeshSealsDoNotTurnBlack) {
  // A bright photograph; in the last pixel the depth mesh receives 1 % of the usual light, all of it past the
  // object.
  StimulusSums sums{.width_px = 5, .height_px = 1, .spp = 2};
  sums.depth_lights_uncovered = true;
  for (auto& half : sums.halves) half.resize(5);
  sums.guides.resize(5, {Eigen::Vector3f(0, 0, 1), 2.0F});
  for (std::size_t i = 0; i < 5; ++i) {
    StimulusPixel& pixel = sums.halves[0][i];
    pixel.uncovered_surfaces = 2;
    pixel.background = Rgb::Constant(2.0F);
    pixel.without_object = Rgb::Constant(i == 4 ? 0.02F : 2.0F);
    pixel.with_object = i == 4 ? Rgb::Zero() : Rgb::Constant(i == 3 ? 0.4F : 2.0F);
  }
  const Composite composite = compose(sums);
  EXPECT_EQ(composite.ratio.at(0, 0), 1.0F);
  EXPECT_NEAR(composite.ratio.at(3, 0), 0.2, 1e-6);  // a shadow stays a shadow
  EXPECT_NEAR(composite.ratio.at(4, 0), 0.9, 1e-6);
  EXPECT_EQ(composite.tiny_denominators.sealed_pixels, 1);
}

}  // namespace
}  // namespace seamline::renderer
