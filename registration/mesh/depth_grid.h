#pragma once
#include <functional>
#include <optional>

#include "registration/mesh/ray_grid.h"
#include "registration/mesh/register_by_mesh.h"

namespace seamline::registration {

/// The pixels of a depth frame as corners of triangles in the colour camera's frame, with those that extrude
/// its border.
class DepthGrid {
 public:
  /// `mesh` says which triangles there are; the frame is only read here.
  DepthGrid(const sensors::DepthFrame& measured, const Eigen::Isometry3d& colour_from_depth,
            const MeshRegistration& mesh, std::span<const std::uint8_t> invented);

  /// Rows of squares between the pixels' centres.
  [[nodiscard]] int rows_of_squares() const { return height_px_ - 1; }

  /// Every triangle of a row of squares.
  void each_measured(int row, const std::function<void(const Triangle&)>& take) const;

  /// Every triangle of the extruded border.
  void each_extruded(const std::function<void(const Triangle&)>& take) const;

 private:
  struct Edge;  ///< from the outermost depth of a row or column to its extrusion
  using Square = std::array<const Corner*, 4>;  ///< round the square; null: nothing there

  [[nodiscard]] const Corner* at(int column, int row) const;
  [[nodiscard]] bool is_cut(const Triangle& triangle) const;
  void each_of_square(const Square& square, const std::function<void(const Triangle&)>& take) const;
  void extrude(const sensors::DepthFrame& measured, const Eigen::Isometry3d& colour_from_depth, int reach_px);

  int width_px_ = 0, height_px_ = 0;
  std::optional<double> largest_ratio_;  ///< of cut triangles
  std::vector<Corner> corners_;
  std::vector<Corner> outer_;     ///< corners beyond the picture
  std::vector<Square> extruded_;  ///< between the picture and those
};

}  // namespace seamline::registration
