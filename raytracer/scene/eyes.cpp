#include "raytracer/scene/eyes.h"

namespace seamline::renderer {

Camera view_camera(const Camera& centre, const View& view) {
  if (view.is_mono()) return centre;
  auto eyes = std::make_shared<CameraEyes>();
  eyes->width_px = centre.width_px / view.squeeze();
  eyes->squeeze = static_cast<float>(view.squeeze());
  const int count = view.eyes();
  for (int k = 0; k < count; ++k) {
    const double right_m = (k - 0.5 * (count - 1)) * view.separation_m;
    eyes->eyes.push_back({.place_m = centre.axes.col(0) * static_cast<float>(right_m),
                          .lean = count == 1 ? 0.0F : static_cast<float>(-right_m / view.zero_parallax_m)});
  }
  Camera camera = centre;
  camera.width_px = count * eyes->width_px;
  camera.eyes = std::move(eyes);
  return camera;
}

Camera centre_camera(const Camera& camera) {
  if (!camera.eyes) return camera;
  Camera centre = camera;
  centre.width_px = static_cast<int>(static_cast<float>(camera.eyes->width_px) * camera.eyes->squeeze);
  centre.eyes.reset();
  return centre;
}

}  // namespace seamline::renderer
