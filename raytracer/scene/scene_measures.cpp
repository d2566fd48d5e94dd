#include "raytracer/scene/scene_measures.h"

#include <Eigen/Geometry>
#include <numbers>
#include "raytracer/scene/camera.h"
#include "support/arithmetic/grid_index.h"

namespace seamline::renderer {
namespace {

Eigen::AlignedBox3f bounds(const std::vector<std::shared_ptr<const SurfaceMesh>>& meshes) {
  Eigen::AlignedBox3f box;
  for (const auto& mesh : meshes)
    for (const Eigen::Vector3f& vertex : mesh->positions_m) box.extend(vertex);
  return box;
}

/// Measures one object; the sun is the scene's first.
class ObjectMeter {
 public:
  ObjectMeter(const TruthScene& scene, int object_index)
      : scene_(scene),
        truth_(scene.geometry_without(object_index)),
        object_(scene.geometry(false, {object_index})),
        background_(scene.geometry(true, {})) {
    measures_.name = scene.definition.objects[object_index - 1].name;
    measures_.distance_m = double{bounds(scene.objects[object_index - 1]).center().norm()};
  }

  ObjectMeasures measure() {
    const Camera& camera = scene_.camera;
    std::vector<bool> silhouette(static_cast<std::size_t>(camera.width_px) *
                                 static_cast<std::size_t>(camera.height_px));
    for (int y = 0; y < camera.height_px; ++y)
      for (int x = 0; x < camera.width_px; ++x) {
        const Ray ray = centre_ray(camera, x, y);
        silhouette[grid_index(y, x, camera.width_px)] = look(ray);
      }
    measures_.silhouette_complexity = silhouette_complexity(silhouette, camera.width_px, camera.height_px);
    return measures_;
  }

 private:
  /// Adds one pixel; whether the object alone would cover it.
  bool look(const Ray& ray) {
    const auto real = truth_.nearest(ray);
    const auto object = object_.nearest(ray);
    measures_.unoccluded_px += object ? 1 : 0;
    if (object && (!real || object->distance_m < real->distance_m))
      add_body(*object);
    else if (real)
      add_ground(*real);
    return object.has_value();
  }

  [[nodiscard]] std::optional<Ray> sun_ray(const SurfacePoint& point) const {
    if (scene_.light.suns.empty()) return std::nullopt;
    const Eigen::Vector3f& to_sun = scene_.light.suns.front().to_sun;
    if (!above_horizon(point, to_sun)) return std::nullopt;
    return Ray{ray_start(point, to_sun), to_sun};
  }

  void add_body(const SurfacePoint& point) {
    measures_.visible_px += 1;
    const std::optional<Ray> ray = sun_ray(point);
    if (!ray) return;
    measures_.sun_facing_px += 1;
    measures_.in_real_shadow_px += background_.occluded(*ray) ? 1 : 0;
  }

  void add_ground(const SurfacePoint& point) {
    const std::optional<Ray> ray = sun_ray(point);
    if (!ray || !object_.occluded(*ray)) return;
    if (background_.occluded(*ray)) {
      measures_.shadow_on_shadow_px += 1;
    } else if (!truth_.occluded(*ray)) {
      measures_.shadow_px += 1;
      measures_.shadow_px_by_surface[truth_.meshes()[point.mesh]->name] += 1;
    }
  }

  const TruthScene& scene_;
  Geometry truth_, object_, background_;
  ObjectMeasures measures_;
};

}  // namespace

double silhouette_complexity(const std::vector<bool>& mask, int width_px, int height_px) {
  double area = 0, edges = 0;
  const auto inside = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < width_px && y < height_px && mask[grid_index(y, x, width_px)];
  };
  for (int y = 0; y < height_px; ++y)
    for (int x = 0; x < width_px; ++x) {
      if (!inside(x, y)) continue;
      area += 1;
      edges += !inside(x - 1, y) + !inside(x + 1, y) + !inside(x, y - 1) + !inside(x, y + 1);
    }
  const double perimeter = edges * std::numbers::pi / 4;
  return area > 0 ? perimeter * perimeter / (4 * std::numbers::pi * area) : 0.0;
}

std::vector<ObjectMeasures> measure_objects(const TruthScene& scene) {
  std::vector<ObjectMeasures> measures;
  for (const int object : scene.object_indices()) measures.push_back(ObjectMeter(scene, object).measure());
  return measures;
}

}  // namespace seamline::renderer
