#include <fmt/core.h>

#include <Eigen/Geometry>
#include <numbers>

#include "laboratory/stability/common/groups.h"
#include "laboratory/stability/common/shapes.h"
#include "laboratory/stability/common/small_render.h"
#include "laboratory/stability/common/stability_case.h"
#include "laboratory/stability/common/worst.h"
#include "support/arithmetic/random.h"
#include "support/text/numbers.h"

namespace seamline::stability {
namespace {

/// A floor with a box on it; the sun stands in the upper right.
SmallScene box_on_floor(const Light& light) {
  return {.background = {plane_shape({.half_size_m = 12})},
          .object = {box_shape({-0.5F, -1, -4.5F}, {0.5F, 0.4F, -3.5F}, {.object_index = 1})},
          .light = light};
}

/// A plane under a sun `irradiance` times as strong as the sky's radiance of 1: the light of a sunlit point
/// against the sum of both, or the light of a point behind a wall against the sky's alone.
Finding try_strong_sun(float irradiance_w_m2, bool in_shadow) {
  const Eigen::Vector3f to_sun = Eigen::Vector3f(1, 1, 0).normalized();
  const Light light = sun_and_sky(to_sun, irradiance_w_m2, 1.0F, 0);
  std::vector<PartPointer> parts = {plane_shape({})};
  if (in_shadow) parts.push_back(box_shape({1, -1, -9}, {1.2F, 30, 1}));
  const Geometry scene(parts);
  const SurfacePoint point =
      scene.nearest({Eigen::Vector3f::Zero(), Eigen::Vector3f(0, -1, -1).normalized()}).value();
  const double lit = 0.5 * irradiance_w_m2 * std::sqrt(0.5) / std::numbers::pi;
  double error = 0, last = 0;
  for (int i = 0; i < 400; ++i) {
    last = static_cast<double>(radiance_with_and_without(scene, nullptr, point, light, Sampler(1, i, 0, 0))
                                   .without_object.total()[1]);
    // In the shadow a sample sees the sky (0.5) or the wall (0), and nothing of the sun.
    error = worse(
        error, in_shadow ? std::min(std::abs(last - 0.5), std::abs(last)) : relative_error(last, lit + 0.5));
  }
  return {error, fmt::format("radiance {:.7g}", last)};
}

/// A sun without a sky: the object's shadow must be black in the reference and in a composite through a
/// coarse depth map, and every pixel a number from 0 to what the photograph can become.
Finding try_black_shadow(int threads, const ComposeRule& rule = compose_as_product) {
  const TruthScene scene = truth_scene_of(box_on_floor(sun_and_sky({0.6F, 1, 0.2F}, 5, 0, 0)));
  int wrong = 0, black = 0;
  for (const Artifact artifact : {Artifact::none, Artifact::receiver, Artifact::overlap, Artifact::all}) {
    const SmallPicture picture = render_small(
        scene, {.artifact = artifact, .depth_width_px = 128, .threads = threads, .compose = rule});
    // 4 times the photograph's brightest floor is what the clamp of the ratio allows.
    wrong += pixels_out_of_range(picture.composite.picture, 4 * 0.5 * 5 / std::numbers::pi);
    if (artifact != Artifact::none) continue;
    for (std::size_t i = 0; i < picture.reference.values.size(); ++i) {
      const bool shadow = picture.reference.values[i] == 0.0F && picture.background.values[i] > 0.0F;
      black += shadow ? 1 : 0;
      wrong += shadow && picture.composite.picture.values[i] > 1e-6F ? 1 : 0;
    }
  }
  if (black == 0) ++wrong;
  return {static_cast<double>(wrong), fmt::format("{} black values, {} wrong pixels", black, wrong)};
}

/// Artifact none under a sun 1e8 times stronger than the sky, in a scene with bounces: the composite must be
/// the reference.
Finding try_strong_sun_composite(int threads) {
  const TruthScene scene = truth_scene_of(box_on_floor(sun_and_sky({0.6F, 1, 0.2F}, 1e8F, 1, 2)));
  const SmallPicture picture = render_small(scene, {.artifact = Artifact::none, .threads = threads});
  double error = 0;
  for (std::size_t i = 0; i < picture.reference.values.size(); ++i) {
    const double wanted = picture.reference.values[i];
    const double found = picture.composite.picture.values[i];
    error =
        worse(error, std::abs(found - wanted) /
                         std::max(1.0, std::max(wanted, static_cast<double>(picture.background.values[i]))));
  }
  return {error, fmt::format("{} values", picture.reference.values.size())};
}

/// A sun `elevation_deg` above a plane in `cells` x cells squares, the plane itself turned by `turn_deg`:
/// light against albedo E sin(elevation) / pi at many points.
Finding try_grazing_sun(double elevation_deg, double turn_deg, int cells) {
  const double elevation = elevation_deg * std::numbers::pi / 180;
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(turn_deg * std::numbers::pi / 180, Eigen::Vector3d(1, 2, 3).normalized())
          .toRotationMatrix();
  const Eigen::Vector3d normal = turn * Eigen::Vector3d::UnitY();
  const PlaneSquare square{.centre_m = -1.5 * normal,
                           .u = turn * Eigen::Vector3d::UnitX(),
                           .v = turn * -Eigen::Vector3d::UnitZ(),
                           .half_size_m = 8,
                           .cells = cells};
  const Geometry plane(std::vector{plane_shape(square)});
  const Eigen::Vector3d to_sun = turn * Eigen::Vector3d(std::cos(elevation), std::sin(elevation), 0);
  const Light light = sun_and_sky(to_sun.cast<float>(), 100, 0, 0);
  const double expected = 0.5 * 100 * std::sin(elevation) / std::numbers::pi;
  Random random(5);
  double error = 0;
  int dark = 0;
  constexpr int points = 20000;
  for (int i = 0; i < points; ++i) {
    const Eigen::Vector3d aim = square.centre_m + 7.5 * ((2 * random.uniform() - 1) * square.u +
                                                         (2 * random.uniform() - 1) * square.v);
    const auto hit = plane.nearest({Eigen::Vector3f::Zero(), aim.normalized().cast<float>()});
    if (!hit) return {nan, "a ray slipped through the plane"};
    const double found =
        static_cast<double>(radiance_with_and_without(plane, nullptr, *hit, light, Sampler(1, i, 0, 0))
                                .without_object.total()[1]);
    dark += found == 0 ? 1 : 0;
    error = worse(error, relative_error(found, expected));
  }
  return {error, fmt::format("{} of {} points in false shadow, largest error {:.2g}", dark, points, error)};
}

}  // namespace

StabilityCases sun_cases() {
  const std::string two_products = "a product and a sum in float: 4 roundings of 6e-8";
  return {
      {.group = "light",
       .name = "sun-1e8-lit",
       .tried = "a plane under a sun 1e8 times as strong as the sky",
       .expected = "albedo (E cos / pi + L)",
       .unit = "relative",
       .tolerance = 2.4e-7,
       .reason = two_products,
       .run = [](const StabilityOptions&) { return try_strong_sun(1e8F, false); }},
      {.group = "light",
       .name = "sun-1e8-shadow",
       .tried = "a point behind a wall from a sun 1e8 times as strong as the sky",
       .expected = "the sky's light alone, 0.5 or 0 a sample",
       .unit = "radiance",
       .tolerance = 0,
       .reason = "1e-8 of the sun would show; a blocked ray adds nothing",
       .run = [](const StabilityOptions&) { return try_strong_sun(1e8F, true); }},
      {.group = "light",
       .name = "sun-1e8-composite",
       .tried = "artifact none composited under a sun 1e8 times as strong as the sky, two bounces",
       .expected = "the reference",
       .unit = "relative",
       .tolerance = 1e-5,
       .reason = "sums of 8 samples in float in two orders: 8 x 2 x 6e-8, ten times that allowed",
       .run = [](const StabilityOptions& options) { return try_strong_sun_composite(options.threads); }},
      {.group = "light",
       .name = "ambient-0",
       .tried = "a sun without a sky: black shadows, four artifacts through a coarse depth map",
       .expected = "shadows that are black, and no pixel that is not a number, negative or above the clamp",
       .unit = "pixels",
       .tolerance = 0,
       .reason = exact_count,
       .run = [](const StabilityOptions& options) { return try_black_shadow(options.threads); }},
      {.group = "space",
       .name = "grazing-sun-floor",
       .tried = "a sun 0.1 degrees above a floor of one square",
       .expected = "albedo E sin(0.1 degrees) / pi everywhere",
       .unit = "relative",
       .tolerance = 1e-4,
       .reason =
           "the sun's direction in float is known to 6e-8, which is 3.4e-5 of sin(0.1 degrees); thrice that",
       .run = [](const StabilityOptions&) { return try_grazing_sun(0.1, 0, 1); }},
      {.group = "space",
       .name = "grazing-sun-turned",
       .tried = "the same above a plane turned by 37 degrees, in 200 x 200 squares that are not quite "
                "coplanar in float",
       .expected = "albedo E sin(0.1 degrees) / pi everywhere, no square shadows its neighbour",
       .unit = "relative",
       .tolerance = 0.05,
       .reason = "corners rounded to 2.4e-7 m tilt a square of 0.08 m by up to 1.2e-5 rad, 0.7 % of 0.1 "
                 "degrees a corner; seven times that; a false shadow is 1",
       .run = [](const StabilityOptions&) { return try_grazing_sun(0.1, 37, 200); }},
  };
}

}  // namespace seamline::stability
