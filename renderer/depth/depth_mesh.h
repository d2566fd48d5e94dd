#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "raytracer/tracing/mesh.h"
#include "renderer/depth/depth_map.h"
#include "stimuli/definition/study_definition.h"

namespace seamline::renderer {

struct MeshOptions {
  MeshDensity density = MeshDensity::adaptive;
  double tolerance = 1e-4;  ///< largest relative error along any ray of the dense sphere (adaptive only)
  /// The phase of the sampling grid: the map was captured with its directions turned, so that texel column c
  /// looks where column c + yaw_texels of the unturned panorama does (towards the right, clockwise seen from
  /// above). The mesh lies where the world is.
  double yaw_texels = 0;
  int threads = 0;  ///< 0: one for each core
};

/// The dense sphere of the paper's section 3.2 pushed out to the map's distances: full density, or the
/// adaptive mesh that stays within the tolerance. Holes stay holes: no triangle touches one. Triangles are
/// wound anticlockwise as seen from the centre, so their normals (b - a) x (c - a) face it. Every vertex is
/// used by a triangle. The same mesh for any number of threads. Values that `clean_holes` would clean are
/// read as holes.
[[nodiscard]] DepthMesh build_depth_mesh(const DepthMap& map, const MeshOptions& options);

}  // namespace seamline::renderer
