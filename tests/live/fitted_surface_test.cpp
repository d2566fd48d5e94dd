// The plane on which a shadow falls: exact where depth is, steadier where depth is noisy, never across a
// jump.
#include "live/frame/fitted_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "live/frame/live_eye.h"
#include "support/arithmetic/random.h"

namespace seamline {
namespace {

constexpr int width_px = 64, height_px = 48;

renderer::DrawView view() {
  const sensors::PinholeCamera camera{.width_px = width_px,
                                      .height_px = height_px,
                                      .fx_px = 60,
                                      .fy_px = 58,
                                      .cx_px = 31,
                                      .cy_px = 25,
                                      .skew_px = 0,
                                      .distortion = {}};
  return live::eye_view(camera, Eigen::Isometry3d::Identity(), 0, 2);
}

/// What a plane normal . point = distance shows in each pixel.
renderer::DepthPicture plane_depth(const live::PixelRays& rays, const Eigen::Vector3f& normal,
                                   float distance_m) {
  renderer::DepthPicture depth = renderer::empty_picture(width_px, height_px);
  for (int y = 0; y < height_px; ++y)
    for (int x = 0; x < width_px; ++x)
      depth.depth_m[static_cast<std::size_t>(y * width_px + x)] =
          distance_m / normal.dot(rays.direction(x, y));
  return depth;
}

TEST(FittedSurface, OfAPlaneIsThePlaneAlsoInCorners) {
  const live::PixelRays rays(view(), width_px, height_px);
  const Eigen::Vector3f normal = Eigen::Vector3f(0.1F, 0.3F, 1).normalized();
  const renderer::DepthPicture depth = plane_depth(rays, normal, 2);
  for (const auto& [x, y] : {std::pair{30, 20}, {0, 0}, {width_px - 1, 3}})
    for (const int reach_px : {2, 4, 8}) {
      const auto surface = live::fitted_surface(depth, rays, x, y, reach_px);
      ASSERT_TRUE(surface);
      EXPECT_NEAR(surface->planar_m, depth.at(x, y), 1e-5F * depth.at(x, y));
      EXPECT_LT((surface->normal + normal).norm(), 1e-4F);
    }
}

TEST(FittedSurface, NoiseOfTwentyFiveDepthsIsAFifth) {
  const live::PixelRays rays(view(), width_px, height_px);
  const renderer::DepthPicture exact = plane_depth(rays, Eigen::Vector3f::UnitZ(), 2);
  renderer::DepthPicture noisy = exact;
  Random random(7);
  constexpr double sigma_m = 0.01;
  for (float& depth_m : noisy.depth_m)
    depth_m += static_cast<float>(sigma_m * std::sqrt(12.0) * (random.uniform() - 0.5));
  double squares = 0;
  int count = 0;
  for (int y = 10; y < height_px - 10; ++y)
    for (int x = 10; x < width_px - 10; ++x, ++count) {
      const auto surface = live::fitted_surface(noisy, rays, x, y, 8);
      ASSERT_TRUE(surface);
      squares += std::pow(surface->planar_m - 2, 2);
      EXPECT_GT(-surface->normal.z(), 0.99);
    }
  EXPECT_NEAR(std::sqrt(squares / count), sigma_m / 5, 0.1 * sigma_m / 5);
}

TEST(FittedSurface, AnotherSurfaceBesideItIsLeftOut) {
  const live::PixelRays rays(view(), width_px, height_px);
  renderer::DepthPicture depth = plane_depth(rays, Eigen::Vector3f::UnitZ(), 2);
  for (int y = 0; y < height_px; ++y)
    for (int x = 33; x < width_px; ++x) depth.depth_m[static_cast<std::size_t>(y * width_px + x)] = 2.5F;
  const auto surface = live::fitted_surface(depth, rays, 32, 20, 8);
  ASSERT_TRUE(surface);
  EXPECT_NEAR(surface->planar_m, 2, 1e-5);
  for (float& depth_m : depth.depth_m) depth_m = std::numeric_limits<float>::infinity();
  for (int y = 0; y < height_px; ++y) depth.depth_m[static_cast<std::size_t>(y * width_px + 32)] = 2;
  EXPECT_FALSE(live::fitted_surface(depth, rays, 32, 20, 8)) << "a line has no plane";
}

}  // namespace
}  // namespace seamline
