#include "study/trials/object_map.h"

#include <gtest/gtest.h>

#include "tests/app/picture_set.h"

namespace seamline::study {
namespace {

constexpr int width_px = 200, height_px = 100;

TEST(ObjectMap, AClickCountsForTheObjectAndALittleAroundIt) {
  const ByteImage ids = test::disc_ids(width_px, height_px);
  const ObjectMap map = make_object_map(ids, 8);
  for (int object = 1; object <= 3; ++object)
    EXPECT_EQ(object_at(map, width_px * object / 4, height_px / 2), object);
  const int radius = height_px / 8;
  EXPECT_EQ(object_at(map, width_px / 4 + radius + 6, height_px / 2), 1);
  EXPECT_EQ(object_at(map, width_px / 4 + radius + 12, height_px / 2), 0);
  EXPECT_EQ(object_at(map, 0, 0), 0);
  EXPECT_EQ(object_at(map, -1, 5), 0);
  EXPECT_EQ(object_at(map, width_px, 5), 0);
  // Growing takes no pixel from another object.
  for (int y = 0; y < height_px; ++y)
    for (int x = 0; x < width_px; ++x)
      if (const int id = ids.values[static_cast<std::size_t>(y * width_px + x)]; id != 0) {
        EXPECT_EQ(object_at(map, x, y), id);
      }
}

TEST(ObjectMap, EveryOneOfEightObjectsHasItsFrameAndItsClicks) {
  for (const int objects : {1, 2, 5, 8}) {
    const ObjectMap map = make_object_map(test::disc_ids(800, 200, objects), usual_reach_px, false, objects);
    ASSERT_EQ(map.frames.size(), static_cast<std::size_t>(objects));
    for (int object = 1; object <= objects; ++object) {
      const PictureFrame& frame = map.frames[static_cast<std::size_t>(object - 1)];
      EXPECT_NEAR(frame.x_px + frame.width_px / 2, 800.0 * object / (objects + 1), 1);
      EXPECT_EQ(object_at(map, 800.0 * object / (objects + 1), 100), object);
    }
  }
}

TEST(ObjectMap, FramesHaveOneSizeAndTheMiddlesOfTheirObjects) {
  ByteImage ids{width_px, height_px, 1, std::vector<std::uint8_t>(width_px * height_px, 0)};
  const auto fill = [&](int object, int x0, int y0, int width, int height) {
    for (int y = y0; y < y0 + height; ++y)
      for (int x = x0; x < x0 + width; ++x)
        ids.values[static_cast<std::size_t>(y * width_px + x)] = static_cast<std::uint8_t>(object);
  };
  fill(1, 20, 40, 10, 30);
  fill(2, 80, 50, 40, 10);
  fill(3, 150, 60, 4, 4);
  const ObjectMap map = make_object_map(ids);
  for (const PictureFrame& frame : map.frames) {
    EXPECT_EQ(frame.width_px, 40 + 12);
    EXPECT_EQ(frame.height_px, 30 + 12);
  }
  EXPECT_EQ(map.frames[0].x_px + map.frames[0].width_px / 2, 25);
  EXPECT_EQ(map.frames[1].y_px + map.frames[1].height_px / 2, 55);
  EXPECT_EQ(map.frames[2].x_px + map.frames[2].width_px / 2, 152);
}

TEST(ObjectMap, SideBySideEachEyeHasFramesOfItsOwn) {
  ByteImage ids{width_px, height_px, 1, std::vector<std::uint8_t>(width_px * height_px, 0)};
  for (const int x0 : {20, width_px / 2 + 14})
    for (int y = 40; y < 60; ++y)
      for (int x = x0; x < x0 + 10; ++x) ids.values[static_cast<std::size_t>(y * width_px + x)] = 2;
  const ObjectMap map = make_object_map(ids, 8, true);
  EXPECT_EQ(map.frames[1].x_px + map.frames[1].width_px / 2, 25);
  EXPECT_EQ(map.right_eye_frames[1].x_px + map.right_eye_frames[1].width_px / 2, width_px / 2 + 19);
  EXPECT_EQ(map.frames[1].width_px, 10 + 12);
  EXPECT_EQ(object_at(map, 25, 50), 2);
  EXPECT_EQ(object_at(map, width_px / 2 + 19, 50), 2);
  EXPECT_EQ(make_object_map(ids).right_eye_frames[1], PictureFrame{});
}

TEST(ObjectMap, AnObjectThatIsNowhereHasNoFrame) {
  const ByteImage ids{20, 10, 1, std::vector<std::uint8_t>(200, 0)};
  for (const PictureFrame& frame : make_object_map(ids).frames) EXPECT_EQ(frame, PictureFrame{});
}

}  // namespace
}  // namespace seamline::study
