#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "physics/rigid_world.h"

namespace seamline::renderer {

/// Across an edge of a triangle: the neighbour, and the neighbour's third corner. An edge that has no other
/// triangle, or several, has none.
struct GroundNeighbour {
  int triangle = -1;
  std::uint32_t third = 0;
};

/// A ground and who is whose neighbour there; side i of a triangle goes from its corner i to its corner i
/// + 1. Corners in one place are one, whatever their numbers.
struct JoinedGround {
  Ground ground;
  std::vector<std::array<GroundNeighbour, 3>> neighbours = {};
};

[[nodiscard]] JoinedGround joined_ground(Ground ground);

/// The normal of a triangle, unit, on the side to which `push` points; zero for a triangle that is a line.
[[nodiscard]] Eigen::Vector3d ground_normal(const Ground& ground, std::size_t triangle,
                                            const Eigen::Vector3d& push);

/// The direction in which a triangle pushes at a point, unit, where it alone would push along `push`. Bodies
/// that ask each triangle alone catch on the edges inside a flat floor: a triangle that goes on beyond its
/// nearest edge, nearly in its plane (14 degrees), pushes along its normal. Elsewhere `push` stays.
[[nodiscard]] Eigen::Vector3d push_of(const JoinedGround& joined, std::size_t triangle,
                                      const Eigen::Vector3d& at_m, const Eigen::Vector3d& push);

}  // namespace seamline::renderer
