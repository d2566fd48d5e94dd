// Who is in front by a test a pixel: the depth of panoramas and of sensors, and both estimators.
#include "renderer/depth/occlusion_test.h"

#include <gtest/gtest.h>

#include <cmath>

#include "renderer/depth/local_scene.h"
#include "renderer/estimators/estimator.h"
#include "renderer/estimators/path/path_depth_pass.h"
#include "stimuli/pictures/difference.h"
#include "tests/renderer/shapes.h"

namespace seamline::renderer {
namespace {

using test::scene_of;

/// A floor, a wall and a post, and a ball that stands half behind the post and half in the floor.
TruthScene yard() {
  test::SceneParts parts;
  parts.background = {test::floor(-1, 30), test::box({-6, -1, -9}, {6, 4, -8}, 0.5F),
                      test::box({0.3F, -1, -4.6F}, {0.8F, 1.5F, -4.2F}, 0.5F)};
  parts.objects[0] = {test::sphere({0.2F, -0.6F, -5.5F}, 0.7F, 48, 0.5F, 1)};
  parts.objects[1] = {test::sphere({-2.2F, -0.5F, -5.0F}, 0.5F, 24, 0.5F, 2)};
  Light light;
  light.bounces = 1;
  light.environment_radiance = Rgb::Constant(1.0F);
  return scene_of(std::move(parts), light, 96, 54);
}

DepthSettings panorama(int width_px, Occlusion occlusion) {
  DepthSettings settings{.width_px = width_px};
  settings.chain = DepthChain{};
  settings.chain->occlusion = occlusion;
  return settings;
}

PinholeSource depth_camera(int width_px, int height_px, double field_of_view_deg) {
  PinholeSource source;
  source.camera = sensors::pinhole_of_field_of_view(width_px, height_px, field_of_view_deg);
  return source;
}

/// Share of the rays through the photograph on which a virtual point just behind the truth is hidden, and one
/// just before it is not.
double share_told_apart(const Geometry& truth, const OcclusionTest& test, const Camera& camera,
                        float relative) {
  int right = 0, all = 0;
  for (int y = 0; y < camera.height_px; ++y)
    for (int x = 0; x < camera.width_px; ++x) {
      const Ray ray = centre_ray(camera, x, y);
      const auto hit = truth.nearest(ray);
      if (!hit) continue;
      ++all;
      right += hides(test, {ray.direction}, hit->distance_m * (1 + relative)) &&
                       !hides(test, {ray.direction}, hit->distance_m * (1 - relative))
                   ? 1
                   : 0;
    }
  return static_cast<double>(right) / all;
}

/// The floor is seen at a grazing angle, where a pixel spans a share of the distance that no linear function
/// follows; the rest of the rays that may fail pass along edges.
TEST(OcclusionTest, EverySourceKnowsWhatIsInFront) {
  const TruthScene scene = yard();
  const ObjectGeometry geometry = object_geometry(scene, 1);
  const LocalSceneUse use{.threads = 2, .photograph = scene.camera};
  DepthSettings settings = panorama(2048, Occlusion::depth_test);
  settings.yaw_texels = 0.37;
  const auto share = [&](float relative) {
    return share_told_apart(geometry.truth, make_local_scene(geometry.truth, settings, use).occlusion.value(),
                            scene.camera, relative);
  };
  EXPECT_GE(share(0.002F), 0.95) << "panorama";
  settings.chain->sources = {depth_camera(640, 400, 80)};
  EXPECT_GE(share(0.002F), 0.95) << "pinhole";
  std::get<PinholeSource>(settings.chain->sources.front()).convention = sensors::DepthConvention::radial;
  std::get<PinholeSource>(settings.chain->sources.front()).pose.rotation_deg = {3, -4, 10};
  EXPECT_GE(share(0.002F), 0.95) << "radial, turned";
  std::get<PinholeSource>(settings.chain->sources.front()).pose.position_m = {0.05, 0.02, 0};
  settings.chain->registration = Registration::mesh;
  EXPECT_GE(share(0.02F), 0.9) << "by mesh";
  settings.chain->registration = Registration::points;  // which wins where several land is half a pixel off
  EXPECT_GE(share(0.02F), 0.75) << "by points";
}

TEST(OcclusionTest, WhatIsNotSeenAndHolesHideNothingAndOneOfSeveralIsEnough) {
  OcclusionTest test;
  FrameSight wall;
  wall.frame.camera = sensors::pinhole_of_field_of_view(8, 6, 40);
  wall.frame.depth_m.assign(48, 3.0F);
  wall.frame_from_world.diagonal() << 1, -1, -1;
  test.sights = {wall};
  const Eigen::Vector3f ahead(0, 0, -1), aside(1, 0, 0), oblique = Eigen::Vector3f(0.3F, 0, -1).normalized();
  EXPECT_TRUE(hides(test, {ahead}, 3.001F));
  EXPECT_FALSE(hides(test, {ahead}, 2.999F));
  EXPECT_TRUE(hides(test, {oblique}, 3.001F / -oblique.z()));  // planar: along the camera's axis
  EXPECT_FALSE(hides(test, {oblique}, 2.999F / -oblique.z()));
  EXPECT_FALSE(hides(test, {aside}, 1e6F));
  EXPECT_FALSE(hides(test, {-ahead}, 1e6F));
  wall.frame.depth_m.assign(48, sensors::hole);
  test.sights = {wall};
  EXPECT_FALSE(hides(test, {ahead}, 1e6F));
  PanoramaSight around{.map = {.width_px = 8, .height_px = 4, .distance_m = std::vector<float>(32, 2.0F)}};
  test.sights.emplace_back(around);
  EXPECT_TRUE(hides(test, {oblique}, 2.001F));  // radial: along the ray
  EXPECT_FALSE(hides(test, {oblique}, 1.999F));
  EXPECT_TRUE(hides(test, {aside}, 2.001F));
}

/// What is nearer by less than a step of the buffer is not told apart; in metres it is.
TEST(OcclusionTest, ABufferIsAsGoodAsItsSteps) {
  OcclusionTest test;
  test.sights.emplace_back(
      PanoramaSight{.map = {.width_px = 8, .height_px = 4, .distance_m = std::vector<float>(32, 8.0F)}});
  const Eigen::Vector3f oblique = Eigen::Vector3f(0.3F, 0.2F, -1).normalized();
  EXPECT_TRUE(hides(test, {oblique}, 8.01F));
  test.buffer = sensors::DepthBuffer{.nearest_m = 0.01, .farthest_m = 100, .bits = 16};
  const double step_m = sensors::depth_buffer_step_m(*test.buffer, -8.0 * static_cast<double>(oblique.z()));
  EXPECT_GT(step_m, 0.07);
  EXPECT_FALSE(hides(test, {oblique}, 8.01F) && hides(test, {oblique}, 8.02F) &&
               hides(test, {oblique}, 7.99F));
  EXPECT_TRUE(hides(test, {oblique}, 8.0F + 1.6F * static_cast<float>(step_m)));
  EXPECT_FALSE(hides(test, {oblique}, 8.0F - 1.6F * static_cast<float>(step_m)));
  test.buffer->bits = 32;
  EXPECT_TRUE(hides(test, {oblique}, 8.01F));
}

/// A test that looks at depth as fine as the mesh gives the mesh's picture but for a few pixels of edges; a
/// test of nothing but holes shows the whole object.
TEST(OcclusionTest, BothEstimatorsAskIt) {
  const TruthScene scene = yard();
  const ObjectGeometry geometry = object_geometry(scene, 1);
  const LocalScene local = make_local_scene(geometry.truth, panorama(2048, Occlusion::depth_test),
                                            {.threads = 2, .photograph = scene.camera});
  OcclusionTest nothing = local.occlusion.value();
  for (float& distance_m : std::get<PanoramaSight>(nothing.sights.front()).map.distance_m)
    distance_m = sensors::hole;
  const Recipe how = recipe(Artifact::occlusion, Isolation::query);
  for (const Estimator kind : {Estimator::path, Estimator::fast}) {
    const auto estimator = make_estimator(kind, scene, {.spp = 16, .threads = 2, .who_is_in_front = true});
    estimator->take_object(1, {});
    const auto picture = [&](const DepthWorld& world) {
      return compose(estimator->stimulus(how, world, {}).sums).picture;
    };
    const Image reference = reference_image(estimator->truth());
    const Image by_mesh = picture(&local.geometry), by_test = picture({nullptr, &*local.occlusion}),
                unhidden = picture({nullptr, &nothing});
    EXPECT_LT(display_rmse(by_test, by_mesh, 0), 0.01) << word(kind);
    EXPECT_LT(display_rmse(by_test, reference, 0), 0.02) << word(kind);
    EXPECT_GT(display_rmse(unhidden, reference, 0), 0.02) << word(kind);
  }
}

/// Where the mesh answers all else, only who is in front changes.
TEST(OcclusionTest, EverythingElseIsStillTheMeshs) {
  const TruthScene scene = yard();
  const ObjectGeometry geometry = object_geometry(scene, 1);
  const LocalScene local = make_local_scene(geometry.truth, panorama(24, Occlusion::depth_test),
                                            {.threads = 2, .photograph = scene.camera});
  const PassOptions options{.spp = 8, .threads = 2};
  const TruthSums truth = render_truth(scene, geometry, options);
  const auto sums = [&](Artifact artifact, const DepthWorld& world) {
    return render_stimulus(scene, geometry, world, truth, recipe(artifact, Isolation::query), options);
  };
  for (const Artifact artifact : {Artifact::receiver, Artifact::shadow, Artifact::overlap, Artifact::bounce})
    EXPECT_EQ(compose(sums(artifact, local.world())).picture.values,
              compose(sums(artifact, &local.geometry)).picture.values)
        << word(artifact);
  EXPECT_NE(compose(sums(Artifact::all, local.world())).picture.values,
            compose(sums(Artifact::all, &local.geometry)).picture.values);
}

}  // namespace
}  // namespace seamline::renderer
