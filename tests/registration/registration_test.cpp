// Depth in another camera: exact on planes by mesh, within slope times footprint by points, wrong only where
// depth jumps; holes stay holes; any number of threads gives the same bytes.
#include <gtest/gtest.h>

#include <cstring>

#include "registration/mesh/register_by_mesh.h"
#include "registration/points/register_by_points.h"
#include "tests/complaint.h"
#include "tests/registration/synthetic_depth.h"

namespace seamline::registration {
namespace {

using namespace test;
using seamline::test::complaint_of;
using sensors::hole;
using sensors::pinhole_of_field_of_view;

constexpr double mesh_bound = 1e-6;  ///< relative; depths are single precision, 6e-8

Eigen::Vector2d centre_of(int column, int row) {
  return {column + 0.5, row + 0.5};
}

bool same_bytes(const RegisteredFrame& a, const RegisteredFrame& b) {
  const auto& left = a.frame.depth_m;
  const auto& right = b.frame.depth_m;
  return left.size() == right.size() &&
         std::memcmp(left.data(), right.data(), left.size() * sizeof(float)) == 0 && a.filled == b.filled &&
         a.extruded == b.extruded && a.invented == b.invented;
}

void expect_masks_agree(const RegisteredFrame& registered) {
  for (std::size_t i = 0; i < registered.filled.size(); ++i) {
    ASSERT_EQ(registered.filled[i] == 0, DepthFrame::is_hole(registered.frame.depth_m[i]));
    ASSERT_LE(registered.extruded[i], registered.filled[i]);
    ASSERT_LE(registered.invented[i], registered.filled[i]);
    ASSERT_GT(registered.frame.depth_m[i], 0);
  }
  EXPECT_EQ(registered.frame.convention, DepthConvention::planar);
}

TEST(Registration, BackProjectingAndProjectingThroughTheWholeChainIsTheIdentity) {
  const PinholeCamera depth = crooked(64, 48, 60), colour = crooked(160, 120, 75);
  const Isometry3d pose = crooked_pose();
  for (const auto convention : {DepthConvention::planar, DepthConvention::radial}) {
    const DepthFrame frame = random_frame(depth, convention);
    const std::vector<Vector3d> points_m = points_in_colour_frame(frame, pose);
    double worst_px = 0;
    int tried = 0;
    for (int row = 0; row < 48; ++row)
      for (int column = 0; column < 64; ++column) {
        const Vector3d& point_m = points_m[frame.index(column, row)];
        EXPECT_EQ(DepthFrame::is_hole(frame.at(column, row)), !point_m.allFinite());
        if (!point_m.allFinite()) continue;
        const auto place_px = sensors::project(colour, point_m);
        if (!place_px) continue;
        const auto ray = sensors::direction_through(colour, *place_px);
        ASSERT_TRUE(ray);
        const auto back_px = sensors::project(depth, pose.inverse() * (*ray * point_m.z()));
        ASSERT_TRUE(back_px);
        worst_px = std::max(worst_px, (*back_px - centre_of(column, row)).norm());
        ++tried;
      }
    EXPECT_GT(tried, 2000);
    EXPECT_LE(worst_px, 1e-6);
  }
}

TEST(Registration, ACameraThatIsTheSameGetsTheSameFrame) {
  for (const PinholeCamera& camera : {pinhole_of_field_of_view(33, 25, 60), crooked(33, 25, 60)})
    for (const auto convention : {DepthConvention::planar, DepthConvention::radial}) {
      const DepthFrame frame = random_frame(camera, convention);
      const DepthFrame planar = in_convention(frame, DepthConvention::planar);
      const RegisteredFrame points = register_by_points(frame, Isometry3d::Identity(), camera);
      EXPECT_EQ(points.frame.depth_m, planar.depth_m);
      const RegisteredFrame mesh = register_by_mesh(frame, Isometry3d::Identity(), camera);
      EXPECT_EQ(mesh.frame.depth_m, planar.depth_m);
      expect_masks_agree(points);
      expect_masks_agree(mesh);
    }
}

/// Registers a plane by mesh, and compares every pixel of the colour camera with the traced plane.
void expect_plane_is_exact(const Vector3d& a, const PinholeCamera& depth, const PinholeCamera& colour,
                           const Isometry3d& pose) {
  const DepthFrame measured = depth_of(plane(a), depth, DepthConvention::radial);
  const RegisteredFrame registered = register_by_mesh(measured, pose, colour);
  expect_masks_agree(registered);
  int filled = 0;
  for (int row = 0; row < colour.height_px; ++row)
    for (int column = 0; column < colour.width_px; ++column) {
      const double truth_m = true_planar_m(plane(a), colour, pose, centre_of(column, row));
      const auto ray = sensors::direction_through(colour, centre_of(column, row));
      ASSERT_TRUE(ray);
      const float found_m = registered.frame.at(column, row);
      if (!DepthFrame::is_hole(found_m)) {
        ++filled;
        ASSERT_NEAR(static_cast<double>(found_m), truth_m, mesh_bound * truth_m);
      }
      // Inside of the outermost pixels' centres nothing may be missing, outside nothing be there.
      if (!std::isfinite(truth_m)) continue;
      const auto seen_px = sensors::project(depth, pose.inverse() * (*ray * truth_m));
      if (!seen_px) continue;
      const double inside_px = std::min(
          {seen_px->x(), depth.width_px - seen_px->x(), seen_px->y(), depth.height_px - seen_px->y()});
      const bool is_clear = inside_px > 0.7 || inside_px < 0.3;
      ASSERT_TRUE(!is_clear || DepthFrame::is_hole(found_m) == (inside_px < 0.3)) << column << " " << row;
    }
  EXPECT_GT(filled, colour.width_px * colour.height_px / 10);
}

TEST(Mesh, IsExactOnPlanesWithoutAHoleBetweenItsTriangles) {
  const PinholeCamera coarse = pinhole_of_field_of_view(24, 18, 55), fine = crooked(96, 72, 60);
  for (const Vector3d& a :
       {Vector3d(0, 0, 0.5), Vector3d(0.2, -0.1, 0.6), Vector3d(0.5, 0.1, 0.45), Vector3d(0, 0.55, 0.35)})
    for (const auto& [depth, colour] :
         {std::pair{coarse, fine}, std::pair{fine, coarse}, std::pair{coarse, crooked(200, 150, 70)}})
      for (const Isometry3d& pose :
           {Isometry3d::Identity(), crooked_pose(), sensors::pose_of({0.3, 0, 0}, {0, 1, 0}, -8)})
        expect_plane_is_exact(a, depth, colour, pose);
}

TEST(Points, AreWithinSlopeTimesFootprintOnPlanes) {
  const PinholeCamera depth = crooked(160, 120, 60), colour = crooked(64, 48, 60);
  const Isometry3d pose = crooked_pose();
  for (const Vector3d& a : {Vector3d(0, 0, 0.5), Vector3d(0.2, -0.1, 0.6), Vector3d(0.5, 0.1, 0.45)}) {
    const DepthFrame measured = depth_of(plane(a), depth, DepthConvention::planar);
    const RegisteredFrame registered = register_by_points(measured, pose, colour);
    expect_masks_agree(registered);
    EXPECT_GT(count_of(registered.filled), 64 * 48 / 2);
    for (int row = 0; row < 48; ++row)
      for (int column = 0; column < 64; ++column) {
        const float found_m = registered.frame.at(column, row);
        if (DepthFrame::is_hole(found_m)) continue;
        const Eigen::Vector2d centre = centre_of(column, row);
        const double truth_m = true_planar_m(plane(a), colour, pose, centre);
        double change_m = 0;  // to the pixel's corners: half of |dz/du| + |dz/dv|
        for (const double u : {-0.5, 0.5})
          for (const double v : {-0.5, 0.5})
            change_m = std::max(
                change_m,
                std::abs(true_planar_m(plane(a), colour, pose, centre + Eigen::Vector2d(u, v)) - truth_m));
        ASSERT_NEAR(static_cast<double>(found_m), truth_m, 1.001 * change_m + mesh_bound * truth_m);
      }
  }
}

TEST(Points, TheNearestWinsAndOfEqualsTheMeasured) {
  DepthFrame measured = random_frame(pinhole_of_field_of_view(8, 6, 40), DepthConvention::planar);
  PinholeCamera colour = pinhole_of_field_of_view(2, 2, 40);
  const float nearest_m = *std::min_element(measured.depth_m.begin(), measured.depth_m.end());
  const RegisteredFrame registered = register_by_points(measured, Isometry3d::Identity(), colour);
  EXPECT_EQ(*std::min_element(registered.frame.depth_m.begin(), registered.frame.depth_m.end()), nearest_m);
  std::fill(measured.depth_m.begin(), measured.depth_m.end(), 2.0F);
  std::vector<std::uint8_t> invented(48, 1);
  EXPECT_EQ(count_of(register_by_points(measured, Isometry3d::Identity(), colour, invented).invented), 4);
  for (const std::size_t one : {9U, 47U}) {
    invented.assign(48, 1);
    invented[one] = 0;
    EXPECT_EQ(count_of(register_by_points(measured, Isometry3d::Identity(), colour, invented).invented), 3);
  }
}

struct Band {
  double least_px, most_px;
};

/// Where a jump may be registered wrongly: between the places of the last depths on its two sides, each taken
/// at both distances.
Band band_of_step(const DepthFrame& measured, const PinholeCamera& colour, const Isometry3d& pose,
                  double near_m, double far_m) {
  int last_near = 0;
  while (measured.at(last_near + 1, 0) < 0.5 * (near_m + far_m)) ++last_near;
  Band band{1e9, -1e9};
  for (const int column : {last_near, last_near + 1})
    for (const double depth_m : {near_m, far_m}) {
      const auto ray = sensors::direction_through(measured.camera, centre_of(column, 0));
      const double u = sensors::project(colour, pose * (*ray * depth_m))->x();
      band.least_px = std::min(band.least_px, u);
      band.most_px = std::max(band.most_px, u);
    }
  return band;
}

TEST(Mesh, IsWrongOnlyInTheBandOfAJump) {
  constexpr double near_m = 1, far_m = 2.5;
  const PinholeCamera depth = pinhole_of_field_of_view(80, 60, 60),
                      colour = pinhole_of_field_of_view(120, 90, 50);
  const DepthFrame measured = depth_of(step(near_m, far_m), depth, DepthConvention::planar);
  for (const double beside_m : {-0.15, -0.03, 0.0, 0.03, 0.15}) {
    Isometry3d pose = Isometry3d::Identity();
    pose.translation() = Vector3d(beside_m, 0, 0);
    const Band band = band_of_step(measured, colour, pose, near_m, far_m);
    EXPECT_LT(band.most_px - band.least_px, 4 + std::abs(beside_m) * colour.fx_px * (1 / near_m - 1 / far_m));
    const RegisteredFrame stretched = register_by_mesh(measured, pose, colour);
    const RegisteredFrame cut =
        register_by_mesh(measured, pose, colour, {.jumps = Jumps::cut, .jump_ratio = 1.2});
    expect_masks_agree(cut);
    int between = 0;
    for (int row = 0; row < colour.height_px; ++row)
      for (int column = 0; column < colour.width_px; ++column) {
        const double u = column + 0.5;
        const double truth_m = true_planar_m(step(near_m, far_m), colour, pose, centre_of(column, row));
        const double stretched_m = stretched.frame.at(column, row), cut_m = cut.frame.at(column, row);
        for (const double found_m : {stretched_m, cut_m}) {
          const bool must_be_true = std::isfinite(found_m) && (u < band.least_px || u > band.most_px);
          ASSERT_TRUE(!must_be_true || std::abs(found_m - truth_m) <= mesh_bound * truth_m)
              << column << " " << row;
        }
        // A cut mesh knows only the two walls; a stretched one has no hole between them.
        ASSERT_TRUE(!std::isfinite(cut_m) || std::abs(cut_m - near_m) < 1e-6 ||
                    std::abs(cut_m - far_m) < 3e-6)
            << cut_m;
        if (stretched_m > near_m + 1e-3 && stretched_m < far_m - 1e-3) ++between;
      }
    if (beside_m < -0.1) {
      EXPECT_GT(between, colour.height_px);
      EXPECT_LT(count_of(cut.filled), count_of(stretched.filled) - colour.height_px);
    }
  }
}

TEST(Mesh, HolesStayHolesAndNoTriangleTouchesThem) {
  const PinholeCamera camera = pinhole_of_field_of_view(40, 30, 60);
  DepthFrame measured = depth_of(plane({0.1, 0, 0.5}), camera, DepthConvention::planar);
  for (int row = 10; row < 20; ++row)
    for (int column = 12; column < 25; ++column) measured.depth_m[measured.index(column, row)] = hole;
  const PinholeCamera colour = pinhole_of_field_of_view(160, 120, 60);
  const RegisteredFrame registered = register_by_mesh(measured, Isometry3d::Identity(), colour);
  for (int row = 0; row < 120; ++row)
    for (int column = 0; column < 160; ++column) {
      // Four pixels of the one are one of the other; the nearest depths lie at 11.5 and 25.5, 9.5 and 20.5.
      // In the four squares at the corners of the hole three depths are left, a triangle.
      const double u = (column + 0.5) / 4, v = (row + 0.5) / 4;
      const bool is_inside = u > 11.5 && u < 25.5 && v > 9.5 && v < 20.5;
      const bool is_corner = (u < 12.5 || u > 24.5) && (v < 10.5 || v > 19.5);
      const bool is_filled = registered.filled[registered.frame.index(column, row)] != 0;
      EXPECT_TRUE(!is_inside || is_corner || !is_filled);
      EXPECT_TRUE(is_inside || u < 0.5 || u > 39.5 || v < 0.5 || v > 29.5 || is_filled);
    }
  EXPECT_GT(count_of(registered.filled), 160 * 120 / 2);
}

TEST(Mesh, TheBorderIsExtrudedMarkedAndNeverBeforeWhatIsMeasured) {
  const PinholeCamera depth = pinhole_of_field_of_view(40, 30, 40),
                      colour = pinhole_of_field_of_view(80, 60, 60);
  DepthFrame measured = depth_of(plane({0, 0, 0.5}), depth, DepthConvention::planar);
  for (int row = 0; row < 30; ++row) measured.depth_m[measured.index(39, row)] = hole;  // as cameras do
  const RegisteredFrame plain = register_by_mesh(measured, Isometry3d::Identity(), colour);
  const RegisteredFrame extruded =
      register_by_mesh(measured, Isometry3d::Identity(), colour, {.border_extrusion_px = 20});
  expect_masks_agree(extruded);
  EXPECT_EQ(count_of(plain.extruded), 0);
  EXPECT_EQ(count_of(extruded.filled), 80 * 60);  // 40 + 2 x 20 pixels of 40 degrees see more than 60
  EXPECT_EQ(count_of(extruded.extruded), 80 * 60 - count_of(plain.filled));
  for (std::size_t i = 0; i < plain.filled.size(); ++i) {
    EXPECT_TRUE(plain.filled[i] == 0 || plain.frame.depth_m[i] == extruded.frame.depth_m[i]);
    EXPECT_NEAR(extruded.frame.depth_m[i], 2.0F, 2e-6F);  // a wall that is parallel to the camera goes on
  }
  // A near border, seen from beside: what is extruded from it would hide the wall, which was measured.
  DepthFrame bordered = depth_of(plane({0, 0, 0.5}), depth, DepthConvention::planar);
  for (int row = 0; row < 30; ++row) bordered.depth_m[bordered.index(0, row)] = 0.5F;
  Isometry3d beside = Isometry3d::Identity();
  beside.translation().x() = 0.3;
  const RegisteredFrame seen = register_by_mesh(bordered, beside, colour, {.jumps = Jumps::cut});
  const RegisteredFrame hidden =
      register_by_mesh(bordered, beside, colour, {.jumps = Jumps::cut, .border_extrusion_px = 20});
  EXPECT_GT(count_of(hidden.extruded), 0);
  for (std::size_t i = 0; i < seen.filled.size(); ++i) {
    EXPECT_TRUE(seen.filled[i] == 0 || seen.frame.depth_m[i] == hidden.frame.depth_m[i]) << i;
  }
  // Holes that reach farther in than the extrusion reaches out stay.
  for (int row = 0; row < 30; ++row)
    for (int column = 0; column < 40; ++column)
      if (column >= 10) measured.depth_m[measured.index(column, row)] = hole;
  const RegisteredFrame half =
      register_by_mesh(measured, Isometry3d::Identity(), colour, {.border_extrusion_px = 20});
  EXPECT_EQ(half.filled[half.frame.index(70, 30)], 0);
  EXPECT_EQ(half.extruded[half.frame.index(3, 30)], 1);
}

TEST(Mesh, ATriangleWithAnInventedCornerIsInvented) {
  const PinholeCamera camera = pinhole_of_field_of_view(10, 8, 40);
  const DepthFrame measured = depth_of(plane({0, 0, 0.5}), camera, DepthConvention::planar);
  std::vector<std::uint8_t> invented(80, 0);
  invented[measured.index(5, 4)] = 1;
  const PinholeCamera colour = pinhole_of_field_of_view(100, 80, 40);
  const RegisteredFrame registered = register_by_mesh(measured, Isometry3d::Identity(), colour, {}, invented);
  for (int row = 0; row < 80; ++row)
    for (int column = 0; column < 100; ++column)
      if (registered.invented[registered.frame.index(column, row)] != 0) {
        EXPECT_LE(std::abs(column + 0.5 - 55), 10);
        EXPECT_LE(std::abs(row + 0.5 - 45), 10);
      }
  EXPECT_EQ(registered.invented[registered.frame.index(54, 44)], 1);
  EXPECT_GE(count_of(registered.invented), 200);
}

TEST(Registration, AnyNumberOfThreadsGivesTheSameBytes) {
  const PinholeCamera depth = crooked(70, 50, 60), colour = crooked(120, 90, 70);
  const DepthFrame measured = random_frame(depth, DepthConvention::radial);
  std::vector<std::uint8_t> invented(measured.depth_m.size(), 0);
  for (std::size_t i = 0; i < invented.size(); i += 3) invented[i] = 1;
  const auto by_mesh = [&](int threads) {
    return register_by_mesh(measured, crooked_pose(), colour, {.border_extrusion_px = 15, .threads = threads},
                            invented);
  };
  const auto by_points = [&](int threads) {
    return register_by_points(measured, crooked_pose(), colour, invented, threads);
  };
  for (const int threads : {2, 3, 8, 50}) {
    EXPECT_TRUE(same_bytes(by_mesh(1), by_mesh(threads))) << threads;
    EXPECT_TRUE(same_bytes(by_points(1), by_points(threads))) << threads;
  }
}

TEST(Registration, ExtremeRigsGiveHolesAndNoNonsense) {
  const PinholeCamera camera = crooked(30, 20, 60);
  DepthFrame measured = random_frame(camera, DepthConvention::planar);
  const MeshRegistration everything{.border_extrusion_px = 30};
  const auto both = [&](const Isometry3d& pose, const PinholeCamera& colour) {
    const RegisteredFrame points = register_by_points(measured, pose, colour);
    const RegisteredFrame mesh = register_by_mesh(measured, pose, colour, everything);
    expect_masks_agree(points);
    expect_masks_agree(mesh);
    return count_of(points.filled) + count_of(mesh.filled);
  };
  const Isometry3d identity = Isometry3d::Identity();
  EXPECT_EQ(both(sensors::pose_of({0, 0, -20}, {0, 0, 1}, 0), camera), 0);  // everything behind the camera
  EXPECT_GT(both(sensors::pose_of({0, 0, -2}, {0, 0, 1}, 0), camera), 0);   // amidst the points
  EXPECT_GT(both(sensors::pose_of({0, 0, 3}, {0, 1, 0}, 90), camera), 0);   // from the side
  EXPECT_GT(both(identity, pinhole_of_field_of_view(2, 2, 60)), 0);
  EXPECT_EQ(both(sensors::pose_of({1e9, 0, 0}, {0, 0, 1}, 0), camera), 0);
  // Every second corner behind the camera: triangles pass through its plane.
  for (std::size_t i = 0; i < measured.depth_m.size(); ++i) measured.depth_m[i] = i % 2 == 0 ? 1.0F : 3.0F;
  EXPECT_GT(both(sensors::pose_of({0, 0, -2}, {0, 0, 1}, 0), camera), 0);
  for (const float far_m : {1e-30F, 1e-3F, 1e9F, 3e38F}) {
    std::fill(measured.depth_m.begin(), measured.depth_m.end(), far_m);
    EXPECT_GT(both(identity, camera), 0) << far_m;
    both(crooked_pose(), camera);
  }
  // A wall seen along itself.
  measured = depth_of(plane({3, 0, 0.001}), camera, DepthConvention::planar);
  both(identity, camera);
  std::fill(measured.depth_m.begin(), measured.depth_m.end(), hole);
  EXPECT_EQ(both(identity, camera), 0);
}

TEST(Registration, WhatIsNoneIsRefused) {
  const PinholeCamera camera = pinhole_of_field_of_view(8, 6, 40);
  DepthFrame measured = random_frame(camera, DepthConvention::planar);
  Isometry3d pose = Isometry3d::Identity();
  const auto both = [&](const PinholeCamera& colour, const MeshRegistration& mesh = {}) {
    const std::string by_mesh = complaint_of([&] { (void)register_by_mesh(measured, pose, colour, mesh); });
    return by_mesh;
  };
  PinholeCamera wrong = camera;
  wrong.width_px = 1;
  EXPECT_EQ(both(wrong), "registration: colour.width_px: wanted at least 2, found 1");
  EXPECT_EQ(both(camera, {.jump_ratio = 1}), "registration: jump_ratio: wanted a number above 1, found 1");
  EXPECT_EQ(both(camera, {.border_extrusion_px = -1}),
            "registration: border_extrusion_px: wanted a whole number from 0 to 16384 px, found -1");
  const std::vector<std::uint8_t> few(3);
  EXPECT_EQ(complaint_of([&] { (void)register_by_points(measured, pose, camera, few); }),
            "registration: invented: wanted 48 values, one for each pixel, found 3");
  pose.linear() *= 2;
  EXPECT_EQ(both(camera),
            "registration: colour_from_depth: wanted a rotation, whose columns are of length 1 and at right "
            "angles, found a matrix that is off by 3");
  pose = Isometry3d::Identity();
  measured.depth_m.pop_back();
  EXPECT_EQ(both(camera), "registration: depth_m: wanted 48 values, one for each pixel, found 47");
}

}  // namespace
}  // namespace seamline::registration
