// A panorama that is light itself: what it gives, how it is sampled, and its sun apart.
#include "composites/photo_light.h"

#include <gtest/gtest.h>

#include <numbers>

#include "composites/fast_photo.h"
#include "composites/photo_composite.h"
#include "composites/photograph.h"
#include "raytracer/light/light_sample.h"
#include "renderer/depth/capture.h"
#include "renderer/depth/depth_map.h"
#include "renderer/depth/depth_mesh.h"
#include "shapes.h"

namespace seamline::renderer {
namespace {

using Meshes = std::vector<std::shared_ptr<const SurfaceMesh>>;

/// A room around the origin as a panorama knows it.
struct Room {
  DepthMesh mesh;
  std::shared_ptr<const Geometry> depth;
  Light light;

  Room(const Meshes& walls, Image panorama, float albedo = 0.5F) {
    mesh = build_depth_mesh(capture_depth(Geometry(walls), 1024, 0, 2), {.threads = 2});
    depth = std::make_shared<const Geometry>(mesh, Rgb::Constant(albedo));
    light.bounces = 3;
    light.environment = std::make_shared<EnvironmentMap>(std::move(panorama), 0.0F);
    light.photographed = depth;
  }
};

std::shared_ptr<const SurfaceMesh> room_walls(float emission_of_all = 0) {
  return test::shape_of(test::box({-2, -1.5F, -3}, {3, 1.5F, 2}, 0.5F)->positions_m,
                        test::box({-2, -1.5F, -3}, {3, 1.5F, 2}, 0.5F)->triangles,
                        {.albedo = 0.0F, .emission = emission_of_all});
}

Camera small_camera() {
  Camera camera;
  camera.width_px = 48;
  camera.height_px = 32;
  return camera;
}

TEST(PhotoLight, InARoomOfOneRadianceADiffuseBallSendsItsAlbedoAndNoShadowIsSeenThroughAWhiteOne) {
  const Room room({room_walls()}, Image(64, 32, 3, 2.0F));
  const Image photograph(48, 32, 3, 2.0F);
  const Camera camera = small_camera();
  for (const float albedo : {0.3F, 1.0F}) {
    const Meshes ball = {test::sphere({0.1F, 0, -2}, 0.5F, 64, albedo, 1)};
    const Geometry objects(ball);
    const PhotoScene scene{photograph, camera, *room.depth, objects, room.light};
    for (const bool fast : {false, true}) {
      const PhotoEstimate made = fast ? photo_by_fast(scene, {surface_of_depth(room.mesh, 0.5), ball}, {}, 0,
                                                      {.spp = 64, .threads = 2})
                                      : photo_by_path(scene, {}, 0, {.spp = 64, .threads = 2});
      const Image picture = compose(made.sums).picture;
      float on_ball = 0;
      for (int y = 14; y < 19; ++y)
        for (int x = 23; x < 28; ++x) on_ball += picture.at(x, y) / 25;
      EXPECT_NEAR(on_ball, 2 * albedo, 0.02F * albedo) << albedo << fast;
      // The ball is as bright as what it covers, so that nothing changes anywhere.
      for (int x = 0; x < 48 && albedo == 1.0F; ++x) EXPECT_NEAR(picture.at(x, 30), 2.0F, 0.1F) << x << fast;
    }
  }
}

TEST(PhotoLight, SurfacesThatSendWhatThePanoramaShowsLightAsSurfacesThatGlow) {
  // One emitting wall of a black room; the panorama is a picture of it.
  const auto lamp =
      test::shape_of({{-0.5F, 1.45F, -2.5F}, {1, 1.45F, -2.5F}, {1, 1.45F, -1.5F}, {-0.5F, 1.45F, -1.5F}},
                     {{0, 1, 2}, {0, 2, 3}}, {.albedo = 0.0F, .emission = 8.0F});
  const Meshes walls = {room_walls(), lamp};
  const Geometry truth(walls);
  Image panorama(512, 256, 3);
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 512; ++x) {
      if (const auto hit = truth.nearest(
              {Eigen::Vector3f::Zero(), panorama_direction(x + 0.5, y + 0.5, 512, 256).cast<float>()}))
        panorama.set_rgb(x, y, hit->emission);
    }
  const Room room(walls, panorama, 0);
  Light emission;
  emission.bounces = 0;
  emission.emitters = std::make_shared<EmittingSurfaces>(walls);
  const Meshes ball = {test::sphere({0.4F, 0, -2}, 0.6F, 64, 0.8F, 1)};
  const Geometry objects(ball);
  const Camera camera = small_camera();
  Rgb by_panorama = Rgb::Zero(), by_rays = Rgb::Zero(), by_emission = Rgb::Zero();
  for (int y = 4; y < 28; ++y)
    for (int x = 8; x < 40; ++x)
      for (int i = 0; i < 64; ++i) {
        const Sampler sampler(1, x, y, i);
        const auto hit = objects.nearest(centre_ray(camera, x, y));
        if (!hit) continue;
        by_panorama += leaving_object(ObjectQuestions::all_of({room.depth.get(), &*hit}), objects, *hit,
                                      room.light, sampler)
                           .total();
        by_emission +=
            leaving_object(ObjectQuestions::all_of({&truth, &*hit}), objects, *hit, emission, sampler)
                .total();
        const auto next = scatter(Light{}, *hit, sampler.point(dimension::direction(0)));
        if (!next) continue;
        const Ray ray = leaving_ray(*hit, next->direction, endless);
        if (const auto met = room.depth->nearest(ray); met && !objects.occluded(ray))
          by_rays += next->weight * room.light.environment->radiance(met->position_m.normalized());
      }
  EXPECT_NEAR(by_panorama[0] / by_rays[0], 1.0F, 0.02F);  // by both strategies as by one
  // The lamp's rim is a sheet up to the ceiling, two texels wide.
  EXPECT_NEAR(by_panorama[0] / by_emission[0], 1.0F, 0.06F);
}

TEST(PhotoLight, ASunIsFoundWhereItIsAndTakesItsLightAlong) {
  Image panorama(256, 128, 3, 0.5F);
  const Eigen::Vector3d to_sun = Eigen::Vector3d(0.5, 0.6, -0.3).normalized();
  double sun_sr = 0;
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 256; ++x)
      if (panorama_direction(x + 0.5, y + 0.5, 256, 128).dot(to_sun) >
          std::cos(2.5 * std::numbers::pi / 180)) {
        panorama.set_rgb(x, y, Rgb(500, 400, 300));
        sun_sr += texel_solid_angle_sr(y, 256, 128);
      }
  Image left = panorama;
  const auto sky = [](const Eigen::Vector3f& direction) { return direction.y() > 0; };
  const auto split = split_sun(left, sky);
  ASSERT_TRUE(split.has_value());
  EXPECT_GT(split->sun.to_sun.cast<double>().dot(to_sun), std::cos(0.5 * std::numbers::pi / 180));
  EXPECT_NEAR(split->solid_angle_sr, sun_sr, 1e-9);
  EXPECT_NEAR(split->sun.irradiance_w_m2[0], 499.5 * sun_sr, 0.01 * 500 * sun_sr);
  // Nothing is lost: what is left and the sun are what there was.
  for (int c = 0; c < 3; ++c) {
    double before = 0, after = 0;
    for (int y = 0; y < 128; ++y)
      for (int x = 0; x < 256; ++x) {
        before += double{panorama.at(x, y, c)} * texel_solid_angle_sr(y, 256, 128);
        after += double{left.at(x, y, c)} * texel_solid_angle_sr(y, 256, 128);
      }
    EXPECT_NEAR(before - after, double{split->sun.irradiance_w_m2[c]}, 1e-4 * before);
  }
  EXPECT_FALSE(split_sun(left, sky).has_value());
  // A lamp of the room is none: it is not in the sky.
  EXPECT_FALSE(split_sun(panorama, [](const Eigen::Vector3f&) { return false; }).has_value());
}

TEST(PhotoLight, AViewOfAPanoramaShowsWhatThePanoramaDoes) {
  Image panorama(256, 128, 3);
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 256; ++x) {
      const Eigen::Vector3d d = panorama_direction(x + 0.5, y + 0.5, 256, 128);
      panorama.set_rgb(x, y, (Eigen::Array3d(d.x(), d.y(), d.z()) + 1.5).cast<float>());
    }
  const Camera camera = small_camera();
  const Image view = view_of_panorama(panorama, camera, 2);
  for (int y = 0; y < camera.height_px; ++y)
    for (int x = 0; x < camera.width_px; ++x)
      EXPECT_TRUE(((view.rgb(x, y) - (camera.centre_direction(x, y).array() + 1.5F)).abs() < 0.01F).all());
  // A photograph twice as bright is alike, and the panorama is taken twice.
  Image bright = view;
  for (float& value : bright.values) value *= 2;
  const ViewMatch match = match_view(bright, camera, panorama);
  EXPECT_GT(match.likeness, 0.99);
  EXPECT_NEAR(match.scale, 2, 0.01);
  Camera elsewhere = camera;
  elsewhere.axes.col(0) *= -1;
  elsewhere.axes.col(2) *= -1;
  EXPECT_LT(match_view(bright, elsewhere, panorama).likeness, 0.2);
  // Its own camera sees a panorama's texels.
  const Camera whole = panorama_camera(256, 128);
  EXPECT_NEAR(
      (whole.centre_direction(17, 100) - panorama_direction(17.5, 100.5, 256, 128).cast<float>()).norm(), 0,
      1e-5);
}

}  // namespace
}  // namespace seamline::renderer
