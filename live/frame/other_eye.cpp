#include "live/frame/other_eye.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "live/frame/pixel_rays.h"
#include "raytracer/common/parallel.h"
#include "support/arithmetic/grid_index.h"

namespace seamline::live {
namespace {

/// From points of an eye's row to places in the colour picture: the pixel x at planar depth z is in the
/// colour camera's axes at `start + z (first + x step)`.
struct RowInColour {
  Eigen::Vector3f start, first, step;
};

/// In steps of 1/256 of a pixel, which is finer than a code can show.
void take_colour(const ByteImage& colour, float x_px, float y_px, std::uint8_t* out) {
  constexpr int one = 256;
  const float x = std::clamp(x_px - 0.5F, 0.0F, static_cast<float>(colour.width_px - 1));
  const float y = std::clamp(y_px - 0.5F, 0.0F, static_cast<float>(colour.height_px - 1));
  const int across = static_cast<int>(x * one), down = static_cast<int>(y * one);
  const int left = across / one, top = down / one;
  const std::size_t right_step = left + 1 < colour.width_px ? 3 : 0;
  const std::size_t down_step =
      top + 1 < colour.height_px ? static_cast<std::size_t>(colour.width_px) * 3 : 0;
  const std::uint8_t* pixel = &colour.values[grid_index(top, left, colour.width_px) * 3];
  const int to_right = across % one, to_below = down % one;
  for (std::size_t c = 0; c < 3; ++c) {
    const int upper = pixel[c] * (one - to_right) + pixel[c + right_step] * to_right;
    const int lower = pixel[c + down_step] * (one - to_right) + pixel[c + down_step + right_step] * to_right;
    out[c] = static_cast<std::uint8_t>((upper * (one - to_below) + lower * to_below + one * one / 2) /
                                       (one * one));
  }
}

}  // namespace

void draw_other_eye(const renderer::TriangleSpan& local_scene, const renderer::DrawView& colour_view,
                    const ByteImage& colour, int threads, LiveEye& eye) {
  const std::array<renderer::TriangleSpan, 1> meshes = {local_scene};
  renderer::draw_depth(eye.view, meshes, threads, eye.real);
  const int width_px = eye.codes.width_px;
  const PixelRays rays(eye.view, width_px, eye.codes.height_px);
  const Eigen::Array2f to_px(static_cast<float>(colour.width_px) / colour_view.size[0],
                             static_cast<float>(colour.height_px) / colour_view.size[1]);
  renderer::parallel_for(eye.codes.height_px, threads, [&](int y) {
    const RowInColour row{colour_view.axes * (rays.eye_m() - colour_view.eye_m),
                          colour_view.axes * rays.direction(0, y), colour_view.axes * rays.right_per_px()};
    const std::size_t start = grid_index(y, 0, width_px);
    for (int x = 0; x < width_px; ++x) {
      std::uint8_t* out = &eye.codes.values[3 * (start + x)];
      out[0] = out[1] = out[2] = 0;
      const float z = eye.real.depth_m[start + x];
      if (!(z < std::numeric_limits<float>::max())) continue;
      const float column = static_cast<float>(x);
      const float depth_m = row.start.z() + z * (row.first.z() + column * row.step.z());
      if (!(depth_m > 0.0F)) continue;
      const float over = 1.0F / depth_m;
      const float x_px =
          ((row.start.x() + z * (row.first.x() + column * row.step.x())) * over - colour_view.corner[0]) *
          to_px[0];
      const float y_px =
          ((row.start.y() + z * (row.first.y() + column * row.step.y())) * over - colour_view.corner[1]) *
          to_px[1];
      if (x_px >= 0.0F && x_px < static_cast<float>(colour.width_px) && y_px >= 0.0F &&
          y_px < static_cast<float>(colour.height_px))
        take_colour(colour, x_px, y_px, out);
    }
  });
}

}  // namespace seamline::live
