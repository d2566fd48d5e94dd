#include "registration/mesh/ray_grid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "support/running/parallel.h"

namespace seamline::registration {
namespace {

using Eigen::Vector3d;

/// Some ten times the rounding error of det(d, u, v), as a share of |d| |u| |v|.
constexpr double rounding = 1e-14;

constexpr std::int64_t no_pixel = -1;

/// The three edges of a triangle as planes through the camera: e = normal . d, and what counts as 0.
struct Edges {
  std::array<Vector3d, 3> normals;  ///< opposite to corner 0, 1, 2
  std::array<double, 3> zero;       ///< times |d|

  explicit Edges(const Triangle& triangle) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3d& from = triangle[(i + 1) % 3]->point_m;
      const Vector3d& to = triangle[(i + 2) % 3]->point_m;
      normals[i] = from.cross(to);
      zero[i] = rounding * from.norm() * to.norm();
    }
  }
};

}  // namespace

bool Hit::is_better_than(const Hit& other) const {
  if (met != other.met) return met;
  if (extruded != other.extruded) return other.extruded;
  if (planar_m != other.planar_m) return planar_m < other.planar_m;
  return !invented && other.invented;
}

RayGrid::RayGrid(const sensors::PinholeCamera& camera, int threads)
    : columns_(camera.width_px), rows_(camera.height_px) {
  const std::vector<Ray> rays = rays_of(camera, threads);
  least_.setConstant(std::numeric_limits<double>::infinity());
  most_ = -least_;
  for (const Ray& ray : rays) {
    least_ = least_.min(Eigen::Array2d(ray.x, ray.y));
    most_ = most_.max(Eigen::Array2d(ray.x, ray.y));
  }
  const std::size_t bins = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  first_.assign(bins + 1, 0);
  if (rays.empty()) return;
  bins_per_unit_ = Eigen::Array2d(columns_, rows_) / (most_ - least_).max(1e-300);
  const auto bin = [&](const Ray& ray) {
    return static_cast<std::size_t>(bin_of(ray.y, 1)) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(bin_of(ray.x, 0));
  };
  for (const Ray& ray : rays) ++first_[bin(ray) + 1];
  for (std::size_t i = 0; i < bins; ++i) first_[i + 1] += first_[i];
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  rays_.resize(rays.size());
  for (const Ray& ray : rays) rays_[next[bin(ray)]++] = ray;
}

/// Of all pixels that light comes from, row by row.
std::vector<RayGrid::Ray> RayGrid::rays_of(const sensors::PinholeCamera& camera, int threads) {
  std::vector<Ray> rays(static_cast<std::size_t>(camera.width_px) *
                        static_cast<std::size_t>(camera.height_px));
  run_parallel(camera.height_px, threads, [&](int row) {
    for (int column = 0; column < camera.width_px; ++column) {
      const std::int64_t pixel = static_cast<std::int64_t>(row) * camera.width_px + column;
      const auto direction = sensors::direction_through(camera, {column + 0.5, row + 0.5});
      rays[static_cast<std::size_t>(pixel)] =
          direction ? Ray{direction->x(), direction->y(), pixel} : Ray{0, 0, no_pixel};
    }
  });
  std::erase_if(rays, [](const Ray& ray) { return ray.pixel == no_pixel; });
  return rays;
}

int RayGrid::bin_of(double value, int axis) const {
  const int bins = axis == 0 ? columns_ : rows_;
  const double place = (value - least_[axis]) * bins_per_unit_[axis];
  return static_cast<int>(std::clamp(std::floor(place), 0.0, bins - 1.0));
}

/// In the plane z = 1. Where the triangle passes the camera's plane z = 0, it reaches to infinity on the side
/// on which it passes.
RayGrid::Box RayGrid::box_of(const Triangle& triangle) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Box box{Eigen::Array2d::Constant(infinite), Eigen::Array2d::Constant(-infinite)};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3d& here = triangle[i]->point_m;
    const Vector3d& next = triangle[(i + 1) % 3]->point_m;
    if (here.z() > 0) {
      const Eigen::Array2d place = here.head<2>().array() / here.z();
      box.least = box.least.min(place);
      box.most = box.most.max(place);
    }
    if ((here.z() > 0) == (next.z() > 0)) continue;
    const Eigen::Array2d passing =
        (here.head<2>() * next.z() - next.head<2>() * here.z()).array() / (next.z() - here.z());
    for (int axis = 0; axis < 2; ++axis) {
      if (passing[axis] >= 0) box.most[axis] = infinite;
      if (passing[axis] <= 0) box.least[axis] = -infinite;
    }
  }
  // What counts as 0 on an edge lies outside by as much.
  box.least -= 1e-12 * (1 + box.least.abs());
  box.most += 1e-12 * (1 + box.most.abs());
  return box;
}

RayGrid::Bins RayGrid::bins_of(const Box& box) const {
  if (rays_.empty() || (box.most < least_).any() || (box.least > most_).any() || (box.most < box.least).any())
    return {};
  return {bin_of(box.least[0], 0), bin_of(box.most[0], 0), bin_of(box.least[1], 1), bin_of(box.most[1], 1)};
}

void RayGrid::look_at(const Triangle& triangle, bool extruded, std::vector<Hit>& hits) const {
  if (std::none_of(triangle.begin(), triangle.end(), [](const Corner* c) { return c->point_m.z() > 0; }))
    return;  // behind the camera
  const Bins bins = bins_of(box_of(triangle));
  if (bins.last_row < bins.row) return;
  const Edges edges(triangle);
  const bool invented = triangle[0]->invented || triangle[1]->invented || triangle[2]->invented;
  const auto ask = [&](const Ray& ray) {
    const Vector3d direction(ray.x, ray.y, 1);
    const double length = direction.norm();
    std::array<double, 3> e{};
    for (std::size_t i = 0; i < 3; ++i) e[i] = edges.normals[i].dot(direction);
    const double side = e[0] + e[1] + e[2] < 0 ? -1 : 1;
    double sum = 0, depth_sum = 0, zero = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      if (side * e[i] < -edges.zero[i] * length) return;
      const double weight = std::max(0.0, side * e[i]);
      sum += weight;
      depth_sum += weight * triangle[i]->point_m.z();
      zero += edges.zero[i] * length;
    }
    if (!(sum > zero)) return;  // seen along its own plane
    const Hit hit{depth_sum / sum, extruded, invented, true};
    if (!(hit.planar_m > 0)) return;  // behind the camera
    Hit& best = hits[static_cast<std::size_t>(ray.pixel)];
    if (hit.is_better_than(best)) best = hit;
  };
  for (int row = bins.row; row <= bins.last_row; ++row) {
    const std::size_t start = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_);
    const std::size_t end = first_[start + static_cast<std::size_t>(bins.last_column) + 1];
    for (std::size_t i = first_[start + static_cast<std::size_t>(bins.column)]; i < end; ++i) ask(rays_[i]);
  }
}

}  // namespace seamline::registration
