#include "laboratory/stability/depth/contact_cases.h"

#include <fmt/core.h>

#include "laboratory/stability/common/groups.h"
#include "laboratory/stability/common/namespaces.h"
#include "laboratory/stability/common/shapes.h"
#include "laboratory/stability/common/worst.h"
#include "renderer/transport/transport.h"
#include "support/arithmetic/random.h"
#include "support/text/numbers.h"

namespace seamline::stability {
namespace {

StabilityCase contact_case(const std::string& name, float gap_m, const std::string& tried) {
  return {.group = "space",
          .name = name,
          .tried = "an object " + tried + ", seen from 2, 20 and 200 m",
          .expected = "no light on the floor under it",
          .unit = "paths",
          .tolerance = 0,
          .reason = exact_count,
          .run = [gap_m](const StabilityOptions&) { return try_contact(gap_m); }};
}

}  // namespace

Finding try_contact(float gap_m) {
  int lit = 0, paths = 0;
  for (const float distance_m : {2.0F, 20.0F, 200.0F}) {
    const Geometry floor(std::vector{
        plane_shape({.centre_m = {0, -1, -static_cast<double>(distance_m)}, .half_size_m = 300})});
    const Geometry box(std::vector{box_shape({-0.5F, -1 + gap_m, -distance_m - 0.5F},
                                             {0.5F, gap_m, -distance_m + 0.5F}, {.object_index = 1})});
    const Light light = sun_and_sky({0.6F, 1, 0.3F}, 3, 1, 0);
    Random random(9);
    for (int i = 0; i < 4000; ++i) {
      // 0.1 m inside the footprint: from there the gap of 1e-4 m shows a millionth of the sky.
      const Eigen::Vector3d aim(0.8 * random.uniform() - 0.4, -1,
                                -static_cast<double>(distance_m) + 0.8 * random.uniform() - 0.4);
      const auto point = floor.nearest({Eigen::Vector3f::Zero(), aim.normalized().cast<float>()});
      if (!point || std::abs(point->position_m.x()) > 0.42F) continue;
      ++paths;
      lit += radiance_with_and_without(floor, &box, *point, light, Sampler(1, i, 0, 0))
                         .with_object.total()
                         .abs()
                         .sum() != 0.0F
                 ? 1
                 : 0;
    }
  }
  return {paths > 11000 ? static_cast<double>(lit) : nan, fmt::format("{} lit of {} paths", lit, paths)};
}

Finding try_leaving_rays(const StartRule& start) {
  int hits = 0, rays = 0;
  for (float distance_m = 1e-3F; distance_m < 2e6F; distance_m *= 10) {
    const Geometry ball(std::vector{ball_shape({0.3F * distance_m, 0, -distance_m}, 0.2F * distance_m, 64)});
    for (int i = 0; i < 2000; ++i) {
      const Sampler sampler(2, i, 0, 0);
      const Eigen::Array2f p = sampler.point(dimension::pixel) * 0.3F - 0.15F;
      const auto point =
          ball.nearest({Eigen::Vector3f::Zero(), Eigen::Vector3f(0.3F + p[0], p[1], -1).normalized()});
      if (!point) continue;
      const Eigen::Vector3f direction =
          cosine_weighted(point->normal, sampler.point(dimension::direction(0)));
      ++rays;
      hits += ball.occluded({start(*point, direction), direction}) ? 1 : 0;
    }
  }
  return {rays > 10000 ? static_cast<double>(hits) : nan, fmt::format("{} of {} rays", hits, rays)};
}

Finding try_white_ball() {
  const Geometry ball(std::vector{ball_shape({0, 0, -5}, 1, 96, {.albedo = 1})});
  Light light;
  light.environment_radiance = Rgb::Ones();
  light.bounces = 64;
  double error = 0;
  int paths = 0;
  for (int i = 0; i < 20000; ++i) {
    const Sampler sampler(7, i, 0, 0);
    const Eigen::Array2f p = sampler.point(dimension::pixel) * 0.4F - 0.2F;
    const auto point = ball.nearest({Eigen::Vector3f::Zero(), Eigen::Vector3f(p[0], p[1], -1).normalized()});
    if (!point) continue;
    ++paths;
    error = worse(
        error,
        relative_error(
            static_cast<double>(
                radiance_with_and_without(ball, nullptr, *point, light, sampler).without_object.total()[1]),
            1));
  }
  return {error, fmt::format("{} paths", paths)};
}

StabilityCases contact_cases() {
  return {
      contact_case("object-touches-floor", 0, "that touches the floor"),
      contact_case("object-penetrates-floor", -0.05F, "0.05 m deep in the floor"),
      contact_case("object-1e-4-above-floor", 1e-4F, "1e-4 m above the floor"),
      {.group = "space",
       .name = "leaving-rays",
       .tried = "rays that leave a ball outwards, seen from 1e-3 to 1e6 m",
       .expected = "none meets the ball that it left",
       .unit = "rays",
       .tolerance = 0,
       .reason = exact_count,
       .run = [](const StabilityOptions&) { return try_leaving_rays(); }},
      {.group = "light",
       .name = "white-ball",
       .tried = "a ball of albedo 1 under a sky of radiance 1, 64 bounces",
       .expected = "radiance 1: it cannot be seen",
       .unit = "relative",
       .tolerance = 0,
       .reason = "1 times 1 is not rounded; a ray that met its own ball would bring less",
       .run = [](const StabilityOptions&) { return try_white_ball(); }},
  };
}

}  // namespace seamline::stability
