#pragma once
#include <array>
#include <vector>

#include "raytracer/common/tiles.h"
#include "raytracer/scene/camera.h"
#include "renderer/picture/scene_sums.h"

namespace seamline::renderer {

/// Cubic B-spline at whole steps: the kernel of the a-trous filters.
inline constexpr std::array<float, 5> b_spline = {1.0F / 16, 4.0F / 16, 6.0F / 16, 4.0F / 16, 1.0F / 16};

/// Bounce light of one pixel without its albedo, in both halves of samples: sums and the number of samples
/// they are over. Filtering sums and numbers apart lets a pixel count for what it saw. All are one array,
/// because filtering adds whole texels.
struct BounceTexel {
  Eigen::Array<float, 16, 1> sums = Eigen::Array<float, 16, 1>::Zero();

  /// Without the object,
  [[nodiscard]] auto without_object(std::size_t half) { return sums.segment<3>(first(half)); }
  [[nodiscard]] auto without_object(std::size_t half) const { return sums.segment<3>(first(half)); }
  /// and with it, minus without.
  [[nodiscard]] auto change(std::size_t half) { return sums.segment<3>(first(half) + 3); }
  [[nodiscard]] auto change(std::size_t half) const { return sums.segment<3>(first(half) + 3); }
  [[nodiscard]] float& without_samples(std::size_t half) { return sums[first(half) + 6]; }
  [[nodiscard]] float without_samples(std::size_t half) const { return sums[first(half) + 6]; }
  [[nodiscard]] float& change_samples(std::size_t half) { return sums[first(half) + 7]; }
  [[nodiscard]] float change_samples(std::size_t half) const { return sums[first(half) + 7]; }

 private:
  [[nodiscard]] static Eigen::Index first(std::size_t half) { return half == 0 ? 0 : 8; }
};

/// The surface a pixel shows: unit normal (zero: none, the pixel is left alone), position, albedo.
struct Surface {
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  Eigen::Vector3f position_m = Eigen::Vector3f::Zero();
  Rgb albedo = Rgb::Ones();
  float distance_m = 0;
  float inverse_reach = 0;  ///< 1 / harmonic mean distance to what sends the bounce light, in 1/m
};
[[nodiscard]] Surface surface_of(const SeenSurface& sums, float samples, const Camera& camera, int x, int y);

/// How far the filter reaches: `levels` a-trous levels (0: nothing is filtered), but never farther than
/// reach / `reach_divisor`, where reach is how far gather rays get from there (the radius in which bounce
/// light is alike: Ward et al., SIGGRAPH 1988).
struct FilterStrength {
  int levels = 2;
  float reach_divisor = 2.0F;
  /// Whether pixels exchange light, so that its sum stays; else each is a mean over those like it, in half
  /// the time: enough for a ratio, whose two lights lose and gain alike.
  bool keeps_sum = true;

  bool operator==(const FilterStrength&) const = default;
};
inline constexpr FilterStrength no_filter{.levels = 0};

/// Filters bounce light among pixels that show like surfaces: a-trous levels (Dammertz et al., HPG 2010) with
/// a cubic B-spline kernel, weights falling with the angle between the normals, with the distance from the
/// pixel's tangent plane and with the distance along it, never with colour. Weights are the same from either
/// side, and pixels exchange light, so that of pixels with as many samples the sum stays what it was
/// (`keeps_sum`). A mean over like neighbours counts pixels in creases, which are dark and have few, for two
/// thirds of what they are: it is too bright there, however many samples it has. Row by row, `texels` in
/// place; those outside the tiles of `where` stay as they are.
void filter_bounce(const std::vector<Surface>& surfaces, const TileGrid& grid, const FilterStrength& strength,
                   int threads, std::vector<BounceTexel>& texels, const TileSet& where);
/// The same everywhere.
void filter_bounce(const std::vector<Surface>& surfaces, const TileGrid& grid, const FilterStrength& strength,
                   int threads, std::vector<BounceTexel>& texels);
/// How far away a pixel can be and still count, in pixels: at most half a tile for the strengths in use.
[[nodiscard]] inline int filter_radius_px(const FilterStrength& strength) {
  return 2 * ((1 << strength.levels) - 1);
}

}  // namespace seamline::renderer
