#pragma once
#include <optional>
#include <string>
#include <vector>

#include "sensors/skeleton/user_file.h"
#include "support/files/image.h"

namespace seamline::renderer {

/// A tracked person as the page has them, in the frame of X3D: joints by `standing_person`.
struct X3dUser {
  int id = 1;
  std::vector<std::uint8_t> mask;  ///< 1: the person's pixel
  sensors::MeasuredJoints joints_m;
  /// Of every joint, by cyclic coordinate descent from the positions: axis and angle, world from joint.
  std::vector<Eigen::AngleAxisd> orientations;
  double rms_m = 0;  ///< of the fitted skeleton's joints from the measured ones
};

/// The person of a file as seen in a frame. The skeleton is `standing_person` with the measured bones.
/// `x3d_from_world`: from the world of the file into the frame of X3D.
[[nodiscard]] X3dUser x3d_user(const sensors::RecordedUser& user, const sensors::DepthFrame& frame,
                               const Eigen::Isometry3d& world_from_frame,
                               const Eigen::Isometry3d& x3d_from_world);

/// What a depth camera recorded of one moment.
struct X3dRecording {
  const sensors::DepthFrame& depth;  ///< planar
  const ByteImage& colour;           ///< in the same pixels: `alignViewports`
  std::string label;
  const X3dUser* user = nullptr;
};

/// The sensors of paper 001, section 3, as prototypes, and an instance of each with the recorded values in
/// its out-slots: DepthSensor, NISensor and, with a user, UserSensor. Depth is in millimetres in 16 bits
/// (`normalizeDepth` FALSE), 0 a hole; images begin with the lowest row, as in X3D.
[[nodiscard]] std::string sensor_prototypes(const X3dRecording& recording);

}  // namespace seamline::renderer
