// Cameras of other programs: recognised by content, or one sentence. The files are small ones of the kinds
// that calib_camera of OpenCV, camera_calibration of ROS, Kalibr, COLMAP, Open3D, the Azure Kinect and
// librealsense write.
#include "registration/files/other_cameras.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "registration/files/lens_fit.h"
#include "tests/complaint.h"

namespace seamline::registration {
namespace {

using seamline::test::complaint_of;
using sensors::FisheyeCamera;
using sensors::PinholeCamera;
using ::testing::Contains;
using ::testing::HasSubstr;

CameraFile camera_of(const std::string& text, std::optional<std::pair<int, int>> size_px = std::nullopt) {
  EXPECT_TRUE(is_other_camera(text)) << text;
  return parse_other_camera(text, "camera", size_px);
}

std::string said(const std::string& text, std::optional<std::pair<int, int>> size_px = std::nullopt) {
  return complaint_of([&] { (void)parse_other_camera(text, "camera", size_px); });
}

void expect_camera(const CameraFile& cameras, const PinholeCamera& wanted) {
  ASSERT_TRUE(cameras.colour);
  const PinholeCamera& found = *cameras.colour;
  EXPECT_EQ(found.width_px, wanted.width_px);
  EXPECT_EQ(found.height_px, wanted.height_px);
  EXPECT_NEAR(found.fx_px, wanted.fx_px, 1e-9);
  EXPECT_NEAR(found.fy_px, wanted.fy_px, 1e-9);
  EXPECT_NEAR(found.cx_px, wanted.cx_px, 1e-9);
  EXPECT_NEAR(found.cy_px, wanted.cy_px, 1e-9);
  EXPECT_EQ(found.distortion, wanted.distortion);
}

PinholeCamera wanted_camera(double shift_px = 0.5) {
  PinholeCamera camera;
  camera.width_px = 640, camera.height_px = 480;
  camera.fx_px = 530, camera.fy_px = 531;
  camera.cx_px = 318 + shift_px, camera.cy_px = 242 + shift_px;
  return camera;
}

constexpr char opencv_yaml[] = R"(%YAML:1.0
---
calibration_time: "Mon Jan 1"
image_width: 640
image_height: 480
camera_matrix: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 5.30e+02, 0., 3.18e+02, 0., 5.31e+02, 2.42e+02, 0., 0., 1. ]
distortion_coefficients: !!opencv-matrix
   rows: 5
   cols: 1
   dt: d
   data: [ -2.6e-01, 9.0e-02, 1.0e-03, -2.0e-03, 1.0e-02 ]
)";

TEST(OtherCameras, OpenCvAndRos) {
  PinholeCamera camera = wanted_camera();
  camera.distortion = {.k1 = -0.26, .k2 = 0.09, .p1 = 1e-3, .p2 = -2e-3, .k3 = 0.01};
  expect_camera(camera_of(opencv_yaml), camera);
  expect_camera(
      camera_of(R"({"image_width": 640, "image_height": 480, "camera_matrix": [[530, 0, 318], [0, 531, 242],
      [0, 0, 1]], "dist_coeff": [[-0.26, 0.09, 0.001, -0.002, 0.01]]})"),
      camera);
  const std::string ros = R"(image_width: 640
image_height: 480
camera_name: narrow_stereo
camera_matrix:
  rows: 3
  cols: 3
  data: [530, 0, 318, 0, 531, 242, 0, 0, 1]
distortion_model: plumb_bob
distortion_coefficients:
  rows: 1
  cols: 5
  data: [-0.26, 0.09, 0.001, -0.002, 0.01]
)";
  expect_camera(camera_of(ros), camera);
  expect_camera(
      camera_of(
          "height: 480\nwidth: 640\ndistortion_model: plumb_bob\nD: [-0.26, 0.09, 0.001, -0.002, 0.01]\n"
          "K: [530, 0, 318, 0, 531, 242, 0, 0, 1]\n"),
      camera);
  std::string fisheye = ros;
  fisheye.replace(fisheye.find("plumb_bob"), 9, "equidistant");
  EXPECT_THAT(said(fisheye), HasSubstr("wanted the four terms of a fisheye, found 5"));
  fisheye.replace(fisheye.find(", 0.01]"), 7, "]");
  EXPECT_EQ(camera_of(fisheye).fisheye, (FisheyeCamera{.width_px = 640,
                                                       .height_px = 480,
                                                       .fx_px = 530,
                                                       .fy_px = 531,
                                                       .cx_px = 318.5,
                                                       .cy_px = 242.5,
                                                       .k1 = -0.26,
                                                       .k2 = 0.09,
                                                       .k3 = 0.001,
                                                       .k4 = -0.002}));
}

TEST(OtherCameras, Kalibr) {
  const CameraFile cameras = camera_of(R"(cam0:
  cam_overlaps: [1]
  camera_model: pinhole
  distortion_coeffs: [-0.0292, 0.0208, -0.0319, 0.0166]
  distortion_model: equidistant
  intrinsics: [530, 531, 318, 242]
  resolution: [640, 480]
  rostopic: /left/image_raw
cam1:
  camera_model: pinhole
  intrinsics: [1, 1, 1, 1]
)");
  ASSERT_TRUE(cameras.fisheye);
  EXPECT_EQ(cameras.fisheye->cx_px, 318.5);
  EXPECT_EQ(cameras.fisheye->k4, 0.0166);
  EXPECT_THAT(cameras.notes, Contains("of its cameras it is cam0"));
  EXPECT_EQ(
      said("cam0:\n  camera_model: omni\n  intrinsics: [1, 2, 3, 4, 5]\n"),
      "camera: Kalibr: camera_model: wanted pinhole (with radtan, equidistant or no distortion), found omni");
}

TEST(OtherCameras, Camodocal) {
  PinholeCamera camera = wanted_camera();
  camera.distortion = {.k1 = 0.1, .k2 = 0.01, .p1 = 1e-3, .p2 = 2e-3, .k3 = 0};
  const std::string pinhole =
      "%YAML:1.0\n---\nmodel_type: PINHOLE\ncamera_name: camera\nimage_width: 640\nimage_height: 480\n"
      "distortion_parameters:\n   k1: 0.1\n   k2: 0.01\n   p1: 0.001\n   p2: 0.002\n"
      "projection_parameters:\n   fx: 530\n   fy: 531\n   cx: 318\n   cy: 242\n";
  expect_camera(camera_of(pinhole), camera);
  std::string mei = pinhole;
  mei.replace(mei.find("PINHOLE"), 7, "MEI");
  EXPECT_EQ(said(mei), "camera: camodocal: model_type: wanted PINHOLE or KANNALA_BRANDT, found MEI");
}

TEST(OtherCameras, Colmap) {
  const std::string head =
      "# Camera list with one line of data per camera:\n#   CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]\n";
  PinholeCamera camera = wanted_camera(0);  // COLMAP's first pixel has its centre at a half, as ours
  expect_camera(camera_of(head + "1 PINHOLE 640 480 530 531 318 242\n"), camera);
  camera.distortion = {.k1 = 0.1, .k2 = 0.01, .p1 = 1e-3, .p2 = 2e-3, .k3 = 0};
  expect_camera(camera_of(head + "7 OPENCV 640 480 530 531 318 242 0.1 0.01 0.001 0.002\n"), camera);
  camera.fy_px = 530;
  camera.distortion = {.k1 = 0.1, .k2 = 0, .p1 = 0, .p2 = 0, .k3 = 0};
  expect_camera(camera_of("1 SIMPLE_RADIAL 640 480 530 318 242 0.1"), camera);
  EXPECT_TRUE(camera_of("1 OPENCV_FISHEYE 640 480 530 531 318 242 0.1 0.01 0 0").fisheye);
  EXPECT_THAT(said("1 FOV 640 480 530 531 318 242 0.9"), HasSubstr("COLMAP: wanted one of SIMPLE_PINHOLE"));
  EXPECT_THAT(said("1 PINHOLE 640 480 530 531 318 242\n2 PINHOLE 640 480 530 531 318 242\n"),
              HasSubstr("one camera: leave its line alone"));
}

TEST(OtherCameras, Open3dWithItsPose) {
  const CameraFile cameras = camera_of(R"({"class_name": "PinholeCameraParameters",
    "extrinsic": [0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0.5, 0, 2, 1],
    "intrinsic": {"height": 480, "intrinsic_matrix": [530, 0, 0, 0, 531, 0, 318, 242, 1], "width": 640}})");
  expect_camera(cameras, wanted_camera());
  ASSERT_TRUE(cameras.world_from_colour);
  // Where the world's point that the extrinsic matrix puts at the camera's origin is.
  Eigen::Matrix4d extrinsic;
  extrinsic << 0, 0, -1, 0.5, 0, 1, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1;
  EXPECT_TRUE((cameras.world_from_colour->matrix() * extrinsic).isIdentity(1e-12));
}

TEST(OtherCameras, AzureKinectOfTheModeThatThePhotographHas) {
  const std::string json = R"({"CalibrationInformation": {"Cameras": [{"Purpose":
    "CALIBRATION_CameraPurposePhotoVideo", "Intrinsics": {"ModelParameters": [0.49425735473632815, 0.49793917338053384,
    0.5848361253738403, 0.7792156934738159, 0.0873513743, -0.1150452122, 0.0480436012, 0, 0, 0, 0, 0, 0.0002995548,
    -0.0002088123]}}]}})";
  const CameraFile cameras = camera_of(json, std::pair{1920, 1080});
  ASSERT_TRUE(cameras.colour);
  // The sensor's numbers of the mode 1920 x 1080, as another program derives them; it counts from the first
  // pixel's corner as we do.
  EXPECT_NEAR(cameras.colour->fx_px, 1122.88536, 1e-4);
  EXPECT_NEAR(cameras.colour->fy_px, 1122.07060, 1e-4);
  EXPECT_NEAR(cameras.colour->cx_px, 948.97412, 1e-4);
  EXPECT_NEAR(cameras.colour->cy_px, 537.03241, 1e-4);
  EXPECT_EQ(cameras.colour->distortion.p1, -0.0002088123);
  EXPECT_EQ(cameras.colour->distortion.p2, 0.0002995548);
  EXPECT_THAT(said(json), HasSubstr("Azure Kinect: wanted the photograph beside it"));
  EXPECT_THAT(said(json, std::pair{1000, 1000}), HasSubstr("a photograph of 4:3 or 16:9"));
}

TEST(OtherCameras, RealSense) {
  const std::string json = R"({"depth": {"fx": 1, "fy": 1, "ppx": 1, "ppy": 1, "width": 2, "height": 2},
    "color": {"width": 640, "height": 480, "fx": 530, "fy": 531, "ppx": 318, "ppy": 242,
              "model": "Distortion.Inverse Brown Conrady", "coeffs": [0, 0, 0, 0, 0]}})";
  expect_camera(camera_of(json), wanted_camera());
  std::string bent = json;
  bent.replace(bent.find("[0,"), 3, "[0.1,");
  EXPECT_EQ(said(bent),
            "camera: RealSense: model: wanted a lens without terms, brown_conrady or kannala_brandt4, found "
            "inverse_brown_conrady");
}

TEST(OtherCameras, NumbersAlone) {
  for (const char* text : {"530 0 318\n0 531 242\n0 0 1\n", "[[530, 0, 318], [0, 531, 242], [0, 0, 1]]",
                           "530 0 318 0\n0 531 242 0\n0 0 1 0\n0 0 0 1\n", "530,0,318,0,531,242,0,0,1"}) {
    const CameraFile cameras = camera_of(text, std::pair{640, 480});
    expect_camera(cameras, wanted_camera());
    EXPECT_THAT(cameras.notes, Contains(HasSubstr("it is taken as that of the photograph, 640 x 480")));
  }
  EXPECT_EQ(
      said("530 0 318 0 531 242 0 0 1"),
      "camera: a matrix K alone: wanted the size of its pictures in pixels, which another format states, found "
      "none");
  EXPECT_THAT(said("1 2 3 4"), HasSubstr("a matrix of 3 x 3, 3 x 4 or 4 x 4 numbers, found 4 numbers"));
  EXPECT_THAT(said("1 2 3 4 5 6 7 8 9"), HasSubstr("wanted a camera matrix"));
  expect_camera(
      camera_of("P0: 1 0 0 0 0 1 0 0 0 0 1 0\nP2: 530 0 318 45 0 531 242 0 0 0 1 0\n", std::pair{640, 480}),
      wanted_camera());
  expect_camera(
      camera_of("cam0=[530 0 318; 0 531 242; 0 0 1]\ndoffs=1\nbaseline=193\nwidth=640\nheight=480\n"),
      wanted_camera());
}

TEST(OtherCameras, WhatIsMissingIsNamed) {
  EXPECT_THAT(said("{\"a\": 1}"), HasSubstr("found none of their keys"));
  EXPECT_EQ(said("{\"camera_matrix\": "), "camera: wanted a camera as JSON, found damaged JSON");
  EXPECT_THAT(said("<?xml version=\"1.0\"?>"), HasSubstr("found XML"));
  EXPECT_THAT(said("camera_matrix: [1, 2"), HasSubstr("wanted a camera as YAML"));
  EXPECT_THAT(said("a: &x 1\nb: *x\n"), HasSubstr("an alias"));
  std::string no_size = opencv_yaml;
  no_size.replace(no_size.find("image_width"), 11, "other_width");
  EXPECT_THAT(said(no_size), HasSubstr("OpenCV: wanted the size of its pictures"));
  EXPECT_FALSE(is_other_camera("format = \"seamline camera 1\"\n[colour]\nwidth_px = 2\n"));
  EXPECT_FALSE(is_other_camera("# a remark: with a colon\nformat = \"seamline camera 1\"\n"));
}

TEST(OtherCameras, ARationalLensIsTheNearestByBrown) {
  // Of an Azure Kinect's colour camera.
  const CameraFile cameras =
      camera_of(R"({"image_width": 1280, "image_height": 720, "camera_matrix": [607.7, 0, 638.4,
    0, 607.5, 366.9, 0, 0, 1], "dist_coeffs": [0.4463, -2.5237, 0.000641, -0.000304, 1.4817, 0.3284, -2.3478, 1.4098]})");
  ASSERT_TRUE(cameras.colour);
  EXPECT_THAT(cameras.notes, Contains(HasSubstr("rational lens is taken as the nearest")));
  const std::vector<double> k = {0.4463, -2.5237, 0.000641, -0.000304, 1.4817, 0.3284, -2.3478, 1.4098};
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {0.5, -0.3}, {-1.0, 0.55}, {1.0, 0.5}}) {
    const double r2 = x * x + y * y;
    const double radial =
        (1 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]))) / (1 + r2 * (k[5] + r2 * (k[6] + r2 * k[7])));
    const Eigen::Vector2d exact(607.7 * (x * radial + 2 * k[2] * x * y + k[3] * (r2 + 2 * x * x)) + 638.9,
                                607.5 * (y * radial + k[2] * (r2 + 2 * y * y) + 2 * k[3] * x * y) + 367.4);
    const auto place_px = sensors::project(*cameras.colour, {x, y, 1});
    ASSERT_TRUE(place_px);
    EXPECT_LT((*place_px - exact).norm(), 2);
  }
}

}  // namespace
}  // namespace seamline::registration
