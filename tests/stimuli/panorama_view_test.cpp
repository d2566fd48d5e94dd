// Views of panoramas as an observer that looks at pictures sees them.
#include <gtest/gtest.h>

#include <cmath>

#include "stimuli/pictures/panorama_view.h"

namespace seamline {
namespace {

/// Codes that rise along a row, and differ between rows.
ByteImage marked_panorama() {
  ByteImage panorama{360, 180, 3, {}};
  for (int y = 0; y < 180; ++y)
    for (int x = 0; x < 360; ++x)
      for (const int code : {x / 2, y, (x + y) % 7})
        panorama.values.push_back(static_cast<std::uint8_t>(code));
  return panorama;
}

TEST(PanoramaView, ShowsTheDirectionItLooks) {
  const LookDefinition look{.view_px = {65, 33}, .horizontal_fov_deg = 40};
  for (const auto& [yaw, pitch] : {std::pair{0.0, 0.0}, {90.0, 0.0}, {-120.0, 30.0}, {60.0, -45.0}}) {
    const ByteImage view = panorama_view(marked_panorama(), look, {yaw, pitch});
    ASSERT_EQ(view.width_px, 65);
    ASSERT_EQ(view.height_px, 33);
    const std::size_t middle = (16 * 65 + 32) * 3;
    EXPECT_NEAR(view.values[middle], (180 + yaw) / 2, 1.01);
    EXPECT_NEAR(view.values[middle + 1], 90 - pitch, 1.01);
  }
}

TEST(PanoramaView, TheSeamIsNotSeen) {
  ByteImage even{256, 128, 1, std::vector<std::uint8_t>(256 * 128, 77)};
  const ByteImage view = panorama_view(even, {.view_px = {64, 64}, .horizontal_fov_deg = 100}, {180, 60});
  for (const std::uint8_t code : view.values) ASSERT_EQ(code, 77);
}

TEST(PanoramaView, AnObjectOnTheSeamIsBehind) {
  ByteImage ids{360, 180, 1, std::vector<std::uint8_t>(360 * 180, 0)};
  for (int y = 100; y < 110; ++y)
    for (int x = -5; x < 5; ++x) ids.values[static_cast<std::size_t>(y * 360 + (x + 360) % 360)] = 2;
  const auto [yaw, pitch] = object_pose_deg(ids, 2);
  EXPECT_NEAR(std::abs(yaw), 180, 1e-6);
  EXPECT_NEAR(pitch, -15, 0.1);
  EXPECT_EQ(object_pose_deg(ids, 1), (std::array{0.0, 0.0}));
}

}  // namespace
}  // namespace seamline
