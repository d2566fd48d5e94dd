#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "registration/files/camera_file.h"

namespace seamline::registration {

/// A camera as other programs state it, before it is one of ours.
struct StatedCamera {
  std::string format;  ///< whose it is, for complaints and notes
  double fx_px = 0, fy_px = 0, cx_px = 0, cy_px = 0, skew_px = 0;
  int width_px = 0, height_px = 0;  ///< 0: not stated
  bool from_first_centre = true;    ///< cx and cy are counted from the first pixel's centre, as by OpenCV
  bool fisheye = false;             ///< `lens` is k1 to k4 of Kannala and Brandt
  std::vector<double> lens = {};    ///< else k1 k2 p1 p2 k3 k4 k5 k6 ..., as OpenCV orders them
  std::optional<Eigen::Isometry3d> world_from_camera = {};
  std::vector<std::string> notes = {};
};

/// The photograph's camera of it. Throws InputError naming `file` and the format where the size is missing
/// (`size_px`: the photograph's), or the lens cannot be expressed.
[[nodiscard]] CameraFile camera_of_stated(StatedCamera stated, const std::string& file,
                                          const std::optional<std::pair<int, int>>& size_px);

/// Cameras that are lines of numbers: a matrix alone, COLMAP's cameras.txt, KITTI's and Middlebury's
/// calib.txt. None: another format. Throws InputError naming `file` and the format where something is
/// missing.
[[nodiscard]] std::optional<StatedCamera> text_camera(const std::string& text, const std::string& file);

/// Takes K of nine numbers, row by row or column by column. Throws InputError where they are no such matrix.
void take_matrix(const std::vector<double>& k, const std::string& file, StatedCamera& stated);

}  // namespace seamline::registration
