#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "laboratory/stability/common/groups.h"
#include "laboratory/stability/common/namespaces.h"
#include "laboratory/stability/common/shapes.h"
#include "laboratory/stability/common/stability_case.h"
#include "raytracer/error/true_error.h"
#include "raytracer/light/bright_patches.h"
#include "raytracer/scene/truth_scene.h"
#include "renderer/depth/local_scene.h"
#include "renderer/estimators/estimator.h"
#include "renderer/picture/composite.h"
#include "stimuli/definition/artifact.h"
#include "support/text/numbers.h"

namespace seamline::stability {
namespace {

/// What pictures of a scene's left object say of their own error beside the true one, over six seeds: the
/// error is how many times the larger of the two is the smaller, less one. Truth is the path estimator with
/// 1,024 samples a pixel of another seed, its own noise taken out.
Finding try_told_error(const TruthScene& scene, Artifact artifact, int threads);

constexpr double asked_error = 0.02;
constexpr int truth_spp = 1024, told_seeds = 6;
constexpr std::uint64_t truth_seed = 900001;

PartPointer polished(const PartPointer& part, float alpha) {
  auto out = std::make_shared<SurfaceMesh>(*part);
  out->albedo = Rgb::Zero();
  out->f0 = Rgb(0.95F, 0.9F, 0.7F);
  out->alpha = alpha;
  return out;
}

/// The inside of a ring focuses light onto what it stands on.
PartPointer upright_band(const Eigen::Vector3f& foot_m, float radius_m, float height_m) {
  constexpr std::uint32_t around = 48;
  std::vector<Eigen::Vector3f> positions_m;
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < around; ++i) {
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(around);
    for (const float up_m : {0.0F, height_m})
      positions_m.push_back(foot_m +
                            Eigen::Vector3f(radius_m * std::cos(angle), up_m, radius_m * std::sin(angle)));
    const std::uint32_t next = (i + 1) % around;
    triangles.push_back({2 * i, 2 * next, 2 * i + 1});
    triangles.push_back({2 * i + 1, 2 * next, 2 * next + 1});
  }
  return shape_of(std::move(positions_m), std::move(triangles), {.object_index = 1});
}

/// A floor, a wall 6 m away, and something on the floor.
TruthScene small_room(std::vector<PartPointer> object, Light light, std::vector<PartPointer> more = {}) {
  SmallScene scene{.background = {plane_shape({.half_size_m = 8}),
                                  plane_shape({.centre_m = {0, 1, -6}, .v = Eigen::Vector3d::UnitY()})},
                   .object = std::move(object),
                   .light = std::move(light)};
  scene.background.insert(scene.background.end(), more.begin(), more.end());
  TruthScene made = truth_scene_of(scene);
  add_emitters(made.background, made.light);
  add_bright_patches(made.background, made.geometry(true, made.object_indices()), made.light);
  return made;
}

Light faint_sky(float radiance) {
  Light light;
  light.environment_radiance = Rgb::Constant(radiance);
  light.bounces = 2;
  return light;
}

TruthScene lamp_of_two_centimetres() {
  return small_room(
      {ball_shape({0, -0.6F, -4}, 0.4F, 24, {.object_index = 1})}, faint_sky(0.1F),
      {plane_shape({.centre_m = {0.61, 0.47, -4.5}, .v = Eigen::Vector3d::UnitY(), .half_size_m = 0.01},
                   {.emission = 400})});
}

TruthScene lamp_close_to_the_wall() {
  Light light = faint_sky(0.05F);
  light.lamps.push_back({.position_m = {0.7F, 0.3F, -5.96F}, .intensity_w_sr = Rgb::Constant(1.5F)});
  return small_room({ball_shape({0, -0.6F, -4}, 0.4F, 24, {.object_index = 1})}, light);
}

TruthScene ring_in_the_sun() {
  Light light = sun_and_sky({0.5F, 1, 0.3F}, 3, 0.3F, 3);
  return small_room({polished(upright_band({0, -1, -4}, 0.5F, 0.4F), 0.02F)}, light);
}

/// A ball with the normals of a sphere, in which a lamp behind the camera covers a hundredth of a pixel.
TruthScene lamp_in_a_mirror() {
  const Eigen::Vector3f centre_m(0, -0.3F, -3);
  constexpr float radius_m = 0.6F;
  auto ball = std::make_shared<SurfaceMesh>(
      *polished(ball_shape(centre_m, radius_m, 48, {.object_index = 1}), 0.0025F));
  for (const Eigen::Vector3f& at : ball->positions_m) ball->normals.push_back((at - centre_m).normalized());
  return small_room({ball}, faint_sky(0.3F),
                    {plane_shape({.centre_m = {0.6, 1.2, 0.6}, .half_size_m = 0.02}, {.emission = 900})});
}

StabilityCase told_error_case(const std::string& name, const std::string& tried, TruthScene (*scene)(),
                              Artifact artifact) {
  return {.group = "light",
          .name = name,
          .tried = tried,
          .expected = "the true error, over six seeds",
          .unit = "of the true error",
          .tolerance = 0.25,
          .reason = "six pictures know their true error to a tenth; two and a half times that",
          .run = [scene, artifact](const StabilityOptions& options) {
            return try_told_error(scene(), artifact, options.threads);
          }};
}

Finding try_told_error(const TruthScene& scene, Artifact artifact, int threads) {
  const Recipe how = recipe(artifact, Isolation::query);
  const auto render = [&](SceneEstimator& estimator) {
    estimator.take_object(1, {});
    const LocalScene depth = make_local_scene(estimator.geometry().truth, {.width_px = 64},
                                              {.albedo = scene.definition.albedo, .threads = threads});
    return estimator.stimulus(how, &depth.geometry, {});
  };
  const auto path = make_path_estimator(scene, {.spp = truth_spp, .seed = truth_seed, .threads = threads});
  const EstimatedStimulus truth = render(*path);
  const ReferenceHalves halves = {compose_half(truth.sums, 0).picture, compose_half(truth.sums, 1).picture};
  double told = 0, squares = 0;
  for (std::uint64_t seed = 1; seed <= told_seeds; ++seed) {
    const auto fast = make_estimator(Estimator::fast, scene,
                                     {.spp = 16, .error = asked_error, .seed = seed, .threads = threads});
    const EstimatedStimulus made = render(*fast);
    if (!made.rmse) return {nan, "no error is told"};
    told += *made.rmse * *made.rmse / told_seeds;
    squares += true_error(display_image(compose(made.sums).picture), halves, 0).squared / told_seeds;
  }
  if (!(squares > 0)) return {nan, "the true error is not known"};
  const double ratio = std::sqrt(told / squares);
  return {std::max(ratio, 1 / ratio) - 1,
          fmt::format("told {:.4f}, true {:.4f} (display units)", std::sqrt(told), std::sqrt(squares))};
}

}  // namespace

StabilityCases told_error_cases() {
  return {told_error_case("told-error-small-lamp", "a lamp of 2 cm in view, 4.5 m away, that lights a room",
                          lamp_of_two_centimetres, Artifact::receiver),
          told_error_case("told-error-near-lamp", "a lamp without size 4 cm before a wall",
                          lamp_close_to_the_wall, Artifact::receiver),
          told_error_case("told-error-metal-ring", "a polished ring that focuses the sun onto the floor",
                          ring_in_the_sun, Artifact::receiver),
          told_error_case("told-error-mirrored-lamp", "a lamp of 4 cm that is seen in a polished ball alone",
                          lamp_in_a_mirror, Artifact::all)};
}

}  // namespace seamline::stability
