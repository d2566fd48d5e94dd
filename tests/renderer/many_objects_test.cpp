// Scenes of other numbers of objects than the paper's three: one truth pass holds a world for each.
#include <gtest/gtest.h>

#include "renderer/estimators/estimator.h"
#include "renderer/estimators/fast/fast_truth_pass.h"
#include "stimuli/pictures/difference.h"
#include "tests/renderer/shapes.h"

namespace seamline::renderer {
namespace {

/// A floor, a wall and so many balls from left to right; `left_out` (from 1) of them is not there, and those
/// behind it count one less.
TruthScene balls(int objects, int left_out = 0) {
  test::SceneParts parts;
  parts.background = {test::floor(-1, 6), test::box({-6, -2, -8}, {6, 4, -7.8F}, 0.6F)};
  parts.objects.clear();
  for (int k = 1; k <= objects; ++k) {
    if (k == left_out) continue;
    const float x =
        3.2F * (static_cast<float>(k) - 0.5F * static_cast<float>(objects + 1)) / static_cast<float>(objects);
    // They cover each other here and there.
    parts.objects.push_back(
        {test::sphere({x, -0.6F, k % 2 == 0 ? -4.0F : -4.6F}, 0.36F, 24, 0.3F + 0.05F * static_cast<float>(k),
                      static_cast<int>(parts.objects.size()) + 1)});
  }
  Light light;
  light.environment_radiance = Rgb(0.3F, 0.4F, 0.5F);
  light.suns = {{Eigen::Vector3f(0.5F, 1, 0.4F).normalized(), Rgb::Constant(1.5F), 0}};
  light.bounces = 2;
  return test::scene_of(std::move(parts), std::move(light), 64, 36);
}

SceneSums sampled(const TruthScene& scene, int spp) {
  SceneSums sums = empty_sums(scene.camera, scene.objects.size());
  add_samples(scene, SceneGeometry(scene), std::vector<int>(sums.spp.size(), spp),
              {.seed = 3, .threads = 2, .who_is_in_front = true}, sums);
  return sums;
}

class ManyObjects : public testing::TestWithParam<int> {};
class SeveralObjects : public testing::TestWithParam<int> {};

/// What world k shows is what a scene shows that never had object k, sample by sample.
TEST_P(SeveralObjects, AWorldIsTheSceneWithoutItsObject) {
  const int objects = GetParam();
  const SceneSums together = sampled(balls(objects), 4);
  EXPECT_EQ(together.halves[0].size(), std::size_t{64} * 36 * together.groups);
  for (int k = 1; k <= objects; ++k) {
    const SceneSums alone = sampled(balls(objects, k), 4);
    std::size_t others = 0;
    for (std::size_t half = 0; half < 2; ++half)
      for (std::size_t pixel = 0; pixel < std::size_t{64} * 36; ++pixel) {
        const Rgb here = together.seen(half, pixel, static_cast<std::size_t>(k)).total();
        const Rgb there = alone.seen(half, pixel, 0).total();
        EXPECT_EQ(together.surfaces(half, pixel, static_cast<std::size_t>(k)),
                  alone.surfaces(half, pixel, 0));
        others += here.isApprox(there, 1e-3F) ? 0 : 1;
      }
    EXPECT_LT(others, std::size_t{64} * 36 * 2U / 500U) << k << " of " << objects;  // rays along edges
  }
}

/// The unbiased estimator has a pass of its own for each object.
TEST_P(ManyObjects, FastAgreesWithPathForEachObject) {
  const TruthScene scene = balls(GetParam());
  const auto fast = make_estimator(Estimator::fast, scene, {.spp = 32, .seed = 1, .threads = 2});
  const auto path = make_estimator(Estimator::path, scene, {.spp = 32, .seed = 7, .threads = 2});
  EXPECT_EQ(fast->truth_pieces(), 1);
  EXPECT_EQ(path->truth_pieces(), GetParam());
  const Recipe none = recipe(Artifact::none, Isolation::query);
  for (const int k : scene.object_indices()) {
    fast->take_object(k, {});
    path->take_object(k, {});
    const Geometry nothing(std::span<const std::shared_ptr<const SurfaceMesh>>{});
    const EstimatedStimulus a = fast->stimulus(none, &nothing, {}), b = path->stimulus(none, &nothing, {});
    EXPECT_LT(display_rmse(compose(a.sums).picture, compose(b.sums).picture, 0),
              1.3 * std::hypot(*a.rmse, *b.rmse))
        << k;
    EXPECT_LT(display_rmse(background_image(fast->truth()), background_image(path->truth()), 0),
              1.3 * std::hypot(*a.rmse, *b.rmse))
        << k;
  }
}

/// What another process made of the truth is the truth.
TEST_P(ManyObjects, ATruthIsReadAsItWasWritten) {
  const TruthScene scene = balls(GetParam());
  const auto made = make_estimator(Estimator::fast, scene, {.spp = 4, .seed = 1, .threads = 2});
  ByteWriter out;
  made->write_truth(1, out, {});
  const auto read = make_estimator(Estimator::fast, scene, {.spp = 4, .seed = 1, .threads = 2});
  ByteReader in(out.bytes());
  ASSERT_TRUE(read->read_truth(1, in));
  for (const int k : scene.object_indices()) {
    made->take_object(k, {});
    read->take_object(k, {});
    EXPECT_EQ(reference_image(made->truth()).values, reference_image(read->truth()).values) << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Objects, ManyObjects, testing::Values(1, 2, 3, 5, 8));
INSTANTIATE_TEST_SUITE_P(Objects, SeveralObjects, testing::Values(2, 3, 5, 8));

}  // namespace
}  // namespace seamline::renderer
