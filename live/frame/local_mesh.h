#pragma once
#include <optional>
#include <vector>

#include "live/frame/depth_points.h"
#include "raytracer/tracing/mesh.h"

namespace seamline::live {

/// How the local scene is made of a frame's depth pixels (paper 000, section 2.2.2).
struct LocalMeshOptions {
  int most_triangles = 25'000;  ///< of every so many pixels one is a corner; 0: of all pixels
  /// Triangles whose depths differ by more than this ratio are left out; none: sheets, as the paper has them.
  std::optional<float> cut_ratio = {};
};

/// The pixels of a depth camera that are corners of its local scene.
struct CornerGrid {
  std::vector<int> columns, rows;

  /// The pixel of a corner, row by row from the top.
  [[nodiscard]] std::size_t pixel(std::size_t column, std::size_t row, int width_px) const {
    return static_cast<std::size_t>(rows[row]) * static_cast<std::size_t>(width_px) +
           static_cast<std::size_t>(columns[column]);
  }
};

/// As close to each other as so many triangles allow (`LocalMeshOptions::most_triangles`).
[[nodiscard]] CornerGrid corner_grid(const DepthPoints& points, int most_triangles);

/// The local scene of one frame, rebuilt in place for each: a grid over the depth camera's pixels, two
/// triangles for each square of four neighbours, one where three have a depth. The diagonal joins the corners
/// whose depths are nearer to each other, as in `registration/mesh`.
class LocalMesh {
 public:
  LocalMesh(const DepthPoints& points, const LocalMeshOptions& options);

  /// In the world: `world_from_colour` with its origin taken off in double precision.
  void build(const DepthPoints& points, const std::vector<float>& depth_m,
             const Eigen::Isometry3d& world_from_colour, int threads);

  [[nodiscard]] const renderer::DepthMesh& mesh() const { return mesh_; }
  [[nodiscard]] renderer::TriangleSpan span() const { return {mesh_.vertices_m, mesh_.triangles}; }
  [[nodiscard]] int columns() const { return static_cast<int>(grid_.columns.size()); }
  [[nodiscard]] int rows() const { return static_cast<int>(grid_.rows.size()); }

 private:
  void add_square(std::uint32_t upper_left);
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);

  std::optional<float> cut_ratio_;
  CornerGrid grid_;
  std::vector<float> depth_m_;  ///< of the corners; a hole is infinite
  renderer::DepthMesh mesh_;
};

}  // namespace seamline::live
