#pragma once
#include <Eigen/Geometry>
#include <vector>

#include "registration/files/camera_file.h"
#include "renderer/realtime/depth_picture.h"

namespace seamline::live {

/// The points that a depth camera's values stand for. What does not change from frame to frame (the ray of
/// each pixel, through skew and lens) is computed once.
class DepthPoints {
 public:
  DepthPoints(const sensors::DepthFileForm& form, const Eigen::Isometry3d& colour_from_depth, int threads);

  /// The point of a pixel in the colour camera's frame, as `registration::points_in_colour_frame` has it, bit
  /// for bit. Not of a hole.
  [[nodiscard]] Eigen::Vector3d point_m(std::size_t pixel, float depth_m) const {
    return colour_from_depth_ * (metre_of_pixel_[pixel] * static_cast<double>(depth_m));
  }
  /// Whether a ray leads through a pixel of the lens.
  [[nodiscard]] bool has_ray(std::size_t pixel) const { return metre_of_pixel_[pixel].z() > 0; }
  [[nodiscard]] int width_px() const { return width_px_; }
  [[nodiscard]] int height_px() const { return height_px_; }

 private:
  int width_px_, height_px_;
  Eigen::Isometry3d colour_from_depth_;
  std::vector<Eigen::Vector3d> metre_of_pixel_;  ///< in which one unit of the value is one metre; 0: no ray
};

/// Registration by points at the rate of a camera: the same planar depths as
/// `registration::register_by_points`, bit for bit, for a view without a lens. The buffers of one frame serve
/// the next.
class PointRegistration {
 public:
  explicit PointRegistration(const sensors::PinholeCamera& view) : view_(view) {}

  void operator()(const DepthPoints& points, const std::vector<float>& depth_m, int threads,
                  renderer::DepthPicture& registered);

 private:
  struct Landing {
    std::int32_t pixel;
    float depth_m;
  };
  sensors::PinholeCamera view_;
  std::vector<Landing> landings_;
};

}  // namespace seamline::live
