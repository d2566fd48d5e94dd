// What registration gives to people and programs: points, edges over the photograph, masks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "registration/files/point_cloud.h"
#include "registration/mesh/register_by_mesh.h"
#include "registration/pictures/photograph.h"
#include "registration/points/register_by_points.h"
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

/// Pixels from which the true depth of the pixel to the right or below differs by more than the ratio.
std::vector<std::uint8_t> true_outline(const DepthFrame& truth, double ratio) {
  std::vector<std::uint8_t> outline(truth.depth_m.size());
  for (int row = 0; row + 1 < truth.camera.height_px; ++row)
    for (int column = 0; column + 1 < truth.camera.width_px; ++column)
      for (const float there : {truth.at(column + 1, row), truth.at(column, row + 1)}) {
        const auto [near_m, far_m] = std::minmax({truth.at(column, row), there});
        if (double{far_m} > ratio * double{near_m}) outline[truth.index(column, row)] = 1;
      }
  return outline;
}

/// Share of the marked pixels of `a` that have a marked one of `b` within `px`.
double share_near(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b,
                  const PinholeCamera& camera, int px) {
  DepthFrame frame;
  frame.camera = camera;
  int marked = 0, near = 0;
  for (int row = 0; row < camera.height_px; ++row)
    for (int column = 0; column < camera.width_px; ++column) {
      if (a[frame.index(column, row)] == 0) continue;
      ++marked;
      bool found = false;
      for (int y = std::max(0, row - px); y <= std::min(camera.height_px - 1, row + px); ++y)
        for (int x = std::max(0, column - px); x <= std::min(camera.width_px - 1, column + px); ++x)
          found = found || b[frame.index(x, y)] != 0;
      near += found ? 1 : 0;
    }
  return marked == 0 ? 0 : static_cast<double>(near) / marked;
}

// A pixel of the depth camera covers 3.5 of the photograph, over which the mesh spreads a jump.
TEST(EdgesOverPhotograph, FollowTheTrueOutlineWhereDepthIsCoarse) {
  const PinholeCamera colour = sensors::pinhole_of_field_of_view(280, 210, 60),
                      depth = sensors::pinhole_of_field_of_view(80, 60, 60);
  // A disc before a wall, both a little slanted; the jump is an eighth of the distance.
  const Scene disc = [](const Vector3d& from_m, const Vector3d& direction) {
    const double to_disc = plane({0.05, 0, 1})(from_m, direction);
    const Vector3d at_m = from_m + to_disc * direction;
    if (std::hypot(at_m.x() - 0.05, at_m.y()) < 0.27) return to_disc;
    return plane({0, 0.04, 0.88})(from_m, direction);
  };
  const std::vector<std::uint8_t> outline =
      true_outline(depth_of(disc, colour, DepthConvention::planar), 1.05);
  const Image grey(280, 210, 3, 0.5F);
  for (const bool by_mesh : {true, false}) {
    const DepthFrame seen = depth_of(disc, depth, DepthConvention::planar);
    const RegisteredFrame registered = by_mesh ? register_by_mesh(seen, Isometry3d::Identity(), colour)
                                               : register_by_points(seen, Isometry3d::Identity(), colour);
    const ByteImage picture = edges_over_photograph(registered, grey, 1.05, colour.fx_px / depth.fx_px);
    std::vector<std::uint8_t> red;
    for (std::size_t i = 0; i < picture.values.size(); i += 3)
      red.push_back(picture.values[i] == 255 && picture.values[i + 1] == 0 ? 1 : 0);
    EXPECT_GT(share_near(outline, red, colour, by_mesh ? 3 : 4), 0.98) << by_mesh;
    EXPECT_GT(share_near(red, outline, colour, by_mesh ? 3 : 4), 0.98) << by_mesh;
    if (by_mesh) {
      EXPECT_LT(count_of(red), 2 * count_of(outline));  // a line, no band
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
