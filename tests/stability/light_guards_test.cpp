// Each guard that keeps light and space stable is taken away, and the case that watches it must fail.
#include <gtest/gtest.h>

#include "laboratory/stability/depth/contact_cases.h"
#include "laboratory/stability/light/pocket_cases.h"
#include "laboratory/stability/light/ratio_cases.h"
#include "laboratory/stability/light/space_scale_cases.h"

namespace seamline::stability {
namespace {

/// background * with / without, and nothing else.
Composite plain_ratio(const StimulusSums& sums) {
  Composite out{Image(sums.width_px, sums.height_px, 3), Image(sums.width_px, sums.height_px, 3, 1.0F), {}};
  for (int y = 0; y < sums.height_px; ++y)
    for (int x = 0; x < sums.width_px; ++x) {
      const std::size_t i = out.picture.index(x, y) / 3;
      StimulusPixel pixel = sums.halves[0][i];
      pixel += sums.halves[1][i];
      const Rgb ratio = pixel.with_object / pixel.without_object;
      out.ratio.set_rgb(x, y, ratio);
      out.picture.set_rgb(
          x, y, (pixel.sky + pixel.background * ratio + pixel.object) / static_cast<float>(sums.spp));
    }
  return out;
}

bool passes(const Finding& finding, double tolerance = 0) {
  return finding.error <= tolerance;
}

TEST(LightGuards, PlainRatioFailsOnEveryDenominator) {
  for (const float denominator : {0.0F, 1e-30F, 1e-40F}) {
    EXPECT_TRUE(passes(try_denominator(denominator))) << denominator;
    EXPECT_FALSE(passes(try_denominator(denominator, plain_ratio))) << denominator;
  }
}

TEST(LightGuards, PlainRatioIsNotClamped) {
  EXPECT_TRUE(passes(try_brightened(1e30F)));
  EXPECT_FALSE(passes(try_brightened(1e30F, plain_ratio)));
}

TEST(LightGuards, FaceBehindASheetIsDarkWhenAskedFromItself) {
  EXPECT_TRUE(passes(try_face_behind_sheet(), 1e-6));
  EXPECT_FALSE(passes(try_face_behind_sheet(false), 0.5));
}

TEST(LightGuards, RaysThatStartOnTheirSurfaceHitIt) {
  EXPECT_TRUE(passes(try_leaving_rays()));
  const Finding naive =
      try_leaving_rays([](const SurfacePoint& point, const Eigen::Vector3f&) { return point.position_m; });
  EXPECT_GT(naive.error, 100) << naive.found;
}

/// The scene as single precision would have it: rounded before it is brought to the camera.
TruthScene load_in_float(const SceneDefinition& definition, int width_px, int height_px) {
  TruthScene scene = load_truth_scene(definition, width_px, height_px);
  SceneFile file = read_scene_file(definition.path);
  for (FileMesh& mesh : file.meshes)
    for (Eigen::Vector3d& vertex : mesh.positions_m) vertex = vertex.cast<float>().cast<double>();
  scene.background =
      place_meshes(file, Eigen::Affine3d::Identity(), scene.camera_position_m, definition.albedo, 0);
  return scene;
}

TEST(LightGuards, FarScenesInSinglePrecisionAreOtherScenes) {
  const RootNode far_away{.translation_m = {1000000.3, -999999.7, 1000000.1}};
  EXPECT_TRUE(passes(try_root_node(far_away, 2), 0.1));
  EXPECT_FALSE(passes(try_root_node(far_away, 2, load_in_float), 0.1));
}

}  // namespace
}  // namespace seamline::stability
