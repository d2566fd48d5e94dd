#pragma once
#include <optional>

#include "raytracer/tracing/mesh.h"
#include "renderer/depth/sensor/pixel_grid.h"
#include "stimuli/definition/study_definition.h"

namespace seamline::renderer {

struct PixelMeshOptions {
  MeshDensity density = MeshDensity::adaptive;
  double tolerance = 1e-4;               ///< largest relative error along the ray of any pixel (adaptive)
  std::optional<double> cut_ratio = {};  ///< triangles of one cell that jump by more are left out
  /// Of the full mesh: only triangles with a corner among these pixels (1); null: all.
  const std::vector<std::uint8_t>* only = nullptr;
  int threads = 0;  ///< 0: one for each core
};

/// The mesh of a frame's pixels: each pixel a vertex, each cell between four of them two triangles, parted
/// from its upper left to its lower right; or a right-triangulated network over them that keeps the tolerance
/// (PixelBound). No triangle touches a hole. Triangles are wound anticlockwise as seen from the eye; every
/// vertex is used. The same mesh for any number of threads.
[[nodiscard]] DepthMesh build_pixel_mesh(const PixelGrid& grid, const PixelMeshOptions& options);

/// Adds the triangles of one mesh to another, which keeps the larger of their errors.
void append(DepthMesh& mesh, const DepthMesh& more);

}  // namespace seamline::renderer
