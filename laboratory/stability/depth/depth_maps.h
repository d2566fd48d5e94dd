#pragma once
#include <functional>

#include "laboratory/stability/common/namespaces.h"
#include "renderer/depth/dense_sphere.h"
#include "renderer/depth/depth_mesh.h"
#include "support/arithmetic/random.h"

namespace seamline::stability {

/// How a depth map becomes a mesh; the product's is `build_depth_mesh`.
using MeshRule = std::function<DepthMesh(const DepthMap& map, const MeshOptions& options)>;

/// A map whose texels are given by column and row, as they are: nothing is cleaned.
[[nodiscard]] DepthMap make_depth_map(int width_px,
                                      const std::function<double(int column, int row)>& distance_m);
/// The same distance everywhere.
[[nodiscard]] DepthMap constant_map(int width_px, double distance_m);
/// A room of 5 x 3 x 6 m seen from off its middle, and how far its walls are in a direction.
[[nodiscard]] DepthMap room_map(int width_px);
[[nodiscard]] double room_distance_m(const Eigen::Vector3d& direction);
/// Texel column c of the result is column c + texels of the map.
[[nodiscard]] DepthMap turned_map(const DepthMap& map, int texels);

/// What a random map may hold.
struct RandomMapKind {
  bool holes = true;  ///< single ones, patches, half of the map
  bool jumps = true;  ///< boxes at any distance from 1e-3 to 1e6 m
};
/// Smooth walls with bumps, boxes and holes, all by chance.
[[nodiscard]] DepthMap random_depth_map(int width_px, const RandomMapKind& kind, Random& random);

}  // namespace seamline::stability
