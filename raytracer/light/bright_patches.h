#pragma once
#include <Eigen/Core>
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "raytracer/tracing/surface_point.h"

namespace seamline::renderer {

class Geometry;
struct Light;

/// The spot that a lamp without size lights on a surface close to it, as the plane that touches the surface
/// at the lamp's foot. It is a small, strong light of which no light sample knows, and that paths rarely
/// meet.
struct BrightPatch {
  Eigen::Vector3f foot_m = Eigen::Vector3f::Zero();   ///< of the perpendicular from the lamp
  Eigen::Vector3f normal = Eigen::Vector3f::UnitY();  ///< unit, towards the lamp
  float height_m = 0;                                 ///< of the lamp above its foot
  float strength_w_sr = 0;                            ///< luminance that the spot sends along its normal
};

/// Where paths of a scene look for the light of its lamps' spots. How well it describes them decides how much
/// noise is left and nothing else: every density below is exact, whatever really lies in its direction.
struct BrightPatches {
  static constexpr std::size_t most = 8;
  std::vector<BrightPatch> patches;  ///< at most `most`
  float elsewhere_w_m2 = 0;  ///< irradiance, as luminance, of all other bounce light and the sky; a guess
};

/// The spots of all lamps that stand closer to a surface than a fifth of the way to what else they light;
/// null where there is none. `everything`: all that lamps shine on.
[[nodiscard]] std::shared_ptr<const BrightPatches> find_bright_patches(const Light& light,
                                                                       const Geometry& everything);

/// Gives a light the spots of its lamps, where there are any. `background`: as of `add_emitters`.
void add_bright_patches(std::span<const std::shared_ptr<const SurfaceMesh>> background,
                        const Geometry& everything, Light& light);

/// How often paths that leave a point go towards each spot; those that are left go as the surface scatters.
struct PatchAim {
  std::array<float, BrightPatches::most> shares = {};
  float sum = 0;  ///< of the shares: at most a half; 0 where no spot is worth it
};

/// By what each spot sends to the point if nothing is in the way. None at mirrors (alpha below 0.25), whose
/// paths remember which lobe they came from.
[[nodiscard]] PatchAim aim_at_patches(const BrightPatches& bright, const SurfacePoint& from);

/// A direction to a place of a spot, with the density of the lamp's light there: on the plane at distance r
/// of the foot, h^3 / (h^2 + r^2)^(3/2) / (2 pi h^2), ten heights far. `point` is of [0, 1)^2; its first
/// number chooses the spot, too.
[[nodiscard]] Eigen::Vector3f direction_to_patch(const BrightPatches& bright, const PatchAim& aim,
                                                 const SurfacePoint& from, const Eigen::Array2f& point);

/// The density, per steradian, with which that direction is chosen among all paths; sums up to `aim.sum`.
[[nodiscard]] float patch_density_sr(const BrightPatches& bright, const PatchAim& aim,
                                     const SurfacePoint& from, const Eigen::Vector3f& direction);

}  // namespace seamline::renderer
