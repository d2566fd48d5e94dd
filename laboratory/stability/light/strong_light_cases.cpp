#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <functional>

#include "laboratory/stability/common/groups.h"
#include "laboratory/stability/common/shapes.h"
#include "laboratory/stability/common/stability_case.h"
#include "raytracer/error/error_estimate.h"
#include "raytracer/scene/scene_file.h"
#include "raytracer/scene/truth_scene.h"
#include "renderer/depth/local_scene.h"
#include "renderer/estimators/estimator.h"
#include "renderer/picture/composite.h"
#include "stimuli/pictures/difference.h"
#include "support/files/atomic_file.h"
#include "support/files/temporary_folder.h"
#include "support/text/error.h"
#include "support/text/limits.h"
#include "support/text/number_option.h"
#include "support/text/numbers.h"

namespace seamline::stability {
namespace {

constexpr float strongest = static_cast<float>(limits::strongest_light);

/// A triangle lit by a light, both of whose numbers a case chooses.
struct LitFile {
  std::string light = R"("intensity":683)", material = "{}", transform = R"("scale":[1,1,1])";

  [[nodiscard]] std::string text() const {
    return R"({"asset":{"version":"2.0"},"extensionsUsed":["KHR_lights_punctual"],"scene":0,"scenes":[{"nodes":[0,1]}],)"
           R"("nodes":[{"mesh":0},{"extensions":{"KHR_lights_punctual":{"light":0}},)" +
           transform + R"(}],"extensions":{"KHR_lights_punctual":{"lights":[{"type":"directional",)" + light +
           R"(}]}},"materials":[)" + material +
           R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],)"
           R"("accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3}],)"
           R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,)"
           R"("uri":"data:application/octet-stream;base64,)" +
           std::string(48, 'A') + R"("}]})";
  }
};

bool is_refused(const std::function<void()>& attempt) {
  try {
    attempt();
  } catch (const InputError&) {
    return true;
  }
  return false;
}

/// How many of the attempts are not refused.
Finding count_accepted(const std::vector<std::function<void()>>& attempts, const char* what) {
  std::size_t accepted = 0;
  for (const auto& attempt : attempts) accepted += is_refused(attempt) ? 0 : 1;
  return {static_cast<double>(accepted),
          fmt::format("{} of {} {} accepted", accepted, attempts.size(), what)};
}

/// Vertices that a placement takes beyond what areas in single precision can be computed from.
Finding try_far_products() {
  SceneFile file;
  file.meshes.push_back({.name = "one",
                         .positions_m = {{0, 0, 0}, {1, 0, 0}, {0, 1, 1e3}},
                         .normals = {},
                         .triangles = {{0, 1, 2}},
                         .albedo = {}});
  std::vector<std::function<void()>> attempts;
  for (const double scale : {1e7, 1e9, 1e155, 1e308})
    for (const double away_m : {0.0, 1e9, 1e300})
      attempts.emplace_back([=] {
        ObjectDefinition object;
        object.scale = scale;
        object.position_m = {away_m, 0, 0};
        (void)place_meshes(file, object_placement(object), {0, -away_m, 0}, 0.5, 1);
      });
  return count_accepted(attempts, "placements");
}

/// One value of a picture that is no number, wherever pictures are written or judged.
Finding try_planted_values() {
  std::vector<std::function<void()>> attempts;
  for (const float value : {std::nanf(""), HUGE_VALF, -HUGE_VALF}) {
    Image picture(64, 48, 3, 0.25F);
    picture.at(40, 30, 1) = value;
    const Image sound(64, 48, 3, 0.25F);
    attempts.emplace_back([=] { (void)display_image(picture); });
    attempts.emplace_back([=] { require_numbers(picture); });
    attempts.emplace_back([=] { (void)display_rmse(sound, picture, 0); });
    attempts.emplace_back([=] { (void)estimate_error({{picture, sound}, {sound, sound}, {}}, 0, 1); });
    attempts.emplace_back([=] { (void)estimate_error({{sound, sound}, {sound, picture}, {}}, 0, 1); });
    attempts.emplace_back([=] {
      const TemporaryFolder folder;
      write_picture_exr(folder / "picture.exr", picture);
    });
  }
  return count_accepted(attempts, "pictures");
}

/// What is no number, as options of the three kinds.
Finding try_wrong_options() {
  std::vector<std::function<void()>> attempts;
  for (const char* text :
       {"nan", "-nan", "inf", "-inf", "1e999", "", " ", "1e400", "171", "0.99", "1;2", "0x10"})
    for (const int kind : {0, 1, 2})
      attempts.emplace_back([=] {
        CLI::App app;
        double number = 0;
        int whole = 0;
        std::array<double, 3> triple{};
        if (kind == 0) add_number(app, "--option", number, {1, 170}, "a number");
        if (kind == 1) add_number(app, "--option", whole, {1, 170}, "a whole number");
        if (kind == 2) add_number(app, "--option", triple, {1, 170}, "three numbers");
        std::vector<const char*> arguments = {"app", "--option", "2", "2", text};
        if (kind < 2) arguments = {"app", "--option", text};
        app.parse(static_cast<int>(arguments.size()), arguments.data());
      });
  return count_accepted(attempts, "options");
}

/// Files with lights and emissions that no sum can hold, or that are negative: how many are read.
Finding try_impossible_lights() {
  std::vector<LitFile> files;
  for (const char* light :
       {R"("intensity":1e308)", R"("intensity":1e16)", R"("intensity":-1)", R"("color":[1e300,1,1])",
        R"("color":[1,-0.1,1])", R"("intensity":1e200,"color":[1e200,0,0])",
        R"("intensity":0,"color":[1e308,0,0])"})
    files.push_back({.light = light});
  for (
      const char* material :
      {R"({"emissiveFactor":[1e39,0,0]})", R"({"emissiveFactor":[0,1e13,0]})",
       R"({"emissiveFactor":[0,-1,0]})",
       R"({"emissiveFactor":[1,1,1],"extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":1e300}}})",
       R"({"emissiveFactor":[1,1,1],"extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":-1}}})"})
    files.push_back({.material = material});
  for (const char* transform :
       {R"("scale":[0,0,0])", R"("scale":[1e-200,1e-200,1e-200])", R"("scale":[1e200,1e200,1e200])"})
    files.push_back({.transform = transform});
  const TemporaryFolder folder;
  std::vector<std::function<void()>> attempts;
  for (const LitFile& file : files)
    attempts.emplace_back([&folder, file] {
      write_file_atomically(folder / "scene.gltf", file.text());
      (void)read_scene_file(folder / "scene.gltf");
    });
  // What they differ from is read, or every one would be refused for another reason.
  write_file_atomically(folder / "sound.gltf", LitFile{}.text());
  if (read_scene_file(folder / "sound.gltf").suns.size() != 1) return {nan, "the sound file has no light"};
  return count_accepted(attempts, "files");
}

/// Every number of a scene at the largest that is accepted: pixels that are no number, of pictures and their
/// estimated errors.
Finding try_strongest_light(Estimator estimator, int threads) {
  const Matter white{.albedo = 1, .emission = strongest};
  TruthScene scene = truth_scene_of(
      {.background = {plane_shape({.half_size_m = 12}, white), ball_shape({0, 0, -4}, 30, 24, white)},
       .object = {box_shape({-0.5F, -1, -4.5F}, {0.5F, 0.4F, -3.5F},
                            {.albedo = 1, .emission = strongest, .object_index = 1})},
       .light = sun_and_sky({0.6F, 1, 0.2F}, strongest, strongest, 1024),
       .width_px = 16,
       .height_px = 9});
  scene.definition.albedo = 1;
  scene.definition.exposure_ev = 60;
  const auto estimating =
      make_estimator(estimator, scene, {.spp = 4, .threads = threads, .depth_bounces = true});
  const SceneReference reference = estimating->reference({});
  estimating->take_object(1, {});
  const LocalScene depth =
      make_local_scene(estimating->geometry().truth, {.width_px = 64}, {.albedo = 1, .threads = threads});
  int wrong = 0, values = 0;
  const auto count = [&](const Image& picture) {
    for (const float value : picture.values) wrong += std::isfinite(value) && value >= 0 ? 0 : 1;
    values += static_cast<int>(picture.values.size());
    (void)display_image(picture, scene.definition.exposure_ev);
  };
  count(reference.radiance);
  for (const Artifact artifact : {Artifact::none, Artifact::receiver, Artifact::all}) {
    const EstimatedStimulus made =
        estimating->stimulus(recipe(artifact, Isolation::query), &depth.geometry, {});
    count(compose(made.sums).picture);
    wrong += made.rmse && std::isfinite(*made.rmse) ? 0 : 1;
  }
  return {static_cast<double>(wrong), fmt::format("{} of {} values and errors are no number", wrong, values)};
}

}  // namespace

StabilityCases strong_light_cases() {
  StabilityCases cases = {
      counted_case(
          "light", "impossible-lights",
          "glTF lights of intensity 1e308, colour 1e300 or -0.1, emission 1e39 or -1, directions scaled "
          "to nothing",
          "each refused", try_impossible_lights),
      counted_case("light", "planted-no-number", "pictures with one value that is NaN or infinite",
                   "refused wherever a picture is written or its error estimated", try_planted_values),
      counted_case("space", "far-products", "objects scaled by 1e7 to 1e308 and placed up to 1e300 m away",
                   "refused: no vertex is farther than 1e9 m from the camera", try_far_products),
      counted_case("bounds", "options-no-number",
                   "NaN, infinities, empty texts and numbers outside as options", "each refused",
                   try_wrong_options)};
  for (const Estimator estimator : {Estimator::fast, Estimator::path})
    cases.push_back(
        {.group = "light",
         .name = fmt::format("strongest-light-{}", word(estimator)),
         .tried = fmt::format("sun, sky and emission of 1e12, albedo 1, 1,024 bounces in a closed ball, "
                              "exposure 60 stops: the largest numbers accepted, estimator {}",
                              word(estimator)),
         .expected = "pictures and estimated errors that are numbers",
         .unit = "values",
         .tolerance = 0,
         .reason = exact_count,
         .run = [estimator](const StabilityOptions& options) {
           return try_strongest_light(estimator, options.threads);
         }});
  return cases;
}

}  // namespace seamline::stability
