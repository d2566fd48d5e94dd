#pragma once
#include "raytracer/tracing/geometry.h"
#include "raytracer/tracing/mesh.h"
#include "renderer/depth/depth_map.h"
#include "renderer/depth/depth_mesh.h"

namespace seamline::renderer {

/// Whether distance jumps between neighbouring texels: by more than a tenth, and by a tenth more than the
/// slope on either side would make it, in inverse distance, along which planes are nearly linear. A floor
/// towards the horizon slopes; it does not jump. `before_m` and `behind_m` are the neighbours beyond.
[[nodiscard]] bool is_segment_border(float before_m, float first_m, float second_m, float behind_m);

/// The map on a finer grid, which follows the texels of one side of a jump only: every point belongs to the
/// texel it lies in and is linear between those around it that do not jump from it. So things keep their
/// texels' outlines, where the plain map joins them to what is behind.
[[nodiscard]] DepthMap segmented(const DepthMap& map, int finer_width_px, int threads);

/// The paper's section 6, blockers as layers: the mesh of the segmented map, cut where it jumps, and behind
/// the near side of every jump, `reach_texels` far, what `truth` has there, sampled a ray a texel. Sheets are
/// gone: light passes behind things.
[[nodiscard]] DepthMesh layered_mesh(const Geometry& truth, const DepthMap& map, const MeshOptions& options,
                                     int reach_texels = 3);

}  // namespace seamline::renderer
