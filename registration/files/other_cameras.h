#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "registration/files/camera_file.h"

namespace seamline::registration {

/// Whether a text is a camera of another program, by its content, not its name. What is none is TOML.
[[nodiscard]] bool is_other_camera(const std::string& text);

/// The camera of another program, as the photograph's: OpenCV (YAML, JSON), ROS camera_info, Kalibr, COLMAP's
/// cameras.txt, Open3D, Azure Kinect, RealSense, KITTI, Middlebury, or the matrix K as 3 x 3, 3 x 4 or 4 x 4
/// numbers. Pixel centres become halves where the program counts from the first one's centre. A lens with
/// more terms than Brown's five becomes the nearest of these, which is said with its error. `size_px`: the
/// photograph's, of files that state none or leave it to the camera's mode.
///
/// Throws InputError naming `file`, the format, and what is missing or cannot be used.
[[nodiscard]] CameraFile parse_other_camera(const std::string& text, const std::string& file,
                                            const std::optional<std::pair<int, int>>& size_px);

}  // namespace seamline::registration
