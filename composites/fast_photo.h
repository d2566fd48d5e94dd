#pragma once
#include "composites/photo_composite.h"
#include "raytracer/scene/truth_scene.h"

namespace seamline::renderer {

/// What the fast estimator wants of a photograph's world beside its geometries: the meshes they are made of.
struct PhotoMeshes {
  std::shared_ptr<const SurfaceMesh> local_scene;
  std::vector<std::shared_ptr<const SurfaceMesh>> objects;  ///< of object index 1
};

/// The local scene as a mesh of a scene file.
[[nodiscard]] std::shared_ptr<const SurfaceMesh> surface_of_depth(const DepthMesh& mesh, double albedo);

/// Whether the fast estimator can render a scene: something real hides and shades the objects, no light is
/// added with them, and the lens shows something everywhere.
[[nodiscard]] bool fast_can_render(const PhotoScene& scene);

/// What small objects that emit send straight to the camera, for paths. Null where there is none, and where a
/// mask or looked-up depth decides who is in front.
[[nodiscard]] std::shared_ptr<const SeenEmission> seen_objects(const PhotoScene& scene,
                                                               const PhotoMeshes& meshes, int threads);

/// By the fast estimator of studies: the photograph is given and without error, everything else is asked of
/// the local scene as by the artifact `all`, or of the mask, test and matte in its place, a few samples first
/// and more where the picture is not good enough, bounce light filtered. The error is estimated as in
/// studies, bias included.
[[nodiscard]] PhotoEstimate photo_by_fast(const PhotoScene& scene, const PhotoMeshes& meshes,
                                          const std::optional<double>& error, double exposure_ev,
                                          const PassOptions& options);

}  // namespace seamline::renderer
