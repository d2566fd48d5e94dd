// The error of a photograph counts light that an object in it blocks.
#include "renderer/estimators/fast/photograph_error.h"

#include <gtest/gtest.h>

#include "renderer/views/view_picture.h"

namespace seamline::renderer {
namespace {

constexpr int side_px = 32;

/// Grey everywhere; `without` and `with` are what one half has more in the first pixel, without the object
/// and with it.
TruthSums grey(float without, float with) {
  TruthSums sums{.width_px = side_px, .height_px = side_px, .spp = 2};
  for (auto& half : sums.halves) {
    half.resize(side_px * side_px);
    for (TruthPixel& pixel : half) {
      pixel.without_object.direct = pixel.with_object.direct = Rgb::Constant(0.2F);
      pixel.uncovered_surfaces = 1;
    }
  }
  sums.halves[0][0].without_object.bounce = Rgb::Constant(without);
  sums.halves[0][0].with_object.bounce = Rgb::Constant(with);
  return sums;
}

double noise_of(float without, float with) {
  const PhotographHalves halves = photograph_halves(grey(without, with), {});
  return photograph_error(halves, halves, 0, 1, false).image.noise;
}

TEST(PhotographError, CountsASpeckThatTheObjectBlocks) {
  EXPECT_EQ(noise_of(0, 0), 0);
  EXPECT_NEAR(noise_of(0.5F, 0), 0.5 * noise_of(0.5F, 0.5F), 1e-9);
}

TEST(PhotographError, IsThatOfThePictureWhereTheObjectChangesLittle) {
  EXPECT_EQ(noise_of(0.1F, 0.1F), noise_of(0, 0.1F));
}

TEST(PhotographError, OfBlocksTilesAndImageIsOne) {
  const PhotographHalves halves = photograph_halves(grey(0.5F, 0), {});
  const ErrorEstimate error = photograph_error(halves, halves, 0, 1, false);
  ASSERT_EQ(error.tiles.size(), 1U);
  ASSERT_EQ(error.blocks.size(), 4U);
  EXPECT_NEAR(error.tiles[0].noise, error.image.noise, 1e-12);
  EXPECT_NEAR(error.blocks[0].noise, 4 * error.image.noise, 1e-12);
}

TEST(PhotographError, OfAnAnaglyphIsThatOfThePictureThatIsSeen) {
  // A speck in the left eye only, in a picture of two eyes of 16 columns each.
  const TruthSums sums = grey(0.3F, 0.3F);
  const View view{.kind = ViewKind::anaglyph};
  const PhotographHalves halves = photograph_halves(sums, view);
  std::array<Image, 2> mixed;
  for (std::size_t half = 0; half < 2; ++half)
    mixed[half] = compose_view(view, half_reference_image(sums, half));
  const double of_mixed = estimate_error({mixed, mixed, {}}, 0, 1).image.noise;
  const ErrorEstimate error = photograph_error(halves, halves, 0, 1, false);
  EXPECT_GT(of_mixed, 0);
  EXPECT_NEAR(error.image.noise, of_mixed, 1e-6 * of_mixed);
  EXPECT_NE(error.image.noise, noise_of(0.3F, 0.3F));
  // Both eyes' blocks at that place are to have more samples.
  EXPECT_GT(error.blocks[0].noise, 0);
  EXPECT_NEAR(error.blocks[1].noise, error.blocks[0].noise, 1e-12);
}

}  // namespace
}  // namespace seamline::renderer
