// Places that were clicked become the points from which an estimate's scale and shift are found.
#include "composites/measured_places.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "renderer/depth/depth_map.h"

namespace seamline::renderer {
namespace {

SeenPhoto seen_through(Projection projection, int width_px, int height_px) {
  SeenPhoto seen;
  seen.photograph.projection = projection;
  seen.photograph.width_px = width_px;
  seen.photograph.height_px = height_px;
  seen.camera.width_px = 480;
  seen.camera.height_px = 270;
  seen.camera.tan_half_horizontal = 1;
  return seen;
}

PhotoDepthRequest of_rays() {
  PhotoDepthRequest request;
  request.convention = sensors::DepthConvention::radial;
  return request;
}

TEST(MeasuredPlaces, ATapesDistanceBecomesOneAlongTheAxisUnlessTheMapHoldsRays) {
  const SeenPhoto seen = seen_through(Projection::perspective, 960, 540);
  const std::vector<MeasuredPlace> places = {{.across = 0, .down = 0.5, .distance_m = 3}};
  const auto planar = known_points(places, seen, {});
  ASSERT_EQ(planar.size(), 1U);
  EXPECT_DOUBLE_EQ(planar[0].x_px, 0);
  EXPECT_DOUBLE_EQ(planar[0].y_px, 270);
  EXPECT_NEAR(planar[0].depth_m, 3 / std::numbers::sqrt2, 1e-4) << "45 degrees to the left";
  const auto radial = known_points(places, seen, of_rays());
  EXPECT_DOUBLE_EQ(radial[0].depth_m, 3);
}

TEST(MeasuredPlaces, AClickIntoAViewIsThePanoramasPixelInThatDirection) {
  SeenPhoto seen = seen_through(Projection::panorama, 2048, 1024);
  seen.camera.axes = Eigen::AngleAxisf(2.0F, Eigen::Vector3f::UnitY()).toRotationMatrix();
  for (const double across : {0.1, 0.5, 0.9}) {
    const std::vector<MeasuredPlace> places = {{.across = across, .down = 0.2, .distance_m = 3}};
    const auto points = known_points(places, seen, {});
    const Eigen::Vector3d direction = panorama_direction(points[0].x_px, points[0].y_px, 2048, 1024);
    const Eigen::Vector3d through =
        seen.camera.direction(static_cast<float>(across * 480), 0.2F * 270).cast<double>();
    EXPECT_LT((direction - through).norm(), 2 * std::numbers::pi / 2048 * 0.1) << "a tenth of a pixel";
    EXPECT_DOUBLE_EQ(points[0].depth_m, 3);
  }
}

TEST(MeasuredPlaces, OptionsReadBackAsTheSameNumbers) {
  const SeenPhoto seen = seen_through(Projection::perspective, 1000, 500);
  const std::vector<MeasuredPlace> places = {{.across = 0.33333, .down = 0.5, .distance_m = 2.12345678}};
  const auto points = known_points(places, seen, of_rays());
  EXPECT_EQ(point_options(points), " --depth-point 333.3,250,2.1235");
  EXPECT_DOUBLE_EQ(points[0].x_px, 333.3);
  EXPECT_DOUBLE_EQ(points[0].depth_m, 2.1235);
}

}  // namespace
}  // namespace seamline::renderer
