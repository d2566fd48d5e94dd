#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sensors/camera/fisheye_camera.h"
#include "sensors/files/depth_file.h"
#include "sensors/rig/rig.h"

namespace seamline::registration {

/// What is known of a depth camera and a colour camera: a small TOML file
/// (documentation/how-to/registration.md), which `seamline calibrate` writes and `seamline register` reads.
/// Whatever is not known is absent.
struct CameraFile {
  std::optional<sensors::PinholeCamera> depth, colour;
  std::optional<sensors::FisheyeCamera> fisheye;  ///< the colour camera, in place of `colour`
  std::optional<Eigen::Isometry3d> colour_from_depth;
  std::optional<Eigen::Isometry3d> world_from_colour;  ///< where the colour camera stands
  std::optional<Eigen::Vector3d> up;                   ///< in that world; none: +Y
  std::optional<sensors::DepthConvention> convention;
  std::optional<double> metres_per_step;
  std::optional<sensors::DepthPacking> packing;
  std::optional<double> nearest_m, farthest_m;
  bool unusual_distances = false;
  std::optional<std::vector<double>> nothing;  ///< values of depth files that stand for no depth
  std::vector<std::string> notes;              ///< to be said of another program's file, without its name
};

/// All that a registration needs.
struct RegistrationRig {
  sensors::DepthFileForm depth_form;  ///< the depth camera's own, and how its files are read
  sensors::PinholeCamera colour;
  Eigen::Isometry3d colour_from_depth = Eigen::Isometry3d::Identity();
  std::optional<Eigen::Isometry3d> world_from_colour;
};

/// Reads the file, or another program's camera (`parse_other_camera`), whose size is `size_px` where it
/// states none. Throws InputError naming file, key, wanted and found: for what is no TOML, an unknown key or
/// preset, a camera or rotation that is none, a rotation that is stated twice.
[[nodiscard]] CameraFile read_camera_file(const std::filesystem::path& path,
                                          const std::optional<std::pair<int, int>>& size_px = {});

/// The same for a text that a file held; complaints name `path`.
[[nodiscard]] CameraFile parse_camera_file(const std::string& text, const std::filesystem::path& path);

/// The cameras of a preset by its name in files. Throws InputError naming `field` where there is none, or
/// where it has no two cameras.
[[nodiscard]] CameraFile camera_file_of_preset(const std::string& key, const std::string& field);

/// Whether a preset has this name.
[[nodiscard]] bool is_preset(const std::string& key);

/// The file's text; reading it gives the same values, bit for bit. `remark` is written above as a comment,
/// line by line.
[[nodiscard]] std::string camera_file_text(const CameraFile& cameras, const std::string& remark);

/// What a registration needs of it. Throws InputError naming `file` and the first key that is missing.
[[nodiscard]] RegistrationRig registration_rig(const CameraFile& cameras, const std::string& file);

}  // namespace seamline::registration
