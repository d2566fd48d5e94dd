#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

namespace seamline::scenes {

/// Triangles over shared vertices. Metres, +Y up; triangles are counter-clockwise seen from outside.
struct TriangleMesh {
  std::vector<Eigen::Vector3d> positions_m;
  std::vector<Eigen::Vector3d> normals;                 ///< unit length, one a vertex
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices into the two arrays above
};

/// Adds copies of `part`'s vertices and triangles to `whole`.
void append(TriangleMesh& whole, const TriangleMesh& part);

/// The mesh after `transform`, which may mirror: the winding follows, so outside stays outside.
[[nodiscard]] TriangleMesh transformed(const TriangleMesh& mesh, const Eigen::Affine3d& transform);

/// The axis-aligned box around all vertices; empty for an empty mesh.
[[nodiscard]] Eigen::AlignedBox3d bounds(const TriangleMesh& mesh);

/// The signed volume enclosed (m3): positive when a closed mesh is wound outwards.
[[nodiscard]] double enclosed_volume_m3(const TriangleMesh& mesh);

/// The edge-connected piece with most triangles; unused vertices are dropped, the order of the rest is kept.
[[nodiscard]] TriangleMesh largest_piece(const TriangleMesh& mesh);

/// Moved so that its lowest vertex is at y = 0 and its box is centred on x = z = 0.
[[nodiscard]] TriangleMesh stood_on_ground(const TriangleMesh& mesh);

}  // namespace seamline::scenes
