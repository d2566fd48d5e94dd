// Three laws of the pixel (documentation/developers/design.md, section 2) on the built-in scenes, small
// pictures, both isolations.
#include <gtest/gtest.h>

#include <map>

#include "renderer/depth/capture.h"
#include "renderer/depth/depth_mesh.h"
#include "renderer/estimators/path/path_depth_pass.h"
#include "renderer/picture/composite.h"
#include "stimuli/pictures/difference.h"
#include "stimuli/study_file/study_file.h"
#include "tests/renderer/small_pictures.h"

namespace seamline::renderer {
namespace {

using test::paper_study;
using test::picture_height_px;
using test::picture_width_px;
using test::scene_named;
using test::threads;

/// One virtual object of a built-in scene, with what its stimuli share.
class Bench {
 public:
  Bench(const SceneDefinition& definition, int object_index)
      : scene_(load_truth_scene(definition, picture_width_px, picture_height_px)),
        geometry_(object_geometry(scene_, object_index)) {}

  [[nodiscard]] TruthSums truth(std::uint64_t seed, int spp) const {
    return render_truth(scene_, geometry_, {.spp = spp, .seed = seed, .threads = threads});
  }

  [[nodiscard]] Composite composite(Artifact artifact, Isolation isolation, int depth_width_px,
                                    const TruthSums& truth, std::uint64_t seed) {
    const Recipe how = recipe(artifact, isolation);
    const Geometry* depth = how.answers.needs_depth() ? &depth_of(depth_width_px) : nullptr;
    return compose(render_stimulus(scene_, geometry_, depth, truth, how,
                                   {.spp = truth.spp, .seed = seed, .threads = threads}));
  }

  [[nodiscard]] double exposure_ev() const { return scene_.definition.exposure_ev; }

 private:
  const Geometry& depth_of(int width_px) {
    auto found = depths_.find(width_px);
    if (found == depths_.end())
      found =
          depths_
              .emplace(width_px,
                       Geometry(build_depth_mesh(capture_depth(geometry_.truth, width_px, 0, threads), {}),
                                Rgb::Constant(static_cast<float>(scene_.definition.albedo))))
              .first;
    return found->second;
  }

  TruthScene scene_;
  ObjectGeometry geometry_;
  std::map<int, Geometry> depths_;
};

/// Pixels where an artifact may show: the object for `shadow`, off the object for `receiver` and `overlap`,
/// all for `occlusion`.
Image region(Artifact artifact, const TruthSums& truth) {
  Image mask = matte_image(truth);
  for (float& value : mask.values) {
    const bool covered = value > 0.5F;
    value = artifact == Artifact::occlusion || (artifact == Artifact::shadow) == covered ? 1.0F : 0.0F;
  }
  return mask;
}

std::vector<std::string> scene_names() {
  return {"bedroom", "gazebo", "atrium"};
}

class BuiltinScene : public testing::TestWithParam<std::string> {};

TEST_P(BuiltinScene, NoneWithAnotherSeedEqualsTheReferenceWithinNoise) {
  Bench bench(scene_named(GetParam()), 2);
  const int spp = 8;
  const TruthSums first = bench.truth(1, spp), second = bench.truth(2, spp), third = bench.truth(3, spp);
  const Image none = bench.composite(Artifact::none, Isolation::query, 0, second, 2).picture;
  const double difference = display_rmse(none, reference_image(first), bench.exposure_ev());
  const double noise = display_rmse(reference_image(third), reference_image(first), bench.exposure_ev());
  EXPECT_LT(difference, 1.1 * noise);
  // No bias either: the mean over the picture agrees within 4 standard errors of the noise.
  double sum = 0;
  const Image reference = reference_image(first);
  for (std::size_t i = 0; i < none.values.size(); ++i)
    sum += double{none.values[i]} - double{reference.values[i]};
  double square = 0;
  for (std::size_t i = 0; i < none.values.size(); ++i)
    square += std::pow(double{none.values[i]} - double{reference.values[i]}, 2);
  EXPECT_LT(std::abs(sum), 4 * std::sqrt(3 * square));  // the three channels share their noise
}

TEST_P(BuiltinScene, NoiseOnTheCompositedObjectIsTheReferencesNoise) {
  const SceneDefinition scene = scene_named(GetParam());
  Bench bench(scene, 1);
  const int spp = 8;
  const TruthSums first = bench.truth(1, spp), second = bench.truth(2, spp);
  Image on_object = matte_image(first);
  for (float& value : on_object.values) value = value > 0.99F ? 1.0F : 0.0F;
  const double expected =
      display_rmse(reference_image(first), reference_image(second), bench.exposure_ev(), &on_object);
  for (const Isolation isolation : {Isolation::query, Isolation::mask})
    for (const Artifact artifact : scene.artifacts) {
      const double found = display_rmse(bench.composite(artifact, isolation, 512, first, 1).picture,
                                        bench.composite(artifact, isolation, 512, second, 2).picture,
                                        bench.exposure_ev(), &on_object);
      EXPECT_NEAR(found / expected, 1.0, 0.2) << word(artifact) << " " << word(isolation);
    }
}

TEST_P(BuiltinScene, DifferenceFallsFrom64To512To4096) {
  const SceneDefinition scene = scene_named(GetParam());
  std::map<std::pair<Isolation, Artifact>, std::map<int, double>> squares;
  for (int object = 1; object <= 3; ++object) {
    Bench bench(scene, object);
    // Same sample points: what is left in the difference is the artifact.
    const TruthSums truth = bench.truth(1, 8);
    const Image reference = reference_image(truth);
    for (const Isolation isolation : {Isolation::query, Isolation::mask})
      for (const Artifact artifact : scene.artifacts) {
        const Image where = region(artifact, truth);
        for (const int width_px : {64, 512, 4096})
          squares[{isolation, artifact}][width_px] +=
              std::pow(display_rmse(bench.composite(artifact, isolation, width_px, truth, 1).picture,
                                    reference, bench.exposure_ev(), &where),
                       2);
      }
  }
  for (const auto& [key, by_width] : squares) {
    const auto rms = [&](int width_px) { return std::sqrt(by_width.at(width_px) / 3); };
    EXPECT_GT(rms(64), rms(512)) << word(key.first) << " " << word(key.second);
    EXPECT_GT(rms(512), rms(4096)) << word(key.first) << " " << word(key.second);
    RecordProperty(
        std::string(word(key.first)) + "_" + std::string(word(key.second)),
        std::to_string(rms(64)) + " " + std::to_string(rms(512)) + " " + std::to_string(rms(4096)));
    std::printf("%s %s %s: rms display difference %.4f at 64, %.4f at 512, %.4f at 4096\n",
                GetParam().c_str(), word(key.first).data(), word(key.second).data(), rms(64), rms(512),
                rms(4096));
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, BuiltinScene, testing::ValuesIn(scene_names()),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace seamline::renderer
