#include "renderer/depth/depth_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numbers>

#include "support/files/image.h"
#include "support/text/error.h"
#include "tests/renderer/depth_mesh_laws.h"

namespace seamline::renderer {
namespace {

using test::hole;

std::filesystem::path test_file(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(SEAMLINE_TEST_OUTPUT) / "depth_map";
  std::filesystem::create_directories(folder);
  return folder / name;
}

void expect_refused(const std::filesystem::path& path, const std::string& part) {
  try {
    (void)read_depth_map(path);
    FAIL() << path << " was read";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(path.string()));
    EXPECT_THAT(error.what(), testing::HasSubstr(part));
  }
}

TEST(DepthMap, DirectionsFollowTheCompass) {
  constexpr int w = 64, h = 32;
  const auto expect_direction = [&](double column, double row, const Eigen::Vector3d& wanted) {
    EXPECT_LT((panorama_direction(column, row, w, h) - wanted).norm(), 1e-15) << column << ", " << row;
  };
  expect_direction(w / 2, h / 2, {0, 0, -1});
  expect_direction(w * 3 / 4, h / 2, {1, 0, 0});
  expect_direction(w / 4, h / 2, {-1, 0, 0});
  expect_direction(0, h / 2, {0, 0, 1});
  expect_direction(w, h / 2, {0, 0, 1});
  expect_direction(11, 0, {0, 1, 0});
  expect_direction(11, h, {0, -1, 0});
  EXPECT_NEAR(panorama_direction(3.7, 8.1, w, h).norm(), 1, 1e-15);
}

TEST(DepthMap, SolidAnglesSumToTheWholeSphere) {
  for (const int width : {2, 4, 64, 426, 4096}) {
    double sum = 0;
    for (int row = 0; row < width / 2; ++row) {
      const double row_sr = texel_solid_angle_sr(row, width, width / 2);
      EXPECT_GT(row_sr, 0);
      EXPECT_NEAR(row_sr, texel_solid_angle_sr(width / 2 - 1 - row, width, width / 2), 1e-15);
      sum += row_sr * width;
    }
    EXPECT_NEAR(sum, 4 * std::numbers::pi, 1e-9) << width;
  }
}

TEST(DepthMap, CountsTheHolesItCleans) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  DepthMap map{.width_px = 4,
               .height_px = 2,
               .distance_m = {0, -1, nan, 1e9F, hole, -hole, 1e-30F, 999999936},
               .cleaned_texels = 0};
  clean_holes(map);
  EXPECT_EQ(map.cleaned_texels, 5);  // infinity is a hole as it is
  EXPECT_THAT(map.distance_m, testing::ElementsAre(hole, hole, hole, hole, hole, hole, 1e-30F, 999999936));
  clean_holes(map);
  EXPECT_EQ(map.cleaned_texels, 5);
}

TEST(DepthMap, SurvivesAFile) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const DepthMap map{.width_px = 4,
                     .height_px = 2,
                     .distance_m = {1e-3F, 1e6F, hole, 1.2345678F, nan, 0, 3, 4},
                     .cleaned_texels = 0};
  const auto path = test_file("survives.exr");
  write_depth_map(path, map);
  const DepthMap back = read_depth_map(path);
  EXPECT_EQ(back.width_px, 4);
  EXPECT_EQ(back.height_px, 2);
  EXPECT_THAT(back.distance_m, testing::ElementsAre(1e-3F, 1e6F, hole, 1.2345678F, hole, hole, 3, 4));
  EXPECT_EQ(back.cleaned_texels, 0);  // every hole was written as infinity
}

TEST(DepthMap, CountsTheHolesOfAFile) {
  Image image(4, 2, 1, 1.0F);
  image.at(1, 0) = -2;
  image.at(2, 1) = 1e10F;
  image.at(3, 1) = hole;
  const auto path = test_file("holes.exr");
  write_exr(path, image);
  const DepthMap map = read_depth_map(path);
  EXPECT_EQ(map.cleaned_texels, 2);
  EXPECT_EQ(map.at(1, 0), hole);
  EXPECT_EQ(map.at(0, 0), 1.0F);
}

TEST(DepthMap, RefusesWhatIsNoPanorama) {
  for (const auto& [width, height] : {std::pair{5, 2}, {4, 4}, {1, 1}, {6, 2}, {3, 1}}) {
    const auto path = test_file("refused.exr");
    write_exr(path, Image(width, height, 1, 1.0F));
    expect_refused(path, "found " + std::to_string(width) + " x " + std::to_string(height));
  }
  const auto colour = test_file("colour.exr");
  write_exr(colour, Image(4, 2, 3, 1.0F));
  expect_refused(colour, "found 3 channels");
  const auto png = test_file("depth.png");
  write_png(png, ByteImage{4, 2, 1, std::vector<std::uint8_t>(8, 7)});
  expect_refused(png, "`.png`");
  expect_refused(test_file("missing.exr"), "no such file");
  const auto broken = test_file("broken.exr");
  std::ofstream(broken) << "not an image";
  expect_refused(broken, "wanted");
}

}  // namespace
}  // namespace seamline::renderer
