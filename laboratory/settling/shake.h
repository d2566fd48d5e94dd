#pragma once
#include <Eigen/Geometry>
#include <functional>
#include <string>
#include <vector>

#include "physics/rigid_world.h"
#include "sensors/frame/depth_frame.h"

namespace seamline::renderer {

/// A body over depth frames.
struct FallRequest {
  std::string name;  ///< of the depth, for tables and complaints
  BodyShape shape;
  Eigen::Isometry3d world_from_body = Eigen::Isometry3d::Identity();  ///< where it is let go
  Eigen::Isometry3d world_from_depth = Eigen::Isometry3d::Identity();
  int frames_to_rest = 60;  ///< before those that count
  int frames = 100;         ///< that count
  int frames_per_s = 30;
  PhysicsSettings physics;
  std::string when_lost = {};  ///< what may be the reason where it falls out of the scene; may be empty
};

/// Where the body is at the end of each frame, and how much that shakes over the frames that count.
struct Fall {
  std::string name;
  std::vector<Eigen::Isometry3d> poses = {};  ///< of all frames
  std::vector<double> away_mm = {};  ///< of frames that count: from the mean place of the centre of mass
  double shake_mm = 0;               ///< root mean square of `away_mm`
  double height_mm = 0;              ///< root mean square along Y alone
  double jump_mm = 0;                ///< root mean square from one frame to the next
  double turn_deg = 0;               ///< likewise, of the turn
  std::size_t triangles = 0;         ///< of the last ground
};

/// The frame of a moment, 0 and on.
using DepthSequence = std::function<sensors::DepthFrame(int frame)>;

/// Lets the body go and steps it through all frames; in each the ground is first moved to that frame's depth.
/// Throws InputError where it begins in the ground, or falls out of it.
[[nodiscard]] Fall fall_on(const DepthSequence& depth, const FallRequest& request,
                           const std::function<void()>& after_frame);

}  // namespace seamline::renderer
