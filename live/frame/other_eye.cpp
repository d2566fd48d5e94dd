#include "live/frame/other_eye.h"

#include <algorithm>
#include <array>
#include <limits>

#include "raytracer/common/parallel.h"
#include "support/arithmetic/grid_index.h"

namespace seamline::live {
namespace {

constexpr int one_px = 256;  // places in a row are known to 1/256 of a pixel, finer than a code can show
constexpr int nowhere = -1;

/// How far points move along their row from an eye's picture to the colour camera's.
struct Disparity {
  float of_all_px = 0;        ///< of points at infinity
  float at_one_metre_px = 0;  ///< more, divided by the planar depth in metres
};

/// Where the colour camera sees the pixels of an eye's row, in units of 1/256 of a pixel.
void find_places(const Disparity& disparity, const float* depth_m, int width_px, int* places) {
  const auto last_px = static_cast<float>(width_px - 1);
  for (int x = 0; x < width_px; ++x) {
    const float x_px = static_cast<float>(x) + disparity.of_all_px + disparity.at_one_metre_px / depth_m[x];
    const bool is_seen =
        (depth_m[x] < std::numeric_limits<float>::max()) & (x_px >= -0.5F) & (x_px < last_px + 0.5F);
    const float inside_px = std::min(std::max(x_px, 0.0F), last_px);
    const int place = static_cast<int>(inside_px * one_px);
    places[x] = is_seen ? place : nowhere;
  }
}

/// Linear between the two pixels beside each place; black for `nowhere`. A row begins at `in` and `out`.
void take_colours(const int* places, int width_px, const std::uint8_t* in, std::uint8_t* out) {
  for (int x = 0; x < width_px; ++x, out += 3) {
    if (places[x] == nowhere) {
      out[0] = out[1] = out[2] = 0;
      continue;
    }
    const int left = places[x] / one_px, to_right = places[x] % one_px;
    const std::uint8_t* pixel = in + grid_index(left, 0, 3);
    const std::uint8_t* beside = left + 1 < width_px ? pixel + 3 : pixel;
    for (int c = 0; c < 3; ++c)
      out[c] = static_cast<std::uint8_t>(
          (pixel[c] * (one_px - to_right) + beside[c] * to_right + one_px / 2) / one_px);
  }
}

}  // namespace

void draw_other_eye(const renderer::TriangleSpan& local_scene, const renderer::DrawView& colour_view,
                    const ByteImage& colour, int threads, LiveEye& eye) {
  const std::array<renderer::TriangleSpan, 1> meshes = {local_scene};
  renderer::draw_depth(eye.view, meshes, threads, eye.real);
  const int width_px = eye.codes.width_px;
  const float to_px = static_cast<float>(width_px) / eye.view.size[0];
  const Disparity disparity{(eye.view.corner[0] - colour_view.corner[0]) * to_px,
                            colour_view.axes.row(0).dot(eye.view.eye_m - colour_view.eye_m) * to_px};
  renderer::parallel_for(eye.codes.height_px, threads, [&](int y) {
    std::vector<int> places(width_px);
    const std::size_t start = grid_index(y, 0, width_px);
    find_places(disparity, &eye.real.depth_m[start], width_px, places.data());
    take_colours(places.data(), width_px, &colour.values[3 * start], &eye.codes.values[3 * start]);
  });
}

}  // namespace seamline::live
