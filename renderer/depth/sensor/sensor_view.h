#pragma once
#include <Eigen/Geometry>
#include <optional>

#include "raytracer/tracing/geometry.h"
#include "sensors/noise/measurement.h"
#include "support/files/image.h"

namespace seamline::renderer {

/// What of a sensor's view is wanted; each costs its rays.
struct SensorSight {
  bool surfaces = false;                            ///< albedo (mean of the three colours) and cosine
  int sub_rays_across = 0;                          ///< so many times as many through each pixel
  std::optional<Eigen::Vector3d> projector_m = {};  ///< in the sensor's frame: what it lights
};

/// What a noise model asks of a sensor's view; the projector is for structured light.
[[nodiscard]] SensorSight sight_for(const sensors::NoiseModel& model,
                                    const std::optional<Eigen::Vector3d>& projector_m);

/// What of the truth a sensor sees: a ray through the centre of each pixel, and what else is wanted. A pixel
/// through which the lens lets no direction sees nothing. The same for any number of threads.
[[nodiscard]] sensors::SeenFrame see_truth(const Geometry& truth, const sensors::PinholeCamera& camera,
                                           const Eigen::Isometry3d& world_from_sensor,
                                           const SensorSight& sight, int threads);

/// What guides a joint bilateral repair in place of a photograph from the sensor's place: albedo times
/// cosine, as in the sensor's own light, 0 where nothing is.
[[nodiscard]] Image headlight_picture(const sensors::SeenFrame& seen);

}  // namespace seamline::renderer
