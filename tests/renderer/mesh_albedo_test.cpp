// What the depth mesh is made of: one albedo, the truth's by direction, or what a photograph shows.
#include "renderer/estimators/mesh_albedo.h"

#include <gtest/gtest.h>

#include "renderer/depth/local_scene.h"
#include "renderer/estimators/estimator.h"
#include "renderer/picture/composite.h"
#include "shapes.h"
#include "stimuli/study_file/study_file.h"
#include "support/text/error.h"

namespace seamline::renderer {
namespace {

const Rgb red(0.7F, 0.05F, 0.04F);

std::shared_ptr<const SurfaceMesh> painted(std::shared_ptr<const SurfaceMesh> mesh, const Rgb& albedo) {
  SurfaceMesh copy = *mesh;
  copy.albedo = albedo;
  return std::make_shared<const SurfaceMesh>(std::move(copy));
}

/// A closed room with one red wall on the left, three white balls in it, a sun through nothing: it stands
/// inside, so that light is the sky's through an open ceiling, and the sun's.
TruthScene red_wall_room(int width_px = 48, int height_px = 27) {
  test::SceneParts parts;
  parts.background = {test::floor(-1, 5, 0.6F), painted(test::box({-2.2F, -1, -6}, {-2, 2, -1}, 0.5F), red),
                      test::box({-2.2F, -1, -6.4F}, {3, 2, -6.2F}, 0.6F)};
  for (std::size_t i = 0; i < 3; ++i)
    parts.objects[i] = {test::sphere({-1.4F + 1.5F * static_cast<float>(i), -0.5F, -4}, 0.4F, 32, 0.8F,
                                     static_cast<int>(i) + 1)};
  Light light;
  light.bounces = 3;
  light.environment_radiance = Rgb::Constant(0.3F);
  light.suns.push_back({Eigen::Vector3f(0.7F, 0.6F, 0.2F).normalized(), Rgb::Constant(3.0F), 0});
  return test::scene_of(std::move(parts), std::move(light), width_px, height_px);
}

AlbedoMap constant_map(const Rgb& albedo) {
  return {.width_px = 64,
          .height_px = 32,
          .texels = std::vector<Rgb>(64 * 32, albedo),
          .known = {},
          .elsewhere = Rgb::Zero()};
}

LocalScene local_scene_of(const Geometry& truth, int width_px) {
  return make_local_scene(truth, {.width_px = width_px, .mesh_tolerance = 1e-3},
                          {.albedo = 0.5, .threads = 2});
}

/// Light that object 1 sends to the camera with bounce light from `depth`: its mean over the pixels it has.
Rgb object_light(const TruthScene& scene, const Geometry& depth, Estimator kind, Artifact artifact,
                 int spp = 256) {
  const auto estimator =
      make_estimator(kind, scene, {.spp = spp, .seed = 1, .threads = 2, .depth_bounces = true});
  estimator->take_object(1, {});
  const StimulusSums sums = estimator->stimulus(recipe(artifact, Isolation::query), &depth, {}).sums;
  Rgb light = Rgb::Zero();
  for (const auto& half : sums.halves)
    for (const StimulusPixel& pixel : half) light += pixel.object;
  return light / static_cast<float>(spp);
}

TEST(DirectionMap, IsBilinearAndWrapsAround) {
  DirectionMap<float> map{.width_px = 8, .height_px = 4, .texels = {}, .known = {}, .elsewhere = -1};
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 8; ++column) map.texels.push_back(static_cast<float>(10 * row + column));
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 8; ++column) {
      const auto centre = panorama_direction(column + 0.5, row + 0.5, 8, 4).cast<float>();
      EXPECT_NEAR(map.at(centre), static_cast<float>(10 * row + column), 1e-4F);
      EXPECT_NEAR(map.at(3.0F * centre), map.at(centre), 1e-4F) << "of any length";
    }
  EXPECT_NEAR(map.at(panorama_direction(0, 1.5, 8, 4).cast<float>()), 10 + 3.5F, 1e-4F) << "the seam";
  EXPECT_NEAR(map.at(panorama_direction(3, 2, 8, 4).cast<float>()), 15 + 2.5F, 1e-4F);
  EXPECT_NEAR(map.at(Eigen::Vector3f::UnitY()), map.at(Eigen::Vector3f(1e-9F, 1, 0)), 4.1F) << "a pole";
  map.known.assign(32, 0);
  EXPECT_EQ(map.at(Eigen::Vector3f::UnitX()), -1);
  map.known[map.index(3, 2)] = 1;
  EXPECT_NEAR(map.at(panorama_direction(3.1, 2.9, 8, 4).cast<float>()), 23, 1e-4F) << "only what is known";
}

TEST(MeshAlbedo, OfOneValueIsTheConstantOne) {
  const TruthScene scene = red_wall_room();
  const Geometry truth = scene.geometry_without(1);
  const LocalScene constant = local_scene_of(truth, 128);
  LocalScene mapped = local_scene_of(truth, 128);
  mapped.geometry.paint(std::make_shared<const AlbedoMap>(constant_map(Rgb::Constant(0.5F))));
  for (const Estimator kind : {Estimator::path, Estimator::fast})
    for (const Artifact artifact : {Artifact::bounce, Artifact::all}) {
      const Rgb a = object_light(scene, constant.geometry, kind, artifact, 16),
                b = object_light(scene, mapped.geometry, kind, artifact, 16);
      EXPECT_LT(((a - b) / a).abs().maxCoeff(), 1e-5F) << word(artifact);
    }
}

TEST(MeshAlbedo, CentreRaysAndOthersSeeTheSame) {
  const TruthScene scene = red_wall_room();
  const Geometry truth = scene.geometry_without(1);
  LocalScene local = local_scene_of(truth, 256);
  local.geometry.paint(std::make_shared<const AlbedoMap>(albedo_of_truth(truth, 256, 0.5, 2)));
  int seen = 0;
  for (int y = 0; y < scene.camera.height_px; ++y)
    for (int x = 0; x < scene.camera.width_px; ++x) {
      const Ray ray = centre_ray(scene.camera, x, y);
      std::optional<SurfacePoint> by_table;
      local.geometry.nearest_from_centre({&ray, 1}, {&by_table, 1});
      const auto by_tree = local.geometry.nearest(ray);
      ASSERT_EQ(by_table.has_value(), by_tree.has_value());
      if (!by_table) continue;
      EXPECT_LT((by_table->albedo - by_tree->albedo).abs().maxCoeff(), 1e-3F);
      ++seen;
    }
  EXPECT_GT(seen, 500);
}

TEST(MeshAlbedo, ARedWallBleedsOntoAWhiteBall) {
  const TruthScene scene = red_wall_room();
  const Geometry truth = scene.geometry_without(1);
  LocalScene local = local_scene_of(truth, 512);
  const Rgb grey = object_light(scene, local.geometry, Estimator::path, Artifact::bounce);
  EXPECT_NEAR(grey[0] / grey[1], 1, 1e-4F) << "the paper's mesh has no colour";
  local.geometry.paint(std::make_shared<const AlbedoMap>(albedo_of_truth(truth, 512, 0.5, 2)));
  const Rgb bleeding = object_light(scene, local.geometry, Estimator::path, Artifact::bounce);
  const Rgb real = object_light(scene, local.geometry, Estimator::path, Artifact::none);
  EXPECT_GT(bleeding[0] / bleeding[1], 1.05F);
  EXPECT_NEAR(bleeding[0] / bleeding[1], real[0] / real[1], 0.02F);
}

TEST(MeshAlbedo, TheTruthsTendsToItsBounceLight) {
  const TruthScene scene = red_wall_room();
  const Geometry truth = scene.geometry_without(1);
  float before = 1;
  for (const int width_px : {32, 2048}) {
    LocalScene local = local_scene_of(truth, width_px);
    local.geometry.paint(std::make_shared<const AlbedoMap>(albedo_of_truth(truth, width_px, 0.5, 2)));
    const Rgb depth = object_light(scene, local.geometry, Estimator::path, Artifact::bounce);
    const Rgb real = object_light(scene, local.geometry, Estimator::path, Artifact::none);
    const float error = ((depth - real) / real).abs().maxCoeff();
    EXPECT_LT(error, before);
    before = error;
  }
  EXPECT_LT(before, 0.02F) << "what remains is disocclusion: sheets behind the balls";
}

TEST(MeshAlbedo, FastAgreesWithPath) {
  const TruthScene scene = red_wall_room();
  const Geometry truth = scene.geometry_without(1);
  LocalScene local = local_scene_of(truth, 256);
  local.geometry.paint(std::make_shared<const AlbedoMap>(albedo_of_truth(truth, 256, 0.5, 2)));
  for (const Artifact artifact : {Artifact::bounce, Artifact::all}) {
    const Rgb path = object_light(scene, local.geometry, Estimator::path, artifact),
              fast = object_light(scene, local.geometry, Estimator::fast, artifact);
    EXPECT_LT((fast / path - 1).abs().maxCoeff(), 0.01F) << word(artifact);
  }
}

/// The photograph of a scene, nearly without noise.
Image photograph_of(const TruthScene& scene) {
  const auto estimator = make_estimator(Estimator::path, scene, {.spp = 256, .seed = 3, .threads = 2});
  estimator->take_object(1, {});
  return background_image(estimator->truth());
}

TEST(MeshAlbedo, IsReadOutOfAPhotograph) {
  TruthScene scene = red_wall_room(96, 54);
  scene.camera.tan_half_horizontal = 0.9F;
  const Image photograph = photograph_of(scene);
  const Geometry truth = scene.geometry_without(1);
  LocalScene local = local_scene_of(truth, 1024);
  const auto map =
      paint_from_photograph(local.geometry, 256, {photograph, scene.camera, scene.light, 0.5, 2});
  // In the middle of the red wall, of the floor and of the back wall.
  const Rgb wall = map->at({-2, 0.3F, -4}), ground = map->at({0.9F, -1, -2.6F}),
            back = map->at({0.8F, 1, -6.2F});
  EXPECT_NEAR(wall[0], red[0], 0.1F * red[0]);
  EXPECT_NEAR(wall[1], red[1], 0.02F);
  EXPECT_NEAR(ground[1], 0.6F, 0.06F);
  EXPECT_NEAR(back[1], 0.6F, 0.06F);
  EXPECT_NEAR(map->at({0, 0, 1})[0], 0.5F, 1e-6F) << "behind the camera nobody knows";
}

TEST(MeshAlbedo, OfAPhotographNeverGainsEnergy) {
  const TruthScene scene = red_wall_room(32, 18);
  const Geometry truth = scene.geometry_without(1);
  for (const float radiance : {0.0F, 1e9F}) {
    const Image photograph(32, 18, 3, radiance);
    LocalScene local = local_scene_of(truth, 128);
    const auto map =
        paint_from_photograph(local.geometry, 64, {photograph, scene.camera, scene.light, 0.5, 2});
    for (const Rgb& texel : map->texels) {
      EXPECT_GE(texel.minCoeff(), least_photographed_albedo);
      EXPECT_LE(texel.maxCoeff(), most_photographed_albedo);
    }
  }
}

TEST(MeshAlbedo, TheSameForAnyNumberOfThreads) {
  const TruthScene scene = red_wall_room(32, 18);
  const Geometry truth = scene.geometry_without(1);
  const Image photograph(32, 18, 3, 0.2F);
  std::vector<std::vector<Rgb>> maps;
  for (const int threads : {1, 3}) {
    LocalScene local = local_scene_of(truth, 128);
    maps.push_back(
        paint_from_photograph(local.geometry, 64, {photograph, scene.camera, scene.light, 0.5, threads})
            ->texels);
  }
  for (std::size_t i = 0; i < maps[0].size(); ++i) EXPECT_TRUE((maps[0][i] == maps[1][i]).all());
}

TEST(MeshAlbedo, HasTheDepthMapsWidthAndAPhotographsAtMost1024) {
  EXPECT_EQ(albedo_map_width_px({.width_px = 64, .albedo = MeshAlbedo::truth}), 64);
  EXPECT_EQ(albedo_map_width_px({.width_px = 4096, .albedo = MeshAlbedo::truth}), 4096);
  EXPECT_EQ(albedo_map_width_px({.width_px = 4096, .albedo = MeshAlbedo::photograph}), 1024);
  DepthSettings pinhole{.width_px = 320, .chain = DepthChain{}, .albedo = MeshAlbedo::truth};
  PinholeSource source;
  source.camera.fx_px = 320;
  pinhole.chain->sources = {source};
  EXPECT_EQ(albedo_map_width_px(pinhole), 2010) << "2 pi 320";
}

}  // namespace
}  // namespace seamline::renderer
