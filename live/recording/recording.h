#pragma once
#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "registration/files/camera_file.h"
#include "stimuli/definition/study_definition.h"

namespace seamline::live {

// How much a recording may ask for (documentation/reference/limits.md).
inline constexpr std::size_t most_recorded_frames = 100'000;
inline constexpr std::int64_t largest_loaded_recording_bytes = std::int64_t{4} << 30;  ///< frames in memory

/// One moment of a recording.
struct RecordedFrame {
  double time_s = 0;
  std::string depth_file, colour_file;  ///< below the recording's folder
  /// Where the colour camera stood, in OpenCV's axes (x right, y down, z forward); none: not known.
  std::optional<Eigen::Isometry3d> world_from_colour = {};
};

/// What the index of a recording says: a folder of RGB-D frames by one rig (documentation/how-to/live.md).
struct Recording {
  std::filesystem::path folder;
  std::string camera_file = "camera.toml";        ///< of the rig, below the folder
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();  ///< of the world; unit
  /// Suns, lamps, environment and exposure of the pictures; nothing where `has_light` is false.
  SceneDefinition light = {};
  bool has_light = false;
  std::vector<RecordedFrame> frames = {};
};

inline constexpr const char* recording_index = "recording.toml";

/// Reads FOLDER/recording.toml. Throws InputError naming file, key, wanted and found: for what is no TOML, an
/// unknown key, no frame or more than `most_recorded_frames`, a time before the frame before, a pose
/// that is none, a file outside the folder.
[[nodiscard]] Recording read_recording(const std::filesystem::path& folder);

/// The same for a text that a file held; complaints name `path`, in whose folder the frames are.
[[nodiscard]] Recording parse_recording(const std::string& text, const std::filesystem::path& path);

/// The index's text; reading it gives the same values, bit for bit.
[[nodiscard]] std::string recording_text(const Recording& recording);

/// The rig of a recording, from its camera file.
[[nodiscard]] registration::RegistrationRig recording_rig(const Recording& recording);

}  // namespace seamline::live
