#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <vector>

#include "laboratory/stability/common/shapes.h"

namespace seamline::stability {

/// Where a scene file's root node puts everything under it.
struct RootNode {
  Eigen::Vector3d translation_m = Eigen::Vector3d::Zero();
  double scale = 1;
};

/// Writes parts as a glTF file: one root node; under it a node for each part and a camera at the node's
/// origin that looks along -Z.
void write_gltf_scene(const std::filesystem::path& path, const std::vector<PartPointer>& parts,
                      const RootNode& root);

}  // namespace seamline::stability
