#pragma once
#include <optional>

#include "renderer/depth/sensor/pixel_grid.h"

namespace seamline::renderer {

/// Says whether a triangle may stand for all pixels under it. Its plane n.x = 1, x from the eye, meets the
/// ray through a pixel's point p at t / r = 1 / (n.p), so that |t - r| / r <= e is 1 / (1 + e) <= n.p <= 1 /
/// (1 - e): planes are tested exactly, because along a row of an undistorted picture 1 / z of a plane is
/// linear.
///
/// Tested are all corners of the cells that the triangle covers, at least in part. A lens bends the grid's
/// lines, while the triangle's edges stay straight in space: then all pixels are tested too that lie as near
/// to it as an edge strays.
///
/// Where jumps are cut, no triangle of more than one cell holds over neighbours that jump: a strip one cell
/// wide can lie in a plane that stands between two surfaces.
class PixelBound {
 public:
  PixelBound(const PixelGrid& grid, double tolerance, const std::optional<double>& cut_ratio = {});

  /// Whether the bound holds under the whole triangle, or the triangle and its surroundings are one hole.
  [[nodiscard]] bool holds(const GridTriangle& t) const;
  /// The largest |t - r| / r under a triangle for which it holds; 0 in a hole.
  [[nodiscard]] double largest_error(const GridTriangle& t) const;

 private:
  struct Spread {
    double smallest = 1, largest = 1;
  };
  [[nodiscard]] Spread spread_under(const GridTriangle& t) const;
  [[nodiscard]] bool within(const Spread& spread) const;
  [[nodiscard]] bool is_one_hole(const GridTriangle& t) const;
  [[nodiscard]] int straying_px(const GridTriangle& t) const;
  [[nodiscard]] bool jumps_under(const GridTriangle& t) const;

  const PixelGrid& grid_;
  double smallest_q_, largest_q_;
  std::optional<double> cut_ratio_;
};

}  // namespace seamline::renderer
