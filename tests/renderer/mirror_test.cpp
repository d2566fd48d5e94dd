// Question 6: what is mirrored in a glossy object, by the truth and by the depth mesh, in both estimators.
#include <gtest/gtest.h>

#include "raytracer/scene/visible_objects.h"
#include "renderer/estimators/estimator.h"
#include "renderer/estimators/fast/fast_truth_pass.h"
#include "renderer/estimators/fast/scene_sums_bytes.h"
#include "renderer/picture/composite.h"
#include "shapes.h"
#include "support/text/error.h"

namespace seamline::renderer {
namespace {

std::shared_ptr<const SurfaceMesh> glossy_ball(const Eigen::Vector3f& centre, int object, float alpha) {
  SurfaceMesh ball = *test::sphere(centre, 0.6F, 32, 0.1F, object);
  ball.f0 = Rgb(0.9F, 0.8F, 0.7F);
  ball.alpha = alpha;
  return std::make_shared<const SurfaceMesh>(std::move(ball));
}

/// Three balls on a floor before a wall, one glossy, under a sun, a map and a lamp.
TruthScene mirror_room(float alpha) {
  test::SceneParts parts;
  parts.background = {test::floor(-1, 6), test::box({-3, -1, -7}, {3, 2, -6.5F}, 0.7F)};
  parts.objects[0] = {test::sphere({-1.8F, -0.4F, -4.5F}, 0.5F, 24, 0.3F, 1)};
  parts.objects[1] = {glossy_ball({0, -0.3F, -4}, 2, alpha)};
  parts.objects[2] = {test::sphere({1.8F, -0.4F, -4.5F}, 0.5F, 24, 0.6F, 3)};
  Light light;
  light.bounces = 2;
  light.suns.push_back({Eigen::Vector3f(0.5F, 1, 0.4F).normalized(), Rgb::Constant(2.0F), 0.02F});
  Image sky(32, 16, 3, 0.3F);
  sky.set_rgb(20, 3, {20, 18, 15});
  light.environment = std::make_shared<EnvironmentMap>(sky, 0.4F);
  light.lamps.push_back({.position_m = {0.5F, 1.5F, -2.5F}, .intensity_w_sr = {2, 2, 3}});
  return test::scene_of(std::move(parts), std::move(light), 48, 28);
}

/// What is left of the truth's world when object 2 is taken out, as the depth mesh.
Geometry everything_else(const TruthScene& scene) {
  return scene.geometry_without(2);
}

Image stimulus_of(SceneEstimator& estimator, Artifact artifact, const Geometry& depth) {
  return compose(estimator.stimulus(recipe(artifact, Isolation::query), &depth, {}).sums).picture;
}

double mean_of(const Image& picture) {
  double sum = 0;
  for (const float value : picture.values) sum += double{value};
  return sum / static_cast<double>(picture.values.size());
}

double rms_between(const Image& a, const Image& b) {
  double squares = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i)
    squares += std::pow(double{a.values[i]} - double{b.values[i]}, 2);
  return std::sqrt(squares / static_cast<double>(a.values.size()));
}

TEST(Mirror, ADepthMeshThatIsTheTruthMirrorsTheSame) {
  for (const float alpha : {0.0025F, 0.3F}) {
    const TruthScene scene = mirror_room(alpha);
    const Geometry depth = everything_else(scene);
    const auto estimator = make_estimator(Estimator::path, scene, {.spp = 8, .seed = 1, .threads = 2});
    estimator->take_object(2, {});
    const Image none = stimulus_of(*estimator, Artifact::none, depth);
    EXPECT_LT(rms_between(none, reference_image(estimator->truth())), 1e-5);
    for (const Artifact artifact : {Artifact::reflection, Artifact::shadow, Artifact::bounce, Artifact::all})
      EXPECT_LT(rms_between(stimulus_of(*estimator, artifact, depth), none), 1e-4)
          << word(artifact) << " alpha " << alpha;
  }
}

TEST(Mirror, NothingIsDarkInAFurnaceThatMirrorsCastTheirLightInto) {
  // All surfaces are white and the same light comes from everywhere, so that each sends as much as it gets,
  // also where a glossy ball takes the sky and casts it onto the floor.
  const Geometry real(std::vector{test::floor(-1, 50, 1.0F)});
  for (const float alpha : {0.05F, 0.4F}) {
    SurfaceMesh ball = *test::sphere({0, -0.35F, -4}, 0.6F, 32, 0.0F, 1);
    ball.f0 = Rgb::Ones();
    ball.alpha = alpha;
    const Geometry object(std::vector{std::make_shared<const SurfaceMesh>(ball)});
    Light light;
    light.bounces = 64;
    light.environment = std::make_shared<EnvironmentMap>(Image(32, 16, 3, 1.0F), 0.0F);
    const auto floor = real.nearest({Eigen::Vector3f::Zero(), Eigen::Vector3f(0, -1, -3.3F).normalized()});
    const auto glossy = object.nearest({Eigen::Vector3f::Zero(), Eigen::Vector3f(0, -0.5F, -4).normalized()});
    ASSERT_TRUE(floor && glossy);
    constexpr int samples = 6000;
    double on_floor = 0, on_object = 0;
    for (int i = 0; i < samples; ++i) {
      const Sampler sampler(1, i, 0, 0);
      on_floor +=
          double{radiance_with_and_without(real, &object, *floor, light, sampler).with_object.total()[1]} /
          samples;
      on_object +=
          double{leaving_object(ObjectQuestions::all_of({&real, &*glossy}), object, *glossy, light, sampler)
                     .total()[1]} /
          samples;
    }
    EXPECT_NEAR(on_floor, 1, 0.01) << alpha;
    EXPECT_NEAR(on_object, 1, 0.01) << alpha;
  }
}

TEST(Mirror, OnlyReflectionAndAllShowWhatTheDepthMeshLacks) {
  const TruthScene scene = mirror_room(0.0025F);
  const Geometry depth(std::vector{test::floor(-1, 6)});  // no wall, no other balls
  const auto estimator = make_estimator(Estimator::path, scene, {.spp = 16, .seed = 1, .threads = 2});
  estimator->take_object(2, {});
  const Image none = stimulus_of(*estimator, Artifact::none, depth);
  const double mirrored = rms_between(stimulus_of(*estimator, Artifact::reflection, depth), none);
  EXPECT_GT(mirrored, 0.01);
}

TEST(Mirror, FastAgreesWithPath) {
  for (const float alpha : {0.0025F, 0.3F}) {
    const TruthScene scene = mirror_room(alpha);
    const Geometry depth(std::vector{test::floor(-1, 6), test::box({-3, -1, -7.2F}, {3, 1.6F, -6.4F}, 0.7F)});
    const auto fast = make_estimator(Estimator::fast, scene, {.spp = 64, .seed = 1, .threads = 2});
    const auto path = make_estimator(Estimator::path, scene, {.spp = 64, .seed = 2, .threads = 2});
    fast->take_object(2, {});
    path->take_object(2, {});
    for (const Artifact artifact :
         {Artifact::none, Artifact::reflection, Artifact::shadow, Artifact::overlap, Artifact::all}) {
      const double by_fast = mean_of(stimulus_of(*fast, artifact, depth));
      const double by_path = mean_of(stimulus_of(*path, artifact, depth));
      EXPECT_NEAR(by_fast / by_path, 1, 0.01) << word(artifact) << " alpha " << alpha;
    }
  }
}

TEST(Mirror, SumsOfItAreThereOnlyWhereSomethingIsGlossyAndComeBackFromTheirBytes) {
  for (const bool glossy : {true, false}) {
    TruthScene scene = mirror_room(0.3F);
    if (!glossy) scene.objects[1] = {test::sphere({0, -0.3F, -4}, 0.6F, 32, 0.1F, 2)};
    SceneSums sums = empty_sums(scene.camera);
    add_samples(scene, SceneGeometry(scene), std::vector<int>(sums.spp.size(), 2), {}, sums);
    EXPECT_EQ(sums.mirrored[0].empty(), !glossy);
    for (const auto& object : sums.objects)
      for (const auto& tile : object) EXPECT_TRUE(!tile || tile->mirrored[1].empty() == !glossy);
    ByteWriter written, again;
    write_sums(sums, written);
    SceneSums read = empty_sums(scene.camera);
    ByteReader in(written.bytes());
    ASSERT_TRUE(read_sums(in, read));
    write_sums(read, again);
    EXPECT_EQ(written.bytes(), again.bytes());
  }
}

TEST(Mirror, ReflectionIsAskedOfGlossyObjectsOnly) {
  TruthScene scene = mirror_room(0.3F);
  scene.definition.artifacts = {Artifact::reflection};
  scene.definition.objects.resize(3);
  EXPECT_THROW(require_mirrors({}, scene), InputError);
  for (std::size_t i : {0U, 2U}) scene.objects[i] = {glossy_ball({0, 0, -4}, static_cast<int>(i) + 1, 0.3F)};
  EXPECT_NO_THROW(require_mirrors({}, scene));
  scene = mirror_room(0.3F);
  EXPECT_NO_THROW(require_mirrors({}, scene)) << "nothing is asked";
}

}  // namespace
}  // namespace seamline::renderer
