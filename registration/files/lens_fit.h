#pragma once
#include <Eigen/Core>
#include <functional>

#include "sensors/camera/pinhole_camera.h"

namespace seamline::registration {

/// Where a lens of any model puts a direction: of ideal image coordinates x = X/Z, y = Y/Z, those behind it.
using LensModel = std::function<Eigen::Vector2d(const Eigen::Vector2d& ideal)>;

/// A lens by Brown's five terms that is as near to another as they allow, and how near.
struct LensFit {
  sensors::LensDistortion lens;
  double worst_px = 0;  ///< largest distance in the picture
};

/// The smallest largest distance, nearly, over a grid of the directions whose places lie in the picture.
/// `camera`: size, focal lengths and principal point.
[[nodiscard]] LensFit fit_brown(const LensModel& model, const sensors::PinholeCamera& camera);

}  // namespace seamline::registration
