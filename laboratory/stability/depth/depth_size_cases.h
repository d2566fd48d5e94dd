#pragma once
#include <filesystem>
#include <functional>

#include "laboratory/stability/common/stability_case.h"
#include "laboratory/stability/depth/depth_maps.h"

namespace seamline::stability {

/// How a file becomes a depth map; the product's is `read_depth_map`.
using ReadRule = std::function<DepthMap(const std::filesystem::path& path)>;

/// Files of sizes that are no panorama, and one of three channels: how many are not refused by a sentence.
[[nodiscard]] Finding try_wrong_sizes(bool odd, const ReadRule& read = read_depth_map);

/// A sphere of 2 m in maps of these widths, both densities up to 4096: largest error of random rays.
[[nodiscard]] Finding try_widths(const std::vector<int>& widths_px, int threads);

/// A room in a map of 16384 x 8192, adaptive mesh: largest error of random rays.
[[nodiscard]] Finding try_largest_width(int threads);

/// Texels of 2 and 4 m by turns, which no mesh can be coarse on: largest distance of random rays from 3 m,
/// relative; NaN where a mesh has too many triangles.
[[nodiscard]] Finding try_alternating(int threads);

}  // namespace seamline::stability
