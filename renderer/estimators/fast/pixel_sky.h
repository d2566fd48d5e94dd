#pragma once
#include "raytracer/light/light.h"
#include "raytracer/scene/camera.h"

namespace seamline::renderer {

/// Radiance of the environment over one pixel. A map's is the mean over a grid of 4 x 4 places: it is smooth
/// between its texels, and has no noise that halves could tell.
[[nodiscard]] inline Rgb pixel_sky(const Light& light, const Camera& camera, int x, int y) {
  if (!light.environment) return light.environment_radiance;
  constexpr int side = 4;
  Rgb sum = Rgb::Zero();
  for (int i = 0; i < side * side; ++i) {
    const float right = (static_cast<float>(i % side) + 0.5F) / side;
    const float down = (static_cast<float>(i / side) + 0.5F) / side;
    sum += light.sky(camera.direction_within(x, y, right, down));
  }
  return sum / static_cast<float>(side * side);
}

}  // namespace seamline::renderer
