#pragma once
#include <Eigen/Geometry>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "raytracer/light/light.h"
#include "raytracer/scene/camera.h"
#include "raytracer/scene/scene_file.h"
#include "raytracer/tracing/geometry.h"
#include "stimuli/definition/study_definition.h"

namespace seamline::renderer {

/// The truth: background and objects in the renderer's frame, the camera and the light. Read in double
/// precision and recentred on the camera before going to float, so that scenes far from their file's origin
/// lose nothing.
struct TruthScene {
  SceneDefinition definition;
  Eigen::Vector3d camera_position_m = Eigen::Vector3d::Zero();  ///< in the scene file's world
  Camera camera;
  Light light;
  std::vector<std::shared_ptr<const SurfaceMesh>> background;
  /// From left to right; as many as the definition has.
  std::vector<std::vector<std::shared_ptr<const SurfaceMesh>>> objects =
      std::vector<std::vector<std::shared_ptr<const SurfaceMesh>>>(3);
  std::vector<std::string> rests;             ///< a sentence about each object that was let down
  std::set<std::string> left_out_of_diffuse;  ///< of the files' materials (`SceneFile`)
  std::set<std::string> left_out;             ///< a sentence about each file that has what no picture shows

  /// Of all objects, from 1.
  [[nodiscard]] std::vector<int> object_indices() const;
  /// The same without one of them.
  [[nodiscard]] std::vector<int> other_indices(int object_index) const;
  /// Background and the objects listed (from 1): one Embree scene.
  [[nodiscard]] Geometry geometry(bool with_background, const std::vector<int>& indices,
                                  Edges edges = Edges::tight) const;
  /// T of a virtual object: the background and the other objects.
  [[nodiscard]] Geometry geometry_without(int object_index) const;
};

/// Reads the scene's files; the camera has the eyes of the scene's view. Throws InputError when a file is
/// wrong, there is no camera, or a light cannot be rendered.
[[nodiscard]] TruthScene load_truth_scene(const SceneDefinition& definition, int width_px, int height_px);

/// Sentences about what the scene's files have and its pictures do not show.
[[nodiscard]] std::vector<std::string> left_out_sentences(const TruthScene& scene);

/// The scene's light from outside and from lamps: the study's suns and lamps, else the file's; ambient
/// occlusion has neither, and no bounce. `centre_m` becomes the origin.
[[nodiscard]] Light scene_light(const SceneDefinition& definition, const SceneFile& file,
                                const Eigen::Vector3d& centre_m);

/// Adds the surfaces of a background that emit.
void add_emitters(std::span<const std::shared_ptr<const SurfaceMesh>> background, Light& light);

/// The camera of the study file, else the scene file's first; position in `camera_position_m`.
[[nodiscard]] Camera scene_camera(const SceneDefinition& definition, const SceneFile& file, int width_px,
                                  int height_px, Eigen::Vector3d& camera_position_m);

/// Gives a mesh of an object the metallic and roughness that the scene has for all objects, in place of its
/// file's own.
void set_layer(const SceneDefinition& definition, FileMesh& mesh);

/// Meshes of a file placed in the world and moved so that `centre_m` becomes the origin.
[[nodiscard]] std::vector<std::shared_ptr<const SurfaceMesh>> place_meshes(const SceneFile& file,
                                                                           const Eigen::Affine3d& placement,
                                                                           const Eigen::Vector3d& centre_m,
                                                                           double default_albedo,
                                                                           int object_index);

/// Where the file of an object stands: as its definition says, or where it comes to rest from there on the
/// background, in which case `rests` gets a sentence. Throws InputError as `settle` does.
[[nodiscard]] Eigen::Affine3d standing_placement(const ObjectDefinition& object, const SceneFile& file,
                                                 const TruthScene& scene, std::vector<std::string>& rests);

/// position + Ry(yaw) Rx(pitch) Rz(roll) (scale * vertex).
[[nodiscard]] Eigen::Affine3d object_placement(const ObjectDefinition& object);

}  // namespace seamline::renderer
