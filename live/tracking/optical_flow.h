#pragma once
#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <vector>

#include "sensors/camera/pinhole_camera.h"
#include "support/files/image.h"

namespace seamline::live {

// Camera tracking by OpenCV (its parts imgproc, video and calib3d), as paper 001 (section 4.2) has it. Image
// positions are ours: the centre of the first pixel is (0.5, 0.5). The same numbers on every machine: one
// thread, and random samples that always begin alike. Built without it, `require_optical_flow` says so and
// nothing else here may be called.

/// Throws InputError, naming the Debian packages, when Seamline was built without these parts.
void require_optical_flow();
[[nodiscard]] bool has_optical_flow();

/// Corners of a grey picture by the smaller eigenvalue (Shi and Tomasi 1994), at most so many, at least so
/// far from each other and from those that are known already.
[[nodiscard]] std::vector<Eigen::Vector2d> find_corners(const ByteImage& grey, int most, double apart_px,
                                                        std::span<const Eigen::Vector2d> known);

/// Where positions of one picture are in the next (Lucas and Kanade, in a pyramid); none where they are lost:
/// when the way back does not lead to within half a pixel of the start.
[[nodiscard]] std::vector<std::optional<Eigen::Vector2d>> follow_corners(
    const ByteImage& before, const ByteImage& now, std::span<const Eigen::Vector2d> positions_px);

/// A camera's pose from points of the world and where it sees them.
struct FoundPose {
  Eigen::Isometry3d camera_from_world;
  std::vector<std::size_t> inliers;  ///< seen within 2 pixels
};
/// By perspective from points, random samples against outliers, then all inliers refined together; the camera
/// has no lens. `near`: the last known pose. None where fewer than 8 points agree.
[[nodiscard]] std::optional<FoundPose> pose_from_points(const sensors::PinholeCamera& camera,
                                                        std::span<const Eigen::Vector3d> world_m,
                                                        std::span<const Eigen::Vector2d> seen_px,
                                                        const Eigen::Isometry3d& near);

}  // namespace seamline::live
