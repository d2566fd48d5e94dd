#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace seamline::renderer {

/// Values by direction from the panorama's centre, equirectangular as a depth map
/// (renderer/depth/depth_map.h): row 0 is the zenith, the middle column looks along -Z, +Y is up, texel
/// centres at half integers. `Value` may be multiplied by a float and added.
template <class Value>
struct DirectionMap {
  int width_px = 0;                 ///< even
  int height_px = 0;                ///< half of that
  std::vector<Value> texels;        ///< row by row
  std::vector<std::uint8_t> known;  ///< of each texel; empty: all are
  Value elsewhere = {};             ///< where no texel around a direction is known

  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_px) +
           static_cast<std::size_t>(column);
  }

  /// The texel that a direction of any length but 0 lies in, as `at` places it.
  [[nodiscard]] std::size_t texel_in(const Eigen::Vector3f& direction) const {
    const Eigen::Array2f place = place_of(direction);
    const int column = static_cast<int>(std::floor(place[0] + 0.5F)), row = static_cast<int>(place[1] + 0.5F);
    return index((column + width_px) % width_px, std::clamp(row, 0, height_px - 1));
  }

  /// Bilinear between known texels, wrapping around, rows clamped at the poles. `direction` has any length
  /// but 0.
  [[nodiscard]] Value at(const Eigen::Vector3f& direction) const {
    const Eigen::Array2f place = place_of(direction);
    const float column = place[0], row = place[1];
    const float left = std::floor(column), top = std::floor(row);
    const float right_share = column - left, lower_share = row - top;
    Value sum = 0.0F * elsewhere;
    float weights = 0;
    for (const int dy : {0, 1})
      for (const int dx : {0, 1}) {
        const int x = (static_cast<int>(left) + dx + 2 * width_px) % width_px;
        const int y = std::clamp(static_cast<int>(top) + dy, 0, height_px - 1);
        const std::size_t i = index(x, y);
        const float weight =
            (dx == 0 ? 1.0F - right_share : right_share) * (dy == 0 ? 1.0F - lower_share : lower_share);
        if ((!known.empty() && known[i] == 0) || !(weight > 0.0F)) continue;
        sum = sum + weight * texels[i];
        weights += weight;
      }
    if (!(weights > 0.0F)) return elsewhere;
    return (1.0F / weights) * sum;
  }

 private:
  /// Column and row, whole numbers at the texels' centres.
  [[nodiscard]] Eigen::Array2f place_of(const Eigen::Vector3f& direction) const {
    const float elevation =
        std::atan2(direction.y(), std::hypot(direction.x(), direction.z())) * std::numbers::inv_pi_v<float>;
    const float azimuth = std::atan2(direction.x(), -direction.z()) * (0.5F * std::numbers::inv_pi_v<float>);
    return {(azimuth + 0.5F) * static_cast<float>(width_px) - 0.5F,
            (0.5F - elevation) * static_cast<float>(height_px) - 0.5F};
  }
};

}  // namespace seamline::renderer
