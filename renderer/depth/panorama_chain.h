#pragma once
#include "renderer/depth/depth_map.h"
#include "renderer/depth/sensor/sensor_scene.h"

namespace seamline::renderer {

/// A panorama as it was captured and mended, and the mesh of it.
struct MeasuredPanorama {
  DepthMap map;
  DepthMesh mesh;
  SensorCounts counts;
  std::optional<ModelRecord> model = {};
  std::optional<DepthErrorRecord> depth_error = {};  ///< of a panorama in a file
};

/// source -> repair -> mesh of a chain that is a panorama: read from a file and mixed with the truth, or
/// reduced from a finer map, with generic noise; repaired as a picture whose left and right edges are
/// neighbours, cut where texels jump. With boxes: the model of a finer map, which has noise of its own, and a
/// mesh of the texels that it does not explain and of their neighbours; the map then shows both.
[[nodiscard]] MeasuredPanorama panorama_mesh(const Geometry& truth, const DepthSettings& settings,
                                             int threads);

/// The texels of such a panorama before any repair.
[[nodiscard]] SensorCounts panorama_counts(const Geometry& truth, DepthSettings settings, int threads);

/// The mesh of a map without the triangles, of about a texel and smaller, that lie between texels whose
/// distances differ by more than the ratio, and without the vertices that only they used.
[[nodiscard]] DepthMesh without_jumps(const DepthMesh& mesh, const DepthMap& map, double yaw_texels,
                                      double ratio);

/// A map of a `factor`-th of the size, whose texels stand for factor x factor of the finer one's. Exposed for
/// tests.
[[nodiscard]] DepthMap reduced(const DepthMap& finer, Reduction reduction, int factor, int threads);

}  // namespace seamline::renderer
