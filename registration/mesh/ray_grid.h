#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "sensors/camera/pinhole_camera.h"

namespace seamline::registration {

/// A corner of a triangle, in the colour camera's frame.
struct Corner {
  Eigen::Vector3d point_m = Eigen::Vector3d::Zero();
  float depth_m = 0;      ///< as it was measured, by which jumps are judged
  bool invented = false;  ///< by a repair
};

using Triangle = std::array<const Corner*, 3>;

/// What a ray met. What is measured comes before what is extruded, then the nearer before the farther, then
/// what is not invented: an order in which the best of any triangles is the same in any order of asking.
struct Hit {
  double planar_m = std::numeric_limits<double>::infinity();
  bool extruded = false;
  bool invented = false;
  bool met = false;

  [[nodiscard]] bool is_better_than(const Hit& other) const;
};

/// The rays of the centres of a camera's pixels, sorted into a grid in the plane z = 1. There triangles have
/// straight edges whatever the lens does to them, so that the box of a triangle is exactly that of its
/// corners, and the rays that may meet it lie next to one another.
class RayGrid {
 public:
  /// The same for any number of threads (0: one for each core).
  explicit RayGrid(const sensors::PinholeCamera& camera, int threads = 0);

  /// Asks every ray that may meet the triangle, and keeps in `hits` (one for each pixel of the camera) what
  /// is better than what was there.
  ///
  /// With e_ij = det(d, v_i, v_j), d the ray's direction (z = 1): the ray or its continuation backwards meets
  /// the triangle where all three have one sign; the e opposite to a corner are then the weights of the
  /// corners in the point it meets, so that
  ///
  ///     z = sum e z_corner / sum e
  ///
  /// which is 1 / (a . d) of the plane a . x = 1 through the corners, and never outside the depths of its
  /// corners. Two triangles compute the e of a shared edge from the same cross product, and one within its
  /// rounding error of 0 counts for both, so that no ray slips between them, nor through a corner.
  void look_at(const Triangle& triangle, bool extruded, std::vector<Hit>& hits) const;

 private:
  struct Ray {
    double x = 0, y = 0;
    std::int64_t pixel = 0;
  };
  struct Box {
    Eigen::Array2d least, most;
  };
  struct Bins {
    int column = 0, last_column = -1, row = 0, last_row = -1;
  };
  [[nodiscard]] static std::vector<Ray> rays_of(const sensors::PinholeCamera& camera, int threads);
  [[nodiscard]] Bins bins_of(const Box& box) const;
  [[nodiscard]] int bin_of(double value, int axis) const;
  [[nodiscard]] static Box box_of(const Triangle& triangle);

  int columns_ = 0, rows_ = 0;
  Eigen::Array2d least_ = Eigen::Array2d::Zero(), most_ = Eigen::Array2d::Zero(),
                 bins_per_unit_ = Eigen::Array2d::Zero();
  std::vector<Ray> rays_;           ///< bin after bin, row by row
  std::vector<std::size_t> first_;  ///< the first ray of each bin; one more at the end
};

}  // namespace seamline::registration
