#pragma once
#include <Eigen/Core>
#include <functional>
#include <memory>

#include "renderer/common/sampler.h"
#include "renderer/tracing/ray.h"

namespace seamline::renderer {

/// Unit direction through an image position in pixels; zero where a lens lets none through.
using ImageDirections = std::function<Eigen::Vector3f(float x, float y)>;

/// A pinhole camera at the origin of the renderer's frame (everything is recentred on it), axes of the world.
struct Camera {
  Eigen::Matrix3f axes = Eigen::Matrix3f::Identity();  ///< columns: right, up, back
  float tan_half_horizontal = 0.577F;                  ///< tangent of half the horizontal field of view
  int width_px = 960;
  int height_px = 540;
  /// Of a camera that is no plain pinhole (a lens, a panorama); null: a pinhole. The axes are still whither
  /// it looks.
  std::shared_ptr<const ImageDirections> directions = {};

  /// Unit direction through image position (x, y) in pixels, (0, 0) being the upper left corner of the
  /// picture.
  [[nodiscard]] Eigen::Vector3f direction(float x, float y) const {
    if (directions) return (*directions)(x, y);
    const float scale = 2.0F * tan_half_horizontal / static_cast<float>(width_px);
    const Eigen::Vector3f local((x - 0.5F * static_cast<float>(width_px)) * scale,
                                (0.5F * static_cast<float>(height_px) - y) * scale, -1.0F);
    return (axes * local).normalized();
  }
  /// Unit direction through the centre of a pixel.
  [[nodiscard]] Eigen::Vector3f centre_direction(int x, int y) const {
    return direction(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
  }
};

/// The camera ray of one sample of a pixel.
[[nodiscard]] inline Ray camera_ray(const Camera& camera, int x, int y, const Sampler& sampler) {
  const Eigen::Array2f jitter = sampler.point(dimension::pixel);
  return {Eigen::Vector3f::Zero(),
          camera.direction(static_cast<float>(x) + jitter[0], static_cast<float>(y) + jitter[1])};
}

/// The camera ray through the centre of a pixel.
[[nodiscard]] inline Ray centre_ray(const Camera& camera, int x, int y) {
  return {Eigen::Vector3f::Zero(), camera.centre_direction(x, y)};
}

}  // namespace seamline::renderer
