#include "raytracer/scene/scene_surfaces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "support/text/counted.h"
#include "support/text/error.h"

namespace seamline::renderer {
namespace {

/// Normal times twice the area.
Eigen::Vector3d cross_of(const FileMesh& mesh, const Triangle& triangle) {
  const Eigen::Vector3d& a = mesh.positions_m[triangle[0]];
  return (mesh.positions_m[triangle[1]] - a).cross(mesh.positions_m[triangle[2]] - a);
}

/// Beyond what rounding to float, as files have them, leaves of corners on one line.
bool has_area(const FileMesh& mesh, const Triangle& triangle) {
  constexpr double thin = 2e-7;
  const Eigen::Vector3d& a = mesh.positions_m[triangle[0]];
  const double longest_squared = std::max((mesh.positions_m[triangle[1]] - a).squaredNorm(),
                                          (mesh.positions_m[triangle[2]] - a).squaredNorm());
  return cross_of(mesh, triangle).norm() > thin * longest_squared;
}

}  // namespace

void require_triangles(const SceneFile& scene, const std::string& file, const std::string& what) {
  if (scene.meshes.empty())
    throw input_error({.file = file, .wanted = what + " with triangles", .found = "none"});
}

void require_surface(const SceneFile& scene, const std::string& file, const std::string& what) {
  require_triangles(scene, file, what);
  std::size_t count = 0;
  for (const FileMesh& mesh : scene.meshes) {
    for (const Triangle& triangle : mesh.triangles)
      if (has_area(mesh, triangle)) return;
    count += mesh.triangles.size();
  }
  throw input_error({.file = file,
                     .wanted = what + " with triangles that have an area",
                     .found = counted(count, "triangle") + " without any"});
}

bool may_be_z_up(const SceneFile& scene) {
  constexpr double leaning = 0.5, little = 0.01, much = 0.2;
  if (scene.camera)  // with +Z above it; none that looks along -Y, which is down where Y is up
    return scene.camera->axes(2, 1) > leaning && scene.camera->axes(1, 2) < leaning;
  double all = 0, along_y = 0, along_z = 0;
  for (const FileMesh& mesh : scene.meshes)
    for (const Triangle& triangle : mesh.triangles) {
      const Eigen::Vector3d cross = cross_of(mesh, triangle);
      const double area = cross.norm();
      all += area;
      if (std::abs(cross.y()) > leaning * area) along_y += area;
      if (std::abs(cross.z()) > leaning * area) along_z += area;
    }
  return along_y < little * all && along_z > much * all;
}

}  // namespace seamline::renderer
