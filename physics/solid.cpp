#include "physics/solid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>

namespace seamline::renderer {
namespace {

const Eigen::Vector3d& corner_m(const Solid& solid, const std::array<int, 3>& triangle, std::size_t i) {
  return solid.corners_m[static_cast<std::size_t>(triangle[i])];
}

}  // namespace

VolumeMoments moments_of(const Solid& solid) {
  VolumeMoments moments;
  for (const auto& triangle : solid.triangles) {
    const Eigen::Vector3d &a = corner_m(solid, triangle, 0), &b = corner_m(solid, triangle, 1),
                          &c = corner_m(solid, triangle, 2);
    const double volume_m3 = a.dot(b.cross(c)) / 6;
    const Eigen::Vector3d sum = a + b + c;
    moments.volume_m3 += volume_m3;
    moments.first += volume_m3 / 4 * sum;
    moments.second +=
        volume_m3 / 20 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
  }
  return moments;
}

std::vector<std::pair<Eigen::Vector3d, double>> faces_of(const Solid& solid) {
  Eigen::Vector3d middle_m = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& corner : solid.corners_m)
    middle_m += corner / static_cast<double>(solid.corners_m.size());
  std::vector<std::pair<Eigen::Vector3d, double>> faces;
  for (const auto& triangle : solid.triangles) {
    const Eigen::Vector3d& a = corner_m(solid, triangle, 0);
    Eigen::Vector3d normal =
        (corner_m(solid, triangle, 1) - a).cross(corner_m(solid, triangle, 2) - a).normalized();
    if (!normal.allFinite() || normal.isZero()) continue;
    if (normal.dot(a - middle_m) < 0) normal = -normal;
    double distance_m = normal.dot(a);
    for (const Eigen::Vector3d& corner : solid.corners_m)
      distance_m = std::max(distance_m, normal.dot(corner));
    faces.emplace_back(normal, distance_m);
  }
  return faces;
}

}  // namespace seamline::renderer
