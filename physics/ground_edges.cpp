#include "physics/ground_edges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace seamline::renderer {
namespace {

constexpr double flat_cosine = 0.97;  ///< of 14 degrees

/// For each vertex the first one in its place.
std::vector<std::uint32_t> first_in_place(const std::vector<Eigen::Vector3d>& vertices_m) {
  std::vector<std::uint32_t> order(vertices_m.size()), first(vertices_m.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::uint32_t i) {
    return std::array{vertices_m[i].x(), vertices_m[i].y(), vertices_m[i].z()};
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  for (std::size_t i = 0; i < order.size(); ++i)
    first[order[i]] =
        i > 0 && vertices_m[order[i]] == vertices_m[order[i - 1]] ? first[order[i - 1]] : order[i];
  return first;
}

}  // namespace

JoinedGround joined_ground(Ground ground) {
  struct Side {
    std::uint64_t edge;
    int triangle, side;
  };
  const std::vector<std::uint32_t> first = first_in_place(ground.vertices_m);
  std::vector<Side> sides;
  sides.reserve(3 * ground.triangles.size());
  for (std::size_t t = 0; t < ground.triangles.size(); ++t)
    for (int side = 0; side < 3; ++side) {
      const std::uint64_t a = first[ground.triangles[t][static_cast<std::size_t>(side)]],
                          b = first[ground.triangles[t][static_cast<std::size_t>((side + 1) % 3)]];
      sides.push_back({std::min(a, b) << 32U | std::max(a, b), static_cast<int>(t), side});
    }
  std::stable_sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.edge < b.edge; });
  JoinedGround joined{std::move(ground)};
  joined.neighbours.resize(joined.ground.triangles.size());
  const auto meet = [&](const Side& here, const Side& there) {
    joined.neighbours[static_cast<std::size_t>(here.triangle)][static_cast<std::size_t>(here.side)] = {
        there.triangle, joined.ground.triangles[static_cast<std::size_t>(there.triangle)]
                                               [static_cast<std::size_t>((there.side + 2) % 3)]};
  };
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    while (end < sides.size() && sides[end].edge == sides[i].edge) ++end;
    if (end != i + 2) continue;
    meet(sides[i], sides[i + 1]);
    meet(sides[i + 1], sides[i]);
  }
  return joined;
}

Eigen::Vector3d ground_normal(const Ground& ground, std::size_t triangle, const Eigen::Vector3d& push) {
  const auto& corners = ground.triangles[triangle];
  const Eigen::Vector3d& a = ground.vertices_m[corners[0]];
  const Eigen::Vector3d normal =
      (ground.vertices_m[corners[1]] - a).cross(ground.vertices_m[corners[2]] - a).normalized();
  if (!normal.allFinite()) return Eigen::Vector3d::Zero();
  return normal.dot(push) < 0 ? Eigen::Vector3d(-normal) : normal;
}

Eigen::Vector3d push_of(const JoinedGround& joined, std::size_t triangle, const Eigen::Vector3d& at_m,
                        const Eigen::Vector3d& push) {
  const Eigen::Vector3d normal = ground_normal(joined.ground, triangle, push);
  if (normal.isZero() || normal.dot(push) > 1 - 1e-9) return push;
  const auto& corners = joined.ground.triangles[triangle];
  const auto place_m = [&](std::size_t i) -> const Eigen::Vector3d& {
    return joined.ground.vertices_m[corners[i % 3]];
  };
  std::size_t nearest = 0;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d along = (place_m(i + 1) - place_m(i)).normalized();
    const double distance_m = (at_m - place_m(i)).cross(along).norm();
    if (distance_m < nearest_m) nearest = i, nearest_m = distance_m;
  }
  const GroundNeighbour& neighbour = joined.neighbours[triangle][nearest];
  if (neighbour.triangle < 0) return push;
  const Eigen::Vector3d& third_m = joined.ground.vertices_m[neighbour.third];
  const Eigen::Vector3d other =
      (place_m(nearest + 1) - place_m(nearest)).cross(third_m - place_m(nearest)).normalized();
  return std::abs(normal.dot(other)) > flat_cosine ? normal : push;
}

}  // namespace seamline::renderer
