#include "renderer/realtime/depth_normals.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "raytracer/common/parallel.h"
#include "support/arithmetic/grid_index.h"

namespace seamline::renderer {
namespace {

/// The point that a pixel of a camera's picture shows; infinite where it shows nothing.
Eigen::Vector3f point_of(const DepthPicture& depth, const DrawView& view, int x, int y) {
  const float right =
      view.corner[0] + (static_cast<float>(x) + 0.5F) / static_cast<float>(depth.width_px) * view.size[0];
  const float down =
      view.corner[1] + (static_cast<float>(y) + 0.5F) / static_cast<float>(depth.height_px) * view.size[1];
  return view.axes.transpose() * (Eigen::Vector3f(right, down, 1.0F) * depth.at(x, y));
}

bool shows(const DepthPicture& depth, int x, int y) {
  return x >= 0 && y >= 0 && x < depth.width_px && y < depth.height_px && std::isfinite(depth.at(x, y));
}

}  // namespace

Eigen::Vector3f cross_product_normal(const DepthPicture& depth, const DrawView& view, int x, int y) {
  constexpr std::array<std::array<int, 2>, 5> around = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}}};
  if (!shows(depth, x, y)) return Eigen::Vector3f::Zero();
  const Eigen::Vector3f centre_m = point_of(depth, view, x, y);
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (std::size_t i = 0; i < 4; ++i) {
    const auto [ax, ay] = around[i];
    const auto [bx, by] = around[i + 1];
    if (!shows(depth, x + ax, y + ay) || !shows(depth, x + bx, y + by)) continue;
    sum += (point_of(depth, view, x + bx, y + by) - centre_m)
               .cross(point_of(depth, view, x + ax, y + ay) - centre_m);
  }
  if (!(sum.norm() > 0.0F)) sum = -centre_m;  // a pixel alone faces the camera
  if (sum.dot(centre_m) > 0.0F) sum = -sum;
  return sum.normalized();
}

NormalPicture cross_product_normals(const DepthPicture& depth, const DrawView& view, int threads) {
  NormalPicture out{depth.width_px, depth.height_px,
                    std::vector<Eigen::Vector3f>(depth.depth_m.size(), Eigen::Vector3f::Zero())};
  parallel_for(depth.height_px, threads, [&](int y) {
    for (int x = 0; x < depth.width_px; ++x)
      out.normals[grid_index(y, x, depth.width_px)] = cross_product_normal(depth, view, x, y);
  });
  return out;
}

std::vector<Eigen::Vector3f> triangle_mean_normals(const TriangleSpan& mesh) {
  std::vector<Eigen::Vector3f> normals(mesh.positions_m.size(), Eigen::Vector3f::Zero());
  for (const Triangle& triangle : mesh.triangles) {
    const Eigen::Vector3f& a = mesh.positions_m[triangle[0]];
    const Eigen::Vector3f normal =
        (mesh.positions_m[triangle[1]] - a).cross(mesh.positions_m[triangle[2]] - a);
    const float length = normal.norm();
    if (!(length > 0.0F)) continue;
    for (const std::uint32_t corner : triangle) normals[corner] += normal / length;
  }
  for (Eigen::Vector3f& normal : normals)
    if (const float length = normal.norm(); length > 0.0F) normal /= length;
  return normals;
}

NormalPicture draw_normals(const DrawView& view, const TriangleSpan& mesh,
                           std::span<const Eigen::Vector3f> vertex_normals, const DepthPicture& depth) {
  NormalPicture out{depth.width_px, depth.height_px,
                    std::vector<Eigen::Vector3f>(depth.depth_m.size(), Eigen::Vector3f::Zero())};
  std::vector<float> nearest(depth.depth_m.size(), 0.0F);  // 1 / depth of what was drawn
  for (const Triangle& triangle : mesh.triangles) {
    std::array<Eigen::Vector3f, 3> seen;
    for (std::size_t i = 0; i < 3; ++i) seen[i] = view.axes * (mesh.positions_m[triangle[i]] - view.eye_m);
    if (!(std::min({seen[0].z(), seen[1].z(), seen[2].z()}) > 1e-3F)) continue;
    std::array<Eigen::Array2f, 3> place;
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Array2f tangents = seen[i].head<2>().array() / seen[i].z();
      place[i] = (tangents - view.corner) / view.size *
                 Eigen::Array2f(static_cast<float>(depth.width_px), static_cast<float>(depth.height_px));
    }
    const Eigen::Array2f ab = place[1] - place[0], ac = place[2] - place[0];
    const float area = ab[0] * ac[1] - ab[1] * ac[0];
    if (area == 0.0F || !std::isfinite(area)) continue;
    const Eigen::Array2f least = place[0].min(place[1]).min(place[2]),
                         most = place[0].max(place[1]).max(place[2]);
    const int left = static_cast<int>(std::clamp(least[0], 0.0F, static_cast<float>(depth.width_px)));
    const int right = static_cast<int>(std::clamp(most[0], -1.0F, static_cast<float>(depth.width_px - 1)));
    const int top = static_cast<int>(std::clamp(least[1], 0.0F, static_cast<float>(depth.height_px)));
    const int bottom = static_cast<int>(std::clamp(most[1], -1.0F, static_cast<float>(depth.height_px - 1)));
    for (int y = top; y <= bottom; ++y)
      for (int x = left; x <= right; ++x) {
        const Eigen::Array2f from_a =
            Eigen::Array2f(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F) - place[0];
        const float b = (from_a[0] * ac[1] - from_a[1] * ac[0]) / area;
        const float c = (ab[0] * from_a[1] - ab[1] * from_a[0]) / area;
        const float a = 1.0F - b - c;
        if (!(a >= -1e-4F && b >= -1e-4F && c >= -1e-4F)) continue;
        const float over_depth = a / seen[0].z() + b / seen[1].z() + c / seen[2].z();
        const auto i = grid_index(y, x, depth.width_px);
        if (!(over_depth > nearest[i])) continue;
        nearest[i] = over_depth;
        Eigen::Vector3f normal = vertex_normals[triangle[0]] * (a / seen[0].z()) +
                                 vertex_normals[triangle[1]] * (b / seen[1].z()) +
                                 vertex_normals[triangle[2]] * (c / seen[2].z());
        const Eigen::Vector3f towards =
            view.axes.transpose() *
            (a * seen[0] / seen[0].z() + b * seen[1] / seen[1].z() + c * seen[2] / seen[2].z());
        if (normal.dot(towards) > 0.0F) normal = -normal;
        const float length = normal.norm();
        out.normals[i] =
            length > 0.0F ? Eigen::Vector3f(normal / length) : Eigen::Vector3f(-towards.normalized());
      }
  }
  return out;
}

}  // namespace seamline::renderer
