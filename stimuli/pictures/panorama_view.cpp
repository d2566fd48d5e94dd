#include "stimuli/pictures/panorama_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/arithmetic/bilinear.h"
#include "support/arithmetic/grid_index.h"

namespace seamline::inline stimuli {
namespace {

constexpr double half_turn_rad = std::numbers::pi, rad_of_deg = std::numbers::pi / 180;

/// Codes of a panorama, whose columns go round.
class PanoramaCodes {
 public:
  explicit PanoramaCodes(const ByteImage& panorama) : panorama_(panorama) {}

  [[nodiscard]] double at(const Eigen::Vector3d& direction, int channel) const {
    const double u =
        (std::atan2(direction.x(), -direction.z()) / (2 * half_turn_rad) + 0.5) * panorama_.width_px - 0.5;
    const double v =
        (0.5 - std::atan2(direction.y(), std::hypot(direction.x(), direction.z())) / half_turn_rad) *
            panorama_.height_px -
        0.5;
    return bilinear(between_cells(u, v), [&](int x, int y) { return code(x, y, channel); });
  }

 private:
  [[nodiscard]] double code(int x, int y, int channel) const {
    const int column = (x + panorama_.width_px) % panorama_.width_px;
    const int row = std::clamp(y, 0, panorama_.height_px - 1);
    return panorama_
        .values[grid_index(row, column, panorama_.width_px) * static_cast<std::size_t>(panorama_.channels) +
                static_cast<std::size_t>(channel)];
  }

  const ByteImage& panorama_;
};

}  // namespace

ByteImage panorama_view(const ByteImage& panorama, const LookDefinition& look,
                        const std::array<double, 2>& pose_deg) {
  const auto [width_px, height_px] = look.view_px;
  const double step = 2 * std::tan(0.5 * look.horizontal_fov_deg * rad_of_deg) / width_px;
  const Eigen::Matrix3d axes = (Eigen::AngleAxisd(-pose_deg[0] * rad_of_deg, Eigen::Vector3d::UnitY()) *
                                Eigen::AngleAxisd(pose_deg[1] * rad_of_deg, Eigen::Vector3d::UnitX()))
                                   .toRotationMatrix();
  const PanoramaCodes codes(panorama);
  ByteImage view{width_px, height_px, panorama.channels, {}};
  for (int y = 0; y < height_px; ++y)
    for (int x = 0; x < width_px; ++x) {
      const Eigen::Vector3d direction =
          axes * Eigen::Vector3d((x + 0.5 - 0.5 * width_px) * step, (0.5 * height_px - y - 0.5) * step, -1);
      for (int c = 0; c < panorama.channels; ++c)
        view.values.push_back(static_cast<std::uint8_t>(std::lround(codes.at(direction, c))));
    }
  return view;
}

std::array<double, 2> object_pose_deg(const ByteImage& object_ids, int object_index) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int y = 0; y < object_ids.height_px; ++y) {
    const double elevation = (0.5 - (y + 0.5) / object_ids.height_px) * half_turn_rad;
    for (int x = 0; x < object_ids.width_px; ++x) {
      if (object_ids.values[grid_index(y, x, object_ids.width_px)] != object_index) continue;
      const double azimuth = ((x + 0.5) / object_ids.width_px - 0.5) * 2 * half_turn_rad,
                   flat = std::cos(elevation);
      sum += flat * Eigen::Vector3d(std::sin(azimuth) * flat, std::sin(elevation), -std::cos(azimuth) * flat);
    }
  }
  if (sum.isZero()) return {0, 0};
  return {std::atan2(sum.x(), -sum.z()) / rad_of_deg,
          std::atan2(sum.y(), std::hypot(sum.x(), sum.z())) / rad_of_deg};
}

}  // namespace seamline::inline stimuli
