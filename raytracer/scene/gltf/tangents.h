#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "raytracer/tracing/mesh.h"

namespace seamline::renderer {

/// Where a texture's right lies on a surface, at each vertex: a unit vector across the normal, and as fourth
/// number 1, or -1 where the picture is seen mirrored. The mean over the triangles around a vertex, weighed
/// by their angles there; as glTF's TANGENT. `uvs` are the coordinates with the texture's own transform.
/// Where they say nothing (a triangle whose coordinates are on one line), any direction across the normal.
[[nodiscard]] std::vector<Eigen::Vector4f> make_tangents(std::span<const Eigen::Vector3d> positions_m,
                                                         std::span<const Eigen::Vector3f> normals,
                                                         std::span<const Triangle> triangles,
                                                         std::span<const Eigen::Vector2f> uvs);

}  // namespace seamline::renderer
