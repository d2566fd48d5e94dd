// On how few pixels a picture's noise hangs.
#include "renderer/picture/rare_light.h"

#include <gtest/gtest.h>

#include "renderer/picture/composite.h"

namespace seamline::renderer {
namespace {

constexpr int sums_width_px = 100, sums_height_px = 50;

/// A picture whose halves differ by `everywhere` in all pixels and by `speck` in the first.
double share_of(float everywhere, float speck) {
  StimulusSums sums{.width_px = sums_width_px, .height_px = sums_height_px, .spp = 2};
  sums.guides.resize(sums_width_px * sums_height_px);
  for (std::size_t half = 0; half < 2; ++half) {
    sums.halves[half].resize(sums_width_px * sums_height_px);
    for (StimulusPixel& pixel : sums.halves[half])
      pixel.object = Rgb::Constant(0.2F + (half == 0 ? everywhere : 0.0F));
  }
  sums.halves[0][0].object += speck;
  return rare_light_share(sums, compose(sums).picture, 0);
}

TEST(RareLight, IsTheShareOfTheNoisiestPixels) {
  EXPECT_NEAR(share_of(0.02F, 0), 10.0 / (sums_width_px * sums_height_px), 1e-6);
  EXPECT_GT(share_of(0.001F, 0.5F), 0.9);
  EXPECT_EQ(share_of(0, 0), 0);
}

}  // namespace
}  // namespace seamline::renderer
