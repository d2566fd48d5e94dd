#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

namespace seamline::scenes {

/// Sixteen control points of a bicubic Bezier patch, rows along v, in Newell's units with z up.
using BezierPatch = std::array<Eigen::Vector3d, 16>;

/// Martin Newell's 32 patches (1975): rim, body, lid and bottom four times around, handle and spout on both
/// sides.
[[nodiscard]] std::vector<BezierPatch> newell_teapot();

}  // namespace seamline::scenes
