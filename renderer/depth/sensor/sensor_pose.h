#pragma once
#include <Eigen/Geometry>

#include "raytracer/scene/camera.h"
#include "stimuli/definition/depth_chain.h"

namespace seamline::renderer {

// The one place where the camera frame of OpenCV (x right, y down, z forward), in which sensors are, meets
// the world, whose cameras look along their -z with +y up.

/// The photograph's camera frame in the renderer's world, whose origin it shares.
[[nodiscard]] Eigen::Isometry3d world_from_photograph(const Camera& camera);

/// The photograph's camera as sensors write cameras, of its own size or so small that its focal length is at
/// most `largest_focal_px`.
[[nodiscard]] sensors::PinholeCamera pinhole_of(const Camera& camera, double largest_focal_px = 1e9);

/// Where a sensor is.
[[nodiscard]] Eigen::Isometry3d photograph_from_sensor(const SensorPose& pose);

/// Where the chain believes that it is: off by the calibration error, in an axis and a direction that the
/// chain's seed draws, and by the way that the rig has gone since the depth was captured.
[[nodiscard]] Eigen::Isometry3d believed_photograph_from_sensor(const SensorPose& pose,
                                                                const DepthChain& chain);

}  // namespace seamline::renderer
