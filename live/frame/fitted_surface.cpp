#include "live/frame/fitted_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace seamline::live {
namespace {

constexpr float same_share = 0.1F;  ///< of the distance; more is another surface
constexpr float fewest = 6;
constexpr int taps = 2;  ///< on each side

/// Sums of least squares of v = a + b x + c y.
struct PlaneSums {
  float n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0, v = 0, xv = 0, yv = 0;

  void add(float at_x, float at_y, float value) {
    n += 1;
    x += at_x;
    y += at_y;
    xx += at_x * at_x;
    xy += at_x * at_y;
    yy += at_y * at_y;
    v += value;
    xv += at_x * value;
    yv += at_y * value;
  }

  /// a, b, c; none where the places lie in one line.
  [[nodiscard]] std::optional<Eigen::Vector3f> solved() const {
    if (n < fewest) return std::nullopt;
    const float mean_x = x / n, mean_y = y / n, mean_v = v / n;
    const float cxx = xx - mean_x * x, cxy = xy - mean_x * y, cyy = yy - mean_y * y;
    const float cxv = xv - mean_x * v, cyv = yv - mean_y * v;
    const float det = cxx * cyy - cxy * cxy;
    if (!(det > 1e-3F * (cxx + cyy) * (cxx + cyy))) return std::nullopt;
    const float b = (cxv * cyy - cyv * cxy) / det, c = (cyv * cxx - cxv * cxy) / det;
    return Eigen::Vector3f(mean_v - b * mean_x - c * mean_y, b, c);
  }
};

}  // namespace

std::optional<FittedSurface> fitted_surface(const renderer::DepthPicture& depth, const PixelRays& rays, int x,
                                            int y, int reach_px) {
  const float centre_m = depth.at(x, y);
  const float nearest_m = (1 - same_share) * centre_m, farthest_m = (1 + same_share) * centre_m;
  PlaneSums sums;
  for (int row = -taps; row <= taps; ++row) {
    const int at_y = y + row * reach_px / taps;
    if (at_y < 0 || at_y >= depth.height_px) continue;
    for (int column = -taps; column <= taps; ++column) {
      const int at_x = x + column * reach_px / taps;
      if (at_x < 0 || at_x >= depth.width_px) continue;
      const float planar_m = depth.at(at_x, at_y);
      if (!(planar_m >= nearest_m && planar_m <= farthest_m)) continue;
      sums.add(static_cast<float>(at_x - x), static_cast<float>(at_y - y), centre_m / planar_m);
    }
  }
  const auto plane = sums.solved();
  if (!plane || !((*plane)[0] > 0.0F)) return std::nullopt;
  // A plane m . P = 1 has 1 / depth = m . direction.
  const Eigen::Vector3f ahead = rays.direction(x, y), right = rays.right_per_px(), down = rays.down_per_px();
  const Eigen::Vector3f normal =
      ((*plane)[0] * right.cross(down) + (*plane)[1] * down.cross(ahead) + (*plane)[2] * ahead.cross(right))
          .normalized();
  if (!normal.allFinite()) return std::nullopt;
  return FittedSurface{.planar_m = centre_m / (*plane)[0],
                       .normal = normal.dot(ahead) > 0.0F ? Eigen::Vector3f(-normal) : normal};
}

}  // namespace seamline::live
