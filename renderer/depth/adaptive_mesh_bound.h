#pragma once
#include <Eigen/Core>
#include <array>

#include "renderer/depth/dense_sphere.h"

namespace seamline::renderer {

/// Says whether a triangle may stand for all dense vertices under it.
///
/// The triangle's plane n.x = 1 meets the ray of direction d at t = 1 / (n.d), so that with q = r (n.d) the
/// bound |t - r| / r <= e is 1 / (1 + e) <= q <= 1 / (1 - e). The plane goes through the vertices as they are
/// rounded in the mesh.
///
/// The triangle's edges are straight and the grid's rows and diagonals are not, so a ray that seems to belong
/// to one triangle may hit its neighbour. Therefore every vertex is tested that the triangle can be hit by,
/// and beyond that all corners of the cells that it covers in part: at a depth jump, cells stay whole. Near
/// the poles and for large triangles this is decided by the great circles of the edges; elsewhere those stray
/// by less than half a cell, and the grid decides.
class TriangleBound {
 public:
  TriangleBound(const DenseSphere& sphere, double tolerance);

  /// Whether the bound holds under the whole triangle, or the triangle and its surroundings are one hole.
  [[nodiscard]] bool holds(const GridTriangle& t) const;

  /// The largest |t - r| / r under a triangle for which it holds; 0 in a hole.
  [[nodiscard]] double largest_error(const GridTriangle& t) const;

 private:
  struct Spread;  ///< smallest and largest q
  struct Plane;
  struct Outline;

  [[nodiscard]] Eigen::Vector3d corner_m(const GridVertex& v) const;
  [[nodiscard]] Spread spread_under(const GridTriangle& t) const;
  [[nodiscard]] bool within(const Spread& spread) const;
  [[nodiscard]] bool is_one_hole(const GridTriangle& t) const;
  void scan(const Plane& plane, int row, int first, int last, Spread& spread) const;
  void scan_inside(const Plane& plane, const Outline& outline, int row, Spread& spread) const;
  void scan_pole(const GridTriangle& t, int row, double pole_y_m, Spread& spread) const;

  const DenseSphere& sphere_;
  double smallest_q_, largest_q_;
};

}  // namespace seamline::renderer
