// A recorded user: the file gives its values back, the mask is who stands about the bones.
#include <gtest/gtest.h>

#include <fstream>

#include "sensors/skeleton/user_file.h"
#include "support/files/atomic_file.h"
#include "support/text/error.h"

namespace seamline::sensors {
namespace {

std::filesystem::path file_of(const std::string& name, const std::string& text) {
  const std::filesystem::path folder = std::filesystem::path(SEAMLINE_TEST_OUTPUT) / "user-file";
  std::filesystem::create_directories(folder);
  write_file_atomically(folder / name, text);
  return folder / name;
}

RecordedUser standing_user() {
  RecordedUser user;
  user.id = 3;
  SkeletonPose pose = rest_pose(standing_person());
  pose.root_m = {0.1, 0, 2.5};
  for (const PlacedJoint& joint : place_joints(standing_person(), pose))
    user.joints_m.emplace_back(joint.position_m);
  return user;
}

TEST(UserFile, GivesItsValuesBack) {
  RecordedUser user = standing_user();
  user.joints_m[4].reset();
  const RecordedUser read = read_user_file(file_of("user.toml", user_file_text(user)));
  EXPECT_EQ(read.id, 3);
  EXPECT_EQ(read.reach_m, user.reach_m);
  EXPECT_EQ(read.joints_m, user.joints_m);
}

TEST(UserFile, WhatIsWrongIsNamed) {
  const std::string good = user_file_text(standing_user());
  for (const auto& [from, to] : {std::pair{"user 1", "user 2"},
                                 {"torso", "trunk"},
                                 {"id = 3", "id = 0"},
                                 {"reach_m", "reach"},
                                 {"head = [", "head = [1, "}}) {
    std::string bad = good;
    bad.replace(bad.find(from), std::string(from).size(), to);
    EXPECT_THROW((void)read_user_file(file_of("bad.toml", bad)), InputError) << to;
  }
}

TEST(UserMask, IsWhatLiesWithinReachOfTheBones) {
  const RecordedUser user = standing_user();
  DepthFrame frame;
  frame.camera = pinhole_of_field_of_view(160, 120, 60);
  frame.depth_m.assign(160 * 120, 2.5F);
  const auto near = mask_of_user(frame, Eigen::Isometry3d::Identity(), user);
  const auto torso_px = project(frame.camera, {0.1, 0, 2.5});
  ASSERT_TRUE(torso_px);
  EXPECT_EQ(near[frame.index(static_cast<int>(torso_px->x()), static_cast<int>(torso_px->y()))], 1);
  EXPECT_EQ(near[frame.index(2, 60)], 0);
  // The same directions, 0.3 m behind the person: nobody.
  frame.depth_m.assign(160 * 120, 2.8F);
  for (const std::uint8_t one : mask_of_user(frame, Eigen::Isometry3d::Identity(), user)) EXPECT_EQ(one, 0);
}

}  // namespace
}  // namespace seamline::sensors
