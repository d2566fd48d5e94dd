// Where depth samples are spent, and that a budget that nothing asks for is a uniform map.
#include "renderer/depth/budget/budgeted_panorama.h"

#include <gtest/gtest.h>

#include <numbers>

#include "renderer/depth/budget/samples_picture.h"
#include "renderer/depth/capture.h"
#include "renderer/depth/local_scene.h"
#include "support/text/error.h"
#include "tests/renderer/shapes.h"

namespace seamline::renderer {
namespace {

using Parts = std::vector<std::shared_ptr<const SurfaceMesh>>;

/// A room, and a pillar in front of the camera.
Geometry furnished_room() {
  return Geometry(Parts{test::box({-6, -1.5F, -9}, {6, 3, 6}, 0.6F),
                        test::box({-0.2F, -1.5F, -3.2F}, {0.2F, 1, -3}, 0.6F)});
}
Geometry thing() {
  return Geometry(Parts{test::box({-0.5F, -1.5F, -5}, {0.5F, 0, -4}, 0.6F)});
}
Light sunlight(const Eigen::Vector3f& to_sun) {
  Light light;
  light.suns = {{.to_sun = to_sun.normalized(), .irradiance_w_m2 = Rgb::Ones()}};
  return light;
}

DepthSettings settings_of(Reduction reduction, int width_px) {
  DepthSettings settings{.width_px = width_px};
  settings.chain = DepthChain{};
  PanoramaSource source;
  source.reduction = reduction;
  settings.chain->sources = {source};
  return settings;
}

float weight_towards(const ShownWeights& weights, const Eigen::Vector3d& at_m, DepthRole role) {
  const Eigen::Vector3d d = at_m.normalized();
  const int column = static_cast<int>((std::atan2(d.x(), -d.z()) / (2 * std::numbers::pi) + 0.5) *
                                      weights.width_px),
            row = static_cast<int>((0.5 - std::asin(d.y()) / std::numbers::pi) * weights.height_px);
  const int texel = row * weights.width_px + column;
  return weights.texels[static_cast<std::size_t>(texel)][static_cast<std::size_t>(role)];
}

TEST(BudgetedPanorama, WeightsLieWhereTheObjectIsSeenShadesAndIsShaded) {
  const Geometry truth = furnished_room(), object = thing();
  Camera camera;
  camera.tan_half_horizontal = 1.2F;
  // From behind the object to the front, 45 degrees high: its shadow falls towards the camera.
  const Light light = sunlight({0, 1, -1});
  const ShownWeights weights = where_it_shows({truth, object, light, camera, 2});
  EXPECT_EQ(weight_towards(weights, {0.3, -0.5, -4}, DepthRole::occluder), 1);
  EXPECT_EQ(weight_towards(weights, {2.5, -0.5, -4}, DepthRole::occluder), 0);
  EXPECT_EQ(weight_towards(weights, {0.4, -1.5, -3.4}, DepthRole::receiver), 1);  // in its shadow
  EXPECT_LT(weight_towards(weights, {2.5, -1.5, -4}, DepthRole::receiver), 0.3);
  // What the sun meets before the object: the far wall above it, 45 degrees up from its middle.
  EXPECT_EQ(weight_towards(weights, {0, 3, -8}, DepthRole::blocker), 1);
  EXPECT_LT(weight_towards(weights, {4, 3, -8}, DepthRole::blocker), 0.3);
  // Behind the camera nothing receives what people see.
  EXPECT_EQ(weight_towards(weights, {0, -1.5, 4}, DepthRole::receiver), 0);
}

TEST(BudgetedPanorama, NothingToShowIsTheUniformMapByteForByte) {
  const Geometry truth = furnished_room(), nothing{Parts{}};
  const Camera camera;
  const Light light = sunlight({0, 1, 0});
  for (const int width_px : {64, 150}) {
    const DepthSettings settings = settings_of(Reduction::budgeted, width_px);
    const MeasuredPanorama made = budgeted_panorama({truth, nothing, light, camera, 2}, settings, false);
    const DepthMesh uniform = build_depth_mesh(capture_depth(truth, width_px, 0, 1), {.threads = 1});
    EXPECT_EQ(made.mesh.vertices_m, uniform.vertices_m);
    EXPECT_EQ(made.mesh.triangles, uniform.triangles);
    EXPECT_EQ(made.counts.measured + made.counts.holes, width_px * width_px / 2);
  }
}

TEST(BudgetedPanorama, SpendsAsManyAsTheUniformMapHasAndIsTheSameForAnyThreads) {
  const Geometry truth = furnished_room(), object = thing();
  const Camera camera;
  const Light light = sunlight({0, 1, -1});
  for (const Reduction reduction : {Reduction::jumps, Reduction::budgeted}) {
    const DepthSettings settings = settings_of(reduction, 64);
    const MeasuredPanorama one = budgeted_panorama({truth, object, light, camera, 1}, settings, false),
                           three = budgeted_panorama({truth, object, light, camera, 3}, settings, true);
    EXPECT_EQ(one.counts.measured + one.counts.holes, 2048);
    EXPECT_EQ(one.mesh.vertices_m, three.mesh.vertices_m);
    EXPECT_EQ(one.mesh.triangles, three.mesh.triangles);
    EXPECT_EQ(three.map.width_px, 64);
  }
}

/// Of rays to points where wrong depth shows, those that meet it wrong by more than a hundredth.
int wrong_rays(const DepthMesh& mesh, const Geometry& truth) {
  const Geometry local(mesh, Rgb::Constant(0.5F));
  int wrong = 0;
  for (int i = -40; i <= 40; ++i)
    for (int j = -40; j <= 40; ++j) {  // across the pillar before the object
      const Ray ray{Eigen::Vector3f::Zero(), Eigen::Vector3f(0.005F * static_cast<float>(i),
                                                             -0.2F + 0.005F * static_cast<float>(j), -1)
                                                 .normalized()};
      const auto real = truth.nearest(ray), made = local.nearest(ray);
      wrong += !real || !made || std::abs(real->distance_m - made->distance_m) > 0.01F * real->distance_m;
    }
  return wrong;
}

TEST(BudgetedPanorama, AtEqualSamplesLessIsWrongWhereItShows) {
  const Geometry truth = furnished_room(), object = thing();
  const Camera camera;
  const Light light = sunlight({0, 1, -1});
  const auto wrong = [&](Reduction reduction) {
    return wrong_rays(
        budgeted_panorama({truth, object, light, camera, 2}, settings_of(reduction, 64), false).mesh, truth);
  };
  const int uniform = wrong_rays(build_depth_mesh(capture_depth(truth, 64, 0, 1), {.threads = 1}), truth);
  EXPECT_LT(wrong(Reduction::jumps), uniform);
  EXPECT_LT(4 * wrong(Reduction::budgeted), uniform);
}

TEST(BudgetedPanorama, WhatCannotBeSpentIsRefused) {
  const Geometry truth = furnished_room();
  EXPECT_THROW((void)spend_samples(truth, 500, nullptr, 0, 1), InputError);
  // A budget is spent by those who know the object.
  EXPECT_THROW((void)make_local_scene(truth, settings_of(Reduction::budgeted, 64), {}), InputError);
}

TEST(BudgetedPanorama, ThePictureOfSamplesHasADotForEach) {
  const DepthMesh mesh{.vertices_m = {{0, 0, -2}, {0.5F, 0.2F, -3}, {0, 0, 3}}, .triangles = {}};
  Camera camera;
  camera.width_px = 480, camera.height_px = 270;
  const Image dots = samples_picture(mesh, camera, Image(480, 270, 3), 1);
  int bright = 0;
  for (int y = 0; y < 270; ++y)
    for (int x = 0; x < 480; ++x) bright += dots.rgb(x, y)[0] > 0.5F ? 1 : 0;
  EXPECT_GE(bright, 2);  // the third is behind the camera
  EXPECT_LE(bright, 10);
}

}  // namespace
}  // namespace seamline::renderer
