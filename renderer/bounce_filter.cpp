#include "renderer/bounce_filter.h"

#include <cmath>

#include "renderer/b_spline.h"
#include "renderer/parallel.h"

namespace seamline {
namespace {

constexpr float plane_tolerance = 0.01F;  // distance from the tangent plane, relative to the distance

/// 1 for like surfaces, 0 for unlike ones.
float likeness(const Surface& a, const Surface& b, float reach_divisor) {
  const float cosine = a.normal.dot(b.normal);
  if (!(cosine > 0.5F)) return 0.0F;
  const float off_plane =
      a.normal.dot(b.position_m - a.position_m) / (plane_tolerance * a.distance_m + 1e-30F);
  const float near = 1.0F - off_plane * off_plane;
  if (!(near > 0.0F)) return 0.0F;
  const float inverse_reach = std::max(a.inverse_reach, b.inverse_reach) * reach_divisor;
  const float far = 1.0F - (b.position_m - a.position_m).squaredNorm() * inverse_reach * inverse_reach;
  if (!(far > 0.0F)) return 0.0F;
  const float c2 = cosine * cosine, c4 = c2 * c2, c8 = c4 * c4, c16 = c8 * c8;
  return c16 * c16 * near * near * far * far;
}

}  // namespace

Surface surface_of(const GuideSums& sums, float samples, const Camera& camera, int x, int y) {
  if (samples <= 0.0F) return {};
  Surface surface;
  surface.distance_m = sums.distance_m / samples;
  surface.inverse_reach = sums.inverse_reach / samples;
  const float length = sums.normal.norm();
  if (length > 0.0F) surface.normal = sums.normal / length;
  surface.position_m = camera.centre_direction(x, y) * surface.distance_m;
  surface.albedo = (sums.albedo / samples).max(1e-4F);
  return surface;
}

void filter_bounce(const std::vector<Surface>& surfaces, const TileGrid& grid, const FilterStrength& strength,
                   int threads, std::vector<BounceTexel>& texels, const TileSet& where) {
  std::vector<BounceTexel> filtered;
  if (strength.levels > 0) filtered = texels;
  for (int level = 0; level < strength.levels; ++level) {
    const int step = 1 << level;
    const auto filter_pixel = [&](int x, int y) {
      const std::size_t centre = grid.index(x, y);
      const Surface& surface = surfaces[centre];
      Eigen::Array<float, 16, 1>& sum = filtered[centre].sums;
      sum.setZero();
      if (surface.normal.isZero()) return;
      for (int dy = -2; dy <= 2; ++dy)
        for (int dx = -2; dx <= 2; ++dx) {
          const int column = x + dx * step, row = y + dy * step;
          if (column < 0 || row < 0 || column >= grid.width_px || row >= grid.height_px) continue;
          const std::size_t i = grid.index(column, row);
          const float share =
              b_spline[static_cast<std::size_t>(dx + 2)] * b_spline[static_cast<std::size_t>(dy + 2)];
          const float weight =
              i == centre ? share : share * likeness(surface, surfaces[i], strength.reach_divisor);
          if (weight > 0.0F) sum += weight * texels[i].sums;
        }
    };
    parallel_for(grid.count(), threads, [&](int tile) {
      if (where[static_cast<std::size_t>(tile)] == 0) return;
      const TileGrid::Rectangle r = grid.rectangle(tile);
      for (int y = r.top; y < r.bottom; ++y)
        for (int x = r.left; x < r.right; ++x) filter_pixel(x, y);
    });
    std::swap(texels, filtered);
  }
}

void filter_bounce(const std::vector<Surface>& surfaces, const TileGrid& grid, const FilterStrength& strength,
                   int threads, std::vector<BounceTexel>& texels) {
  filter_bounce(surfaces, grid, strength, threads, texels,
                TileSet(static_cast<std::size_t>(grid.count()), 1));
}

}  // namespace seamline
