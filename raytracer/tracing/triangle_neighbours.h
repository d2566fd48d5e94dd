#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "raytracer/tracing/mesh.h"

namespace seamline::renderer {

inline constexpr std::uint32_t no_neighbour = 0xffffffff;

/// The triangles beyond the edges 01, 12 and 20 of each triangle: those that have the same edge the other way
/// round; or `no_neighbour`.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> triangle_neighbours(
    std::size_t vertex_count, std::span<const Triangle> triangles);

}  // namespace seamline::renderer
