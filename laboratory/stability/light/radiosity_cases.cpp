#include <fmt/core.h>

#include "laboratory/stability/common/groups.h"
#include "laboratory/stability/common/namespaces.h"
#include "laboratory/stability/common/shapes.h"
#include "laboratory/stability/common/stability_case.h"
#include "laboratory/stability/common/worst.h"
#include "renderer/transport/path_batch.h"

namespace seamline::stability {
namespace {

/// A closed sphere that emits 1 everywhere.
struct ClosedSphere {
  float albedo = 0.5F;
  int bounces = 4;
  bool object_inside = false;  ///< a ball of the same matter hangs in it, as the virtual object
};

/// Every path must bring the sum of albedo^k for k = 0 to bounces + 1, through `radiance_with_and_without`
/// (path estimator), in both worlds. The error is the largest relative one of any path.
Finding try_closed_sphere(const ClosedSphere& sphere);
/// The same through `PathBatch` (fast estimator).
Finding try_closed_sphere_fast(const ClosedSphere& sphere);

constexpr int paths = 500;

/// Radiosity of the sphere after a number of bounces; without end it would be 1 / (1 - albedo).
double expected_radiance(const ClosedSphere& sphere) {
  double sum = 0, power = 1;
  for (int k = 0; k <= sphere.bounces + 1; ++k, power *= sphere.albedo) sum += power;
  return sum;
}

struct Furnace {
  Geometry wall, object;
  Light light;
};

Furnace furnace_of(const ClosedSphere& sphere) {
  const Matter matter{.albedo = sphere.albedo, .emission = 1.0F};
  Light light;
  light.bounces = sphere.bounces;
  return {.wall = Geometry(std::vector{ball_shape({0, 0, 0}, 3, 64, matter)}),
          .object = Geometry(std::vector{ball_shape(
              {0, -1, -1}, 0.7F, 32, {.albedo = sphere.albedo, .emission = 1.0F, .object_index = 1})}),
          .light = light};
}

/// What the path's first ray meets on the wall.
SurfacePoint first_hit(const Furnace& furnace, const Sampler& sampler) {
  return furnace.wall
      .nearest({Eigen::Vector3f::Zero(), cosine_weighted({0, 1, 0}, sampler.point(dimension::pixel))})
      .value();
}

Finding finding(const ClosedSphere& sphere, double error, double last) {
  return {error, fmt::format("radiance {:.7g} for {:.7g}", last, expected_radiance(sphere))};
}

StabilityCase sphere_case(const std::string& name, const ClosedSphere& sphere, bool fast = false) {
  const double rounding = 2 * (sphere.bounces + 2) * 6e-8;
  return {.group = "light",
          .name = name,
          .tried = fmt::format("a closed emitting sphere of albedo {:g}, {} bounce{}{}{}", sphere.albedo,
                               sphere.bounces, sphere.bounces == 1 ? "" : "s",
                               sphere.object_inside ? ", an object of the same matter in it" : "",
                               fast ? ", fast estimator" : ""),
          .expected = fmt::format("radiance {:.6g}, the sum of albedo^k over k = 0 to {}",
                                  expected_radiance(sphere), sphere.bounces + 1),
          .unit = "relative",
          .tolerance = rounding,
          .reason = "every path brings the same sum: two roundings of float (6e-8) a term",
          .run = [=](const StabilityOptions&) {
            return fast ? try_closed_sphere_fast(sphere) : try_closed_sphere(sphere);
          }};
}

Finding try_closed_sphere(const ClosedSphere& sphere) {
  const Furnace furnace = furnace_of(sphere);
  double error = 0, last = 0;
  for (int i = 0; i < paths; ++i) {
    const Sampler sampler(3, i, 0, 0);
    const RadiancePair pair =
        radiance_with_and_without(furnace.wall, sphere.object_inside ? &furnace.object : nullptr,
                                  first_hit(furnace, sampler), furnace.light, sampler);
    for (const Split& split : {pair.without_object, pair.with_object}) {
      last = split.total()[1];
      error = worse(error, relative_error(last, expected_radiance(sphere)));
    }
  }
  return finding(sphere, error, last);
}

Finding try_closed_sphere_fast(const ClosedSphere& sphere) {
  const Furnace furnace = furnace_of(sphere);
  const Worlds worlds{.room = &furnace.wall, .objects = &furnace.object, .others = {}, .object_count = 1};
  PathBatch batch;
  double error = 0, last = 0;
  for (int i = 0; i < paths; ++i) {
    const Sampler sampler(3, i, 0, 0);
    batch.begin(worlds, furnace.light);
    batch.add({worlds.all(), first_hit(furnace, sampler), sampler});
    const PathLight found = batch.trace().front();
    for (const int world : {0, 1}) {
      last = found.light[world].total()[1];
      error = worse(error, relative_error(last, expected_radiance(sphere)));
    }
  }
  return finding(sphere, error, last);
}

}  // namespace

StabilityCases radiosity_cases() {
  return {
      sphere_case("albedo-0", {.albedo = 0.0F, .bounces = 4}),
      sphere_case("albedo-0.999", {.albedo = 0.999F, .bounces = 64, .object_inside = true}),
      sphere_case("albedo-1", {.albedo = 1.0F, .bounces = 64, .object_inside = true}),
      sphere_case("albedo-1-fast", {.albedo = 1.0F, .bounces = 64, .object_inside = true}, true),
      sphere_case("bounces-0", {.albedo = 0.6F, .bounces = 0, .object_inside = true}),
      sphere_case("bounces-1", {.albedo = 0.6F, .bounces = 1, .object_inside = true}),
      sphere_case("bounces-64", {.albedo = 0.6F, .bounces = 64, .object_inside = true}),
      {.group = "light",
       .name = "bounces-without-end",
       .tried = "the sphere of albedo 0.9 with 512 bounces",
       .expected = "radiosity 1 / (1 - 0.9) = 10",
       .unit = "relative",
       .tolerance = 2 * 514 * 6e-8,
       .reason = "0.9^514 is 3e-24; two roundings of float a term remain",
       .run =
           [](const StabilityOptions&) {
             const ClosedSphere sphere{.albedo = 0.9F, .bounces = 512};
             Finding finding = try_closed_sphere(sphere);
             finding.error = worse(finding.error, relative_error(expected_radiance(sphere), 10));
             return finding;
           }},
  };
}

}  // namespace seamline::stability
