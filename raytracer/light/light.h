#pragma once
#include <Eigen/Core>
#include <limits>
#include <memory>
#include <vector>

#include "raytracer/light/environment_map.h"
#include "raytracer/light/lamps.h"
#include "raytracer/material/direction_map.h"
#include "raytracer/material/hemisphere.h"
#include "support/arithmetic/colour.h"

namespace seamline::renderer {

class Geometry;

/// A directional light; hard when the angular radius is 0.
struct Sun {
  Eigen::Vector3f to_sun = Eigen::Vector3f::UnitY();  ///< unit
  Rgb irradiance_w_m2 = Rgb::Zero();                  ///< on a plane facing it
  float angular_radius_rad = 0.0F;
};

/// All light of a scene, and how far it is followed. What a scene has none of is not asked for.
struct Light {
  std::vector<Sun> suns = {};
  Rgb environment_radiance = Rgb::Zero();  ///< constant, from every direction; with a map: zero
  std::shared_ptr<const EnvironmentMap> environment = {};  ///< null: `environment_radiance` everywhere
  /// The local scene of a photographed panorama: the surfaces of the real world send what `environment`, the
  /// panorama, shows in their direction from the origin, and nothing else, because all light is in it. Each
  /// direction meets it once. Null: they send on what reaches them.
  std::shared_ptr<const Geometry> photographed = {};
  /// Of such a panorama: the sky behind its surfaces, known where one hides it. Rays that get past the local
  /// scene find it there. Null: nothing hides the sky, or there is none.
  std::shared_ptr<const DirectionMap<Rgb>> hidden_sky = {};
  std::vector<Lamp> lamps = {};
  std::shared_ptr<const EmittingSurfaces> emitters = {};  ///< null: no surface of the background emits
  /// Rays for the environment end here: infinity, or the ambient-occlusion distance in metres.
  float sky_distance_m = std::numeric_limits<float>::infinity();
  int bounces = 4;                 ///< further scatterings after the first
  bool ambient_occlusion = false;  ///< no sun, no bounce
  bool skips_sky = false;          ///< no ray is traced only for the environment, whose radiance is 0
  /// Rays a sample for what the environment sends straight to the surface that the camera sees; by the fast
  /// estimator only (`PathBatch`, `leaving_object`, `direct_on_object`).
  int sky_rays = 1;

  /// Radiance of the environment from a unit direction.
  [[nodiscard]] Rgb sky(const Eigen::Vector3f& direction) const {
    if (const Rgb* hidden = hidden_sky_in(direction)) return *hidden;
    return environment ? environment->radiance(direction) : environment_radiance;
  }
  /// Where a surface of the panorama hides the sky; else null.
  [[nodiscard]] const Rgb* hidden_sky_in(const Eigen::Vector3f& direction) const {
    if (!hidden_sky) return nullptr;
    const std::size_t texel = hidden_sky->texel_in(direction);
    return hidden_sky->known[texel] != 0 ? &hidden_sky->texels[texel] : nullptr;
  }
};

/// A direction towards the sun's disc for a point of [0, 1)^2; the centre when the sun is hard.
[[nodiscard]] Eigen::Vector3f direction_to_sun(const Sun& sun, const Eigen::Array2f& point);

/// With which those are chosen, per steradian; infinite when the sun is hard.
[[nodiscard]] float disc_density_sr(const Sun& sun);

/// Radiance of the sun's disc in a unit direction; 0 beside it, and of a hard sun everywhere.
[[nodiscard]] Rgb disc_radiance(const Sun& sun, const Eigen::Vector3f& direction);

/// Ray `number` of `count` about the same normal: the point's own direction turned, so that together they
/// look all around.
[[nodiscard]] Eigen::Vector3f turned_direction(const Eigen::Vector3f& normal, const Eigen::Array2f& point,
                                               int number, int count);

}  // namespace seamline::renderer
