#include "laboratory/stability/light/pocket_cases.h"

#include <fmt/core.h>

#include <algorithm>
#include <numbers>
#include <utility>
#include <vector>

#include "laboratory/stability/common/groups.h"
#include "laboratory/stability/common/shapes.h"
#include "laboratory/stability/common/worst.h"

namespace seamline::stability {
namespace {

TruthScene well_behind_bars() {
  SmallScene scene;
  scene.background = {plane_shape({}), box_shape({-4, -1, -9}, {4, 3, -8.5F})};
  for (int bar = 0; bar < 16; ++bar) {
    const float x = -1.6F + 0.2F * static_cast<float>(bar);
    scene.background.push_back(box_shape({x, -1, -4.05F}, {x + 0.06F, 1.5F, -4}));
  }
  scene.background.push_back(box_shape({-1.7F, 1.5F, -8.5F}, {1.7F, 1.6F, -3.9F}));
  scene.object = {ball_shape({0, -0.2F, -4.5F}, 0.4F, 32, {.object_index = 1})};
  scene.light = sun_and_sky({0.4F, 1, 0.7F}, 6, 0.2F, 1);
  return truth_scene_of(scene);
}

}  // namespace

Finding try_sealed_pocket(int threads, const ComposeRule& rule) {
  const TruthScene scene = well_behind_bars();
  int wrong = 0;
  std::int64_t tiny = 0;
  const std::vector<std::pair<Artifact, Isolation>> tried = {{Artifact::overlap, Isolation::query},
                                                             {Artifact::bounce, Isolation::query},
                                                             {Artifact::shadow, Isolation::mask},
                                                             {Artifact::all, Isolation::mask}};
  for (const auto& [artifact, isolation] : tried) {
    const SmallPicture picture = render_small(
        scene, {.artifact = artifact, .isolation = isolation, .threads = threads, .compose = rule});
    const float brightest =
        *std::max_element(picture.background.values.begin(), picture.background.values.end());
    wrong += pixels_out_of_range(picture.composite.picture, 4 * static_cast<double>(brightest));
    tiny += picture.composite.tiny_denominators.floored_pixels +
            picture.composite.tiny_denominators.sealed_pixels;
  }
  return {static_cast<double>(wrong),
          fmt::format("{} wrong pixels of 4 pictures; {} with a tiny denominator", wrong, tiny)};
}

Finding try_face_behind_sheet(bool from_mesh) {
  const Geometry sheet(
      std::vector{shape_of({{-9, -9, -3.999F}, {9, -9, -3.999F}, {0, 9, -3.999F}}, {{0, 1, 2}})});
  const Geometry object(std::vector{box_shape({-1, -1, -5}, {1, 1, -4}, {.object_index = 1})});
  const Eigen::Vector3f to_sun = Eigen::Vector3f(0.2F, 0.3F, 1).normalized();
  const Light light = sun_and_sky(to_sun, 3, 0, 0);
  const Ray ray{Eigen::Vector3f::Zero(), {0, 0, -1}};
  const SurfacePoint face = object.nearest(ray).value(), mesh = sheet.nearest(ray).value();
  const RealQuestion question{&sheet, from_mesh ? &mesh : &face};
  const double expected = 0.5 * 3 * static_cast<double>(to_sun.z()) / std::numbers::pi;
  const double found =
      leaving_object(ObjectQuestions::all_of(question), object, face, light, Sampler(1, 0, 0, 0)).total()[1];
  return {relative_error(found, expected), fmt::format("radiance {:.7g} for {:.7g}", found, expected)};
}

StabilityCases pocket_cases() {
  return {
      {.group = "light",
       .name = "sealed-pocket",
       .tried =
           "an object before a well behind bars that the sheets of a 64 px depth map seal in; four artifacts",
       .expected = "numbers from 0 to 4 times the photograph's brightest pixel",
       .unit = "pixels",
       .tolerance = 0,
       .reason = exact_count,
       .run = [](const StabilityOptions& options) { return try_sealed_pocket(options.threads); }},
      {.group = "light",
       .name = "face-behind-sheet",
       .tried = "an object's face 1 mm behind a sheet of the depth mesh",
       .expected = "lit by the sun, as from the sheet's own surface",
       .unit = "relative",
       .tolerance = 2.4e-7,
       .reason = "a product in float: 4 roundings of 6e-8",
       .run = [](const StabilityOptions&) { return try_face_behind_sheet(); }}};
}

}  // namespace seamline::stability
