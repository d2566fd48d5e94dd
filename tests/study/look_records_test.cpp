// What poses come to: degrees turned, the first look at an object, and the time facing it.
#include <gtest/gtest.h>

#include "study/exchange/look_records.h"

namespace seamline::study {
namespace {

TEST(LookRecords, TimesAndAnglesOfAKnownTurn) {
  // From the start to an object at 170 degrees by way of the seam, and past it.
  const std::vector<PoseAt> poses = {{0, {0, 0}},      {1000, {-90, 0}}, {2000, {-170, 0}},
                                     {2500, {175, 0}}, {4000, {120, 0}}, {4500, {120, 30}}};
  const LookMeasures made = measure_look(poses, 170, 5000);
  EXPECT_NEAR(made.degrees_turned, 90 + 80 + 15 + 55 + 30, 1e-4);
  ASSERT_TRUE(made.first_look_s);
  EXPECT_NEAR(*made.first_look_s, 2.5, 1e-12);
  EXPECT_NEAR(made.share_facing, 1500.0 / 5000, 1e-12);
  EXPECT_FALSE(measure_look(poses, 60, 5000).first_look_s);
  EXPECT_NEAR(measure_look({{0, {0, 0}}}, 10, 800).share_facing, 1, 1e-12);
}

TEST(LookRecords, AnObjectIsWhereTheSceneSays) {
  SceneDefinition scene;
  scene.camera = CameraDefinition{.position_m = {1, 2, 3}, .look_at_m = {5, 2, 3}};
  ObjectDefinition object;
  object.position_m = {1, 0, 7};  // to the right of who looks along +X
  EXPECT_NEAR(object_yaw_deg(scene, object), 90, 1e-9);
  object.position_m = {-3, 5, 3};
  EXPECT_NEAR(std::abs(object_yaw_deg(scene, object)), 180, 1e-9);
}

TEST(LookRecords, OtherStudiesHaveNone) {
  LogContents log;
  log.file = "nowhere.sqlite";
  log.study_text = "name = \"x\"";
  EXPECT_TRUE(read_looks(log).empty());
}

}  // namespace
}  // namespace seamline::study
