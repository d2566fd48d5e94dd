#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "raytracer/tracing/mesh.h"

namespace seamline::renderer {

/// The triangles 013 and 231: two that share the edge 13, or one, whose last corner is written twice.
using Quad = std::array<std::uint32_t, 4>;

/// The same triangles with the same winding, two by two where they share an edge, long edges first: the two
/// then lie close together. A search tree of such pairs has half the leaves, and takes a third less memory
/// than one of triangles, or is faster in as much (`seamline lab bench --only local`).
///
/// `neighbours`: of each triangle (`triangle_neighbours`).
[[nodiscard]] std::vector<Quad> pair_into_quads(std::span<const Eigen::Vector3f> vertices_m,
                                                std::span<const Triangle> triangles,
                                                std::span<const std::array<std::uint32_t, 3>> neighbours);

}  // namespace seamline::renderer
