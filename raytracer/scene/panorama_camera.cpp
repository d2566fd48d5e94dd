#include "raytracer/scene/panorama_camera.h"

#include <cmath>
#include <numbers>

namespace seamline::renderer {

Eigen::Vector3f PanoramaDirections::operator()(float x, float y) const {
  constexpr float pi = std::numbers::pi_v<float>;
  const float azimuth = (x / width_px - 0.5F) * 2 * pi + azimuth_rad, elevation = (0.5F - y / height_px) * pi;
  return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
          -std::cos(azimuth) * std::cos(elevation)};
}

Camera panorama_camera(int width_px, int height_px, float azimuth_rad, bool wraps) {
  Camera camera;
  camera.width_px = width_px;
  camera.height_px = height_px;
  camera.directions = std::make_shared<const ImageDirections>(
      PanoramaDirections{static_cast<float>(width_px), static_cast<float>(height_px), azimuth_rad, wraps});
  return camera;
}

bool wraps(const Camera& camera) {
  if (!camera.directions) return false;
  const auto* panorama = camera.directions->target<PanoramaDirections>();
  return panorama != nullptr && panorama->wraps;
}

}  // namespace seamline::renderer
