#pragma once
#include <array>
#include <vector>

#include "renderer/camera.h"
#include "renderer/scene_sums.h"
#include "renderer/tiles.h"

namespace seamline {

/// Bounce light of one pixel without its albedo, in both halves of samples: sums and the number of samples
/// they are over. Filtering sums and numbers apart lets a pixel count for what it saw.
struct BounceTexel {
  std::array<Rgb, 2> no = {Rgb::Zero(), Rgb::Zero()};      ///< without the object
  std::array<Rgb, 2> change = {Rgb::Zero(), Rgb::Zero()};  ///< with it, minus without
  std::array<float, 2> no_samples = {};
  std::array<float, 2> change_samples = {};
};

/// The surface a pixel shows: unit normal (zero: none, the pixel is left alone), position, albedo.
struct Surface {
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  Eigen::Vector3f position_m = Eigen::Vector3f::Zero();
  Rgb albedo = Rgb::Ones();
  float distance_m = 0;
  float inverse_reach = 0;  ///< 1 / harmonic mean distance to what sends the bounce light, in 1/m
};
[[nodiscard]] Surface surface_of(const GuideSums& sums, float samples, const Camera& camera, int x, int y);

/// How far the filter reaches: `levels` a-trous levels (0: nothing is filtered), but never farther than
/// reach / `reach_divisor`, where reach is how far gather rays get from there (the radius in which bounce
/// light is alike: Ward et al., SIGGRAPH 1988).
struct FilterStrength {
  int levels = 2;
  float reach_divisor = 2.0F;
};

/// Filters bounce light among pixels that show like surfaces: a-trous levels (Dammertz et al., HPG 2010) with
/// a cubic B-spline kernel, weights falling with the angle between the normals, with the distance from the
/// pixel's tangent plane and with the distance along it, never with colour. Row by row, `texels` in place;
/// those outside the tiles of `where` stay as they are.
void filter_bounce(const std::vector<Surface>& surfaces, const TileGrid& grid, const FilterStrength& strength,
                   int threads, std::vector<BounceTexel>& texels, const TileSet& where);
/// The same everywhere.
void filter_bounce(const std::vector<Surface>& surfaces, const TileGrid& grid, const FilterStrength& strength,
                   int threads, std::vector<BounceTexel>& texels);
/// How far away a pixel can be and still count, in pixels: at most half a tile for the strengths in use.
[[nodiscard]] inline int filter_radius_px(const FilterStrength& strength) {
  return 2 * ((1 << strength.levels) - 1);
}

}  // namespace seamline
