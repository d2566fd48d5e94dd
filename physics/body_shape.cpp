#include "physics/body_shape.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <set>

#include "support/text/error.h"

namespace seamline::renderer {
namespace {

/// In which a hull's points are looked for.
struct DirectionCounts {
  std::size_t all, of_ring;
};
constexpr DirectionCounts fine = {210, 24}, coarse = {64, 12};

/// The six axes; a ring close around up and down, which finds the outline of a base; the others evenly over
/// the sphere.
std::vector<Eigen::Vector3d> directions(const DirectionCounts& counts) {
  std::vector<Eigen::Vector3d> out;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) out.emplace_back(sign * Eigen::Vector3d::Unit(axis));
  constexpr double ring_rad = 0.05;
  for (const double sign : {-1.0, 1.0})
    for (std::size_t i = 0; i < counts.of_ring; ++i) {
      const double angle =
          2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(counts.of_ring);
      out.emplace_back(std::sin(ring_rad) * std::cos(angle), sign * std::cos(ring_rad),
                       std::sin(ring_rad) * std::sin(angle));
    }
  const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
  const std::size_t others = counts.all - out.size();
  for (std::size_t i = 0; i < others; ++i) {
    const double height = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(others);
    const double radius = std::sqrt(1 - height * height), angle = turn * static_cast<double>(i);
    out.emplace_back(radius * std::cos(angle), height, radius * std::sin(angle));
  }
  return out;
}

std::size_t farthest(std::span<const Eigen::Vector3d> vertices_m, const Eigen::Vector3d& direction) {
  std::size_t best = 0;
  double best_m = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < vertices_m.size(); ++i)
    if (const double along_m = vertices_m[i].dot(direction); along_m > best_m) best = i, best_m = along_m;
  return best;
}

std::vector<Eigen::Vector3d> farthest_points(std::span<const Eigen::Vector3d> vertices_m,
                                             const DirectionCounts& counts) {
  std::set<std::size_t> chosen;
  if (!vertices_m.empty())
    for (const Eigen::Vector3d& direction : directions(counts))
      chosen.insert(farthest(vertices_m, direction));
  std::vector<Eigen::Vector3d> points_m;
  for (const std::size_t i : chosen) points_m.push_back(vertices_m[i]);
  return points_m;
}

/// A ball whose surface the vertices cover on all sides.
std::optional<BallShape> ball_of(std::span<const Eigen::Vector3d> vertices_m, std::size_t extremes) {
  constexpr double same = 1e-3;
  constexpr std::size_t fewest = 100;  ///< of the directions, with a vertex of their own
  if (extremes < fewest) return {};
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& vertex_m : vertices_m) box.extend(vertex_m);
  const Eigen::Vector3d middle_m = box.center();
  double least_m = std::numeric_limits<double>::infinity(), most_m = 0;
  for (const Eigen::Vector3d& vertex_m : vertices_m) {
    const double distance_m = (vertex_m - middle_m).norm();
    least_m = std::min(least_m, distance_m);
    most_m = std::max(most_m, distance_m);
  }
  if (!(most_m - least_m <= same * most_m)) return {};
  return BallShape{middle_m, most_m};
}

/// Whether points span a volume: no plane holds them all.
bool has_volume(std::span<const Eigen::Vector3d> points_m) {
  constexpr double thin = 1e-6;  ///< of the longest side
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points_m) mean += point / static_cast<double>(points_m.size());
  for (const Eigen::Vector3d& point : points_m) spread += (point - mean) * (point - mean).transpose();
  const Eigen::Vector3d squares = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvalues();
  return squares[2] > 0 && squares[0] > thin * thin * squares[2];
}

}  // namespace

BodyShape body_shape_of(std::span<const Eigen::Vector3d> vertices_m, const std::string& what) {
  HullShape hull{farthest_points(vertices_m, fine)};
  if (hull.points_m.size() < 4 || !has_volume(hull.points_m))
    throw input_error(
        {.field = what, .wanted = "an object with a volume, which can lie", .found = "a flat one"});
  if (const auto ball = ball_of(vertices_m, hull.points_m.size())) return *ball;
  return hull;
}

BodyShape coarser(const BodyShape& shape) {
  const auto* hull = std::get_if<HullShape>(&shape);
  if (hull == nullptr) return shape;
  HullShape fewer{farthest_points(hull->points_m, coarse)};
  return fewer.points_m.size() >= 4 && has_volume(fewer.points_m) ? fewer : shape;
}

}  // namespace seamline::renderer
