// The seam of a clip: its mean and its largest frame, and how it flickers.
#include "stimuli/pictures/clip_seam.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace seamline {
namespace {

/// 64 x 32 grey pixels with a square of `side_px` that is `steps` brighter, its corner at (`left_px`, 8).
ByteImage with_square(int left_px, int side_px, int steps) {
  ByteImage image{.width_px = 64, .height_px = 32, .channels = 3, .values = {}};
  image.values.assign(std::size_t{64} * 32 * 3, 100);
  const auto grey = static_cast<std::uint8_t>(100 + steps);
  for (int y = 8; y < 8 + side_px; ++y)
    std::fill_n(image.values.begin() + std::ptrdiff_t{3} * (y * 64 + left_px), 3 * side_px, grey);
  return image;
}

const ByteImage plain_grey = with_square(0, 0, 0);

TEST(ClipSeam, WhatStandsStillDoesNotFlicker) {
  ClipSeamMeter meter;
  for (int frame = 0; frame < 5; ++frame) meter.add(with_square(10, 6, 20), plain_grey);
  const ClipSeam seam = meter.result();
  ASSERT_TRUE(seam.flicker);
  EXPECT_EQ(*seam.flicker, 0);
  EXPECT_EQ(seam.change_steps, 0);
  EXPECT_EQ(seam.beyond[0].mean_area_px, 36);
  EXPECT_EQ(seam.beyond[0].largest_area_px, 36);
}

TEST(ClipSeam, ASquareThatIsElsewhereInEveryFrameFlickersByTheRootOfTwo) {
  ClipSeamMeter meter;
  for (int frame = 0; frame < 6; ++frame) meter.add(with_square(frame % 2 == 0 ? 4 : 40, 6, 20), plain_grey);
  const ClipSeam seam = meter.result();
  EXPECT_NEAR(*seam.flicker, std::sqrt(2), 1e-12);
  EXPECT_NEAR(seam.change_steps, 20, 1e-12);
}

TEST(ClipSeam, ASignThatTurnsFlickersByTwo) {
  ClipSeamMeter meter;
  for (int frame = 0; frame < 6; ++frame) meter.add(with_square(8, 6, frame % 2 == 0 ? 15 : -15), plain_grey);
  EXPECT_NEAR(*meter.result().flicker, 2, 1e-12);
}

TEST(ClipSeam, ASquareThatGoesOnBySomePixelsFlickersByTheShareThatItLeaves) {
  for (const int pixels : {1, 2, 3}) {
    ClipSeamMeter meter;
    for (int frame = 0; frame < 5; ++frame) meter.add(with_square(4 + pixels * frame, 8, 20), plain_grey);
    // Both what it leaves and what it enters change by 20: 2 p / 8 of the square.
    EXPECT_NEAR(*meter.result().flicker, std::sqrt(2.0 * pixels / 8), 1e-12) << pixels;
  }
}

TEST(ClipSeam, MeanAndLargestFrameAreOfAllFrames) {
  ClipSeamMeter meter;
  for (const int side_px : {0, 4, 8, 0}) meter.add(with_square(8, side_px, 20), plain_grey);
  const ClipSeam seam = meter.result();
  for (const ClipSeamExtent& extent : seam.beyond) {
    EXPECT_EQ(extent.mean_area_px, (16 + 64) / 4.0);
    EXPECT_EQ(extent.largest_area_px, 64);
    EXPECT_EQ(extent.mean_band_px, (4 + 8) / 4.0);
    EXPECT_EQ(extent.largest_band_px, 8);
  }
}

TEST(ClipSeam, WithoutASeamThereIsNoFlicker) {
  ClipSeamMeter meter;
  for (int frame = 0; frame < 3; ++frame) meter.add(plain_grey, plain_grey);
  EXPECT_FALSE(meter.result().flicker);
  EXPECT_EQ(meter.result().change_steps, 0);
}

}  // namespace
}  // namespace seamline
