#include "raytracer/scene/eyes.h"

namespace seamline::renderer {
namespace {

double eye_right_m(const View& view, int eye) {
  return (eye - 0.5 * (view.eyes() - 1)) * view.separation_m;
}

Camera omnidirectional_camera(const Camera& centre, const View& view) {
  auto eyes = std::make_shared<CameraEyes>();
  eyes->width_px = centre.width_px;
  eyes->panorama_rows = centre.height_px;
  for (int k = 0; k < view.eyes(); ++k)
    eyes->eyes.push_back({.right_m = static_cast<float>(eye_right_m(view, k))});
  eyes->eyes.resize(view.panoramas());  // from the axis
  Camera camera = centre;
  camera.height_px = view.panoramas() * centre.height_px;
  camera.eyes = std::move(eyes);
  return camera;
}

}  // namespace

Camera view_camera(const Camera& centre, const View& view) {
  if (view.is_mono()) return centre;
  if (view.kind == ViewKind::omnidirectional) return omnidirectional_camera(centre, view);
  auto eyes = std::make_shared<CameraEyes>();
  eyes->width_px = centre.width_px / view.squeeze();
  eyes->squeeze = static_cast<float>(view.squeeze());
  const int count = view.eyes();
  for (int k = 0; k < count; ++k) {
    const double right_m = eye_right_m(view, k);
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
  if (camera.eyes->panorama_rows > 0) centre.height_px = camera.eyes->panorama_rows;
  centre.eyes.reset();
  return centre;
}

}  // namespace seamline::renderer
