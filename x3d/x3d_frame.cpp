#include "x3d/x3d_frame.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "raytracer/common/parallel.h"
#include "renderer/depth/sensor/pixel_mesh.h"
#include "renderer/depth/sensor/sensor_pose.h"
#include "support/arithmetic/grid_index.h"
#include "support/text/numbers.h"

namespace seamline::renderer {
namespace {

constexpr double largest_code = 16777215;  ///< 2^24 - 1
constexpr double ghost_tolerance = 1e-3;   ///< of their mesh, along rays
constexpr double jump_ratio = 1.1;         ///< between depths of what is no longer one surface
constexpr float nowhere_m = std::numeric_limits<float>::infinity();

/// Planar depth of the nearest surface in every pixel's centre; infinity where there is none.
std::vector<float> planar_depths(const Geometry& geometry, const Camera& camera, int threads) {
  std::vector<float> depth_m(
      static_cast<std::size_t>(camera.width_px) * static_cast<std::size_t>(camera.height_px), nowhere_m);
  const Eigen::Vector3f forward = -camera.axes.col(2);
  parallel_for(camera.height_px, threads, [&](int y) {
    for (int x = 0; x < camera.width_px; ++x) {
      const Ray ray = centre_ray(camera, x, y);
      const auto hit = geometry.nearest(ray);
      if (hit) depth_m[grid_index(y, x, camera.width_px)] = hit->distance_m * ray.direction.dot(forward);
    }
  });
  return depth_m;
}

/// Around what is seen and all corners of the objects, with room for moving them.
ClipPlanes planes_around(std::span<const float> depth_m, const X3dSubject& subject) {
  double nearest_m = infinity, farthest_m = 0;
  const auto take = [&](double planar_m) {
    if (!std::isfinite(planar_m) || !(planar_m > 0)) return;
    nearest_m = std::min(nearest_m, planar_m);
    farthest_m = std::max(farthest_m, planar_m);
  };
  for (const float planar_m : depth_m) take(static_cast<double>(planar_m));
  for (const auto& mesh : subject.objects)
    for (const Eigen::Vector3f& place_m : mesh->positions_m)
      take(-static_cast<double>(subject.camera.axes.col(2).dot(place_m)));
  if (farthest_m == 0) return {};
  const double near_m = std::max(0.5 * nearest_m, 1e-4 * farthest_m);
  return {near_m, std::max(2 * farthest_m, 4 * near_m)};
}

/// In the frame of X3D.
DepthMesh mesh_of(const PixelGrid& grid, const Camera& camera, std::optional<double> cut_ratio, int threads) {
  DepthMesh mesh =
      build_pixel_mesh(grid, {.tolerance = ghost_tolerance, .cut_ratio = cut_ratio, .threads = threads});
  for (Eigen::Vector3f& vertex_m : mesh.vertices_m) vertex_m = camera.axes.transpose() * vertex_m;
  return mesh;
}

}  // namespace

double window_depth(double planar_m, const ClipPlanes& planes) {
  const double nearest = 1 / planes.near_m, farthest = 1 / planes.far_m;
  return std::clamp((nearest - 1 / planar_m) / (nearest - farthest), 0.0, 1.0);
}

X3dFrame frame_of(const X3dSubject& subject, int threads) {
  X3dFrame frame;
  frame.depth.camera = pinhole_of(subject.camera);
  frame.depth.depth_m = planar_depths(*subject.depth, subject.camera, threads);
  const Geometry objects(subject.objects);
  const std::vector<float> object_m = planar_depths(objects, subject.camera, threads);
  frame.in_front.resize(object_m.size());
  for (std::size_t i = 0; i < object_m.size(); ++i)
    frame.in_front[i] = object_m[i] == nowhere_m               ? InFront::nothing_virtual
                        : object_m[i] < frame.depth.depth_m[i] ? InFront::object
                                                               : InFront::real;
  frame.planes = planes_around(frame.depth.depth_m, subject);
  const PixelGrid grid = pixel_grid({frame.depth, world_from_photograph(subject.camera)}, threads);
  frame.ghosts = mesh_of(grid, subject.camera, std::nullopt, threads);
  frame.blockers = mesh_of(grid, subject.camera, jump_ratio, threads);
  return frame;
}

ByteImage depth_codes(std::span<const float> depth_m, int width_px, int height_px, double range_m) {
  ByteImage codes{.width_px = width_px, .height_px = height_px, .channels = 3, .values = {}};
  codes.values.reserve(3 * depth_m.size());
  for (const float planar_m : depth_m) {
    const double share = std::isfinite(planar_m) ? static_cast<double>(planar_m) / range_m : 0;
    // The nearest code is 1: 0 is a hole.
    const auto code = static_cast<std::uint32_t>(
        share > 0 ? std::clamp(std::round(share * largest_code), 1.0, largest_code) : 0.0);
    for (const int shift : {16, 8, 0}) codes.values.push_back(static_cast<std::uint8_t>(code >> shift));
  }
  return codes;
}

double depth_of_code(std::span<const std::uint8_t, 3> code, double range_m) {
  const double value = 65536.0 * code[0] + 256.0 * code[1] + code[2];
  return value > 0 ? value / largest_code * range_m : infinity;
}

double depth_range_m(std::span<const float> depth_m) {
  float largest_m = 0;
  for (const float planar_m : depth_m)
    if (std::isfinite(planar_m)) largest_m = std::max(largest_m, planar_m);
  return largest_m > 0 ? static_cast<double>(largest_m) : 1;
}

}  // namespace seamline::renderer
