#pragma once
#include "renderer/depth/depth_map.h"
#include "renderer/depth/sensor/sensor_scene.h"

namespace seamline::renderer {

/// source -> repair -> mesh of a chain that is a panorama: reduced from a finer map, with generic noise,
/// repaired as a picture whose left and right edges are neighbours, cut where texels jump.
[[nodiscard]] MeasuredMesh panorama_mesh(const Geometry& truth, const DepthSettings& settings, int threads);

/// A map of a `factor`-th of the size, whose texels stand for factor x factor of the finer one's. Exposed for
/// tests.
[[nodiscard]] DepthMap reduced(const DepthMap& finer, Reduction reduction, int factor, int threads);

}  // namespace seamline::renderer
