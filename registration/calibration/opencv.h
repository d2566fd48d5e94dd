#pragma once
#include <optional>

#include "registration/calibration/calibrate.h"
#include "support/files/image.h"

namespace seamline::registration {

// OpenCV is behind this header: it finds the corners of boards, and the places where searches begin. Built
// without it, `require_opencv` says so and nothing else here may be called.

/// Throws InputError, naming the Debian package, when Seamline was built without OpenCV.
void require_opencv();
[[nodiscard]] bool has_opencv();

/// The inner corners of a board in a grey picture (one channel), found to a part of a pixel. Nothing where
/// the whole board is not seen.
[[nodiscard]] std::optional<Corners> find_corners(const ByteImage& grey, const Board& board);

/// A camera and the places of the boards to begin with. Throws InputError naming `what` where there is none.
[[nodiscard]] Estimate start_of_camera(const Board& board, const BoardPictures& pictures,
                                       const std::string& what);

/// The pose of the pairs' frame in the camera, to begin with. Throws InputError as `start_of_camera`.
[[nodiscard]] Eigen::Isometry3d start_of_pose(const sensors::PinholeCamera& camera,
                                              const std::vector<PointPair>& pairs, const std::string& what);

}  // namespace seamline::registration
