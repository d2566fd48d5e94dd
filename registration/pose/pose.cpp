#include "registration/pose/pose.h"

#include <cmath>
#include <numbers>

#include "support/arithmetic/random.h"
#include "support/text/csv.h"
#include "support/text/error.h"
#include "support/text/number_range.h"

namespace seamline::registration {
namespace {

enum Stream : std::uint64_t { rotation_axis, displacement_direction };

/// Evenly over the sphere (Archimedes: the height is uniform).
Eigen::Vector3d random_direction(std::uint64_t seed, Stream stream) {
  Random random(seed, stream);
  const double height = 2 * random.uniform() - 1, angle = 2 * std::numbers::pi * random.uniform();
  const double radius = std::sqrt(1 - height * height);
  return {radius * std::cos(angle), radius * std::sin(angle), height};
}

void require_inside(const char* field, double value, NumberRange range) {
  if (!inside(value, range))
    throw input_error({.field = std::string("calibration error: ") + field,
                       .wanted = range_text("a number", range),
                       .found = number_text(value)});
}

}  // namespace

Eigen::Isometry3d depth_from_world(const Eigen::Isometry3d& depth_from_colour,
                                   const Eigen::Isometry3d& colour_from_world) {
  return depth_from_colour * colour_from_world;
}

Eigen::Isometry3d world_from_depth(const Eigen::Isometry3d& world_from_colour,
                                   const Eigen::Isometry3d& colour_from_depth) {
  return world_from_colour * colour_from_depth;
}

Eigen::Isometry3d with_calibration_error(const Eigen::Isometry3d& colour_from_depth,
                                         const CalibrationError& error) {
  require_inside("rotation_deg", error.rotation_deg, {0, 180, "degrees"});
  require_inside("displacement_m", error.displacement_m, {0, 1e9, "m"});
  Eigen::Isometry3d wrong = colour_from_depth;
  if (error.rotation_deg != 0) {
    const Eigen::AngleAxisd turn(error.rotation_deg * std::numbers::pi / 180,
                                 random_direction(error.seed, rotation_axis));
    // Orthonormal again: an error drawn on an error must not leave the rotations.
    wrong.linear() =
        Eigen::Quaterniond(turn.toRotationMatrix() * wrong.linear()).normalized().toRotationMatrix();
  }
  if (error.displacement_m != 0)
    wrong.translation() += error.displacement_m * random_direction(error.seed, displacement_direction);
  return wrong;
}

}  // namespace seamline::registration
