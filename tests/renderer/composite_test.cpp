// Laws of the pixel formula and of artifact isolation on scenes small enough to know by hand.
#include "renderer/picture/composite.h"

#include <gtest/gtest.h>

#include "renderer/depth/capture.h"
#include "renderer/depth/depth_mesh.h"
#include "renderer/estimators/path/path_depth_pass.h"
#include "shapes.h"
#include "stimuli/pictures/difference.h"

namespace seamline::renderer {
namespace {

using test::scene_of;

Light sun_only() {
  Light light;
  light.bounces = 0;
  light.suns.push_back({Eigen::Vector3f(0.8F, 1, 0.3F).normalized(), Rgb::Constant(6.0F), 0.0F});
  return light;
}

Light sun_sky_bounce() {
  Light light = sun_only();
  light.bounces = 3;
  light.environment_radiance = Rgb(0.5F, 0.6F, 0.8F);
  return light;
}

/// A floor, a wall and an occluder with an object before them.
TruthScene courtyard(const Light& light) {
  test::SceneParts parts;
  parts.background = {test::floor(-1, 30), test::box({-4, -1, -9}, {4, 2, -8}, 0.5F),
                      test::box({1, -1, -5}, {1.6F, 1.5F, -4.4F}, 0.5F)};
  parts.objects[0] = {test::sphere({0.2F, -0.3F, -5.5F}, 0.7F, 48, 0.5F, 1)};
  parts.objects[1] = {test::sphere({-1.8F, -0.5F, -5.0F}, 0.5F, 24, 0.5F, 2)};
  return scene_of(std::move(parts), light, 96, 54);
}

StimulusSums stimulus(const TruthScene& scene, const ObjectGeometry& geometry, int depth_width_px,
                      const Recipe& recipe, int spp, std::uint64_t seed) {
  const TruthSums truth = render_truth(scene, geometry, {.spp = spp, .seed = seed, .threads = 2});
  std::optional<Geometry> depth;
  if (depth_width_px > 0)
    depth.emplace(build_depth_mesh(capture_depth(geometry.truth, depth_width_px, 0, 2), {}),
                  Rgb::Constant(0.5F));
  return render_stimulus(scene, geometry, depth ? &*depth : nullptr, truth, recipe,
                         {.spp = spp, .seed = seed, .threads = 2});
}

TEST(Composite, NoneIsTheReferenceOnEveryPixelWithTheSameSamplePoints) {
  const TruthScene scene = courtyard(sun_sky_bounce());
  const ObjectGeometry geometry = object_geometry(scene, 1);
  const TruthSums truth = render_truth(scene, geometry, {.spp = 8, .threads = 2});
  const Composite none = compose(render_stimulus(
      scene, geometry, nullptr, truth, recipe(Artifact::none, Isolation::query), {.spp = 8, .threads = 2}));
  const Image reference = reference_image(truth);
  for (std::size_t i = 0; i < reference.values.size(); ++i)
    ASSERT_NEAR(none.picture.values[i], reference.values[i], 2e-5) << i;
}

/// Whether a sun ray from anywhere along the pixel's view ray comes near the object's bounding sphere: no
/// receiver, true or from the depth mesh, outside of this can lie in the object's shadow.
bool near_the_shadow(const TruthScene& scene, int x, int y) {
  for (int step = 0; step < 4000; ++step) {
    const Eigen::Vector3f direction =
        scene.camera.direction(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
    const Eigen::Vector3f point = direction * (0.01F * static_cast<float>(step));
    // A generous bounding sphere of the object makes up for the pixel's other samples.
    const Eigen::Vector3f to_centre = Eigen::Vector3f(0.2F, -0.3F, -5.5F) - point;
    const Eigen::Vector3f& sun = scene.light.suns[0].to_sun;
    const float along = to_centre.dot(sun);
    if (along > 0 && (to_centre - along * sun).norm() < 0.85F) return true;
  }
  return false;
}

TEST(Composite, RatioIsExactlyOneOutsideTheShadowWithSunOnly) {
  const TruthScene scene = courtyard(sun_only());
  const ObjectGeometry geometry = object_geometry(scene, 1);
  std::vector<bool> is_near;
  for (int y = 0; y < scene.camera.height_px; ++y)
    for (int x = 0; x < scene.camera.width_px; ++x) is_near.push_back(near_the_shadow(scene, x, y));
  for (const Artifact artifact : {Artifact::none, Artifact::receiver, Artifact::overlap, Artifact::all}) {
    const Composite composite =
        compose(stimulus(scene, geometry, 256, recipe(artifact, Isolation::query), 4, 1));
    int darker = 0;
    for (int y = 0; y < composite.ratio.height_px; ++y)
      for (int x = 0; x < composite.ratio.width_px; ++x) {
        darker += composite.ratio.at(x, y) < 1.0F ? 1 : 0;
        ASSERT_LE(composite.ratio.at(x, y), 1.0F);
        if (!is_near[static_cast<std::size_t>(y * composite.ratio.width_px + x)]) {
          ASSERT_EQ(composite.ratio.at(x, y), 1.0F) << word(artifact) << " " << x << " " << y;
        }
      }
    EXPECT_GT(darker, 10);
  }
}

TEST(Composite, RatioIsExactlyOneEverywhereForAnObjectInASealedRoom) {
  TruthScene scene = courtyard(sun_sky_bounce());
  scene.background.push_back(test::box({20, -1, -20}, {24, 3, -16}, 0.5F));
  scene.objects[0] = {test::sphere({22, 0, -18}, 0.7F, 32, 0.5F, 1)};
  const ObjectGeometry geometry = object_geometry(scene, 1);
  const TruthSums truth = render_truth(scene, geometry, {.spp = 8, .threads = 2});
  const Composite none = compose(render_stimulus(
      scene, geometry, nullptr, truth, recipe(Artifact::none, Isolation::query), {.spp = 8, .threads = 2}));
  for (const float ratio : none.ratio.values) ASSERT_EQ(ratio, 1.0F);
}

TEST(Composite, EverythingFromADepthMeshThatIsTheTruthEqualsTheReference) {
  // The table's machinery with the truth in the depth mesh's place: every D row must give what its T row
  // gives.
  const TruthScene scene = courtyard(sun_sky_bounce());
  const ObjectGeometry geometry = object_geometry(scene, 1);
  const Geometry twin = scene.geometry_without(1);
  const PassOptions options{.spp = 8, .seed = 1, .threads = 2};
  const TruthSums truth = render_truth(scene, geometry, options);
  const Image reference = reference_image(truth);
  for (const Isolation isolation : {Isolation::query, Isolation::mask})
    for (const Artifact artifact : every_artifact) {
      StimulusSums sums =
          render_stimulus(scene, geometry, &twin, truth, recipe(artifact, isolation), options);
      sums.depth_lights_uncovered =
          false;  // leave the pockets' filter out: identity sample by sample is asked
      const Composite composite = compose(sums);
      for (std::size_t i = 0; i < reference.values.size(); ++i)
        ASSERT_NEAR(composite.picture.values[i], reference.values[i], 1e-4)
            << word(artifact) << " " << word(isolation) << " " << i;
    }
}

TEST(Composite, PointOfTheObjectBehindTheDepthMeshIsLitFromTheMeshsOwnSurface) {
  // The depth mesh runs 5 cm before the object's face: asked from the face itself, all of the object would be
  // sealed in.
  const Geometry sheet(std::vector{
      test::part_of({{-9, -9, -3.95F}, {9, -9, -3.95F}, {0, 9, -3.95F}}, {{0, 1, 2}}, 0.5F, "sheet")});
  const Geometry object(std::vector{test::box({-1, -1, -5}, {1, 1, -4}, 0.5F, 1)});
  Light light;
  light.bounces = 0;
  light.suns.push_back({Eigen::Vector3f(0.2F, 0.3F, 1).normalized(), Rgb::Constant(3.0F), 0.0F});
  const Ray ray{Eigen::Vector3f::Zero(), {0, 0, -1}};
  const auto face = object.nearest(ray), mesh = sheet.nearest(ray);
  ASSERT_TRUE(face && mesh && mesh->distance_m < face->distance_m);
  const Sampler sampler(1, 0, 0, 0);
  const RealQuestion from_face{&sheet, &*face}, from_mesh{&sheet, &*mesh};
  EXPECT_EQ(leaving_object(ObjectQuestions::all_of(from_face), object, *face, light, sampler).total()[0],
            0.0F);
  EXPECT_GT(leaving_object(ObjectQuestions::all_of(from_mesh), object, *face, light, sampler).total()[0],
            0.4F);
}

TEST(Composite, AdditiveFormEqualsTheRatioWhereTheLocalSceneIsTheTruth) {
  const TruthScene scene = courtyard(sun_sky_bounce());
  const StimulusSums sums =
      stimulus(scene, object_geometry(scene, 1), 0, recipe(Artifact::none, Isolation::query), 8, 1);
  const Composite ratio = compose(sums), additive = compose(sums, Compositing::additive);
  for (std::size_t i = 0; i < ratio.picture.values.size(); ++i)
    ASSERT_NEAR(ratio.picture.values[i], additive.picture.values[i], 2e-5);
}

TEST(Composite, ShadowStimulusDiffersOnTheObjectOnlyAndOverlapOffItOnly) {
  const TruthScene scene = courtyard(sun_sky_bounce());
  const ObjectGeometry geometry = object_geometry(scene, 1);
  const PassOptions options{.spp = 8, .seed = 1, .threads = 2};
  const TruthSums truth = render_truth(scene, geometry, options);
  const Geometry depth(build_depth_mesh(capture_depth(geometry.truth, 64, 0, 2), {}), Rgb::Constant(0.5F));
  const Image reference = reference_image(truth), matte = matte_image(truth);
  for (const Isolation isolation : {Isolation::query, Isolation::mask})
    for (const Artifact artifact : {Artifact::shadow, Artifact::overlap}) {
      const Composite composite =
          compose(render_stimulus(scene, geometry, &depth, truth, recipe(artifact, isolation), options));
      double on = 0, off = 0;
      for (int y = 0; y < reference.height_px; ++y)
        for (int x = 0; x < reference.width_px; ++x) {
          const double difference = (composite.picture.rgb(x, y) - reference.rgb(x, y)).abs().sum();
          if (matte.at(x, y) == 0.0F) off += difference;
          if (matte.at(x, y) == 1.0F) on += difference;
        }
      EXPECT_LT(artifact == Artifact::shadow ? off : on, 2e-2) << word(isolation) << " " << word(artifact);
      EXPECT_GT(artifact == Artifact::shadow ? on : off, 1.0) << word(isolation) << " " << word(artifact);
    }
}

TEST(Composite, DifferenceFallsAtEveryDoublingInARoomWithoutDepthJumps) {
  // Inside a convex box nothing hides anything: no sheets, so the mesh converges to the room.
  test::SceneParts parts;
  parts.background = {test::box({-3, -1.2F, -6}, {3.2F, 2.3F, 3}, 0.5F)};
  parts.objects[0] = {test::sphere({-1.2F, -0.4F, -5.0F}, 0.5F, 48, 0.5F, 1),
                      test::box({-1.3F, -1.2F, -5.1F}, {-1.1F, -0.6F, -4.9F}, 0.5F, 1)};
  Light light;
  light.bounces = 0;
  light.environment_radiance = Rgb::Zero();
  // A sun inside the room: the room itself does not shadow it in question 2, which the truth answers in
  // `receiver`.
  light.suns.push_back({Eigen::Vector3f(1.0F, 0.5F, 0.55F).normalized(), Rgb::Constant(6.0F), 0.0F});
  TruthScene scene = scene_of(std::move(parts), light, 160, 90);
  scene.background = {test::box({-3, -1.2F, -6}, {3.2F, 2.3F, 3}, 0.5F)};
  // Open the room towards the sun: leave out the ceiling and the right wall.
  auto open = std::make_shared<SurfaceMesh>(*scene.background[0]);
  std::erase_if(open->triangles, [&](const Triangle& t) {
    const auto on = [&](auto test) {
      return test(open->positions_m[t[0]]) && test(open->positions_m[t[1]]) && test(open->positions_m[t[2]]);
    };
    return on([](const Eigen::Vector3f& v) { return v.y() > 2; }) ||
           on([](const Eigen::Vector3f& v) { return v.x() > 3; }) ||
           on([](const Eigen::Vector3f& v) { return v.z() > 2; });
  });
  scene.background = {open};
  const ObjectGeometry geometry = object_geometry(scene, 1);
  const TruthSums truth = render_truth(scene, geometry, {.spp = 16, .threads = 2});
  const Image reference = reference_image(truth);
  double last = 1e30;
  for (const int width_px : {64, 128, 256, 512, 1024, 2048, 4096}) {
    const Geometry depth(build_depth_mesh(capture_depth(geometry.truth, width_px, 0, 2), {}),
                         Rgb::Constant(0.5F));
    const Composite composite =
        compose(render_stimulus(scene, geometry, &depth, truth, recipe(Artifact::receiver, Isolation::query),
                                {.spp = 16, .threads = 2}));
    const double difference = display_rmse(composite.picture, reference, 0);
    EXPECT_LT(difference, last) << width_px;
    last = difference;
  }
}

}  // namespace
}  // namespace seamline::renderer
