// Every omission of the plan: the picture with it and without it differ by no more than the plan says.
#include "sets/render_plan.h"
#include "renderer/depth/depth_mesh.h"
#include "sets/set_work.h"

#include <gtest/gtest.h>

#include <cmath>

#include "renderer/depth/capture.h"
#include "renderer/estimators/estimator.h"
#include "stimuli/pictures/difference.h"
#include "stimuli/study_file/study_file.h"
#include "tests/renderer/small_pictures.h"

namespace seamline::renderer {
namespace {

using test::threads;
constexpr int small_width_px = 96, small_height_px = 54, depth_width_px = 128;

StudyDefinition isolated_study() {
  return read_study(std::filesystem::path(SEAMLINE_SOURCE_DIR) / "stimuli" /
                    "depth_resolution_isolated.toml");
}

SceneDefinition isolated_scene(const std::string& name) {
  return test::scene_named(name, isolated_study());
}

struct Rendered {
  Image picture;
  double rmse = 0;
  Savings savings;
};

/// One stimulus of a scene's second object.
class SecondObject {
 public:
  explicit SecondObject(const SceneDefinition& definition)
      : scene_(load_truth_scene(definition, small_width_px, small_height_px)) {}

  [[nodiscard]] Rendered render(Artifact artifact, EstimateOptions options) const {
    options.threads = threads;
    const std::unique_ptr<SceneEstimator> estimator = make_fast_estimator(scene_, options);
    estimator->take_object(2, {});
    if (!depth_)  // whatever is left out, it is the same
      depth_.emplace(
          build_depth_mesh(capture_depth(estimator->geometry().truth, depth_width_px, 0, threads), {}),
          Rgb::Constant(static_cast<float>(scene_.definition.albedo)));
    const EstimatedStimulus made = estimator->stimulus(recipe(artifact, Isolation::query), &*depth_, {});
    return {compose(made.sums).picture, made.rmse.value(), estimator->savings()};
  }

  [[nodiscard]] double difference(const Rendered& a, const Rendered& b) const {
    return display_rmse(a.picture, b.picture, scene_.definition.exposure_ev);
  }
  [[nodiscard]] const TruthScene& scene() const { return scene_; }

 private:
  TruthScene scene_;
  mutable std::optional<Geometry> depth_;
};

/// With everything left out, and with one omission turned off.
struct Pair {
  Rendered with, without;
};
Pair render_pair(const SecondObject& bench, Artifact artifact, EstimateOptions options, const char* name) {
  const Rendered with = bench.render(artifact, options);
  options.omit = omissions_without({name});
  return {with, bench.render(artifact, options)};
}

void expect_within_errors(const SecondObject& bench, const Pair& pair) {
  const double difference = bench.difference(pair.with, pair.without);
  EXPECT_GT(difference, 0.0);
  EXPECT_LT(difference, 3 * std::hypot(pair.with.rmse, pair.without.rmse));
}

TEST(RenderPlan, PathTailsChangeNoMoreThanTheEstimatedErrors) {
  const SecondObject bench(isolated_scene("bedroom"));
  for (const Artifact artifact : {Artifact::receiver, Artifact::bounce}) {
    const Pair pair = render_pair(bench, artifact, {.spp = 16}, "path_tails");
    expect_within_errors(bench, pair);
    EXPECT_GT(pair.with.savings.counts().tails_left_out, 2 * pair.with.savings.counts().tails_traced);
    EXPECT_EQ(pair.without.savings.counts().tails_left_out, 0);
  }
}

TEST(RenderPlan, TheBounceFilterChangesNoMoreThanTheEstimatedErrors) {
  const SecondObject bench(isolated_scene("bedroom"));
  for (const Artifact artifact : {Artifact::receiver, Artifact::bounce})
    expect_within_errors(bench, render_pair(bench, artifact, {.spp = 16}, "bounce_filter"));
}

TEST(RenderPlan, RatioSamplesChangeNoMoreThanTheEstimatedErrors) {
  const SecondObject bench(isolated_scene("bedroom"));
  const Pair pair = render_pair(bench, Artifact::receiver, {.error = 0.02}, "ratio_samples");
  expect_within_errors(bench, pair);
  EXPECT_GT(pair.with.savings.ratio_samples, 0);
  EXPECT_EQ(pair.without.savings.ratio_samples, 0);
}

TEST(RenderPlan, UntouchedTilesChangeNothing) {
  const SecondObject bench(isolated_scene("gazebo"));
  for (const EstimateOptions& options : {EstimateOptions{.spp = 8}, EstimateOptions{.error = 0.03}}) {
    const Pair pair = render_pair(bench, Artifact::shadow, options, "untouched_tiles");
    EXPECT_EQ(pair.with.picture.values, pair.without.picture.values);
    EXPECT_GT(pair.with.savings.untouched_blocks, 0);
    EXPECT_EQ(pair.without.savings.untouched_blocks, 0);
  }
}

TEST(RenderPlan, WhoIsInFrontChangesNothingForOtherArtifacts) {
  const SecondObject bench(isolated_scene("gazebo"));
  for (const EstimateOptions& options : {EstimateOptions{.spp = 8}, EstimateOptions{.error = 0.03}})
    for (const Artifact artifact : {Artifact::shadow, Artifact::overlap}) {
      const Pair pair = render_pair(bench, artifact, options, "who_is_in_front");
      EXPECT_EQ(pair.with.picture.values, pair.without.picture.values) << word(artifact);
      EXPECT_GT(pair.with.savings.order_bytes, 0);
    }
}

TEST(RenderPlan, LateBouncesChangeNoMoreThanTheirBound) {
  SceneDefinition definition = isolated_scene("bedroom");
  definition.bounces = 64;
  definition.exposure_ev = -3;
  const SecondObject bench(definition);
  const BounceLimit limit = needed_bounces(light_facts(bench.scene()), definition.exposure_ev, std::nullopt);
  EXPECT_LT(limit.bounces, 64);
  EXPECT_GT(limit.bounces, 4);
  EXPECT_GT(limit.change, 0.0);
  EXPECT_LE(limit.change, 0.1 / 255);
  for (const Artifact artifact : {Artifact::receiver, Artifact::bounce}) {
    const Pair pair = render_pair(bench, artifact, {.spp = 8}, "late_bounces");
    EXPECT_LE(bench.difference(pair.with, pair.without), limit.change) << word(artifact);
  }
}

TEST(RenderPlan, LateBouncesFollowAlbedoErrorAndEmission) {
  LightFacts facts{.brightest_albedo = 0.5, .brightest_radiance = 3, .bounces = 64};
  const int bounces = needed_bounces(facts, 0, 0.004).bounces;
  EXPECT_GT(bounces, needed_bounces(facts, 0, 0.04).bounces);
  EXPECT_EQ(needed_bounces(facts, 1, 0.004).bounces, bounces + 1);  // twice as bright, half the albedo
  facts.brightest_albedo = 1;
  EXPECT_EQ(needed_bounces(facts, 0, 0.004).bounces, 64);
  facts.brightest_albedo = 0.5;
  facts.emits = true;
  EXPECT_EQ(needed_bounces(facts, 0, 0.004).bounces, 64);
  facts.emits = false;
  facts.bounces = 2;
  EXPECT_EQ(needed_bounces(facts, 0, 0.004).bounces, 2);
}

TEST(RenderPlan, ADarkSkyChangesNothing) {
  SceneDefinition definition = isolated_scene("bedroom");
  definition.environment_radiance = {0, 0, 0};
  for (const int bounces : {0, 2}) {
    definition.bounces = bounces;
    const SecondObject bench(definition);
    for (const Artifact artifact : {Artifact::receiver, Artifact::shadow, Artifact::bounce}) {
      const Pair pair = render_pair(bench, artifact, {.spp = 4}, "dark_sky");
      EXPECT_EQ(pair.with.picture.values, pair.without.picture.values) << word(artifact) << bounces;
      EXPECT_GT(pair.with.savings.counts().dark_sky_rays, 0);
      EXPECT_EQ(pair.without.savings.counts().dark_sky_rays, 0);
    }
  }
}

TEST(RenderPlan, SaysOfEveryOmissionWhetherItIsMade) {
  const StudyDefinition study = isolated_study();
  const std::map<std::string, LightFacts> lights = lights_of(study);
  for (const Estimator estimator : {Estimator::fast, Estimator::path}) {
    const RenderPlan plan = render_plan(
        study, lights, {.estimator = estimator, .error = 0.0039, .omit = omissions_without({"path_tails"})});
    ASSERT_EQ(plan.scenes.size(), 3U);
    for (const ScenePlan& scene : plan.scenes)
      for (const OmissionName& one : omission_names) {
        const auto named = [&](const auto& entry) { return entry.name == one.name; };
        const auto made = std::count_if(scene.omissions.begin(), scene.omissions.end(), named);
        const auto not_made = std::count_if(scene.not_omitted.begin(), scene.not_omitted.end(), named);
        EXPECT_EQ(made + not_made, 1) << scene.scene << " " << one.name;
        EXPECT_TRUE(made == 0 || (one.name != "path_tails" && estimator == Estimator::fast));
      }
  }
}

TEST(RenderPlan, TheEstimatorHoldsToWhatThePlanSays) {
  StudyDefinition study = isolated_study();
  study.width_px = small_width_px;
  study.height_px = small_height_px;
  const std::map<std::string, LightFacts> lights = lights_of(study);
  const StimuliOfTruths stimuli = stimuli_of_truths(study);
  std::vector<TruthScene> scenes;
  for (const SceneDefinition& scene : study.scenes)
    scenes.push_back(load_truth_scene(scene, study.width_px, study.height_px));
  for (const Estimator estimator : {Estimator::fast, Estimator::path})
    for (const std::optional<double> error : {std::optional<double>{}, std::optional<double>{0.02}}) {
      const RenderSettings settings{.spp = 5, .estimator = estimator, .error = error};
      const RenderPlan plan = render_plan(study, lights, settings);
      for (std::size_t i = 0; i < study.scenes.size(); ++i) {
        const auto made = make_estimator(
            estimator, scenes[i], estimate_options(stimuli.at(study.scenes[i].name), settings, threads));
        EXPECT_TRUE(made->choices() == plan.scenes[i].choices) << plan.scenes[i].scene;
      }
    }
}

TEST(RenderPlan, EveryStimulusBelongsToOneTruth) {
  const StudyDefinition study = isolated_study();
  std::size_t stimuli = 0;
  for (const auto& [truth, of_truth] : stimuli_of_truths(study)) {
    stimuli += of_truth.size();
    for (const Stimulus& stimulus : of_truth) EXPECT_EQ(truth_of(stimulus), truth);
  }
  EXPECT_EQ(stimuli, list_stimuli(study).size());
}

TEST(RenderPlan, SaysTheSameForTheSameInput) {
  const StudyDefinition study = isolated_study();
  const auto once = sentences(render_plan(study, lights_of(study), {.error = 0.0039}));
  EXPECT_EQ(once, sentences(render_plan(study, lights_of(study), {.error = 0.0039})));
  EXPECT_GT(once.size(), 10U);
}

}  // namespace
}  // namespace seamline::renderer
