#pragma once
#include <map>
#include <memory>
#include <optional>

#include "raytracer/scene/camera.h"
#include "raytracer/tracing/geometry.h"
#include "renderer/depth/depth_mesh.h"
#include "renderer/depth/occlusion_test.h"
#include "renderer/depth/panorama_chain.h"
#include "stimuli/definition/stimulus.h"
#include "stimuli/set/manifest.h"
#include "support/files/image.h"

namespace seamline::renderer {

/// The local scene D of a stimulus, ready for rays, and what the manifest says of its mesh.
struct LocalScene {
  Geometry geometry;
  MeshRecord mesh;
  std::optional<OcclusionTest> occlusion = {};  ///< who is in front, where not the mesh decides
  std::optional<ShadowMatte> matte = {};        ///< which real surfaces suns do not reach, likewise
  /// Methods of real time in place of rays, and who is in front by them; null: traced.
  std::shared_ptr<const RealtimeWorld> realtime = {};
  std::optional<OcclusionTest> realtime_occlusion = {};
  std::shared_ptr<const DepthMesh> triangles = {};  ///< of the geometry, where its user wants them

  [[nodiscard]] DepthWorld world() const {
    const std::optional<OcclusionTest>& test = realtime_occlusion ? realtime_occlusion : occlusion;
    return {&geometry, test ? &*test : nullptr, matte ? &*matte : nullptr, realtime.get()};
  }
  /// The same with everything traced.
  [[nodiscard]] DepthWorld traced_world() const {
    return {&geometry, occlusion ? &*occlusion : nullptr, matte ? &*matte : nullptr};
  }
};

/// What a local scene is made for.
struct LocalSceneUse {
  double albedo = 0.5;      ///< of the whole mesh
  bool traces_rays = true;  ///< false: only from the panorama's centre, which needs no good tree
  int threads = 1;
  Camera photograph = {};  ///< in whose frame sensors are; panoramas do not look at it
  /// What it shows without the object, linear, where a chain is guided by it; null elsewhere.
  const Image* picture = nullptr;
  /// What matching found for each stereo source, by its place in the chain; null where there is none.
  const std::map<std::size_t, sensors::DepthFrame>* stereo = nullptr;
  bool keeps_triangles = false;  ///< `LocalScene::triangles`
  /// A depth test beside the mesh, in place of the chain's own: `LocalScene::realtime_occlusion`.
  bool tests_depth = false;
  /// Of a chain that is budgeted, made already (renderer/depth/budget); it is taken out.
  MeasuredPanorama* budgeted = nullptr;
};

/// Captures depth of `truth` as the settings say and rebuilds the scene from it: a panorama from the
/// photograph's position, or what a chain of source, repair and registration delivers. Throws InputError as
/// the readers of depth files do.
[[nodiscard]] LocalScene make_local_scene(const Geometry& truth, const DepthSettings& settings,
                                          const LocalSceneUse& use);

/// What sensors deliver of the truth, as `make_local_scene` counts it, but before any repair; none of exact
/// panoramas and of stereo. Throws InputError likewise.
[[nodiscard]] std::optional<SensorCounts> count_captured(const Geometry& truth, const DepthSettings& settings,
                                                         const Camera& photograph, int threads);

}  // namespace seamline::renderer
