#pragma once
#include <Eigen/Core>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "raytracer/tracing/mesh.h"
#include "raytracer/tracing/triangle_neighbours.h"

namespace seamline::renderer {

/// One triangle as rays from the centre see it, in one cache line. A register an axis: lanes 0 to 2 are the
/// unit normals of the planes through the centre and the edges 01, 12, 20, inside where the products with a
/// direction are not negative; lane 3 holds the triangles beyond these edges.
class alignas(64) CentreTriangle {
 public:
  std::array<float, 4> x, y, z;
  /// The triangle lies in the plane where the product with this is 1: with a unit direction, it is the
  /// inverse of the distance.
  Eigen::Vector3f plane_per_m;
  float plane_distance_m;  ///< of the plane from the centre

  /// Over edge 0, 1 or 2; or `no_neighbour`.
  [[nodiscard]] std::uint32_t neighbour(int edge) const {
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(edge == 0   ? x[3]
                                                            : edge == 1 ? y[3]
                                                                        : z[3]) &
                               mask;
    return bits == mask ? no_neighbour : bits;
  }
  void set_neighbour(int edge, std::uint32_t triangle) {
    (edge == 0 ? x : edge == 1 ? y : z)[3] = std::bit_cast<float>(one | (triangle & mask));
  }

 private:
  static constexpr std::uint32_t mask = 0x7fffff;   ///< a float's digits
  static constexpr std::uint32_t one = 0x3f800000;  ///< so that what is calculated with it is a plain number
};

/// Finds the triangle of the local scene that a ray from the panorama's centre hits, without a tree: seen
/// from the centre the mesh is a triangulation of the sphere of directions (with holes), so that each
/// direction has at most one triangle.
///
/// A cell of directions (`cube_cells.h`) names the triangle that its centre lies in; from there the search
/// walks over edges to the triangle of the direction, mostly no step or one. It takes 64 bytes a triangle and
/// 4 a cell (1.5 MB).
struct DirectionTable {
  std::vector<std::uint32_t> triangle_of_cell;  ///< or `nothing`: surely no triangle
  std::vector<CentreTriangle> triangles;

  static constexpr std::uint32_t nothing = no_neighbour;
  static constexpr std::uint32_t not_found = 0xfffffffe;  ///< the walk came to a hole, or took too long
  /// Only full meshes have more; the table would cost more memory than it is worth.
  static constexpr std::size_t most_triangles = std::size_t{1} << 21;
};

/// None when the mesh is no such triangulation (a triangle with its back to the centre, or two that overlap).
/// `triangles`: at most `DirectionTable::most_triangles`; `neighbours`: of each (`triangle_neighbours`).
[[nodiscard]] std::optional<DirectionTable> make_direction_table(
    std::span<const Eigen::Vector3f> vertices_m, std::span<const Triangle> triangles,
    std::span<const std::array<std::uint32_t, 3>> neighbours);

/// The triangle that lies in a direction, `nothing`, or `not_found`: another way has to be taken. `guess`: a
/// triangle that the direction may well lie in, such as its neighbour's; or `nothing`.
[[nodiscard]] std::uint32_t find_triangle(const DirectionTable& table, const Eigen::Vector3f& direction,
                                          std::uint32_t guess);

}  // namespace seamline::renderer
