#pragma once
#include <filesystem>
#include <string>

#include "live/recording/camera_path.h"
#include "live/recording/recording.h"
#include "renderer/estimators/sensed_scene.h"

namespace seamline::live {

struct MakeOptions {
  CameraPath path;
  std::optional<Eigen::Vector3d> orbit_m =
      {};  ///< in the scene's world; none: what the picture's middle shows
  int frames = 30;
  double frames_per_s = 30;
  bool keeps_poses = true;  ///< false: the index does not say where the camera stood
  double exposure_ev = 0;
  renderer::SenseSettings sense = {};  ///< of frame 0; the next have other noise
};

/// Renders a recording of a scene by a rig: what `seamline sense` shows of one moment, for each. Files are
/// depth/N.exr (as measured), colour/N.png and camera.toml; the index comes last. Poses are in the scene
/// file's world. `definition` says camera and light, `rig_name` what the rig is called.
Recording make_recording(const renderer::SceneFile& file, const SceneDefinition& definition,
                         const sensors::Rig& rig, const std::string& rig_name, const MakeOptions& options,
                         const std::filesystem::path& folder);

}  // namespace seamline::live
