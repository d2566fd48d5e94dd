// Pixels of which no shadow is asked are those near which the light's map has nothing.
#include "live/frame/caster_blocks.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/arithmetic/random.h"

namespace seamline {
namespace {

TEST(CasterBlocks, KnowEveryPlaceWithACasterWithinSixteenTexels) {
  constexpr int size_px = 100;
  renderer::ShadowMap map;
  map.view.corner = {-0.3F, 0.2F};
  map.view.size = {0.5F, 0.5F};
  map.depth = renderer::empty_picture(size_px, size_px);
  const auto place = [&](int px) { return 0.5F * (static_cast<float>(px) + 0.5F) / size_px; };
  Random random(3);
  for (int trial = 0; trial < 200; ++trial) {
    const int x = static_cast<int>(random.below(size_px)), y = static_cast<int>(random.below(size_px));
    float& caster_m = map.depth.depth_m[static_cast<std::size_t>(y * size_px + x)];
    const float nothing_m = caster_m;
    caster_m = 1;
    const live::CasterBlocks blocks(map);
    caster_m = nothing_m;
    for (int dy = -16; dy <= 16; dy += 4)
      for (int dx = -16; dx <= 16; dx += 4)
        EXPECT_TRUE(blocks.near(-0.3F + place(x + dx), 0.2F + place(y + dy)) || x + dx < 0 || y + dy < 0 ||
                    x + dx >= size_px || y + dy >= size_px);
    const int far_x = x < size_px / 2 ? x + 40 : x - 40;
    EXPECT_FALSE(blocks.near(-0.3F + place(far_x), 0.2F + place(y)));
  }
  EXPECT_FALSE(live::CasterBlocks(map).near(0, 0.4F)) << "an empty map has no casters";
}

}  // namespace
}  // namespace seamline
