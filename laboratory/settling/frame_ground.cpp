#include "laboratory/settling/frame_ground.h"

namespace seamline::renderer {

FrameGround::Change FrameGround::take(const sensors::DepthFrame& frame) {
  is_measured_.resize(frame.depth_m.size(), 0);
  ground_.vertices_m.resize(frame.depth_m.size(), world_from_depth_.translation());
  Change change = Change::none;
  for (int row = 0; row < frame.camera.height_px; ++row)
    for (int column = 0; column < frame.camera.width_px; ++column) {
      const auto point_m = sensors::point_of_pixel(frame, column, row);
      if (!point_m) continue;
      const std::size_t i = frame.index(column, row);
      const Eigen::Vector3d place_m = world_from_depth_ * *point_m;
      if (is_measured_[i] == 0) {
        is_measured_[i] = 1;
        change = Change::triangles;
      } else if (change == Change::none && place_m != ground_.vertices_m[i]) {
        change = Change::moved;
      }
      ground_.vertices_m[i] = place_m;
    }
  if (change == Change::triangles) join(frame.camera.width_px, frame.camera.height_px);
  return change;
}

void FrameGround::join(int width_px, int height_px) {
  ground_.triangles.clear();
  const auto width = static_cast<std::uint32_t>(width_px);
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (is_measured_[a] != 0 && is_measured_[b] != 0 && is_measured_[c] != 0)
      ground_.triangles.push_back({a, b, c});
  };
  for (std::uint32_t row = 0; row + 1 < static_cast<std::uint32_t>(height_px); ++row)
    for (std::uint32_t column = 0; column + 1 < width; ++column) {
      const std::uint32_t nw = row * width + column, ne = nw + 1, sw = nw + width, se = sw + 1;
      add(nw, sw, se);
      add(nw, se, ne);
    }
}

}  // namespace seamline::renderer
