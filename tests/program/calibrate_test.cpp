// `seamline calibrate` on pictures of a chessboard that a planted rig takes, and on pairs of points: what it
// writes is what `seamline register` reads. The pictures are kept under test-output/calibrate-*.
#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "board_pictures.h"
#include "registration/calibration/opencv.h"
#include "registration/files/camera_file.h"
#include "run_program.h"
#include "sensors/rig/rig.h"
#include "support/arithmetic/random.h"
#include "support/files/image.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using Eigen::Isometry3d;
using sensors::PinholeCamera;
using test::fresh_folder;
using test::Outcome;
using test::run_seamline;
using test::write_text;
using testing::HasSubstr;

struct Pictures {
  std::string depth, colour;
};

/// Pictures of one board in several places, by both cameras of a rig.
Pictures take_pictures(const fs::path& folder, const PinholeCamera& depth, const PinholeCamera& colour,
                       const Isometry3d& colour_from_depth, int count) {
  const test::Board board;  // 7 x 5 inner corners, 40 mm apart
  Random random(3);
  Pictures pictures;
  for (int i = 0; i < count; ++i) {
    const Isometry3d place = test::next_board_place(board, random);
    const fs::path a = folder / fmt::format("depth-{}.png", i), b = folder / fmt::format("colour-{}.png", i);
    write_png(a, test::chessboard_picture(board, depth, place));
    write_png(b, test::chessboard_picture(board, colour, colour_from_depth * place));
    pictures.depth += " " + a.string();
    pictures.colour += " " + b.string();
  }
  return pictures;
}

class Calibrate : public testing::Test {
 protected:
  void SetUp() override {
    if (!registration::has_opencv()) GTEST_SKIP() << "built without OpenCV";
    folder_ = fresh_folder(std::string("calibrate-") +
                           testing::UnitTest::GetInstance()->current_test_info()->name());
  }
  Outcome calibrate(const std::string& arguments) const {
    return run_seamline("calibrate " + arguments + " --out " + (folder_ / "out").string());
  }
  void expect_complaint(const std::string& arguments, const std::string& part) const {
    const Outcome outcome = calibrate(arguments);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.output, HasSubstr(part));
    EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 1) << outcome.output;
    EXPECT_FALSE(fs::exists(folder_ / "out"));
  }
  fs::path folder_;
};

TEST_F(Calibrate, FindsARigFromPicturesOfABoardForRegister) {
  const PinholeCamera depth = sensors::pinhole_of_field_of_view(240, 180, 50),
                      colour = sensors::pinhole_of_field_of_view(320, 240, 54);
  const Isometry3d pose = sensors::pose_of({-0.025, 0.002, 0}, {0, 1, 0}, 1.5);
  const Pictures pictures = take_pictures(folder_, depth, colour, pose, 8);
  write_text(folder_ / "known.toml",
             "format = \"seamline camera 1\"\nconvention = \"planar\"\nmetres_per_step = 0.001\n");
  const Outcome outcome =
      calibrate("--depth-pictures" + pictures.depth + " --colour-pictures" + pictures.colour +
                " --board 7x5 --square 0.04 --camera " + (folder_ / "known.toml").string());
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("the board was found in 8 of 8 pairs of pictures\n"));
  EXPECT_THAT(outcome.output, HasSubstr("reprojection error "));
  EXPECT_THAT(test::read_text(folder_ / "out" / "covariance.csv"),
              HasSubstr("depth.fx_px,colour_from_depth.turn_x,"));
  EXPECT_THAT(test::read_text(folder_ / "out" / "parameters.csv"), HasSubstr("colour.k3,"));
  const registration::RegistrationRig rig = registration::registration_rig(
      registration::read_camera_file(folder_ / "out" / "camera.toml"), "camera.toml");
  // Corners are found within some hundredths of a pixel, 35 in each picture.
  EXPECT_NEAR(rig.depth_form.camera.fx_px, depth.fx_px, 0.01 * depth.fx_px);
  EXPECT_NEAR(rig.colour.fx_px, colour.fx_px, 0.01 * colour.fx_px);
  EXPECT_NEAR(rig.colour.cx_px, colour.cx_px, 2);
  EXPECT_LT((rig.colour_from_depth.translation() - pose.translation()).norm(), 0.003);
  EXPECT_LT((rig.colour_from_depth.linear() - pose.linear()).norm(), 0.006);
  EXPECT_EQ(rig.depth_form.metres_per_step, 0.001);

  const std::string text = test::read_text(folder_ / "out" / "camera.toml");
  const Outcome again =
      calibrate("--depth-pictures" + pictures.depth + " --colour-pictures" + pictures.colour +
                " --board 7x5 --square 0.04 --camera " + (folder_ / "known.toml").string());
  EXPECT_EQ(test::read_text(folder_ / "out" / "camera.toml"), text);

  // A wall seen by the calibrated depth camera is brought into the calibrated colour camera.
  std::string pgm = "P5\n240 180\n65535\n";
  for (int i = 0; i < 240 * 180; ++i) pgm += "\x07\xD0";  // 2000
  write_text(folder_ / "wall.pgm", pgm);
  write_png(folder_ / "photograph.png", ByteImage{320, 240, 3, std::vector<std::uint8_t>(320 * 240 * 3, 99)});
  const Outcome registered =
      run_seamline("register --depth " + (folder_ / "wall.pgm").string() + " --colour " +
                   (folder_ / "photograph.png").string() + " --camera " +
                   (folder_ / "out" / "camera.toml").string() + " --out " + (folder_ / "wall").string());
  ASSERT_EQ(registered.status, 0) << registered.output;
  EXPECT_NEAR(read_image(folder_ / "wall" / "registered.exr").at(160, 120), 2.0F, 0.01F);
}

TEST_F(Calibrate, FindsAPoseFromPairsAndLeavesOutWhatIsNotTrusted) {
  const PinholeCamera colour = sensors::pinhole_of_field_of_view(320, 240, 54);
  const Isometry3d pose = sensors::pose_of({-0.025, 0.002, 0}, {0, 1, 0}, 1.5);
  registration::CameraFile known;
  known.colour = colour;
  write_text(folder_ / "known.toml", registration::camera_file_text(known, "planted"));
  Random random(4);
  std::string csv = "u,v,x,y,z,confidence\n";
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d point_m(0.3 * random.normal(), 0.3 * random.normal(), 1 + 2 * random.uniform());
    const Eigen::Vector2d at = *sensors::project(colour, pose * point_m);
    // Every fifth is wrong, and the depth camera knows it.
    csv += fmt::format("{},{},{},{},{},{}\n", at.x() + (i % 5 == 0 ? 30 : 0), at.y(), point_m.x(),
                       point_m.y(), point_m.z(), i % 5 == 0 ? 0.2 : 0.9);
  }
  write_text(folder_ / "pairs.csv", csv);
  const std::string arguments =
      "--pairs " + (folder_ / "pairs.csv").string() + " --camera " + (folder_ / "known.toml").string();
  const Outcome outcome = calibrate(arguments + " --least-confidence 0.5");
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("16 pairs used, 4 left out for a confidence below 0.5\n"));
  const auto found = registration::read_camera_file(folder_ / "out" / "camera.toml");
  EXPECT_LT((found.colour_from_depth->matrix() - pose.matrix()).norm(), 1e-6);
  ASSERT_EQ(calibrate(arguments).status, 0);
  const auto spoilt = registration::read_camera_file(folder_ / "out" / "camera.toml");
  EXPECT_GT((spoilt.colour_from_depth->matrix() - pose.matrix()).norm(), 1e-3);
}

TEST_F(Calibrate, ItsFolderDoesNotReplaceTheCameraThatItReads) {
  fs::create_directories(folder_ / "out");
  write_text(folder_ / "out" / "camera.toml", "what is known");
  const Outcome outcome =
      calibrate("--pairs none.csv --camera " + (folder_ / "out" / "camera.toml").string());
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.output, HasSubstr("--out: wanted another file than --camera, which would be lost"));
  EXPECT_EQ(test::read_text(folder_ / "out" / "camera.toml"), "what is known");
}

TEST_F(Calibrate, WrongInputIsOneSentenceAndWritesNothing) {
  write_png(folder_ / "empty.png", ByteImage{64, 48, 1, std::vector<std::uint8_t>(64 * 48, 99)});
  const std::string empty = (folder_ / "empty.png").string();
  expect_complaint("", "calibrate: wanted --depth-pictures, --colour-pictures, both, or --pairs, found none");
  expect_complaint("--colour-pictures " + empty + " --board 2x1",
                   "--board: wanted a board's inner corners, from 3x3 to 100x100, e.g. 9x6, found 2x1");
  expect_complaint("--colour-pictures " + empty + " " + empty,
                   "--colour-pictures: wanted at least 3 pictures that show the whole board, found 0");
  expect_complaint("--colour-pictures " + empty + " --depth-pictures " + empty + " " + empty,
                   "--depth-pictures: wanted as many as --colour-pictures, in the same order, found 2 and 1");
  expect_complaint("--colour-pictures " + empty + " --least-confidence 1",
                   "--least-confidence: wanted --pairs");
  write_png(folder_ / "other.png", ByteImage{32, 48, 1, std::vector<std::uint8_t>(32 * 48, 99)});
  expect_complaint("--colour-pictures " + empty + " " + (folder_ / "other.png").string(),
                   "other.png: size: wanted 64 x 48 pixels, as the first picture has, found 32 x 48");
  const std::string pairs = "--pairs " + (folder_ / "pairs.csv").string();
  expect_complaint(pairs, "--pairs: wanted a --camera file with a table [colour]");
  registration::CameraFile known;
  known.colour = sensors::pinhole_of_field_of_view(320, 240, 54);
  write_text(folder_ / "known.toml", registration::camera_file_text(known, ""));
  const std::string with_camera = pairs + " --camera " + (folder_ / "known.toml").string();
  expect_complaint(with_camera, "pairs.csv: wanted a readable file, found none");
  write_text(folder_ / "pairs.csv", "u,v,x,y,z\n1,2,3,4,5\n");
  expect_complaint(with_camera, "confidence");
  std::string line = "u,v,x,y,z,confidence\n";
  for (int i = 0; i < 8; ++i) line += fmt::format("{},{},0,0.1,{},1\n", 100 + i, 120, 1 + i);
  write_text(folder_ / "pairs.csv", line);
  expect_complaint(with_camera, "pairs.csv: wanted points that do not lie on one line, found 8 on one");
  expect_complaint(with_camera + " --board 9x6", "--board: wanted pictures of a board, found --pairs");
}

TEST(CalibrateWithoutOpenCv, SaysSoAndNothingElse) {
  const Outcome outcome = run_seamline("calibrate --colour-pictures a.png --out b");
  EXPECT_EQ(outcome.status, 1);
  const std::string said =
      "seamline: calibrate: wanted a Seamline that was built with OpenCV (Debian: "
      "libopencv-calib3d-dev), found one without\n";
  EXPECT_EQ(outcome.output == said, !registration::has_opencv()) << outcome.output;
}

}  // namespace
}  // namespace seamline
