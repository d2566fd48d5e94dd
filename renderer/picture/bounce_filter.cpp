#include "renderer/picture/bounce_filter.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "raytracer/common/parallel.h"

namespace seamline::renderer {
namespace {

constexpr float plane_tolerance = 0.01F;  // distance from the tangent plane, relative to the distance

/// Weights below this are none: surfaces that are not alike.
constexpr float negligible = 1e-6F;
constexpr int tile_side = TileGrid::side_px;

using TileRow = Eigen::Array<float, tile_side, 1>;

/// The column of a panorama that a column beside it is; any other picture's is itself.
int wrapped(const TileGrid& grid, int x) {
  return grid.wraps ? (x + grid.width_px) % grid.width_px : x;
}

/// The surfaces of a tile and of as many pixels around it as one level reaches, a number each to an array, so
/// that the compiler compares a row of pixels at a time. Beyond the picture there is no surface; beside a
/// panorama there is its other side.
class TileSurfaces {
 public:
  TileSurfaces(const std::vector<Surface>& surfaces, const TileGrid& grid, const TileGrid::Rectangle& tile,
               int margin_px)
      : stride_(tile_side + 2 * margin_px), margin_px_(margin_px) {
    for (std::vector<float>* values : {&nx_, &ny_, &nz_, &x_m_, &y_m_, &z_m_, &plane_, &inverse_reach_})
      values->assign(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(stride_), 0.0F);
    const int left = tile.left - margin_px, top = tile.top - margin_px;
    for (int y = std::max(top, 0); y < std::min(top + stride_, grid.height_px); ++y)
      for (int x = grid.wraps ? left : std::max(left, 0);
           x < (grid.wraps ? left + stride_ : std::min(left + stride_, grid.width_px)); ++x)
        set(place(x - tile.left, y - tile.top), surfaces[grid.index(wrapped(grid, x), y)]);
  }

  /// How like the surfaces of the tile's row `y` and those `dx`, `dy` pixels away are: 1 for like ones, 0 for
  /// unlike ones and where there is none. The same seen from there, to the last bit: what changes its sign is
  /// squared, and everything else is a product of the two or the larger one.
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
};

constexpr float own_weight = b_spline[2] * b_spline[2];

/// One of the 24 neighbours of a pixel, `step` pixels apart.
struct Neighbour {
  int dx, dy;        ///< in steps, -2 to 2
  float share;       ///< of the B-spline
  std::size_t pair;  ///< which of the 12 pairs: itself, or the one that it is seen from
  bool is_ahead;     ///< to the right or below: its pair is kept here; else there
};

/// Row by row, as they are added up.
constexpr std::array<Neighbour, 24> neighbours = [] {
  std::array<Neighbour, 24> out{};
  for (std::size_t i = 0; i < 25; ++i) {
    if (i == 12) continue;
    const std::size_t n = i < 12 ? i : i - 1;
    out[n] = {static_cast<int>(i % 5) - 2, static_cast<int>(i / 5) - 2, b_spline[i % 5] * b_spline[i / 5],
              i < 12 ? 11 - i : n - 12, i > 12};
  }
  return out;
}();

/// What one level of the filter weighs neighbours with, B-spline times likeness: of every pixel in the tiles
/// asked for those with the 12 neighbours ahead of it. With the others they are the same, seen from there.
class PairWeights {
 public:
  explicit PairWeights(const TileGrid& grid)
      : grid_(grid),
        stride_(static_cast<std::size_t>(grid.columns() * tile_side + 2 * margin_px)),
        plane_(stride_ * static_cast<std::size_t>(grid.height_px)),
        weights_(std::make_unique_for_overwrite<float[]>(plane_ * neighbours.size() / 2)),
        sums_(std::make_unique_for_overwrite<float[]>(plane_)) {}

  /// The pairs of a tile.
  void find(const std::vector<Surface>& surfaces, int tile, int step, float reach_divisor) {
    const TileGrid::Rectangle r = grid_.rectangle(tile);
    const TileSurfaces here(surfaces, grid_, r, 2 * step);
    for (int y = r.top; y < r.bottom; ++y)
      for (const Neighbour& other : neighbours) {
        if (!other.is_ahead) continue;
        float* plane = weights_.get() + other.pair * plane_;
        row(plane, r.left, y) =
            other.share * here.likeness(y - r.top, other.dx * step, other.dy * step, reach_divisor);
        fill_margins(plane, r, y);
      }
  }
  /// The sums of the weights of a tile's pixels, their own among them; 0 without a surface. Pairs of the
  /// tiles around it are known.
  void sum(const std::vector<Surface>& surfaces, int tile, int step) {
    const TileGrid::Rectangle r = grid_.rectangle(tile);
    for (int y = r.top; y < r.bottom; ++y) {
      TileRow sum = own_weight * presence(surfaces, r, y);
      for (const Neighbour& other : neighbours) sum += at(other, r.left, y, step);
      row(sums_.get(), r.left, y) = sum;
      fill_margins(sums_.get(), r, y);
    }
  }

  /// Of the row of a tile that begins at a pixel.
  [[nodiscard]] TileRow at(const Neighbour& other, int left, int y, int step) const {
    const int pair_y = other.is_ahead ? y : y + other.dy * step;
    if (pair_y < 0) return TileRow::Zero();
    return row(weights_.get() + other.pair * plane_, other.is_ahead ? left : left + other.dx * step, pair_y);
  }
  /// The larger sum of weights, of its pixels and of the neighbours; of those beyond the picture nothing.
  [[nodiscard]] TileRow larger_sum(const Neighbour& other, int left, int y, int step) const {
    const auto here = row(sums_.get(), left, y);
    const int other_y = y + other.dy * step;
    if (other_y < 0 || other_y >= grid_.height_px) return here;
    return here.max(row(sums_.get(), left + other.dx * step, other_y));
  }
  /// 1 where there is a surface, else 0.
  [[nodiscard]] TileRow presence(const std::vector<Surface>& surfaces, const TileGrid::Rectangle& tile,
                                 int y) const {
    TileRow out = TileRow::Zero();
    for (int x = tile.left; x < tile.right; ++x)
      out[x - tile.left] = surfaces[grid_.index(x, y)].normal.isZero() ? 0.0F : 1.0F;
    return out;
  }

 private:
  static constexpr int margin_px = 16;  ///< to the left and right of the picture, where weights are 0, or
                                        ///< a panorama's other side's

  [[nodiscard]] std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y) * stride_ + static_cast<std::size_t>(x + margin_px);
  }
  [[nodiscard]] Eigen::Map<TileRow> row(float* plane, int x, int y) const {
    return Eigen::Map<TileRow>(plane + place(x, y));
  }
  [[nodiscard]] Eigen::Map<const TileRow> row(const float* plane, int x, int y) const {
    return Eigen::Map<const TileRow>(plane + place(x, y));
  }
  void fill_margins(float* plane, const TileGrid::Rectangle& tile, int y) const {
    if (grid_.wraps) {
      if (tile.left == 0) std::copy_n(plane + place(0, y), margin_px, plane + place(grid_.width_px, y));
      if (tile.right == grid_.width_px)
        std::copy_n(plane + place(tile.right - margin_px, y), margin_px, plane + place(-margin_px, y));
      return;
    }
    if (tile.left == 0) std::fill_n(plane + place(-margin_px, y), margin_px, 0.0F);
    if (tile.right == grid_.width_px)
      std::fill_n(plane + place(grid_.columns() * tile_side, y), margin_px, 0.0F);
  }

  TileGrid grid_;
  std::size_t stride_, plane_;        ///< floats of a row and of a plane
  std::unique_ptr<float[]> weights_;  ///< a plane a pair
  std::unique_ptr<float[]> sums_;
};

/// One level of the filter in one tile. Where the sum is kept, two pixels exchange by their weight over the
/// larger of their sums, and what a pixel does not get from others it keeps of its own: what one gets another
/// gives. Else weights are what they are, because texels count their samples.
void filter_tile(const PairWeights& weights, const std::vector<Surface>& surfaces, const TileGrid& grid,
                 int tile, int step, bool keeps_sum, const std::vector<BounceTexel>& texels,
                 std::vector<BounceTexel>& filtered) {
  const TileGrid::Rectangle r = grid.rectangle(tile);
  const int count = r.right - r.left;
  std::array<BounceTexel, tile_side> sum;
  for (int y = r.top; y < r.bottom; ++y) {
    sum.fill({});
    TileRow own = weights.presence(surfaces, r, y) * (keeps_sum ? 1.0F : own_weight);
    for (const Neighbour& other : neighbours) {
      const TileRow weight = weights.at(other, r.left, y, step);
      TileRow share = (weight > negligible).select(weight, TileRow::Zero());
      if (keeps_sum) {
        share /= weights.larger_sum(other, r.left, y, step).max(negligible);
        own -= share;
      }
      const int line = y + other.dy * step, column = r.left + other.dx * step;
      for (int i = 0; i < count; ++i)
        if (share[i] > 0.0F)
          sum[i].sums += share[i] * texels[grid.index(wrapped(grid, column + i), line)].sums;
    }
    for (int i = 0; i < count; ++i) sum[i].sums += own[i] * texels[grid.index(r.left + i, y)].sums;
    std::copy_n(sum.begin(), count, filtered.begin() + static_cast<std::ptrdiff_t>(grid.index(r.left, y)));
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
  if (camera.eyes) surface.position_m += camera.place_m(x, y);
  surface.albedo = (sums.albedo / samples).max(1e-4F);
  return surface;
}

void filter_bounce(const std::vector<Surface>& surfaces, const TileGrid& grid, const FilterStrength& strength,
                   int threads, std::vector<BounceTexel>& texels, const TileSet& where) {
  if (strength.levels == 0) return;
  std::vector<BounceTexel> filtered = texels;
  // A pixel exchanges with those beside its tile, whose sums are of pairs with those beside them.
  const TileSet beside = with_neighbours(grid, where);
  const TileSet paired = strength.keeps_sum ? with_neighbours(grid, beside) : beside;
  PairWeights weights(grid);
  const auto each_tile = [&](const TileSet& tiles, const auto& work) {
    parallel_for(grid.count(), threads, [&](int tile) {
      if (tiles[tile] != 0) work(tile);
    });
  };
  for (int level = 0; level < strength.levels; ++level) {
    const int step = 1 << level;
    each_tile(paired, [&](int tile) { weights.find(surfaces, tile, step, strength.reach_divisor); });
    if (strength.keeps_sum) each_tile(beside, [&](int tile) { weights.sum(surfaces, tile, step); });
    each_tile(where, [&](int tile) {
      filter_tile(weights, surfaces, grid, tile, step, strength.keeps_sum, texels, filtered);
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
