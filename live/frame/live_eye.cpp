#include "live/frame/live_eye.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace seamline::live {

renderer::DrawView eye_view(const sensors::PinholeCamera& camera, const Eigen::Isometry3d& world_from_camera,
                            double right_m, double zero_parallax_m) {
  renderer::DrawView view;
  const Eigen::Matrix3d axes = world_from_camera.linear().transpose();
  view.axes = axes.cast<float>();
  view.from_point = true;
  view.eye_m = (world_from_camera.translation() + right_m * world_from_camera.linear().col(0)).cast<float>();
  view.size = {static_cast<float>(camera.width_px / camera.fx_px),
               static_cast<float>(camera.height_px / camera.fy_px)};
  view.corner = {static_cast<float>(-camera.cx_px / camera.fx_px - right_m / zero_parallax_m),
                 static_cast<float>(-camera.cy_px / camera.fy_px)};
  return view;
}

}  // namespace seamline::live
