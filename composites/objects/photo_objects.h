#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "raytracer/scene/scene_file.h"
#include "raytracer/scene/truth_scene.h"
#include "stimuli/definition/surface/material_model.h"

namespace seamline::renderer {

/// A virtual object: which file, and where it stands in the composite's world.
struct PlacedModel {
  std::string file;            ///< as written
  std::filesystem::path path;  ///< resolved
  Eigen::Vector3d position_m{0, 0, -3};
  Eigen::Vector3d rotation_deg = Eigen::Vector3d::Zero();  ///< pitch about X, yaw about Y, roll about Z
  double scale = 1;
  std::optional<double> height_m = {};  ///< it is scaled to be so tall; `scale` then says nothing
  bool stands = false;    ///< `position_m` is the middle of its lowest level, not the origin of its file
  bool has_place = true;  ///< else it is put where the view shows a real surface (`stand_in_view`)
  bool rest = false;      ///< it is let down from there, and stands where it comes to rest on the depth map
  MaterialModel materials = MaterialModel::gltf;
  Transparency transparency = Transparency::refused;    ///< of its half-transparent surfaces
  double albedo = 0.5;                                  ///< of its meshes without a material
  std::optional<double> metallic = {}, roughness = {};  ///< in place of its files' own
};

/// Of all virtual objects of a composite, which are one to the estimators.
inline constexpr int photo_object_index = 1;

/// Objects as they stand, in the frame of the camera.
struct PhotoObjects {
  std::vector<std::shared_ptr<const SurfaceMesh>> meshes;
  struct Size {
    std::string file;
    Eigen::Vector3d low_m, high_m;  ///< its box in the composite's world
    std::size_t triangles = 0;
    Eigen::Affine3d placement = Eigen::Affine3d::Identity();  ///< from its file to the composite's world
  };
  std::vector<Size> sizes;            ///< of each object
  std::vector<std::string> rests;     ///< sentences about what was let down
  std::vector<std::string> left_out;  ///< sentences about what of the files is not shown, once a file
};

/// Half of an object's larger side across.
[[nodiscard]] double half_width_m(const PhotoObjects::Size& size);

/// Reads and places objects. `centre_m`: the camera's place in the world. Throws InputError naming the file
/// where it is wrong, has no triangles, is flat where a height is wanted, or has a material that cannot be
/// rendered. Objects that rest are let down on `ground`, which is in the frame of the camera; while it is
/// null they stay at their place.
[[nodiscard]] PhotoObjects place_objects(const std::vector<PlacedModel>& models,
                                         const Eigen::Vector3d& centre_m, const DepthMesh* ground = nullptr);

/// Files that were read, for placing their objects again and again.
using KnownModels = std::map<std::tuple<std::filesystem::path, MaterialModel, Transparency>, SceneFile>;
/// The same, reading only files that are not known.
[[nodiscard]] PhotoObjects place_objects(const std::vector<PlacedModel>& models,
                                         const Eigen::Vector3d& centre_m, const DepthMesh* ground,
                                         KnownModels& known);

/// Where objects are, seen from the camera, a ray a pixel.
struct ObjectSight {
  std::size_t pixels = 0;          ///< that they would cover with nothing before them
  std::size_t visible_pixels = 0;  ///< with the local scene before them
  double nearest_m = 0;            ///< of those pixels, along the ray
  double scene_there_m = 0;        ///< of the local scene in that pixel; infinity: none
  double behind_share = 0;         ///< of the objects' vertices, behind the local scene
};
[[nodiscard]] ObjectSight look_at_objects(const Camera& camera, const Geometry& depth,
                                          const Geometry& objects, const PhotoObjects& placed);

}  // namespace seamline::renderer
