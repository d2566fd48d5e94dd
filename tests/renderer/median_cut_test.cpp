// Lights cut out of an environment map, and normals out of depth.
#include "renderer/realtime/median_cut.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "renderer/realtime/depth_normals.h"
#include "shapes.h"
#include "support/arithmetic/random.h"

namespace seamline::renderer {
namespace {

/// A sky that is brighter above, with a small bright window and a lamp.
EnvironmentMap window_sky(float rotation_rad = 0.7F) {
  Image map(256, 128, 3);
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 256; ++x) {
      const float up = std::cos(std::numbers::pi_v<float> * (static_cast<float>(y) + 0.5F) / 128);
      Rgb radiance = Rgb(0.3F, 0.4F, 0.6F) * (0.2F + std::max(0.0F, up));
      if (x > 60 && x < 90 && y > 40 && y < 60) radiance += Rgb(9, 8, 7);
      if (x > 180 && x < 184 && y > 20 && y < 24) radiance += Rgb(60, 40, 20);
      map.set_rgb(x, y, radiance);
    }
  return {map, rotation_rad};
}

Eigen::Array3d total(const std::vector<CutLight>& lights) {
  Eigen::Array3d sum = Eigen::Array3d::Zero();
  for (const CutLight& light : lights) sum += light.irradiance_w_m2.cast<double>();
  return sum;
}

TEST(MedianCut, KeepsAllLight) {
  const EnvironmentMap map = window_sky();
  const Eigen::Array3d all = total(median_cut(map, 1));
  for (const int count : {2, 8, 64, 256}) {
    const std::vector<CutLight> lights = median_cut(map, count);
    EXPECT_EQ(static_cast<int>(lights.size()), count);
    EXPECT_LT(((total(lights) - all) / all).abs().maxCoeff(), 1e-6) << count;
    double solid_angle_sr = 0;
    for (const CutLight& light : lights) solid_angle_sr += light.solid_angle_sr;
    EXPECT_NEAR(solid_angle_sr, 4 * std::numbers::pi, 1e-9);
  }
  EXPECT_LT(((all - map.total_w_m2().cast<double>()) / all).abs().maxCoeff(), 1e-6);
}

TEST(MedianCut, PartsHaveAboutTheSamePower) {
  const std::vector<CutLight> lights = median_cut(window_sky(), 16);
  const double mean = total(lights)[1] / 16;
  for (const CutLight& light : lights) {
    EXPECT_GT(static_cast<double>(light.irradiance_w_m2[1]), 0.5 * mean);
    EXPECT_LT(static_cast<double>(light.irradiance_w_m2[1]), 2 * mean);
  }
}

/// Root mean square error of irradiance on planes of many orientations, relative to its mean.
double irradiance_error(const EnvironmentMap& map, int count) {
  const std::vector<CutLight> lights = median_cut(map, count);
  Random random(5);
  double squares = 0, sum = 0;
  for (int i = 0; i < 40; ++i) {
    Eigen::Vector3d normal;
    do normal = {2 * random.uniform() - 1, 2 * random.uniform() - 1, 2 * random.uniform() - 1};
    while (normal.norm() > 1 || normal.norm() < 0.1);
    normal.normalize();
    double exact = 0, cut = 0;
    for (int row = 0; row < map.height_px(); ++row) {
      const double texel_sr = 2 * std::numbers::pi / map.width_px() *
                              (std::cos(std::numbers::pi * row / map.height_px()) -
                               std::cos(std::numbers::pi * (row + 1) / map.height_px()));
      for (int column = 0; column < map.width_px(); ++column)
        exact += texel_sr * static_cast<double>(map.texel(column, row)[1]) *
                 std::max(0.0, normal.dot(map.direction_of(column + 0.5, row + 0.5)));
    }
    for (const CutLight& light : lights)
      cut += static_cast<double>(light.irradiance_w_m2[1]) *
             std::max(0.0, normal.dot(light.to_light.cast<double>()));
    squares += (cut - exact) * (cut - exact);
    sum += exact;
  }
  return std::sqrt(squares / 40) / (sum / 40);
}

TEST(MedianCut, IrradianceConvergesToTheMaps) {
  const EnvironmentMap map = window_sky();
  const double four = irradiance_error(map, 4), thirty_two = irradiance_error(map, 32),
               many = irradiance_error(map, 1024);
  EXPECT_LT(thirty_two, 0.5 * four);
  EXPECT_LT(many, 0.1 * thirty_two);
  EXPECT_LT(many, 0.003);
}

TEST(MedianCut, TheMapsDirectionsAreItsRadiances) {
  const EnvironmentMap map = window_sky();
  for (int row = 3; row < 128; row += 17)
    for (int column = 1; column < 256; column += 13)
      EXPECT_TRUE(map.radiance(map.direction_of(column + 0.5, row + 0.5).cast<float>())
                      .isApprox(map.texel(column, row), 2e-3F))
          << column << ", " << row;
}

TEST(MedianCut, StandsForAConstantSkyToo) {
  Light light;
  light.environment_radiance = Rgb(0.5F, 1, 2);
  const Light cut = with_cut_environment(light, 64, true);
  ASSERT_EQ(cut.suns.size(), 64U);
  EXPECT_TRUE(cut.skips_sky);
  Rgb on_floor = Rgb::Zero();
  for (const Sun& sun : cut.suns) {
    on_floor += sun.irradiance_w_m2 * std::max(0.0F, sun.to_sun.y());
    EXPECT_GT(sun.angular_radius_rad, 0.1F);
  }
  EXPECT_TRUE(on_floor.isApprox(light.environment_radiance * std::numbers::pi_v<float>, 0.03F));
}

TEST(MedianCut, CutsNoFinerThanTexels) {
  Image map(4, 2, 3, 1.0F);
  EXPECT_EQ(median_cut({map, 0.0F}, 64).size(), 8U);
}

DrawView narrow_view() {
  DrawView view;
  view.axes = axes_along(-Eigen::Vector3f::UnitZ());
  view.from_point = true;
  view.corner = {-0.3F, -0.3F};
  view.size = {0.6F, 0.6F};
  return view;
}

DepthPicture drawn(const std::shared_ptr<const SurfaceMesh>& mesh, int width_px) {
  DepthPicture picture = empty_picture(width_px, width_px);
  const std::array<TriangleSpan, 1> spans = {TriangleSpan{mesh->positions_m, mesh->triangles}};
  draw_depth(narrow_view(), spans, 2, picture);
  return picture;
}

/// Mean angle between normals of a picture and those of a ball, over pixels well inside it.
double ball_error_rad(const NormalPicture& normals, const DepthPicture& depth) {
  double sum = 0;
  int pixels = 0;
  for (int y = 0; y < depth.height_px; ++y)
    for (int x = 0; x < depth.width_px; ++x) {
      const float right = -0.3F + 0.6F * (static_cast<float>(x) + 0.5F) / static_cast<float>(depth.width_px);
      const float down = -0.3F + 0.6F * (static_cast<float>(y) + 0.5F) / static_cast<float>(depth.width_px);
      if (std::hypot(right, down) > 0.15F) continue;
      const Eigen::Vector3f point = Eigen::Vector3f(right, -down, -1) * depth.at(x, y);
      const Eigen::Vector3f truth = (point - Eigen::Vector3f(0, 0, -4)).normalized();
      sum += static_cast<double>(std::acos(std::min(1.0F, truth.dot(normals.at(x, y)))));
      ++pixels;
    }
  return sum / pixels;
}

TEST(DepthNormals, OfAPlaneAreItsOwn) {
  const auto plane = test::part_of({{-9, -9, -2}, {9, -9, -5}, {0, 20, -3}}, {{0, 1, 2}}, 0.5F, "plane");
  const Eigen::Vector3f truth = (plane->positions_m[1] - plane->positions_m[0])
                                    .cross(plane->positions_m[2] - plane->positions_m[0])
                                    .normalized();
  const DepthPicture depth = drawn(plane, 64);
  const NormalPicture normals = cross_product_normals(depth, narrow_view(), 2);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) EXPECT_GT(std::abs(normals.at(x, y).dot(truth)), 0.9999F);
  EXPECT_LT(normals.at(32, 32).dot(Eigen::Vector3f(0, 0, -1)), 0) << "towards the camera";
}

TEST(DepthNormals, OfABallComeNearItsOwn) {
  const auto fine = test::sphere({0, 0, -4}, 1, 1200, 0.5F);
  const DepthPicture depth = drawn(fine, 128);
  EXPECT_LT(ball_error_rad(cross_product_normals(depth, narrow_view(), 2), depth), 0.02);
  // Of few triangles, the mean around vertices is nearer to the ball than the triangles' own.
  const auto coarse = test::sphere({0, 0, -4}, 1, 40, 0.5F);
  const TriangleSpan mesh{coarse->positions_m, coarse->triangles};
  const DepthPicture coarse_depth = drawn(coarse, 128);
  const double mean = ball_error_rad(
      draw_normals(narrow_view(), mesh, triangle_mean_normals(mesh), coarse_depth), coarse_depth);
  const double flat = ball_error_rad(cross_product_normals(coarse_depth, narrow_view(), 2), coarse_depth);
  EXPECT_LT(mean, 0.35 * flat);
}

TEST(DepthNormals, FlickerWithTheNoiseOfDepthAndMoreWhereItIsFiner) {
  Random random(9);
  const auto flicker = [&](int width_px) {
    const auto plane = test::part_of({{-9, -9, -4}, {9, -9, -4}, {0, 20, -4}}, {{0, 1, 2}}, 0.5F, "plane");
    DepthPicture depth = drawn(plane, width_px);
    for (float& depth_m : depth.depth_m) depth_m += 0.01F * (static_cast<float>(random.uniform()) - 0.5F);
    const NormalPicture normals = cross_product_normals(depth, narrow_view(), 2);
    double sum = 0;
    for (const Eigen::Vector3f& normal : normals.normals)
      sum += static_cast<double>(std::acos(std::min(1.0F, std::abs(normal.z()))));
    return sum / static_cast<double>(normals.normals.size());
  };
  const double coarse = flicker(16), fine = flicker(64);
  EXPECT_GT(fine, 2.5 * coarse);
}

}  // namespace
}  // namespace seamline::renderer
