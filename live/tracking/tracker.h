#pragma once
#include <array>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "live/frame/local_mesh.h"
#include "live/recording/loaded_recording.h"

namespace seamline::live {

/// Where a frame's camera pose comes from. `recorded`: the index. `still`: the camera does not move.
/// `marker`: the marker that `registration/calibration/aruco.h` knows, whose frame is then the world.
/// `features`: corners that are followed from picture to picture (paper 001, section 4.2); their places are
/// those that depth gives, not triangulated ones.
enum class Tracking { recorded, still, marker, features };
inline constexpr std::array every_tracking = {Tracking::recorded, Tracking::still, Tracking::marker,
                                              Tracking::features};
[[nodiscard]] std::string_view word(Tracking tracking);

/// Throws InputError, naming `field`, where the recording has no poses for `recorded`, or Seamline was built
/// without what the way needs.
void require_tracking(Tracking tracking, const LoadedRecording& recording, const std::string& field);

struct TrackedPose {
  Eigen::Isometry3d world_from_colour;  ///< upright (`live_scene.h`)
  bool is_found = true;                 ///< false: lost in this frame; the last pose stays
  int features = 0;                     ///< that agree with the pose; only of `Tracking::features`
};

/// Follows a camera through the frames of a recording, in their order; the first frame begins anew.
class Tracker {
 public:
  /// `recording` must outlive it.
  Tracker(const LoadedRecording& recording, Tracking tracking, double marker_side_m, int threads);

  [[nodiscard]] TrackedPose track(std::size_t frame_index);

 private:
  struct Feature {
    Eigen::Vector2d place_px;
    Eigen::Vector3d world_m;
  };
  [[nodiscard]] TrackedPose by_marker(const ByteImage& grey);
  [[nodiscard]] TrackedPose by_features(const LoadedFrame& frame, ByteImage grey, bool begins);
  void add_features(const LoadedFrame& frame, const ByteImage& grey);

  const LoadedRecording& recording_;
  Tracking tracking_;
  double marker_side_m_;
  int threads_;
  Eigen::Isometry3d pose_;
  std::vector<Feature> features_;
  ByteImage before_;
  DepthPoints points_;
  LocalMesh mesh_;
  renderer::DepthPicture depth_;
};

}  // namespace seamline::live
