#pragma once
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "laboratory/settling/shake.h"

namespace seamline::renderer {

/// A scene, and the rig that looks at it.
struct DepthSubject {
  std::string scene;   ///< file or builtin:NAME
  std::string sensor;  ///< preset of a rig
  std::array<double, 3> at_m{}, look_at_m{0, 0, -1};
  bool has_place = false;  ///< those two say where the colour camera is; else the scene's own camera
  double noise_scale = 1;
  std::uint64_t seed = 1;
};

/// Depth as it comes, frame after frame; exactly where that is known; and where the depth camera is.
struct SensedDepth {
  DepthSequence measured;
  std::optional<DepthSequence> exact;
  Eigen::Isometry3d world_from_depth = Eigen::Isometry3d::Identity();
  bool may_be_z_up = false;  ///< the scene's file (`may_be_z_up`)
};

/// Traces what the sensor sees once; each frame has noise of its own. Throws InputError as the readers do,
/// for a sensor that is none or a scanner, and for a scene without a camera where no place is given.
[[nodiscard]] SensedDepth sense_depth(const DepthSubject& request);

}  // namespace seamline::renderer
