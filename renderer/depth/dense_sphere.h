#pragma once
#include <Eigen/Core>
#include <limits>
#include <span>
#include <vector>

#include "renderer/depth/depth_map.h"
#include "renderer/depth/lattice/grid_vertex.h"

namespace seamline::renderer {

[[nodiscard]] inline bool is_hole(float distance_m) {
  return !(distance_m < std::numeric_limits<float>::infinity());
}

/// The high-density spherical mesh of the paper's section 3.2, before it has triangles: which directions its
/// vertices have and how far each is pushed out. Independent of the map's width below 2048, so that widths
/// differ by their samples and not by their mesh. Column W is column 0 again. It may look into the map it was
/// made from, which must outlive it.
struct DenseSphere {
  int width = 0;                                     ///< vertices around: the map's width, at least 2048
  int height = 0;                                    ///< rows, without the poles: width / 2
  std::vector<double> sin_azimuth, cos_azimuth;      ///< of each column, with the map's yaw
  std::vector<double> sin_elevation, cos_elevation;  ///< of each row, the zenith's first
  std::vector<float> resampled_m;                    ///< empty when the map has this very width
  std::span<const float> distance_m;                 ///< height x width; +infinity is a hole
  float zenith_m = 0;  ///< the pole's distance: mean of the valid vertices of row 0,
  float nadir_m = 0;   ///< and of the last row; a hole when there is none

  DenseSphere() = default;
  DenseSphere(const DenseSphere&) = delete;
  DenseSphere& operator=(const DenseSphere&) = delete;
  DenseSphere(DenseSphere&&) = default;
  DenseSphere& operator=(DenseSphere&&) = default;
  ~DenseSphere() = default;

  [[nodiscard]] float at(int row, int column) const {
    return distance_m[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(column)];
  }
  [[nodiscard]] Eigen::Vector3d direction(int row, int column) const {
    const auto r = static_cast<std::size_t>(row), c = static_cast<std::size_t>(column);
    return {sin_azimuth[c] * cos_elevation[r], sin_elevation[r], -cos_azimuth[c] * cos_elevation[r]};
  }
  [[nodiscard]] bool valid(const GridVertex& vertex) const {
    if (vertex.row < 0) return !is_hole(zenith_m);
    if (vertex.row == height) return !is_hole(nadir_m);
    return !is_hole(at(vertex.row, vertex.column));
  }
  /// Where the vertex (no pole, no hole) lies, rounded as the mesh stores it.
  [[nodiscard]] Eigen::Vector3f position_m(int row, int column) const {
    return (direction(row, column) * static_cast<double>(at(row, column))).cast<float>();
  }
};

/// Samples the map in the directions of the dense sphere's vertices, which lie at the texel centres of a
/// panorama of its size: bilinear in (column, row), wrapping around, rows clamped at the poles, weights
/// renormalised over valid texels. A vertex is a hole when the texel it lies in is one. The map's holes must
/// be +infinity already (`clean_holes`). `yaw_texels` as in MeshOptions.
/// `smallest_width` (even) is another number only in tests.
[[nodiscard]] DenseSphere make_dense_sphere(const DepthMap& map, double yaw_texels, int threads,
                                            int smallest_width = 2048);

}  // namespace seamline::renderer
