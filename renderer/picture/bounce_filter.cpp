#include "renderer/picture/bounce_filter.h"

#include <cmath>

#include "renderer/common/parallel.h"

namespace seamline::renderer {
namespace {

constexpr float plane_tolerance = 0.01F;  // distance from the tangent plane, relative to the distance

/// Weights below this are none: surfaces that are not alike.
constexpr float negligible = 1e-6F;
constexpr int tile_side = TileGrid::side_px;

using TileRow = Eigen::Array<float, tile_side, 1>;

/// The surfaces of a tile and of as many pixels around it as one level reaches, a number each to an array, so
/// that the compiler compares a row of pixels at a time. Beyond the picture there is no surface.
class TileSurfaces {
 public:
  TileSurfaces(const std::vector<Surface>& surfaces, const TileGrid& grid, const TileGrid::Rectangle& tile,
               int margin_px)
      : stride_(tile_side + 2 * margin_px), margin_px_(margin_px) {
    for (std::vector<float>* values :
         {&nx_, &ny_, &nz_, &x_m_, &y_m_, &z_m_, &plane_, &inverse_reach_, &weights_})
      values->assign(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(stride_), 0.0F);
    const int left = tile.left - margin_px, top = tile.top - margin_px;
    for (int y = std::max(top, 0); y < std::min(top + stride_, grid.height_px); ++y)
      for (int x = std::max(left, 0); x < std::min(left + stride_, grid.width_px); ++x)
        set(place(x - tile.left, y - tile.top), surfaces[grid.index(x, y)]);
  }

  /// How like the surfaces of the tile's row `y` and those `dx`, `dy` pixels away are: 1 for like ones, 0 for
  /// unlike ones and where there is none. The same seen from there, to the last bit but for rounding.
  [[nodiscard]] TileRow likeness(int y, int dx, int dy, float reach_divisor) const {
    const auto at = [&](const std::vector<float>& values, int x, int row) {
      return Eigen::Map<const TileRow>(&values[place(x, row)]);
    };
    const auto here = [&](const std::vector<float>& values) { return at(values, 0, y); };
    const auto there = [&](const std::vector<float>& values) { return at(values, dx, y + dy); };
    const TileRow x_m = there(x_m_) - here(x_m_), y_m = there(y_m_) - here(y_m_),
                  z_m = there(z_m_) - here(z_m_);
    const TileRow off_plane = (here(nx_) * x_m + here(ny_) * y_m + here(nz_) * z_m) * here(plane_);
    const TileRow off_other = (there(nx_) * x_m + there(ny_) * y_m + there(nz_) * z_m) * there(plane_);
    const TileRow inverse_reach = here(inverse_reach_).max(there(inverse_reach_)) * reach_divisor;
    const TileRow near = (1.0F - (off_plane * off_plane).max(off_other * off_other)).max(0.0F);
    const TileRow far =
        (1.0F - (x_m * x_m + y_m * y_m + z_m * z_m) * inverse_reach * inverse_reach).max(0.0F);
    TileRow alike =
        (here(nx_) * there(nx_) + here(ny_) * there(ny_) + here(nz_) * there(nz_)).max(0.0F);  // cosine
    for (int squared = 0; squared < 5; ++squared) alike *= alike;
    return alike * near * near * far * far;
  }
  /// Sums of weights of the whole picture, which `larger_sum` looks at.
  void take_weights(const std::vector<float>& sums, const TileGrid& grid, const TileGrid::Rectangle& tile) {
    const int left = tile.left - margin_px_, top = tile.top - margin_px_;
    for (int y = std::max(top, 0); y < std::min(top + stride_, grid.height_px); ++y)
      for (int x = std::max(left, 0); x < std::min(left + stride_, grid.width_px); ++x)
        weights_[place(x - tile.left, y - tile.top)] = sums[grid.index(x, y)];
  }
  /// Of the tile's row and of those `dx`, `dy` pixels away.
  [[nodiscard]] TileRow larger_sum(int y, int dx, int dy) const {
    const Eigen::Map<const TileRow> here(&weights_[place(0, y)]), there(&weights_[place(dx, y + dy)]);
    return here.max(there);
  }
  /// 1 where the tile's row has a surface, else 0.
  [[nodiscard]] TileRow presence(int y) const {
    TileRow out;
    for (int i = 0; i < tile_side; ++i) out[i] = plane_[place(i, y)] > 0.0F ? 1.0F : 0.0F;
    return out;
  }

 private:
  /// Of a pixel counted from the tile's corner.
  [[nodiscard]] std::size_t place(int x, int y) const {
    return static_cast<std::size_t>((y + margin_px_) * stride_ + x + margin_px_);
  }
  void set(std::size_t i, const Surface& surface) {
    if (surface.normal.isZero()) return;
    nx_[i] = surface.normal.x(), ny_[i] = surface.normal.y(), nz_[i] = surface.normal.z();
    x_m_[i] = surface.position_m.x(), y_m_[i] = surface.position_m.y(), z_m_[i] = surface.position_m.z();
    plane_[i] = 1.0F / (plane_tolerance * surface.distance_m + 1e-30F);
    inverse_reach_[i] = surface.inverse_reach;
  }

  int stride_, margin_px_;
  std::vector<float> nx_, ny_, nz_, x_m_, y_m_, z_m_;
  std::vector<float> plane_;  ///< 1 / (distance from the tangent plane at which surfaces are unlike)
  std::vector<float> inverse_reach_;
  std::vector<float> weights_;
};

constexpr float own_weight = b_spline[2] * b_spline[2];

/// Calls `each(dx, dy, weights)` for the 24 neighbours of a tile's row: B-spline times likeness.
template <class Each>
void each_neighbour(const TileSurfaces& surfaces, int y, int step, float reach_divisor, const Each& each) {
  for (int dy = -2; dy <= 2; ++dy)
    for (int dx = -2; dx <= 2; ++dx) {
      if (dx == 0 && dy == 0) continue;
      const float share =
          b_spline[static_cast<std::size_t>(dx + 2)] * b_spline[static_cast<std::size_t>(dy + 2)];
      each(dx * step, dy * step, TileRow(share * surfaces.likeness(y, dx * step, dy * step, reach_divisor)));
    }
}

/// The sum of the weights of every pixel of a tile, its own among them; 0 without a surface.
void sum_weights(const TileSurfaces& surfaces, const TileGrid& grid, const TileGrid::Rectangle& tile,
                 int step, float reach_divisor, std::vector<float>& sums) {
  for (int y = tile.top; y < tile.bottom; ++y) {
    TileRow sum = own_weight * surfaces.presence(y - tile.top);
    each_neighbour(surfaces, y - tile.top, step, reach_divisor,
                   [&](int, int, const TileRow& weight) { sum += weight; });
    std::copy_n(sum.data(), tile.right - tile.left,
                sums.begin() + static_cast<std::ptrdiff_t>(grid.index(tile.left, y)));
  }
}

/// One level of the filter in one tile. Where the sum is kept, two pixels exchange by their weight over the
/// larger of their sums, and what a pixel does not get from others it keeps of its own: what one gets another
/// gives. Else weights are what they are, because texels count their samples.
void filter_tile(const TileSurfaces& surfaces, const TileGrid& grid, const TileGrid::Rectangle& tile,
                 int step, const FilterStrength& strength, const std::vector<BounceTexel>& texels,
                 std::vector<BounceTexel>& filtered) {
  const int count = tile.right - tile.left;
  std::array<BounceTexel, tile_side> sum;
  for (int y = tile.top; y < tile.bottom; ++y) {
    sum.fill({});
    TileRow own = surfaces.presence(y - tile.top) * (strength.keeps_sum ? 1.0F : own_weight);
    const auto add_neighbours = [&](int dx, int dy, const TileRow& weight) {
      TileRow share = (weight > negligible).select(weight, TileRow::Zero());
      if (strength.keeps_sum) {
        share /= surfaces.larger_sum(y - tile.top, dx, dy).max(negligible);
        own -= share;
      }
      const int row = y + dy, column = tile.left + dx;
      for (int i = 0; i < count; ++i)
        if (share[i] > 0.0F)
          sum[static_cast<std::size_t>(i)].sums += share[i] * texels[grid.index(column + i, row)].sums;
    };
    each_neighbour(surfaces, y - tile.top, step, strength.reach_divisor, add_neighbours);
    for (int i = 0; i < count; ++i)
      sum[static_cast<std::size_t>(i)].sums += own[i] * texels[grid.index(tile.left + i, y)].sums;
    std::copy_n(sum.begin(), count, filtered.begin() + static_cast<std::ptrdiff_t>(grid.index(tile.left, y)));
  }
}

}  // namespace

Surface surface_of(const SeenSurface& sums, float samples, const Camera& camera, int x, int y) {
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
  // A pixel beside a tile exchanges with those in it.
  const TileSet beside = with_neighbours(grid, where);
  std::vector<float> sums(strength.keeps_sum && strength.levels > 0 ? texels.size() : 0, 0.0F);
  for (int level = 0; level < strength.levels; ++level) {
    const int step = 1 << level;
    parallel_for(grid.count(), threads, [&](int tile) {
      if (!strength.keeps_sum || beside[static_cast<std::size_t>(tile)] == 0) return;
      const TileGrid::Rectangle r = grid.rectangle(tile);
      sum_weights(TileSurfaces(surfaces, grid, r, 2 * step), grid, r, step, strength.reach_divisor, sums);
    });
    parallel_for(grid.count(), threads, [&](int tile) {
      if (where[static_cast<std::size_t>(tile)] == 0) return;
      const TileGrid::Rectangle r = grid.rectangle(tile);
      TileSurfaces here(surfaces, grid, r, 2 * step);
      if (strength.keeps_sum) here.take_weights(sums, grid, r);
      filter_tile(here, grid, r, step, strength, texels, filtered);
    });
    std::swap(texels, filtered);
  }
}

void filter_bounce(const std::vector<Surface>& surfaces, const TileGrid& grid, const FilterStrength& strength,
                   int threads, std::vector<BounceTexel>& texels) {
  filter_bounce(surfaces, grid, strength, threads, texels,
                TileSet(static_cast<std::size_t>(grid.count()), 1));
}

}  // namespace seamline::renderer
