// Cameras from files: what is written is read again bit for bit, and what is wrong is one sentence.
#include "registration/files/camera_file.h"

#include <gtest/gtest.h>

#include "tests/complaint.h"
#include "tests/registration/synthetic_depth.h"

namespace seamline::registration {
namespace {

using seamline::test::complaint_of;

const std::string two_cameras = R"(format = "seamline camera 1"
convention = "planar"
metres_per_step = 0.001
[depth]
width_px = 640
height_px = 480
fx_px = 518
fy_px = 519
cx_px = 325.5
cy_px = 253.5
[colour]
width_px = 320
height_px = 240
fx_px = 262
fy_px = 262
cx_px = 160
cy_px = 120
k1 = -0.1
[colour_from_depth]
translation_m = [0.025, 0, 0]
)";

std::string with(const std::string& from, const std::string& to) {
  std::string text = two_cameras;
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error("there is no " + from);
  return text.replace(at, from.size(), to);
}

std::string complaint_about(const std::string& text) {
  return complaint_of([&] { (void)registration_rig(parse_camera_file(text, "rig.toml"), "rig.toml"); });
}

TEST(CameraFile, HoldsWhatARegistrationNeeds) {
  const RegistrationRig rig = registration_rig(parse_camera_file(two_cameras, "rig.toml"), "rig.toml");
  EXPECT_EQ(rig.depth_form.camera.fy_px, 519);
  EXPECT_EQ(rig.depth_form.camera.cx_px, 325.5);
  EXPECT_EQ(rig.depth_form.convention, sensors::DepthConvention::planar);
  EXPECT_EQ(rig.depth_form.metres_per_step, 0.001);
  EXPECT_EQ(rig.colour.distortion.k1, -0.1);
  EXPECT_EQ(rig.colour_from_depth.translation(), Eigen::Vector3d(0.025, 0, 0));
  EXPECT_EQ(rig.colour_from_depth.linear(), Eigen::Matrix3d::Identity());
  EXPECT_FALSE(rig.world_from_colour);
}

TEST(CameraFile, WrittenIsReadBitForBit) {
  Random random(2);
  for (int round = 0; round < 50; ++round) {
    CameraFile cameras;
    cameras.depth = test::crooked(64, 48, 40 + 30 * random.uniform());
    cameras.colour = test::crooked(640, 480, 40 + 30 * random.uniform());
    cameras.colour_from_depth =
        sensors::pose_of({random.normal(), random.normal() * 1e-7, random.normal() * 1e5},
                         {random.normal(), random.normal(), 1}, random.uniform());
    if (round % 2 == 0) cameras.world_from_colour = *cameras.colour_from_depth * *cameras.colour_from_depth;
    cameras.convention = sensors::DepthConvention::radial;
    cameras.metres_per_step = random.uniform() / 1000;
    if (round % 3 == 0) cameras.packing = sensors::DepthPacking::red_green;
    cameras.nearest_m = random.uniform();
    cameras.unusual_distances = round % 4 == 0;
    const std::string text = camera_file_text(cameras, "found by a test\nin two lines");
    const CameraFile again = parse_camera_file(text, "rig.toml");
    EXPECT_EQ(camera_file_text(again, "found by a test\nin two lines"), text);
    EXPECT_EQ(again.colour_from_depth->matrix(), cameras.colour_from_depth->matrix());
    EXPECT_EQ(again.depth->distortion.p2, cameras.depth->distortion.p2);
    EXPECT_EQ(again.nearest_m, cameras.nearest_m);
    EXPECT_EQ(again.world_from_colour.has_value(), cameras.world_from_colour.has_value());
  }
}

TEST(CameraFile, APresetGivesWhatTheFileDoesNot) {
  const std::string text = R"(format = "seamline camera 1"
preset = "structured_light_640x480"
metres_per_step = 0.001
[colour]
fx_px = 530
)";
  const RegistrationRig rig = registration_rig(parse_camera_file(text, "rig.toml"), "rig.toml");
  EXPECT_EQ(rig.depth_form.camera.fx_px, 585.6);
  EXPECT_EQ(rig.depth_form.farthest_m, 5);
  EXPECT_EQ(rig.depth_form.convention, sensors::DepthConvention::planar);
  EXPECT_EQ(rig.colour.fx_px, 530);
  EXPECT_EQ(rig.colour.fy_px, 525);
  EXPECT_LT(rig.colour_from_depth.translation().x(), 0);
  EXPECT_EQ(
      complaint_about("format = \"seamline camera 1\"\npreset = \"scanner_360\"\n"),
      "rig.toml: preset: wanted a preset with a depth and a colour camera, found scanner_360, a scanner");
  EXPECT_EQ(
      complaint_about("format = \"seamline camera 1\"\npreset = \"tof_160x121\"\n"),
      "rig.toml: preset: wanted one of tof_160x120, structured_light_640x480, tof_640x576, scanner_360, "
      "found tof_160x121; did you mean tof_160x120?");
}

TEST(CameraFile, PixelCentresAtIntegersAreOpenCvs) {
  const CameraFile half = parse_camera_file(two_cameras, "rig.toml");
  const CameraFile whole =
      parse_camera_file(with("convention", "pixel_centres = \"integer\"\nconvention"), "rig.toml");
  EXPECT_EQ(whole.depth->cx_px, half.depth->cx_px + 0.5);
  EXPECT_EQ(whole.colour->cy_px, half.colour->cy_px + 0.5);
}

TEST(CameraFile, ThreeWaysToWriteOneRotation) {
  const std::string none = "translation_m = [0.025, 0, 0]";
  const auto rotation = [&](const std::string& text) -> Eigen::Matrix3d {
    return parse_camera_file(with(none, none + "\n" + text), "rig.toml").colour_from_depth->linear();
  };
  const Eigen::Matrix3d quarter = rotation("rotation = [0, -1, 0, 1, 0, 0, 0, 0, 1]");
  EXPECT_LT((rotation("axis = [0, 0, 2]\nangle_deg = 90") - quarter).norm(), 1e-15);
  EXPECT_LT((rotation("quaternion_xyzw = [0, 0, 0.70710678, 0.70710678]") - quarter).norm(), 1e-7);
}

TEST(CameraFile, WhatIsWrongIsOneSentence) {
  EXPECT_EQ(complaint_about(with("fx_px = 518", "fx_px = 0")),
            "rig.toml: depth.fx_px: wanted a number from 0.001 to 1000000000 px, found 0");
  EXPECT_EQ(complaint_about(with("fx_px = 262\n", "")),
            "rig.toml: colour.fx_px: wanted a number from 0.001 to 1000000000 px, found nothing");
  const std::string none = "translation_m = [0.025, 0, 0]";
  const auto pose = [&](const std::string& more) { return complaint_about(with(none, none + "\n" + more)); };
  EXPECT_EQ(pose("rotation = [2, 0, 0, 0, 1, 0, 0, 0, 1]"),
            "rig.toml: colour_from_depth.rotation: wanted a rotation, whose columns are of length 1 and at "
            "right angles, found a matrix that is off by 3");
  EXPECT_EQ(pose("rotation = [1, 0, 0, 0, 1, 0, 0, 0, -1]"),
            "rig.toml: colour_from_depth.rotation: wanted a rotation, found a reflection (determinant -1)");
  EXPECT_EQ(
      pose("rotation = [1, 0, 0]"),
      "rig.toml: colour_from_depth.rotation: wanted nine numbers, a matrix row by row, found 3 numbers");
  EXPECT_EQ(pose("quaternion_xyzw = [0, 0, 0, 2]"),
            "rig.toml: colour_from_depth.quaternion_xyzw: wanted four numbers x, y, z, w whose squares have "
            "the sum 1, found a length of 2");
  EXPECT_EQ(pose("axis = [0, 0, 0]\nangle_deg = 3"),
            "rig.toml: colour_from_depth.axis: wanted a direction that is not zero, found none");
  EXPECT_EQ(pose("axis = [0, 0, 1]\nrotation = [1, 0, 0, 0, 1, 0, 0, 0, 1]"),
            "rig.toml: colour_from_depth.rotation: wanted one of rotation, quaternion_xyzw, and axis with "
            "angle_deg, found more than one");
  EXPECT_EQ(complaint_about(with("[colour_from_depth]\n" + none + "\n", "")),
            "rig.toml: colour_from_depth: wanted a table [colour_from_depth]; where depth is registered "
            "already, translation_m = [0, 0, 0], found nothing");
  EXPECT_EQ(complaint_about(with("convention = \"planar\"\n", "")),
            "rig.toml: convention: wanted \"radial\" or \"planar\", found nothing");
  EXPECT_EQ(complaint_about(with("\"planar\"", "\"flat\"")),
            "rig.toml: convention: wanted \"radial\" or \"planar\", found \"flat\"");
  EXPECT_EQ(complaint_about(with("k1 = -0.1", "k4 = -0.1")),
            "rig.toml: colour.k4: wanted a known key; did you mean \"k1\"?, found \"k4\"");
  EXPECT_EQ(complaint_about(with("camera 1", "camera 2")),
            "rig.toml: format: wanted \"seamline camera 1\", found \"seamline camera 2\"");
}

}  // namespace
}  // namespace seamline::registration
