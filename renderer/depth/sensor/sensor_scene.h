#pragma once
#include "renderer/depth/sensor/sensor_view.h"
#include "renderer/scene/camera.h"
#include "renderer/tracing/mesh.h"
#include "stimuli/definition/study_definition.h"
#include "stimuli/set/manifest.h"

namespace seamline::renderer {

/// A mesh rebuilt from measured depth, and what became of the pixels.
struct MeasuredMesh {
  DepthMesh mesh;
  SensorCounts counts;
};

/// source -> repair -> registration -> mesh of every pinhole and file of a chain (which is no panorama), all
/// meshes in one. `truth` is in the frame of the renderer, whose origin and axes `photograph` gives. Throws
/// InputError as the readers of files do.
[[nodiscard]] MeasuredMesh sensor_mesh(const Geometry& truth, const DepthSettings& settings,
                                       const Camera& photograph, int threads);

/// Whether the mesh is seen from its own sensors' one place, the photograph's: rays from there meet each part
/// of it once.
[[nodiscard]] bool is_seen_from_its_place(const DepthChain& chain);

}  // namespace seamline::renderer
