#pragma once
#include "renderer/common/sampler.h"
#include "renderer/scene/camera.h"
#include "renderer/tracing/geometry.h"

namespace seamline::renderer {

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
