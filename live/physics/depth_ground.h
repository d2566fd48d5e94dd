#pragma once
#include <vector>

#include "live/frame/local_mesh.h"
#include "physics/rigid_world.h"

namespace seamline::live {

/// What virtual things fall on: a frame's local scene (paper 000, section 4.1), in the world, in double
/// precision. Its corners are those of `LocalMesh`, with less noise: 1 / depth is the mean of the corner's
/// own pixel and of pairs of pixels that lie opposite to each other about it, in 5 x 5, and differ from it by
/// less than a tenth (on a flat surface that mean is the surface). A pixel that no pair agrees with is a
/// hole.
///
/// Two more things differ, so that the triangles stay the same from frame to frame and only their corners
/// move:
/// - holes are bridged, 1 / depth being linear along a row between the corners that were measured (on a flat
///   surface that is the surface); beyond the last one its depth goes on; a row without any is bridged from
///   the rows above and below;
/// - the diagonal of a square always joins its upper left and lower right corner.
/// Where depth jumps there is a sheet, or with `cut_ratio` nothing, and then triangles come and go.
class DepthGround {
 public:
  DepthGround(const DepthPoints& points, const LocalMeshOptions& options);

  enum class Change {
    none,      ///< every corner is where it was, or the frame has no depth at all and the last ground stays
    moved,     ///< the triangles are those of before
    triangles  ///< other triangles
  };
  Change take(const DepthPoints& points, const std::vector<float>& depth_m,
              const Eigen::Isometry3d& world_from_colour);
  [[nodiscard]] const renderer::Ground& ground() const { return ground_; }

 private:
  [[nodiscard]] bool read_corners(const DepthPoints& points, const std::vector<float>& depth_m);
  [[nodiscard]] std::vector<std::array<std::uint32_t, 3>> joined() const;

  std::optional<float> cut_ratio_;
  CornerGrid grid_;
  std::vector<std::uint8_t> has_ray_;  ///< of the corners
  std::vector<float> depth_m_;         ///< likewise, bridged
  renderer::Ground ground_;
};

/// The depth of a pixel by the mean of 1 / depth over 5 x 5 pixels, as `DepthGround` has it; infinite: a
/// hole. Pixels beside the picture are none.
[[nodiscard]] float quiet_depth_m(const std::vector<float>& depth_m, int width_px, int x, int y);

/// Bridges the holes (infinite) of a grid of depths with `width` columns, row by row; false where all are
/// holes.
[[nodiscard]] bool bridge_holes(std::size_t width, std::vector<float>& depth_m);

/// Whether a ground has a surface straight below a place.
[[nodiscard]] bool has_surface_below(const renderer::Ground& ground, const Eigen::Vector3d& place_m);

}  // namespace seamline::live
