// What registration gives to people and programs: points, edges over the photograph, masks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "registration/files/point_cloud.h"
#include "registration/mesh/register_by_mesh.h"
#include "registration/pictures/photograph.h"
#include "support/files/atomic_file.h"
#include "support/files/temporary_folder.h"
#include "tests/complaint.h"
#include "tests/registration/synthetic_depth.h"

namespace seamline::registration {
namespace {

using namespace test;
using seamline::test::complaint_of;
using testing::HasSubstr;

/// A photograph whose colours say which pixel they are.
Image numbered_photograph(int width_px, int height_px) {
  Image photograph(width_px, height_px, 3);
  for (int row = 0; row < height_px; ++row)
    for (int column = 0; column < width_px; ++column)
      photograph.set_rgb(column, row,
                         {static_cast<float>(column) / 100, static_cast<float>(row) / 100, 0.5F});
  return photograph;
}

TEST(PointCloud, EveryMeasuredPixelIsOnePointThatProjectsIntoItWithItsColour) {
  const PinholeCamera camera = crooked(24, 18, 60);
  RegisteredFrame registered = empty_frame(camera);
  registered.frame = random_frame(camera, DepthConvention::planar);
  for (std::size_t i = 0; i < registered.filled.size(); ++i)
    registered.filled[i] = DepthFrame::is_hole(registered.frame.depth_m[i]) ? 0 : 1;
  registered.extruded[0] = registered.extruded[1] = 1;
  const ByteImage picture = display_image(numbered_photograph(24, 18));
  const Isometry3d world = crooked_pose();
  const std::string ply = point_cloud_ply(registered, picture, world, "world frame");
  const std::int64_t points = count_of(registered.filled) - 2;
  EXPECT_THAT(ply, HasSubstr("format binary_little_endian 1.0\ncomment metres, world frame\n"));
  EXPECT_THAT(ply, HasSubstr("element vertex " + std::to_string(points) + "\n"));
  const std::size_t start = ply.find("end_header\n") + 11;
  ASSERT_EQ(ply.size(), start + static_cast<std::size_t>(points) * 15);
  for (std::size_t at = start; at < ply.size(); at += 15) {
    Eigen::Vector3f place;
    std::memcpy(place.data(), ply.data() + at, 12);
    const auto pixel = sensors::project(camera, world.inverse() * place.cast<double>());
    ASSERT_TRUE(pixel);
    const std::size_t index =
        registered.frame.index(static_cast<int>(pixel->x()), static_cast<int>(pixel->y()));
    EXPECT_NEAR(pixel->x() - std::floor(pixel->x()), 0.5, 1e-3);
    EXPECT_EQ(std::memcmp(ply.data() + at + 12, &picture.values[index * 3], 3), 0);
  }
  EXPECT_EQ(complaint_of([&] { (void)point_cloud_ply(registered, {}, world, ""); }),
            "point cloud: picture: wanted 24 x 18 pixels of colour, found 0 x 0 of 0 channels");
}

TEST(EdgesOverPhotograph, AreRedAlongAJumpAndNowhereElse) {
  const PinholeCamera camera = sensors::pinhole_of_field_of_view(40, 30, 60);
  RegisteredFrame registered =
      register_by_mesh(depth_of(step(1, 2), camera, DepthConvention::planar), Isometry3d::Identity(), camera);
  const std::size_t gone = registered.frame.index(30, 10), beyond = registered.frame.index(35, 20);
  registered.frame.depth_m[gone] = sensors::hole;
  registered.filled[gone] = 0;
  registered.extruded[beyond] = 1;
  const ByteImage plain = display_image(numbered_photograph(40, 30));
  const ByteImage edges = edges_over_photograph(registered, numbered_photograph(40, 30), 1.05);
  for (int row = 0; row < 30; ++row)
    for (int column = 0; column < 40; ++column) {
      const std::size_t at = registered.frame.index(column, row);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const int code = plain.values[at * 3 + channel];
        const int wanted = column == 19   ? (channel == 0 ? 255 : 0)
                           : at == gone   ? code / 3
                           : at == beyond ? code * 2 / 3
                                          : code;
        ASSERT_EQ(int{edges.values[at * 3 + channel]}, wanted) << column << " " << row;
      }
    }
}

TEST(PhotographInDepthPixels, IsTheColourOfWhereEachDepthLands) {
  const PinholeCamera camera = crooked(24, 18, 60);
  const Image photograph = numbered_photograph(24, 18);
  const DepthFrame measured = random_frame(camera, DepthConvention::planar);  // with holes
  EXPECT_EQ(photograph_in_depth_pixels(photograph, measured, Isometry3d::Identity(), camera).values,
            photograph.values);
  // A wall two metres away, seen 0.1 m beside: everything shifts by as many pixels.
  const PinholeCamera straight = sensors::pinhole_of_field_of_view(24, 18, 60);
  const DepthFrame wall = depth_of(plane({0, 0, 0.5}), straight, DepthConvention::planar);
  Isometry3d pose = Isometry3d::Identity();
  pose.translation().x() = 3 * 2 / straight.fx_px;
  const Image shifted = photograph_in_depth_pixels(photograph, wall, pose, straight);
  EXPECT_EQ(shifted.at(5, 7), photograph.at(8, 7));
  EXPECT_EQ(shifted.at(23, 7), photograph.at(23, 7));  // at the edge
}

TEST(Photograph, OfAnotherKindIsRefused) {
  const TemporaryFolder folder;
  const PinholeCamera camera = sensors::pinhole_of_field_of_view(24, 18, 60);
  write_png(folder / "grey.png", ByteImage{24, 18, 1, std::vector<std::uint8_t>(24 * 18)});
  write_png(folder / "large.png", ByteImage{48, 36, 3, std::vector<std::uint8_t>(48 * 36 * 3)});
  const auto complaint = [&](const char* name) {
    const std::string sentence = complaint_of([&] { (void)read_photograph(folder / name, camera); });
    return sentence.substr(std::min(sentence.size(), folder.path().string().size() + 1));
  };
  EXPECT_EQ(complaint("grey.png"), "grey.png: wanted three colour channels, found 1 channels");
  EXPECT_EQ(complaint("large.png"),
            "large.png: size: wanted 24 x 18 pixels, as the colour camera is stated, found 48 x 36");
}

TEST(MaskPicture, IsWhiteWhereTheMaskIs) {
  const PinholeCamera camera = sensors::pinhole_of_field_of_view(2, 2, 60);
  const std::vector<std::uint8_t> mask = {0, 1, 1, 0};
  EXPECT_EQ(mask_picture(camera, mask).values, (std::vector<std::uint8_t>{0, 255, 255, 0}));
}

}  // namespace
}  // namespace seamline::registration
