#pragma once
#include <algorithm>
#include <functional>
#include <string>

#include "support/files/image.h"

/// Files as cameras and other programs leave them, which Seamline reads and does not write.
namespace seamline::page_commands {

/// A JPEG of a picture of three channels: of each 8 x 8 pixels their mean.
[[nodiscard]] std::string jpeg_of(const ByteImage& picture);

/// Radiance in Greg Ward's format.
[[nodiscard]] std::string hdr_of(const Image& radiance);

/// A depth map of whole numbers.
struct DepthNumbers {
  int width_px = 0, height_px = 0;
  std::function<double(int x, int y)> value_at;  ///< rounded, 0 to 65535
};
[[nodiscard]] std::string png_of(const DepthNumbers& depth);
[[nodiscard]] std::string pgm_of(const DepthNumbers& depth);

/// What a camera at the origin, of the middle of its picture, sees of a floor below it and of a wall.
struct PlainRoom {
  double focal_px = 0, floor_m = 1, wall_m = 4;
  int width_px = 0, height_px = 0;

  [[nodiscard]] double depth_m(int y) const {
    const double below_px = y + 0.5 - 0.5 * height_px;
    return below_px <= 0 ? wall_m : std::min(wall_m, floor_m * focal_px / below_px);
  }
};

/// A jointed figure without a skin (.glb), and where its joints were in three moments (.csv).
[[nodiscard]] std::string jointed_figure();
[[nodiscard]] std::string recorded_joints();

}  // namespace seamline::page_commands
