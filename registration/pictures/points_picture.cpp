#include "registration/pictures/points_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace seamline::registration {
namespace {

constexpr int width_px = 720, height_px = 540;
constexpr double turn_rad = 35 * std::numbers::pi / 180, tilt_rad = 12 * std::numbers::pi / 180;
constexpr double focal_px = 620;

using Colour = std::array<std::uint8_t, 3>;

/// Points in a frame turned about their middle, nearest first in each pixel.
class View {
 public:
  explicit View(const Eigen::Vector3d& middle_m)
      : picture_{.width_px = width_px, .height_px = height_px, .channels = 3, .values = {}},
        depth_m_(static_cast<std::size_t>(width_px) * height_px, std::numeric_limits<double>::infinity()) {
    picture_.values.assign(depth_m_.size() * 3, 255);
    turn_ = Eigen::AngleAxisd(tilt_rad, Eigen::Vector3d::UnitX()) *
            Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitY());
    // Far enough back that the cameras, which stand where the middle is measured from, are seen too.
    away_m_ = 1.45 * middle_m.norm();
    middle_m_ = 0.55 * middle_m;
  }

  /// A square of `side_px` pixels.
  void add(const Eigen::Vector3d& place_m, const Colour& colour, int side_px) {
    const Eigen::Vector3d seen_m = turn_ * (place_m - middle_m_) + Eigen::Vector3d(0, 0, away_m_);
    if (!(seen_m.z() > 0.05 * away_m_)) return;
    const double u = 0.5 * width_px + focal_px * seen_m.x() / seen_m.z(),
                 v = 0.5 * height_px + focal_px * seen_m.y() / seen_m.z();
    if (!(u > -8 && v > -8 && u < width_px + 8 && v < height_px + 8)) return;
    const int left_px = static_cast<int>(std::floor(u - 0.5 * (side_px - 1))),
              top_px = static_cast<int>(std::floor(v - 0.5 * (side_px - 1)));
    for (int y = std::max(top_px, 0); y < std::min(top_px + side_px, height_px); ++y)
      for (int x = std::max(left_px, 0); x < std::min(left_px + side_px, width_px); ++x) {
        const std::size_t at = static_cast<std::size_t>(y) * width_px + static_cast<std::size_t>(x);
        if (!(seen_m.z() < depth_m_[at])) continue;
        depth_m_[at] = seen_m.z();
        std::copy(colour.begin(), colour.end(),
                  picture_.values.begin() + static_cast<std::ptrdiff_t>(3 * at));
      }
  }

  void add_line(const Eigen::Vector3d& from_m, const Eigen::Vector3d& to_m, const Colour& colour) {
    constexpr int steps = 400;
    for (int i = 0; i <= steps; ++i) add(from_m + (to_m - from_m) * i / steps, colour, 3);
  }

  [[nodiscard]] ByteImage take() { return std::move(picture_); }

 private:
  ByteImage picture_;
  std::vector<double> depth_m_;
  Eigen::Matrix3d turn_;
  Eigen::Vector3d middle_m_;
  double away_m_ = 1;
};

/// A camera as the pyramid of its view, so high.
void add_camera(const sensors::PinholeCamera& camera, const Eigen::Isometry3d& place, double height_m,
                const Colour& colour, View& view) {
  std::array<Eigen::Vector3d, 4> corners;
  const std::array<Eigen::Vector2d, 4> corners_px = {Eigen::Vector2d(0, 0),
                                                     {1.0 * camera.width_px, 0},
                                                     {1.0 * camera.width_px, 1.0 * camera.height_px},
                                                     {0, 1.0 * camera.height_px}};
  for (std::size_t i = 0; i < 4; ++i)
    corners[i] = place * (height_m * Eigen::Vector3d((corners_px[i].x() - camera.cx_px) / camera.fx_px,
                                                     (corners_px[i].y() - camera.cy_px) / camera.fy_px, 1));
  for (std::size_t i = 0; i < 4; ++i) {
    view.add_line(place.translation(), corners[i], colour);
    view.add_line(corners[i], corners[(i + 1) % 4], colour);
  }
}

}  // namespace

ByteImage points_picture(const RegisteredFrame& registered, const ByteImage& picture,
                         const sensors::PinholeCamera& depth, const Eigen::Isometry3d& colour_from_depth) {
  const sensors::DepthFrame& frame = registered.frame;
  std::vector<double> depths_m;
  for (std::size_t i = 0; i < frame.depth_m.size(); ++i)
    if (registered.filled[i] != 0 && registered.extruded[i] == 0)
      depths_m.push_back(static_cast<double>(frame.depth_m[i]));
  double middle_m = 1;
  if (!depths_m.empty()) {
    const auto half = depths_m.begin() + static_cast<std::ptrdiff_t>(depths_m.size() / 2);
    std::nth_element(depths_m.begin(), half, depths_m.end());
    middle_m = *half;
  }
  View view({0, 0, middle_m});
  for (int row = 0; row < frame.camera.height_px; ++row)
    for (int column = 0; column < frame.camera.width_px; ++column) {
      const std::size_t at = frame.index(column, row);
      if (registered.filled[at] == 0 || registered.extruded[at] != 0) continue;
      const std::uint8_t* code = &picture.values[3 * at];
      if (const auto point_m = sensors::point_of_pixel(frame, column, row))
        view.add(*point_m, {code[0], code[1], code[2]}, 2);
    }
  const double height_m = 0.15 * middle_m;
  add_camera(frame.camera, Eigen::Isometry3d::Identity(), height_m, {235, 130, 20}, view);
  add_camera(depth, colour_from_depth, 0.8 * height_m, {30, 80, 200}, view);
  return view.take();
}

}  // namespace seamline::registration
