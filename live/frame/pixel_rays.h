#pragma once
#include <Eigen/Core>

#include "live/frame/live_eye.h"

namespace seamline::live {

/// Rays through the centres of a picture's pixels.
class PixelRays {
 public:
  PixelRays(const renderer::DrawView& view, int width_px, int height_px)
      : eye_m_(view.eye_m),
        forward_(view.axes.row(2).transpose()),
        right_per_px_(view.axes.row(0).transpose() * (view.size[0] / static_cast<float>(width_px))),
        down_per_px_(view.axes.row(1).transpose() * (view.size[1] / static_cast<float>(height_px))),
        first_(forward_ + view.axes.row(0).transpose() * view.corner[0] +
               view.axes.row(1).transpose() * view.corner[1] + 0.5F * (right_per_px_ + down_per_px_)) {}

  /// One metre along the camera's axis.
  [[nodiscard]] Eigen::Vector3f direction(int x, int y) const {
    return first_ + static_cast<float>(x) * right_per_px_ + static_cast<float>(y) * down_per_px_;
  }
  [[nodiscard]] Eigen::Vector3f right_per_px() const { return right_per_px_; }
  [[nodiscard]] Eigen::Vector3f down_per_px() const { return down_per_px_; }
  [[nodiscard]] Eigen::Vector3f point_m(int x, int y, float planar_m) const {
    return eye_m_ + planar_m * direction(x, y);
  }
  [[nodiscard]] float planar_m(const Eigen::Vector3f& point_m) const {
    return forward_.dot(point_m - eye_m_);
  }
  [[nodiscard]] const Eigen::Vector3f& eye_m() const { return eye_m_; }

 private:
  Eigen::Vector3f eye_m_, forward_, right_per_px_, down_per_px_, first_;
};

/// A number in [0, 1) of a pixel, by which neighbours differ much (interleaved gradient noise, Jimenez 2014).
[[nodiscard]] inline float turn_of_pixel(int x, int y) {
  const float along = 0.06711056F * static_cast<float>(x) + 0.00583715F * static_cast<float>(y);
  const float scaled = 52.9829189F * (along - std::floor(along));
  return scaled - std::floor(scaled);
}

}  // namespace seamline::live
