#include "composites/objects/photo_objects.h"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "raytracer/scene/resting_object.h"
#include "raytracer/scene/scene_surfaces.h"
#include "raytracer/scene/seen_surface.h"
#include "support/text/error.h"
#include "support/text/printable.h"

namespace seamline::renderer {
namespace {

Eigen::AlignedBox3d turned_box(const SceneFile& file, const Eigen::Affine3d& placement) {
  Eigen::AlignedBox3d box;
  for (const FileMesh& mesh : file.meshes)
    for (const Eigen::Vector3d& place_m : mesh.positions_m) box.extend(placement * place_m);
  return box;
}

/// Turned, scaled and moved as its model says.
Eigen::Affine3d placement_of(const PlacedModel& model, const SceneFile& file) {
  ObjectDefinition object{.name = {},
                          .file = {},
                          .path = {},
                          .position_m = Eigen::Vector3d::Zero(),
                          .rotation_deg = model.rotation_deg,
                          .scale = 1};
  Eigen::AlignedBox3d box = turned_box(file, object_placement(object));
  object.scale = model.scale;
  if (model.height_m) {
    const double tall = box.sizes().y();
    if (!(tall > 0))
      throw input_error({.file = model.file, .wanted = "an object with a height", .found = "a flat one"});
    object.scale = *model.height_m / tall;
  }
  object.position_m = model.position_m;
  if (model.stands)
    object.position_m -= object.scale * Eigen::Vector3d(box.center().x(), box.min().y(), box.center().z());
  return object_placement(object);
}

/// Sentences about what of a file is not shown, each once.
void add_left_out(const SceneFile& file, std::vector<std::string>& sentences) {
  std::string names;
  for (const std::string& one : file.left_out_of_diffuse)
    names += (names.empty() ? "" : ", ") + printable(one);
  if (!names.empty())
    names = fmt::format("{} has {}, which diffuse materials leave out", printable(file.file), names);
  for (const std::string& sentence : {left_out_sentence(file, camera_and_lights(file)), names})
    if (!sentence.empty() && std::find(sentences.begin(), sentences.end(), sentence) == sentences.end())
      sentences.push_back(sentence);
}

}  // namespace

double half_width_m(const PhotoObjects::Size& size) {
  const Eigen::Vector3d sides = size.high_m - size.low_m;
  return 0.5 * std::max(sides.x(), sides.z());
}

PhotoObjects place_objects(const std::vector<PlacedModel>& models, const Eigen::Vector3d& centre_m,
                           const DepthMesh* ground) {
  KnownModels known;
  return place_objects(models, centre_m, ground, known);
}

PhotoObjects place_objects(const std::vector<PlacedModel>& models, const Eigen::Vector3d& centre_m,
                           const DepthMesh* ground, KnownModels& known) {
  PhotoObjects placed;
  for (const PlacedModel& model : models) {
    const std::tuple key(model.path, model.materials, model.transparency);
    auto read = known.find(key);
    if (read == known.end())
      read = known.emplace(key, read_scene_file(model.path, model.materials, model.transparency)).first;
    SceneFile file = read->second;
    require_surface(file, model.file, "an object");
    SceneDefinition layer;
    layer.albedo = model.albedo;
    layer.object_metallic = model.metallic;
    layer.object_roughness = model.roughness;
    PhotoObjects::Size size{.file = model.file, .low_m = {}, .high_m = {}};
    for (FileMesh& mesh : file.meshes) {
      set_layer(layer, mesh);
      size.triangles += mesh.triangles.size();
    }
    Eigen::Affine3d placement = placement_of(model, file);
    if (model.rest && ground != nullptr) {
      const RestingObject at_rest =
          rested(file, placement, ground_of(*ground, centre_m), "rest of " + model.file);
      placement = at_rest.placement;
      placed.rests.push_back(rest_sentence(model.file, at_rest));
    }
    const Eigen::AlignedBox3d box = turned_box(file, placement);
    size.low_m = box.min();
    size.high_m = box.max();
    size.placement = placement;
    placed.sizes.push_back(size);
    const auto meshes = place_meshes(file, placement, centre_m, model.albedo, photo_object_index);
    placed.meshes.insert(placed.meshes.end(), meshes.begin(), meshes.end());
    add_left_out(file, placed.left_out);
  }
  return placed;
}

ObjectSight look_at_objects(const Camera& camera, const Geometry& depth, const Geometry& objects,
                            const PhotoObjects& placed) {
  ObjectSight sight;
  float nearest_m = std::numeric_limits<float>::infinity();
  for (int y = 0; y < camera.height_px; ++y)
    for (int x = 0; x < camera.width_px; ++x) {
      const Ray ray = centre_ray(camera, x, y);
      if (ray.direction.isZero()) continue;
      const auto hit = objects.nearest(ray);
      if (!hit) continue;
      const auto real = seen_surface(camera, depth, x, y);
      const float real_m = real ? real->distance_m : std::numeric_limits<float>::infinity();
      ++sight.pixels;
      sight.visible_pixels += hit->distance_m < real_m ? 1 : 0;
      if (hit->distance_m >= nearest_m) continue;
      nearest_m = hit->distance_m;
      sight.scene_there_m = double{real_m};
    }
  sight.nearest_m = double{nearest_m};
  std::size_t asked = 0, behind = 0;
  for (const auto& mesh : placed.meshes) {
    const std::size_t step = mesh->positions_m.size() / 5000 + 1;
    for (std::size_t i = 0; i < mesh->positions_m.size(); i += step) {
      const float distance_m = mesh->positions_m[i].norm();
      if (!(distance_m > 0.0F)) continue;
      ++asked;
      behind +=
          depth.occluded({Eigen::Vector3f::Zero(), mesh->positions_m[i] / distance_m, 0.999F * distance_m})
              ? 1
              : 0;
    }
  }
  sight.behind_share = asked > 0 ? static_cast<double>(behind) / static_cast<double>(asked) : 0;
  return sight;
}

}  // namespace seamline::renderer
