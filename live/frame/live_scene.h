#pragma once
#include <Eigen/Geometry>
#include <vector>

#include "composites/objects/photo_objects.h"
#include "live/recording/loaded_recording.h"
#include "raytracer/light/light.h"
#include "raytracer/tracing/geometry.h"
#include "renderer/realtime/depth_picture.h"

namespace seamline::live {

/// A virtual thing that moves: rays are taken back to where it was placed, where its tree is; what maps are
/// drawn of is moved itself.
struct MovingObject {
  renderer::Geometry placed;                                   ///< where it was placed
  std::vector<std::shared_ptr<renderer::SurfaceMesh>> meshes;  ///< where it is: those of `LiveScene::objects`
  Eigen::Isometry3f scene_from_placed = Eigen::Isometry3f::Identity();
};

/// The virtual things and the light, in a frame with +Y up whose origin is where the camera was first.
struct LiveScene {
  renderer::PhotoObjects objects;
  renderer::Geometry geometry;  ///< of the objects, where they were placed
  renderer::Light light;        ///< its suns and lamps; of the sky `ambient_radiance` stands for all
  Rgb ambient_radiance;         ///< the environment's, the mean over all directions
  float display_factor = 1;     ///< codes show this times the radiance
  std::vector<MovingObject> moving = {};  ///< all objects, one for each model; or none, and nothing moves

  [[nodiscard]] std::size_t light_count() const { return light.suns.size() + light.lamps.size(); }
  [[nodiscard]] std::vector<renderer::TriangleSpan> spans() const;
};

/// What is asked for in the scene.
struct SceneRequest {
  std::vector<renderer::PlacedModel> models;
  const SceneDefinition* light = nullptr;  ///< in place of the recording's; null: the recording's, else ours
};

/// Where the camera of the first frame is believed to stand in a world with +Y up: the recording's own world
/// turned, or, without a pose, the camera's own place with its y axis up.
[[nodiscard]] Eigen::Isometry3d first_pose(const LoadedRecording& recording);

/// A pose of the recording's world in one with +Y up.
[[nodiscard]] Eigen::Isometry3d upright(const LoadedRecording& recording, const Eigen::Isometry3d& pose);

/// Reads and places the objects. Light that nobody states is a sun from behind the first camera, to the left
/// and above, and a third as much from everywhere. Throws InputError as `place_objects` does.
[[nodiscard]] LiveScene live_scene(const LoadedRecording& recording, const SceneRequest& request,
                                   const Eigen::Vector3d& origin_m);

}  // namespace seamline::live
