#pragma once
#include <map>
#include <optional>
#include <vector>

#include "raytracer/scene/camera.h"
#include "raytracer/tracing/mesh.h"
#include "renderer/depth/sensor/pixel_grid.h"
#include "renderer/depth/sensor/sensor_view.h"
#include "stimuli/definition/study_definition.h"
#include "stimuli/set/manifest.h"

namespace seamline::renderer {

/// A mesh rebuilt from measured depth, what became of the pixels, and the frames of all sources that it was
/// built from: repaired, registered, where they are believed to be.
struct MeasuredMesh {
  DepthMesh mesh;
  SensorCounts counts;
  std::vector<PlacedFrame> frames = {};
  std::optional<DepthErrorRecord> depth_error = {};  ///< of estimated sources together
};

/// The photograph that a virtual object is put into: its camera, and what it shows without that object, where
/// a repair is guided by it (else null). A mere camera is one.
struct SeenPhotograph {
  Camera camera;
  const Image* picture = nullptr;
  /// What matching found for each stereo source, by the place of the source in the chain; null where there is
  /// none (renderer/estimators/stereo_depth.h).
  const std::map<std::size_t, sensors::DepthFrame>* stereo = nullptr;

  SeenPhotograph(const Camera& of, const Image* shows = nullptr) : camera(of), picture(shows) {}
};

/// source -> repair -> registration -> mesh of every pinhole and file of a chain (which is no panorama), all
/// meshes in one; or source -> registration -> repair. `truth` is in the frame of the renderer, whose origin
/// and axes `photograph` gives. Throws InputError as the readers of files do.
[[nodiscard]] MeasuredMesh sensor_mesh(const Geometry& truth, const DepthSettings& settings,
                                       const SeenPhotograph& photograph, int threads);

/// The pixels of all sources of such a chain before any repair; no mesh is made; stereo is left out. Throws
/// InputError likewise.
[[nodiscard]] SensorCounts sensor_counts(const Geometry& truth, const DepthChain& chain,
                                         const Camera& photograph, int threads);

/// Whether the mesh is seen from its own sensors' one place, the photograph's: rays from there meet each part
/// of it once.
[[nodiscard]] bool is_seen_from_its_place(const DepthChain& chain);

}  // namespace seamline::renderer
