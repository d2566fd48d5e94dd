#include "live/recording/view_camera.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "support/arithmetic/grid_index.h"
#include "support/running/parallel.h"
#include "support/text/error.h"

namespace seamline::live {
namespace {

constexpr double shape_tolerance = 0.01;

/// A code between the four pixels around an image position.
std::uint8_t between(const ByteImage& picture, double x_px, double y_px, int channel) {
  const double x = std::clamp(x_px - 0.5, 0.0, picture.width_px - 1.0);
  const double y = std::clamp(y_px - 0.5, 0.0, picture.height_px - 1.0);
  const int left = static_cast<int>(x), top = static_cast<int>(y);
  const int right = std::min(left + 1, picture.width_px - 1),
            bottom = std::min(top + 1, picture.height_px - 1);
  const double across = x - left, down = y - top;
  const auto code = [&](int column, int row) {
    return static_cast<double>(picture.values[grid_index(row, column, picture.width_px) * 3 + channel]);
  };
  const double upper = code(left, top) + across * (code(right, top) - code(left, top));
  const double lower = code(left, bottom) + across * (code(right, bottom) - code(left, bottom));
  return static_cast<std::uint8_t>(std::lround(upper + down * (lower - upper)));
}

}  // namespace

sensors::PinholeCamera view_camera(const sensors::PinholeCamera& colour, int width_px, int height_px,
                                   const std::string& field) {
  sensors::PinholeCamera view = colour;
  view.skew_px = 0;
  view.distortion = {};
  if (width_px == 0 && height_px == 0) return view;
  const double wide = static_cast<double>(width_px) / colour.width_px;
  const double high = static_cast<double>(height_px) / colour.height_px;
  if (std::abs(wide / high - 1) > shape_tolerance)
    throw input_error(
        {.field = field,
         .wanted = fmt::format("a size of the shape of {} x {}", colour.width_px, colour.height_px),
         .found = fmt::format("{} x {}", width_px, height_px)});
  view.width_px = width_px;
  view.height_px = height_px;
  view.fx_px *= wide;
  view.cx_px *= wide;
  view.fy_px *= high;
  view.cy_px *= high;
  return view;
}

ByteImage view_picture(const ByteImage& picture, const sensors::PinholeCamera& colour,
                       const sensors::PinholeCamera& view, int threads) {
  if (colour == view) return picture;
  ByteImage out{.width_px = view.width_px, .height_px = view.height_px, .channels = 3, .values = {}};
  out.values.assign(view.width_px * static_cast<std::size_t>(view.height_px) * 3, 0);
  run_parallel(view.height_px, threads, [&](int row) {
    for (int column = 0; column < view.width_px; ++column) {
      const Eigen::Vector3d direction((column + 0.5 - view.cx_px) / view.fx_px,
                                      (row + 0.5 - view.cy_px) / view.fy_px, 1);
      const auto place_px = sensors::project(colour, direction);
      if (!place_px || !sensors::is_in_picture(colour, *place_px)) continue;
      const std::size_t pixel = grid_index(row, column, view.width_px) * 3;
      for (int channel = 0; channel < 3; ++channel)
        out.values[pixel + channel] = between(picture, place_px->x(), place_px->y(), channel);
    }
  });
  return out;
}

}  // namespace seamline::live
