// The fast estimator against the unbiased one, on small pictures of the built-in scenes.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "renderer/depth/capture.h"
#include "renderer/depth/depth_mesh.h"
#include "renderer/estimators/estimator.h"
#include "stimuli/pictures/difference.h"
#include "stimuli/study_file/study_file.h"
#include "tests/renderer/small_pictures.h"

namespace seamline::renderer {
namespace {

using test::paper_study;
/// The truth and the depth mesh of one scene's middle object.
struct Subject {
  Subject(const SceneDefinition& definition, int width_px)
      : scene(load_truth_scene(definition, width_px, width_px * 9 / 16)),
        depth(build_depth_mesh(capture_depth(scene.geometry_without(2), 256, 0, 2), {}),
              Rgb::Constant(static_cast<float>(definition.albedo))) {}

  [[nodiscard]] std::unique_ptr<SceneEstimator> estimator(Estimator kind, EstimateOptions options) const {
    options.who_is_in_front = true;
    auto made = make_estimator(kind, scene, options);
    made->take_object(2, {});
    return made;
  }
  [[nodiscard]] double exposure_ev() const { return scene.definition.exposure_ev; }

  TruthScene scene;
  Geometry depth;
};

/// Made once for all laws of a scene.
const Subject& subject_of_scene(int scene, int width_px) {
  static std::map<std::pair<int, int>, Subject> made;
  return made.try_emplace({scene, width_px}, paper_study().scenes[static_cast<std::size_t>(scene)], width_px)
      .first->second;
}

/// Half the usual picture's lengths do for most laws.
class EveryScene : public testing::TestWithParam<int> {
 protected:
  const Subject& subject = subject_of_scene(GetParam(), test::picture_width_px / 2);
};

constexpr std::array artifacts = {Artifact::receiver, Artifact::shadow, Artifact::occlusion,
                                  Artifact::overlap,  Artifact::bounce, Artifact::all,
                                  Artifact::none};

TEST_P(EveryScene, FastAgreesWithPathWithinBothErrors) {
  // Not in larger pixels: the wider the filter of bounce light, the larger is its bias.
  const Subject& large = subject_of_scene(GetParam(), test::picture_width_px);
  const auto fast = large.estimator(Estimator::fast, {.spp = 16, .seed = 1, .threads = 2});
  const auto path = large.estimator(Estimator::path, {.spp = 16, .seed = 7, .threads = 2});
  // Under a bright sky, which both sample alike and neither filters, fast has little to gain from its filter
  // of bounce light, and its estimate holds the bias of that: up to 1.16 in the gazebo. The
  // atrium has no bounce light.
  const double largest_ratio = large.scene.definition.ambient_occlusion ? 1.05 : 1.2;
  for (const Isolation isolation : {Isolation::query, Isolation::mask})
    for (const Artifact artifact : artifacts) {
      const Recipe how = recipe(artifact, isolation);
      const EstimatedStimulus a = fast->stimulus(how, &large.depth, {});
      const EstimatedStimulus b = path->stimulus(how, &large.depth, {});
      const double difference =
          display_rmse(compose(a.sums).picture, compose(b.sums).picture, large.exposure_ev());
      EXPECT_LT(difference, 1.15 * std::hypot(*a.rmse, *b.rmse)) << word(artifact) << " " << word(isolation);
      EXPECT_LT(*a.rmse, largest_ratio * *b.rmse) << word(artifact) << " " << word(isolation);
    }
}

/// The paper's isolation: no stimulus takes sky and bounce light of different geometries.
TEST_P(EveryScene, AFilteredSkyAgreesWithPathWithinBothErrors) {
  const Subject& large = subject_of_scene(GetParam(), test::picture_width_px);
  const EstimateOptions options{.spp = 16, .seed = 1, .threads = 2, .light_of_one_geometry = true};
  const auto fast = large.estimator(Estimator::fast, options);
  EXPECT_EQ(fast->choices().filters_sky, !large.scene.definition.ambient_occlusion);
  const auto path = large.estimator(Estimator::path, {.spp = 16, .seed = 7, .threads = 2});
  for (const Artifact artifact : {Artifact::receiver, Artifact::shadow, Artifact::overlap, Artifact::none}) {
    const Recipe how = recipe(artifact, Isolation::mask);
    const EstimatedStimulus a = fast->stimulus(how, &large.depth, {});
    const EstimatedStimulus b = path->stimulus(how, &large.depth, {});
    const double difference =
        display_rmse(compose(a.sums).picture, compose(b.sums).picture, large.exposure_ev());
    EXPECT_LT(difference, 1.15 * std::hypot(*a.rmse, *b.rmse)) << word(artifact);
    // At equal samples the gazebo's holds the filter's bias, as above: up to 1.12. It needs fewer rays a
    // sample.
    EXPECT_LT(*a.rmse, 1.2 * *b.rmse) << word(artifact);
  }
}

/// Sky that is filtered, and kept apart because stimuli take sky of one geometry and bounce light of another.
TEST_P(EveryScene, ASkyKeptApartIsTakenOutOfTheBounceLightAndLeftInTheSum) {
  const EstimateOptions options{.spp = 16, .seed = 1, .threads = 2};
  const auto apart = subject.estimator(Estimator::fast, options);
  EXPECT_EQ(apart->choices().keeps_sky_apart, apart->choices().filters_sky);
  EXPECT_EQ(apart->choices().keeps_sky_apart, !subject.scene.definition.ambient_occlusion);
  EstimateOptions of_one = options;
  of_one.light_of_one_geometry = true;
  const auto together = subject.estimator(Estimator::fast, of_one);
  // The same rays find both, so the photographs differ by what the objects keep apart alone.
  const double difference = display_rmse(background_image(apart->truth()),
                                         background_image(together->truth()), subject.exposure_ev());
  EXPECT_LT(difference, 0.01);
  if (!apart->choices().keeps_sky_apart) return;
  double sky = 0, bounce = 0, both = 0;
  for (std::size_t half = 0; half < 2; ++half)
    for (std::size_t i = 0; i < apart->truth().halves[half].size(); ++i) {
      const Split& one = apart->truth().halves[half][i].without_object;
      const Split& joined = together->truth().halves[half][i].without_object;
      sky += double{one.direct.sum()} - double{joined.direct.sum()};
      bounce += double{one.bounce.sum()};
      both += double{joined.bounce.sum()};
    }
  EXPECT_GT(sky, 0.05 * both);
  EXPECT_NEAR(sky + bounce, both, 0.01 * both);
}

TEST_P(EveryScene, NothingAskedOfTheDepthMeshIsTheReference) {
  const auto fast = subject.estimator(Estimator::fast, {.spp = 8, .seed = 1, .threads = 2});
  const Image none =
      compose(fast->stimulus(recipe(Artifact::none, Isolation::query), nullptr, {}).sums).picture;
  const Image reference = reference_image(fast->truth());
  int others = 0;  // the ratio is clamped to 4, which few samples can pass
  for (std::size_t i = 0; i < none.values.size(); ++i)
    others += std::abs(none.values[i] - reference.values[i]) > 1e-4F * (1.0F + reference.values[i]) ? 1 : 0;
  EXPECT_LE(others, static_cast<int>(none.values.size()) / 1000);
}

TEST_P(EveryScene, SameBytesForAnyNumberOfThreads) {
  std::map<int, Image> pictures;
  for (const int threads : {1, 2, 3}) {
    const auto fast = subject.estimator(Estimator::fast, {.error = 0.03, .seed = 1, .threads = threads});
    pictures[threads] =
        compose(fast->stimulus(recipe(Artifact::all, Isolation::query), &subject.depth, {}).sums).picture;
  }
  EXPECT_EQ(pictures[1].values, pictures[2].values);
  EXPECT_EQ(pictures[1].values, pictures[3].values);
}

TEST_P(EveryScene, SamplesUntilTheErrorIsBelowWhatWasAsked) {
  const double asked = 0.015;
  const auto fast = subject.estimator(Estimator::fast, {.error = asked, .seed = 1, .threads = 2});
  const auto path = subject.estimator(Estimator::path, {.spp = 64, .seed = 7, .threads = 2});
  for (const Artifact artifact :
       {Artifact::receiver, Artifact::shadow, Artifact::occlusion, Artifact::overlap}) {
    const Recipe how = recipe(artifact, Isolation::query);
    const EstimatedStimulus made = fast->stimulus(how, &subject.depth, {});
    EXPECT_LE(*made.rmse, asked) << word(artifact);
    EXPECT_LE(*made.worst_tile, 3 * asked) << word(artifact);
    const EstimatedStimulus reference = path->stimulus(how, &subject.depth, {});
    const double difference =
        display_rmse(compose(made.sums).picture, compose(reference.sums).picture, subject.exposure_ev());
    EXPECT_LT(difference, 1.1 * std::hypot(asked, *reference.rmse)) << word(artifact);
  }
}

TEST_P(EveryScene, NoiseDoesNotGiveTheObjectAway) {
  const auto fast = subject.estimator(Estimator::fast, {.error = 0.006, .seed = 1, .threads = 2});
  const StimulusSums made =
      fast->stimulus(recipe(Artifact::shadow, Isolation::query), &subject.depth, {}).sums;
  // Relative to the object's light, which differs where the depth mesh lets in what the truth keeps out.
  double noise_in_photograph = 0, noise_in_stimulus = 0, light_in_photograph = 0, light_in_stimulus = 0;
  for (std::size_t i = 0; i < made.guides.size(); ++i) {
    const auto& truth = fast->truth().halves;
    const Rgb there[2] = {truth[0][i].object.total(), truth[1][i].object.total()};
    const Rgb here[2] = {made.halves[0][i].object, made.halves[1][i].object};
    noise_in_photograph += double{(there[0] - there[1]).square().sum()};
    noise_in_stimulus += double{(here[0] - here[1]).square().sum()};
    light_in_photograph += double{(there[0] + there[1]).square().sum()};
    light_in_stimulus += double{(here[0] + here[1]).square().sum()};
  }
  EXPECT_GT(noise_in_photograph, 0);
  EXPECT_LT(noise_in_stimulus / light_in_stimulus, 1.44 * noise_in_photograph / light_in_photograph);
}

/// A round makes again what it changed. In one go the same samples give the same sums and errors, to the bit.
TEST(FastRounds, GiveWhatTheirSamplesGiveInOneGo) {
  const Subject& large = subject_of_scene(0, 480);
  const auto fast = large.estimator(Estimator::fast, {.error = 0.006, .seed = 1, .threads = 2});
  int uneven = 0;
  for (const auto& [artifact, isolation] :
       {std::pair{Artifact::receiver, Isolation::query}, std::pair{Artifact::all, Isolation::mask}}) {
    const Recipe how = recipe(artifact, isolation);
    const EstimatedStimulus rounds = fast->stimulus(how, &large.depth, {});
    const EstimatedStimulus once = fast->decided_stimulus(how, &large.depth, *rounds.decision, {});
    const auto [least, most] =
        std::minmax_element(rounds.decision->uncovered.begin(), rounds.decision->uncovered.end());
    uneven += *most > *least ? 1 : 0;
    EXPECT_EQ(*rounds.rmse, *once.rmse) << word(artifact);
    EXPECT_EQ(*rounds.worst_tile, *once.worst_tile) << word(artifact);
    EXPECT_EQ(compose(rounds.sums).picture.values, compose(once.sums).picture.values) << word(artifact);
    for (std::size_t half = 0; half < 2; ++half) {
      EXPECT_EQ(compose_half(rounds.sums, half).picture.values, compose_half(once.sums, half).picture.values);
      EXPECT_EQ(rounds.sums.light_as_sampled[half], once.sums.light_as_sampled[half]);
    }
    for (std::size_t i = 0; i < once.sums.guides.size(); ++i)
      ASSERT_EQ(rounds.sums.guides[i].distance_m, once.sums.guides[i].distance_m) << i;
  }
  EXPECT_EQ(uneven, 2) << "no second round";
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene, testing::Values(0, 1, 2), [](const auto& scene) {
  return paper_study().scenes[static_cast<std::size_t>(scene.param)].name;
});

}  // namespace
}  // namespace seamline::renderer
