#include "renderer/depth/sensor/second_layer.h"

#include <algorithm>
#include <array>

#include "raytracer/common/parallel.h"
#include "renderer/depth/sensor/pixel_mesh.h"

namespace seamline::renderer {
namespace {

using sensors::DepthFrame;

/// The corners of the two triangles of a cell, as its mesh has them.
std::array<std::array<GridVertex, 3>, 2> triangles_of_cell(int row, int column) {
  const GridVertex nw{row, column}, sw{row + 1, column}, se{row + 1, column + 1}, ne{row, column + 1};
  return {{{nw, sw, se}, {nw, se, ne}}};
}

/// Of every pixel the nearest distance that something behind it jumps to; infinite where there is none.
std::vector<float> far_sides_m(const DepthFrame& radial, const SecondLayer& layer) {
  const int width = radial.camera.width_px, height = radial.camera.height_px, reach = layer.reach_px;
  std::vector<float> far_m(radial.depth_m.size(), sensors::hole);
  const auto mark = [&](int row, int column, float jumps_to_m) {
    for (int y = std::max(0, row - reach + 1); y <= std::min(height - 1, row + reach); ++y)
      for (int x = std::max(0, column - reach + 1); x <= std::min(width - 1, column + reach); ++x) {
        const std::size_t i = radial.index(x, y);
        if (static_cast<double>(radial.depth_m[i]) * layer.jump_ratio < static_cast<double>(jumps_to_m))
          far_m[i] = std::min(far_m[i], jumps_to_m);
      }
  };
  for (int row = 0; row + 1 < height; ++row)
    for (int column = 0; column + 1 < width; ++column)
      for (const auto& [a, b, c] : triangles_of_cell(row, column)) {
        const float a_m = radial.at(a.column, a.row), b_m = radial.at(b.column, b.row),
                    c_m = radial.at(c.column, c.row);
        const float farthest_m = std::max({a_m, b_m, c_m});
        if (!DepthFrame::is_hole(farthest_m) && is_jump(static_cast<double>(a_m), static_cast<double>(b_m),
                                                        static_cast<double>(c_m), layer.jump_ratio))
          mark(row, column, farthest_m);
      }
  return far_m;
}

/// How far the ray of a pixel goes on from `start_m`; infinite when it meets nothing.
float distance_behind_m(const SecondLayer& layer, const sensors::PinholeCamera& camera, int column, int row,
                        double start_m) {
  const auto direction = sensors::direction_through(camera, {column + 0.5, row + 0.5});
  if (!direction) return sensors::hole;
  const Eigen::Vector3d along = (layer.world_from_frame.linear() * *direction).normalized();
  const Eigen::Vector3d from_m = layer.world_from_frame.translation() + along * start_m;
  const auto hit = layer.truth.nearest({from_m.cast<float>(), along.cast<float>()});
  return hit ? static_cast<float>(start_m + static_cast<double>(hit->distance_m)) : sensors::hole;
}

}  // namespace

DepthMesh second_layer_mesh(const PlacedFrame& placed, const SecondLayer& layer, int threads) {
  PlacedFrame behind = placed;
  DepthFrame& frame = behind.frame;
  frame = sensors::in_convention(frame, sensors::DepthConvention::radial);
  const std::vector<float> far_m = far_sides_m(frame, layer);
  std::vector<std::uint8_t> is_behind(far_m.size());
  parallel_for(frame.camera.height_px, threads, [&](int row) {
    for (int column = 0; column < frame.camera.width_px; ++column) {
      const std::size_t i = frame.index(column, row);
      if (DepthFrame::is_hole(far_m[i])) continue;
      is_behind[i] = 1;
      frame.depth_m[i] = distance_behind_m(layer, frame.camera, column, row,
                                           static_cast<double>(far_m[i]) / layer.jump_ratio);
    }
  });
  // Only cells with a point of the second surface; the others are in the frame's own mesh.
  const PixelGrid grid = pixel_grid(behind, threads);
  return build_pixel_mesh(
      grid,
      {.density = MeshDensity::full, .cut_ratio = layer.jump_ratio, .only = &is_behind, .threads = threads});
}

}  // namespace seamline::renderer
