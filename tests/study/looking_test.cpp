// Looking round a panorama: places and directions, the seam, and the poses that are kept.
#include <gtest/gtest.h>

#include <cmath>

#include "study/trials/looking.h"

namespace seamline::study {
namespace {

const LookDefinition by_mouse{.kind = LookKind::mouse, .view_px = {640, 360}, .horizontal_fov_deg = 70};

TEST(Looking, ADirectionIsFoundAgainInTheView) {
  for (const Pose& pose : {Pose{}, Pose{170, 30}, Pose{-95.5, -60}})
    for (const ViewPlace& at : {ViewPlace{320, 180}, ViewPlace{3, 350}, ViewPlace{600.5, 12}}) {
      const Direction3 direction = direction_at(by_mouse, pose, at);
      const auto back = place_in_view(by_mouse, pose, direction);
      ASSERT_TRUE(back);
      EXPECT_NEAR(back->x_px, at.x_px, 1e-9);
      EXPECT_NEAR(back->y_px, at.y_px, 1e-9);
      const ViewPlace there = place_of(512, 256, direction);
      const auto again = place_in_view(by_mouse, pose, direction_of(512, 256, there));
      EXPECT_NEAR(again->x_px, at.x_px, 1e-6);
    }
  const ViewPlace middle = place_of(512, 256, direction_at(by_mouse, {90, 0}, {320, 180}));
  EXPECT_NEAR(middle.x_px, 384, 1e-9);  // a quarter of the columns to the right
  EXPECT_NEAR(middle.y_px, 128, 1e-9);
}

TEST(Looking, AnObjectOnTheSeamIsOneObject) {
  ByteImage ids{512, 256, 1, std::vector<std::uint8_t>(512 * 256, 0)};
  for (int y = 120; y < 140; ++y)
    for (int x = -10; x < 14; ++x) ids.values[static_cast<std::size_t>(y * 512 + (x + 512) % 512)] = 3;
  const ObjectMap map = make_panorama_map(ids);
  EXPECT_EQ(map.frames[2].width_px, 24 + 12);
  EXPECT_EQ(map.frames[2].x_px, 512 - 10 - 6);
  EXPECT_EQ(object_at(map, 511.5, 130), 3);
  EXPECT_EQ(object_at(map, 0.5, 130), 3);
  const Pose behind{180, 0};
  EXPECT_EQ(object_in_view(by_mouse, behind, map, {320, 180}), 3);
  EXPECT_EQ(object_in_view(by_mouse, {}, map, {320, 180}), 0);
  EXPECT_EQ(frames_in_view(by_mouse, {}, map)[2], PictureFrame{});
  const PictureFrame seen = frames_in_view(by_mouse, behind, map)[2];
  EXPECT_NEAR(seen.x_px + seen.width_px / 2, 320 + 2 / degrees_per_pixel(by_mouse) * 360 / 512, 2);
  EXPECT_GT(seen.width_px, 150);
  const Pose towards = pose_towards(map, map.frames[2]);
  EXPECT_NEAR(std::abs(towards.yaw_deg), 180 - 2 * 360.0 / 512, 1e-9);
}

TEST(Looking, StaysWithinItsLimits) {
  EXPECT_EQ(turned(by_mouse, {170, 0}, 20, 0), (Pose{-170, 0}));
  EXPECT_EQ(turned(by_mouse, {0, 80}, 0, 20), (Pose{0, 90}));
  LookDefinition narrow = by_mouse;
  narrow.yaw_deg = {-45, 45};
  EXPECT_EQ(turned(narrow, {40, 0}, 20, 0), (Pose{45, 0}));
  LookDefinition fixed = by_mouse;
  fixed.kind = LookKind::fixed;
  EXPECT_EQ(turned(fixed, {40, 0}, 20, 0), (Pose{40, 0}));
}

TEST(Looking, PosesAreKeptThirtyTimesASecondAndOnlyWhereTheyChange) {
  PoseRecorder recorder;
  recorder.add(0, {0, -7.46});
  for (int ms = 1; ms <= 1000; ++ms) recorder.add(ms, {ms * 0.1, -7.46});
  for (int ms = 1001; ms <= 9000; ++ms) recorder.add(ms, {100, -7.46});
  const std::vector<std::string> texts = recorder.take();
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_EQ(texts[0].substr(0, 8), "0 0.0 -7");
  const auto poses = poses_of(texts[0]);
  ASSERT_TRUE(poses);
  EXPECT_GE(poses->size(), 28U);
  EXPECT_LE(poses->size(), 32U);
  for (std::size_t i = 1; i < poses->size(); ++i) EXPECT_GE((*poses)[i].ms - (*poses)[i - 1].ms, 33 - 1e-9);
  EXPECT_EQ(poses->back().pose, (Pose{100, -7.5}));
  EXPECT_TRUE(recorder.take().empty());
}

TEST(Looking, TheFieldChangesWithinItsLimitsAndIsKeptWithThePose) {
  LookDefinition look{.kind = LookKind::mouse, .horizontal_fov_deg = 60};
  EXPECT_EQ(zoomed_fov_deg(look, 1), 60) << "without limits it stays";
  look.fov_limits_deg = std::array{52.0, 90.0};
  EXPECT_EQ(zoomed_fov_deg(look, 1), 55);
  EXPECT_EQ(zoomed_fov_deg(look, 2), 52);
  EXPECT_EQ(zoomed_fov_deg(look, -9), 90);
  look.kind = LookKind::fixed;
  EXPECT_EQ(zoomed_fov_deg(look, 1), 60);
  PoseRecorder recorder;
  recorder.add(0, {1, 2}, 60);
  recorder.add(100, {1, 2}, 55);
  recorder.add(200, {1, 2}, 55);
  const std::vector<std::string> texts = recorder.take();
  EXPECT_EQ(texts, std::vector<std::string>{"0 1.0 2.0 60.0;100 1.0 2.0 55.0"});
  const auto poses = poses_of(texts.at(0));
  ASSERT_TRUE(poses);
  ASSERT_EQ(poses->size(), 2U);
  EXPECT_EQ(poses->at(1).fov_deg, 55);
  EXPECT_EQ(poses->at(1).pose, (Pose{1, 2}));
  EXPECT_FALSE(poses_of("0 1.0 2.0")->at(0).fov_deg);
}

TEST(Looking, ALongTrialNeedsSeveralTextsAndLosesNothing) {
  PoseRecorder recorder;
  for (int i = 0; i < 2000; ++i) recorder.add(40 * i, {(i % 3600) * 0.1 - 180, 0});
  std::size_t poses = 0;
  for (const std::string& text : recorder.take()) {
    EXPECT_LE(text.size(), 4000U);
    poses += poses_of(text).value().size();
  }
  EXPECT_EQ(poses, 2000U);
  for (const char* wrong : {"1 2", "a b c", "1 2 3;", "1 2 3 4 5", "1 nan 3", "1;2;3", "1 2 3 x"})
    EXPECT_EQ(wrong == std::string("1 2 3;"), poses_of(wrong).has_value()) << wrong;
}

}  // namespace
}  // namespace seamline::study
