#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "renderer/scene_file.h"

namespace seamline {

/// One triangle as rays from the centre see it: one cache line, and one register an axis. Lanes 0 to 2 are
/// the unit normals of the planes through the centre and the edges 01, 12, 20, inside where the products with
/// a direction are not negative; lane 3 is m of the triangle's plane m.x = 1, whose product with a direction
/// is the inverse of the distance.
struct alignas(64) CentreTriangle {
  std::array<float, 4> x, y, z;
  std::array<std::uint32_t, 3> neighbours;  ///< over the edges 01, 12, 20, or `DirectionTable::nothing`
  float inverse_length_m;                   ///< of m; the surface's normal towards the centre is -m / |m|
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

  static constexpr std::uint32_t nothing = 0xffffffff;
  static constexpr std::uint32_t not_found = 0xfffffffe;  ///< the walk came to a hole, or took too long
};

/// None when the mesh is no such triangulation (a triangle with its back to the centre, or two that overlap),
/// or so large that the table would cost more memory than it is worth.
[[nodiscard]] std::optional<DirectionTable> make_direction_table(std::span<const Eigen::Vector3f> vertices_m,
                                                                 std::span<const Triangle> triangles);

/// What lies in a direction.
struct CentreHit {
  std::uint32_t triangle = DirectionTable::nothing;  ///< or `not_found`: another way has to be taken
  float inverse_distance_m = 0;
};

/// `guess`: a triangle that the direction may well lie in, such as its neighbour's; or `nothing`.
[[nodiscard]] CentreHit find_triangle(const DirectionTable& table, const Eigen::Vector3f& direction,
                                      std::uint32_t guess);

}  // namespace seamline
