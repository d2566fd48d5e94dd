#include "x3d/x3d_openness.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "raytracer/common/parallel.h"
#include "raytracer/common/sampler.h"
#include "raytracer/material/hemisphere.h"
#include "renderer/realtime/depth_normals.h"

namespace seamline::renderer {
namespace {

constexpr int rays_a_vertex = 64;
constexpr float start_share = 1e-3F;  ///< of the objects' size: rays begin so far off the surface

/// The vertices' own, or the mean of the triangles around each; up where there is none.
std::vector<Eigen::Vector3f> vertex_normals(const SurfaceMesh& mesh) {
  if (!mesh.normals.empty()) return mesh.normals;
  std::vector<Eigen::Vector3f> normals = triangle_mean_normals({mesh.positions_m, mesh.triangles});
  std::replace(normals.begin(), normals.end(), Eigen::Vector3f(0, 0, 0), Eigen::Vector3f(0, 1, 0));
  return normals;
}

float size_of(const X3dSubject& subject) {
  Eigen::AlignedBox3f box;
  for (const auto& mesh : subject.objects)
    for (const Eigen::Vector3f& place_m : mesh->positions_m) box.extend(place_m);
  return box.isEmpty() ? 0.0F : box.diagonal().norm();
}

}  // namespace

std::vector<std::vector<float>> x3d_openness(const X3dSubject& subject, int threads) {
  const Geometry objects(subject.objects);
  const float size_m = size_of(subject), sky_m = subject.light.sky_distance_m;
  const float reach_m = subject.light.ambient_occlusion ? sky_m : std::min(0.5F * size_m, sky_m);
  std::vector<std::vector<float>> openness;
  for (std::size_t m = 0; m < subject.objects.size(); ++m) {
    const SurfaceMesh& mesh = *subject.objects[m];
    const std::vector<Eigen::Vector3f> normals = vertex_normals(mesh);
    std::vector<float>& open = openness.emplace_back(mesh.positions_m.size());
    parallel_for(static_cast<int>(open.size()), threads, [&](int v) {
      const std::size_t at = v;
      const Eigen::Vector3f start_m = mesh.positions_m[at] + start_share * size_m * normals[at];
      std::array<Ray, rays_a_vertex> far, near;
      for (int i = 0; i < rays_a_vertex; ++i) {
        const Eigen::Array2f point = Sampler(1, v, static_cast<int>(m), i).point(dimension::direction(0));
        const Eigen::Vector3f direction = cosine_weighted(normals[at], point);
        const std::size_t number = i;
        far[number] = {start_m, direction, sky_m};
        near[number] = {start_m, direction, reach_m};
      }
      std::array<std::uint8_t, rays_a_vertex> by_object{}, by_world{};
      objects.occluded(far, by_object, Coherence::scattered);
      subject.depth->occluded(near, by_world, Coherence::scattered);
      int arriving = 0;
      for (std::size_t i = 0; i < rays_a_vertex; ++i)
        arriving += by_object[i] == 0 && by_world[i] == 0 ? 1 : 0;
      open[at] = static_cast<float>(arriving) / rays_a_vertex;
    });
  }
  return openness;
}

}  // namespace seamline::renderer
