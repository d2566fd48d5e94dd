// `seamline register` on files of one's own: what it writes, that it writes the same again, and one sentence
// about what is wrong.
#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "run_program.h"
#include "support/files/image.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using test::fresh_folder;
using test::Outcome;
using test::run_seamline;
using test::write_text;
using testing::HasSubstr;

constexpr int width_px = 64, height_px = 48;

std::string camera_text(const std::string& name, int width, int height) {
  return fmt::format("[{}]\nwidth_px = {}\nheight_px = {}\nfx_px = {}\nfy_px = {}\ncx_px = {}\ncy_px = {}\n",
                     name, width, height, width, width, 0.5 * width, 0.5 * height);
}

const std::string head = "format = \"seamline camera 1\"\nconvention = \"planar\"\nmetres_per_step = 0.001\n";
const std::string pose = "[colour_from_depth]\ntranslation_m = [0.02, 0, 0]\n";

/// A wall at two metres, in front of it a square at one; some holes.
std::string depth_pgm(int at_wall = 2000) {
  std::string bytes = fmt::format("P5\n{} {}\n65535\n", width_px, height_px);
  for (int row = 0; row < height_px; ++row)
    for (int column = 0; column < width_px; ++column) {
      const bool square = column > 20 && column < 40 && row > 15 && row < 35;
      const int value = column < 3 ? 0 : square ? at_wall / 2 : at_wall;
      bytes += static_cast<char>(value >> 8);
      bytes += static_cast<char>(value & 0xFF);
    }
  return bytes;
}

class Register : public testing::Test {
 protected:
  explicit Register()
      : folder_(fresh_folder(std::string("register-") +
                             testing::UnitTest::GetInstance()->current_test_info()->name())) {
    write_text(folder_ / "rig.toml", head + camera_text("depth", width_px, height_px) +
                                         camera_text("colour", 2 * width_px, 2 * height_px) + pose);
    write_text(folder_ / "depth.pgm", depth_pgm());
    write_exr(folder_ / "photograph.exr", Image(2 * width_px, 2 * height_px, 3, 0.4F));
  }
  Outcome run(const std::string& more = "", const std::string& out = "out") {
    return run_seamline("register --depth " + (folder_ / depth_).string() + " --colour " +
                        (folder_ / "photograph.exr").string() + " --camera " +
                        (folder_ / "rig.toml").string() + " --out " + (folder_ / out).string() + " " + more);
  }
  void expect_complaint(const Outcome& outcome, const std::string& part) {
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.output, HasSubstr(part));
    EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 1) << outcome.output;
    EXPECT_FALSE(fs::exists(folder_ / "out"));
  }
  fs::path folder_;
  std::string depth_ = "depth.pgm";
};

const std::vector<std::string> written = {"registered.exr", "filled.png", "extruded.png", "invented.png",
                                          "edges.png",      "points.ply", "points.png"};

TEST_F(Register, WritesEveryPartTheSameAgainAndCountsIt) {
  for (const std::string& way :
       {std::string("--by points"), std::string("--by mesh"), std::string("--jumps cut --jump-ratio 1.3"),
        std::string("--extrude 30 --repair nearest"), std::string("--repair median"),
        std::string("--repair joint_bilateral"), std::string("--repair planes")}) {
    const Outcome first = run(way), again = run(way, "again");
    ASSERT_EQ(first.status, 0) << first.output;
    for (const std::string& part : written) {
      const std::string bytes = test::read_text(folder_ / "out" / part);
      EXPECT_FALSE(bytes.empty()) << part;
      EXPECT_TRUE(bytes == test::read_text(folder_ / "again" / part)) << way << " " << part;
    }
    EXPECT_THAT(first.output, HasSubstr("holes                                    144    4.7 %"));
    EXPECT_THAT(first.output, HasSubstr("seconds: read "));
    ASSERT_EQ(again.status, 0);
  }
}

TEST_F(Register, TheMapHoldsMetresAndHolesAreInfinite) {
  ASSERT_EQ(run().status, 0);
  const Image depth = read_image(folder_ / "out" / "registered.exr");
  const ByteImage filled = read_bytes_image(folder_ / "out" / "filled.png");
  ASSERT_EQ(depth.values.size(), filled.values.size());
  for (std::size_t i = 0; i < depth.values.size(); ++i)
    EXPECT_EQ(std::isinf(depth.values[i]), filled.values[i] == 0);
  EXPECT_NEAR(depth.at(100, 20), 2.0F, 1e-6F);
  EXPECT_NEAR(depth.at(62, 50), 1.0F, 1e-6F);
}

TEST_F(Register, ARepairAfterwardsFillsThePhotographsPixelsAndMarksThem) {
  ASSERT_EQ(run("--by points", "before").status, 0);
  const Outcome after = run("--by points --repair nearest --repair-after");
  ASSERT_EQ(after.status, 0) << after.output;
  const Image measured = read_image(folder_ / "before" / "registered.exr");
  const Image mended = read_image(folder_ / "out" / "registered.exr");
  const ByteImage invented = read_bytes_image(folder_ / "out" / "invented.png");
  std::int64_t holes = 0;
  for (std::size_t i = 0; i < measured.values.size(); ++i) {
    const bool hole = std::isinf(measured.values[i]);
    holes += hole ? 1 : 0;
    EXPECT_EQ(invented.values[i], hole ? 255 : 0);
    EXPECT_TRUE(std::isfinite(mended.values[i]));
    if (!hole) {
      EXPECT_EQ(mended.values[i], measured.values[i]);
    }
  }
  EXPECT_GT(holes, 0);
  EXPECT_THAT(after.output, HasSubstr(fmt::format("{:<34}{:>10}", "invented by the repair", holes)));
}

TEST_F(Register, BesideTheTruthItCountsWhatIsWrongByReason) {
  Image truth(2 * width_px, 2 * height_px, 1, 2.0F);
  write_exr(folder_ / "truth.exr", truth);
  const std::string given = "--extrude 9 --true-depth " + (folder_ / "truth.exr").string();
  const Outcome outcome = run(given), again = run(given, "again"), without = run("--extrude 9", "without");
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("beside the true depth:\n  right "));
  EXPECT_THAT(outcome.output, HasSubstr("    noise "));
  const std::string table = test::read_text(folder_ / "out" / "errors.csv");
  EXPECT_THAT(table, testing::StartsWith("class,colour,pixels,share,share_of_wrong,without_depth,"));
  EXPECT_THAT(table, HasSubstr("\nall,,12288,1,1,"));
  EXPECT_EQ(table, test::read_text(folder_ / "again" / "errors.csv"));
  const ByteImage picture = read_bytes_image(folder_ / "out" / "errors.png");
  EXPECT_EQ(picture.width_px, 2 * width_px);
  const std::size_t square = 3 * (50 * static_cast<std::size_t>(picture.width_px) + 62);
  EXPECT_EQ(picture.values[square], 204) << "a metre too near";
  for (const std::string& part : written)
    EXPECT_TRUE(test::read_text(folder_ / "out" / part) == test::read_text(folder_ / "without" / part))
        << part;
  EXPECT_FALSE(fs::exists(folder_ / "without" / "errors.csv"));

  const Outcome loose = run(given + " --error-tolerance 0.6", "loose");
  EXPECT_THAT(loose.output, testing::Not(HasSubstr("noise")));
  fs::remove_all(folder_ / "out");
  expect_complaint(run("--true-depth " + (folder_ / "none.exr").string()),
                   "none.exr: wanted a depth map, found no such file");
  expect_complaint(run("--error-tolerance 0.1"),
                   "--error-tolerance: wanted --true-depth beside it, found none");
  write_exr(folder_ / "truth.exr", Image(width_px, height_px, 1, 2.0F));
  expect_complaint(run(given),
                   "truth.exr: size: wanted 128 x 96 pixels, as its camera is stated, found 64 x 48");
}

TEST_F(Register, SeveralDepthMapsAreTheirMean) {
  write_text(folder_ / "other.pgm", depth_pgm(2200));
  write_text(folder_ / "wild.pgm", depth_pgm(9000));
  ASSERT_EQ(run().status, 0);
  const std::string same = (folder_ / "depth.pgm").string();
  ASSERT_EQ(run(" --depth " + same, "twice").status, 0);
  EXPECT_TRUE(test::read_text(folder_ / "out" / "registered.exr") ==
              test::read_text(folder_ / "twice" / "registered.exr"));
  const std::string more = " --depth " + (folder_ / "other.pgm").string() + " --depth " + same + " --depth " +
                           (folder_ / "wild.pgm").string();
  ASSERT_EQ(run(more, "mean").status, 0);
  const Image mean = read_image(folder_ / "mean" / "registered.exr");
  EXPECT_NEAR(mean.at(100, 20), 2.1F, 1e-5F) << "of 2, 2, 2.2 and 9 m the middle two";
}

TEST_F(Register, WrongInputIsOneSentenceAndWritesNothing) {
  const auto with_rig = [&](const std::string& text) {
    write_text(folder_ / "rig.toml", text);
    return run();
  };
  expect_complaint(run("--by points --extrude 3"),
                   "--extrude: wanted --by mesh beside it, found --by points");
  expect_complaint(run("--by points --jumps cut"), "--jumps: wanted --by mesh beside it");
  expect_complaint(run("--jump-ratio 1.2"),
                   "--jump-ratio: wanted --jumps cut beside it, found --jumps stretch");
  expect_complaint(run("--repair-after"), "--repair-after: wanted a repair beside it, found --repair none");
  expect_complaint(run_seamline("register --depth a --colour b --camera tof_160x121 --out c"),
                   "tof_160x121: wanted a readable file, found none");
  const std::string colour = camera_text("colour", 2 * width_px, 2 * height_px);
  expect_complaint(
      with_rig(head + camera_text("depth", 32, 24) + colour + pose),
      "depth.pgm: size: wanted 32 x 24 pixels, as its camera is stated, found 64 x 48: state the "
      "camera of that size");
  expect_complaint(with_rig(head + camera_text("depth", 64, 64) + colour + pose),
                   "which is of another shape");
  const std::string depth = camera_text("depth", width_px, height_px);
  expect_complaint(
      with_rig(head + depth + camera_text("colour", 64, 48) + pose),
      "photograph.exr: size: wanted 64 x 48 pixels, as the colour camera is stated, found 128 x 96");
  expect_complaint(with_rig(head + depth + colour + pose + "rotation = [1, 1, 0, 0, 1, 0, 0, 0, 1]\n"),
                   "colour_from_depth.rotation: wanted a rotation");
  std::string flat = depth;
  flat.replace(flat.find("fx_px = 64"), 10, "fx_px = 0");
  expect_complaint(with_rig(head + flat + colour + pose), "depth.fx_px: wanted a number from");
  std::string metres = head;
  metres.replace(metres.find("0.001"), 5, "1");
  expect_complaint(
      with_rig(metres + depth + colour + pose),
      "a median depth from 0.05 to 500 m, found 2000 m with 1 metres a step: give 0.001 metres a "
      "step");
  write_text(folder_ / "rig.toml", head + depth + colour + pose);
  write_text(folder_ / "depth.pgm", depth_pgm(0));
  expect_complaint(run(), "nothing but holes");
  write_png(folder_ / "eight.png", ByteImage{width_px, height_px, 1, std::vector<std::uint8_t>(3072, 9)});
  depth_ = "eight.png";
  expect_complaint(run(), "wanted one channel of 16 bits, found one channel of 8 bits");
}

}  // namespace
}  // namespace seamline
