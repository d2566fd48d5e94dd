#include "live/frame/moving_objects.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

namespace seamline::live {
namespace {

using renderer::Ray;
using renderer::SurfacePoint;

Ray turned_back(const Ray& ray, const Eigen::Isometry3f& placed_from_scene) {
  Ray back = ray;
  back.origin_m = placed_from_scene * ray.origin_m;
  back.direction = placed_from_scene.linear() * ray.direction;
  return back;
}

/// Takes the hits of one object where they are nearer than those before.
void keep_nearer(const MovingObject& object, std::span<const std::optional<SurfacePoint>> found,
                 std::span<std::optional<SurfacePoint>> hits) {
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (!found[i] || (hits[i] && hits[i]->distance_m <= found[i]->distance_m)) continue;
    SurfacePoint& hit = hits[i].emplace(*found[i]);
    const Eigen::Matrix3f turn = object.scene_from_placed.linear();
    hit.position_m = object.scene_from_placed * hit.position_m;
    hit.normal = turn * hit.normal;
    hit.geometric_normal = turn * hit.geometric_normal;
  }
}

}  // namespace

void make_movable(const std::vector<renderer::PlacedModel>& models, const Eigen::Vector3d& origin_m,
                  LiveScene& scene) {
  renderer::KnownModels known;
  std::vector<std::shared_ptr<const renderer::SurfaceMesh>> moved;
  for (const renderer::PlacedModel& model : models) {
    const renderer::PhotoObjects one = renderer::place_objects({model}, origin_m, nullptr, known);
    MovingObject object{.placed = renderer::Geometry(one.meshes, renderer::Edges::loose), .meshes = {}};
    for (const auto& mesh : one.meshes)
      object.meshes.push_back(std::make_shared<renderer::SurfaceMesh>(*mesh));
    moved.insert(moved.end(), object.meshes.begin(), object.meshes.end());
    scene.moving.push_back(std::move(object));
  }
  scene.objects.meshes = std::move(moved);
}

void move_objects(std::span<const Eigen::Isometry3d> moves, const Eigen::Vector3d& origin_m,
                  LiveScene& scene) {
  assert(moves.size() == scene.moving.size());
  const Eigen::Translation3d to_world(origin_m);
  for (std::size_t i = 0; i < scene.moving.size(); ++i) {
    MovingObject& object = scene.moving[i];
    const Eigen::Isometry3d by = to_world.inverse() * moves[i] * to_world;
    object.scene_from_placed = by.cast<float>();
    for (std::size_t m = 0; m < object.meshes.size(); ++m) {
      const std::vector<Eigen::Vector3f>& placed_m = object.placed.meshes()[m]->positions_m;
      std::transform(placed_m.begin(), placed_m.end(), object.meshes[m]->positions_m.begin(),
                     [&](const Eigen::Vector3f& place_m) -> Eigen::Vector3f {
                       return object.scene_from_placed * place_m;
                     });
    }
  }
}

void nearest_objects(const LiveScene& scene, std::span<const Ray> rays,
                     std::span<std::optional<SurfacePoint>> hits) {
  if (scene.moving.empty()) {
    scene.geometry.nearest(rays, hits);
    return;
  }
  assert(rays.size() <= renderer::rays_a_call);
  std::array<Ray, renderer::rays_a_call> back;
  std::array<std::optional<SurfacePoint>, renderer::rays_a_call> found;
  for (std::size_t i = 0; i < rays.size(); ++i) hits[i].reset();
  for (const MovingObject& object : scene.moving) {
    const Eigen::Isometry3f placed_from_scene = object.scene_from_placed.inverse();
    for (std::size_t i = 0; i < rays.size(); ++i) back[i] = turned_back(rays[i], placed_from_scene);
    object.placed.nearest(std::span(back).first(rays.size()), std::span(found).first(rays.size()));
    keep_nearer(object, std::span(found).first(rays.size()), hits.first(rays.size()));
  }
}

bool objects_block(const LiveScene& scene, const Ray& ray) {
  if (scene.moving.empty()) return scene.geometry.occluded(ray);
  return std::any_of(scene.moving.begin(), scene.moving.end(), [&](const MovingObject& object) {
    return object.placed.occluded(turned_back(ray, object.scene_from_placed.inverse()));
  });
}

}  // namespace seamline::live
