#pragma once
#include "raytracer/tracing/geometry.h"
#include "raytracer/tracing/mesh.h"
#include "renderer/depth/sensor/pixel_grid.h"

namespace seamline::renderer {

/// Where the second surface comes from, and how much of it is wanted.
struct SecondLayer {
  const Geometry& truth;
  Eigen::Isometry3d world_from_frame;  ///< where the frame was truly seen from
  double jump_ratio = 1.1;
  int reach_px = 16;
};

/// The surface behind the near side of jumps, which a frame cannot show. A pixel is near when a cell within
/// `reach_px` of it jumps to a distance that is more than the ratio farther than its own; its ray then goes
/// on behind it to the first surface of the truth that is no nearer than that distance by more than the
/// ratio. The mesh joins such points with each other and, at the jump, with the frame's own far side,
/// wherever neighbours do not jump. The same for any number of threads.
[[nodiscard]] DepthMesh second_layer_mesh(const PlacedFrame& placed, const SecondLayer& layer, int threads);

}  // namespace seamline::renderer
