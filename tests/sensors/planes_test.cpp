// Flat surfaces become planes: the right ones, and nothing else does.
#include "sensors/repair/planes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "sensors/files/depth_file.h"
#include "support/arithmetic/random.h"
#include "tests/sensors/distributions.h"

namespace seamline::sensors {
namespace {

using Eigen::Vector3d;

struct Room {
  DepthFrame truth, measured;
  std::vector<int> surface;  ///< 0 floor, 1 wall, 2 ball
};

/// A floor 1.2 m below the camera, a slanted wall and a ball before it, in either convention, with noise
/// along the ray and some holes.
Room some_room(DepthConvention convention, double sigma_m) {
  const std::vector<Vector3d> planes = {Vector3d(0, 1, 0) / 1.2, Vector3d(0.3, 0, 1).normalized() / 4};
  const Vector3d centre(-0.4, 0.5, 2.2);
  Room room;
  room.truth.camera = pinhole_of_field_of_view(160, 120, 60);
  room.truth.camera.distortion.k1 = -0.05;
  room.truth.convention = convention;
  Random random(3);
  for (int row = 0; row < 120; ++row)
    for (int column = 0; column < 160; ++column) {
      Vector3d metre = *direction_through(room.truth.camera, {column + 0.5, row + 0.5});
      if (convention == DepthConvention::radial) metre.normalize();
      double depth_m = 1e9;
      int surface = 0;
      for (int i = 0; i < 2; ++i)
        if (const double inverse = planes[static_cast<std::size_t>(i)].dot(metre);
            inverse > 0 && 1 / inverse < depth_m) {
          depth_m = 1 / inverse;
          surface = i;
        }
      const double b = metre.dot(centre), a = metre.squaredNorm();
      if (const double root = b * b - a * (centre.squaredNorm() - 0.25); root > 0) {
        depth_m = (b - std::sqrt(root)) / a;
        surface = 2;
      }
      room.truth.depth_m.push_back(static_cast<float>(depth_m));
      room.surface.push_back(surface);
    }
  room.measured = room.truth;
  for (float& depth_m : room.measured.depth_m)
    depth_m = random.uniform() < 0.05 ? hole : depth_m + static_cast<float>(sigma_m * random.normal());
  return room;
}

TEST(Planes, FloorAndWallAreFoundAndTheirNoiseGoes) {
  for (const auto convention : {DepthConvention::radial, DepthConvention::planar}) {
    const Room room = some_room(convention, 0.01);
    const RepairedPlanes found = replace_planes(room.measured, {.most_planes = 2, .tolerance_m = 0.03});
    ASSERT_EQ(found.planes.size(), 2U);
    const Vector3d expected[] = {Vector3d(0, 1, 0) / 1.2, Vector3d(0.3, 0, 1).normalized() / 4};
    for (const FoundPlane& plane : found.planes) {
      const Vector3d& truth = std::abs(plane.inverse.normalized().y()) > 0.7 ? expected[0] : expected[1];
      EXPECT_LT(std::acos(plane.inverse.normalized().dot(truth.normalized())) * 180 / std::numbers::pi, 0.1);
      EXPECT_NEAR(1 / plane.inverse.norm(), 1 / truth.norm(), 0.002);
    }
    std::vector<double> before, after;
    std::int64_t flat = 0, replaced = 0;
    for (std::size_t i = 0; i < room.surface.size(); ++i) {
      if (room.surface[i] == 2 || DepthFrame::is_hole(room.measured.depth_m[i])) continue;
      ++flat;
      if (found.plane_of_pixel[i] < 0) continue;
      ++replaced;
      const double truth = static_cast<double>(room.truth.depth_m[i]);
      before.push_back(static_cast<double>(room.measured.depth_m[i]) - truth);
      after.push_back(static_cast<double>(found.repaired.frame.depth_m[i]) - truth);
    }
    // Three standard deviations hold 99.7 %; a few pixels of the corner go to the other surface.
    EXPECT_GT(static_cast<double>(replaced), 0.99 * static_cast<double>(flat));
    EXPECT_LT(testing::moments(after).sigma, 0.1 * testing::moments(before).sigma);
  }
}

TEST(Planes, CountsAreThoseOfThePixelsAndHolesStayHoles) {
  const Room room = some_room(DepthConvention::planar, 0.01);
  const RepairedPlanes found = replace_planes(room.measured, {.tolerance_m = 0.03});
  std::int64_t counted = 0;
  for (std::size_t plane = 0; plane < found.planes.size(); ++plane) {
    const auto pixels =
        std::count(found.plane_of_pixel.begin(), found.plane_of_pixel.end(), static_cast<int>(plane));
    EXPECT_EQ(found.planes[plane].pixels, pixels);
    counted += pixels;
  }
  EXPECT_GE(counted, found.repaired.count(RepairMark::changed));
  EXPECT_LE(static_cast<double>(counted),
            1.001 * static_cast<double>(found.repaired.count(RepairMark::changed)));
  EXPECT_EQ(found.repaired.count(RepairMark::invented), 0);
  for (std::size_t i = 0; i < room.surface.size(); ++i)
    if (found.plane_of_pixel[i] < 0) {
      EXPECT_EQ(found.repaired.frame.depth_m[i], room.measured.depth_m[i]);
    }
}

TEST(Planes, NoPixelMovesFartherThanTheTolerance) {
  const Room room = some_room(DepthConvention::radial, 0.01);
  const RepairedPlanes found =
      replace_planes(room.measured, {.tolerance_m = 0.02, .tolerance_relative = 0.005});
  for (std::size_t i = 0; i < room.surface.size(); ++i)
    if (found.plane_of_pixel[i] >= 0) {
      const float before = room.measured.depth_m[i];
      EXPECT_LE(std::abs(found.repaired.frame.depth_m[i] - before), 0.02F + 0.005F * before + 1e-6F);
    }
}

TEST(Planes, WithoutNoiseNothingMovesAndTheBallStaysABall) {
  const Room room = some_room(DepthConvention::planar, 0);
  const RepairedPlanes found = replace_planes(room.measured, {.most_planes = 2, .tolerance_m = 0.002});
  ASSERT_EQ(found.planes.size(), 2U);
  std::int64_t of_ball = 0, ball = 0, of_corner = 0, flat = 0;
  for (std::size_t i = 0; i < room.surface.size(); ++i) {
    if (DepthFrame::is_hole(room.measured.depth_m[i])) continue;
    const float moved_m = std::abs(found.repaired.frame.depth_m[i] - room.truth.depth_m[i]);
    if (room.surface[i] == 2) {
      ++ball;
      of_ball += found.plane_of_pixel[i] >= 0 ? 1 : 0;
    } else {
      ++flat;
      of_corner += moved_m > 1e-5F ? 1 : 0;  // nearer to the other surface than the tolerance
    }
  }
  EXPECT_LT(static_cast<double>(of_ball), 0.01 * static_cast<double>(ball));
  EXPECT_LT(static_cast<double>(of_corner), 0.001 * static_cast<double>(flat));
}

TEST(Planes, WhatIsNotFlatIsLeft) {
  DepthFrame frame = some_room(DepthConvention::planar, 0).truth;
  Random random(4);
  for (float& depth_m : frame.depth_m) depth_m = static_cast<float>(1 + 3 * random.uniform());
  const RepairedPlanes found = replace_planes(frame, {.least_share = 0.05, .tolerance_m = 0.01});
  EXPECT_TRUE(found.planes.empty());
  EXPECT_EQ(found.repaired.count(RepairMark::kept), 160 * 120);
}

TEST(Planes, TheSameSeedGivesTheSameBytesAndAnotherTheSamePlanes) {
  const Room room = some_room(DepthConvention::planar, 0.01);
  const auto repaired = [&](std::uint64_t seed) {
    return replace_planes(room.measured, {.most_planes = 2, .tolerance_m = 0.03, .seed = seed});
  };
  const RepairedPlanes a = repaired(1), again = repaired(1), b = repaired(2);
  EXPECT_EQ(std::memcmp(a.repaired.frame.depth_m.data(), again.repaired.frame.depth_m.data(),
                        a.plane_of_pixel.size() * sizeof(float)),
            0);
  ASSERT_EQ(b.planes.size(), 2U);
  for (const FoundPlane& plane : b.planes) {
    const double nearest =
        std::min((plane.inverse - a.planes[0].inverse).norm(), (plane.inverse - a.planes[1].inverse).norm());
    EXPECT_LT(nearest, 1e-4);
  }
}

TEST(Planes, FewPixelsAndDegenerateOnesGiveNone) {
  DepthFrame frame = some_room(DepthConvention::planar, 0).truth;
  for (std::size_t i = 0; i < frame.depth_m.size(); ++i)
    if (i > 160) frame.depth_m[i] = hole;  // one row and a pixel: every three of the row's are on a line
  EXPECT_TRUE(replace_planes(frame, {}).planes.empty());
  EXPECT_NO_THROW((void)replace_planes(frame, {.least_share = 1e-4}));
}

}  // namespace
}  // namespace seamline::sensors
