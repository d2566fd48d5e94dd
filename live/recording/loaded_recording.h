#pragma once
#include <optional>
#include <vector>

#include "live/recording/recording.h"
#include "sensors/frame/depth_frame.h"
#include "support/files/image.h"

namespace seamline::live {

/// A frame in memory: what the depth camera measured, in its own pixels, and the colour picture as the view
/// camera sees it (sRGB codes, 3 channels).
struct LoadedFrame {
  double time_s = 0;
  sensors::DepthFrame depth;
  ByteImage colour;
  std::optional<Eigen::Isometry3d> world_from_colour = {};
};

/// A recording in memory, ready to be shown at the rate of a camera.
struct LoadedRecording {
  registration::RegistrationRig rig;
  sensors::PinholeCamera view;  ///< without a lens
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();
  SceneDefinition light = {};
  bool has_light = false;
  std::vector<LoadedFrame> frames = {};

  [[nodiscard]] bool has_poses() const;  ///< of every frame
};

/// How long after the frame before it a frame came, as a recording plays that begins again after its last
/// frame: the first comes after a mean interval (a thirtieth of a second, where there is none). At most a
/// second: a longer gap is a break.
[[nodiscard]] double interval_before_s(const LoadedRecording& recording, std::size_t frame_index);

struct LoadOptions {
  int width_px = 0, height_px = 0;  ///< of the view; 0: the colour camera's own
  int most_frames = 0;              ///< from the first on; 0: all
  int threads = 0;                  ///< 0: one for each core
};

/// Reads the frames of a recording. Throws InputError as the readers of depth maps and photographs do, and
/// where the frames do not fit into `largest_loaded_recording_bytes`.
[[nodiscard]] LoadedRecording load_recording(const Recording& recording, const LoadOptions& options);

}  // namespace seamline::live
