#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "composites/objects/photo_objects.h"
#include "raytracer/light/light.h"
#include "raytracer/scene/camera.h"
#include "raytracer/scene/scene_figure.h"
#include "raytracer/tracing/geometry.h"
#include "stimuli/definition/study_definition.h"
#include "support/files/image.h"

namespace seamline::renderer {

/// What `seamline export x3d SET_OR_SCENE DIR` asks for.
struct X3dRequest {
  std::string source;  ///< a set's folder, or a scene: .glb, .gltf or builtin:NAME
  std::filesystem::path out_folder;
  // Of a set.
  std::string stimulus;    ///< its id; empty: the set's first
  std::string asset_root;  ///< where the study's scene files may lie, too
  // Of a scene.
  std::optional<PlacedModel> object;  ///< what is put into it
  SceneDefinition light;              ///< sun, environment, bounces, camera and exposure
  int width_px = 640, height_px = 360;
  std::optional<double> fov_deg;  ///< horizontal; none: the camera's own
  // Of both.
  std::string user;  ///< file of a recorded user; empty: nobody
  int spp = 64;
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: one for each core
};

/// What a page shows: a photograph with the depth that is known of it, and what is put into it. Everything
/// in the renderer's frame, in whose origin the camera is.
struct X3dSubject {
  std::string title;
  Image photograph;  ///< linear radiance, without the virtual objects
  Camera camera;     ///< a plain pinhole
  Eigen::Vector3d camera_position_m = Eigen::Vector3d::Zero();  ///< in the scene's world
  double exposure_ev = 0;
  std::shared_ptr<const Geometry> depth;  ///< the local scene: what stands for the real world
  std::vector<std::shared_ptr<const SurfaceMesh>> objects;
  Light light;
  double albedo = 0.5;                     ///< of the local scene
  std::vector<std::string> notes;          ///< what of the source the page does not show
  std::optional<SceneFigure> figure = {};  ///< of the objects, one mesh for each of theirs
  Eigen::Affine3d x3d_from_figure = Eigen::Affine3d::Identity();  ///< from its file to where it stands
};

/// A stimulus of a set: its truth without the virtual object is photographed again, with `spp` samples a
/// pixel; its depth is the stimulus' own, whatever its artifact. Throws InputError where the set, the
/// stimulus or a scene file is not there.
[[nodiscard]] X3dSubject subject_of_set(const X3dRequest& request);

/// A scene photographed with its own camera and light, or those of the request; its depth is exact. Throws
/// InputError where it has no camera, no light or no triangles, or no object is given.
[[nodiscard]] X3dSubject subject_of_scene(const X3dRequest& request);

}  // namespace seamline::renderer
