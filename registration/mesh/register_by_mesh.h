#pragma once
#include <string>

#include "registration/frame/registered_frame.h"
#include "sensors/frame/jumps.h"

namespace seamline::registration {

using sensors::Jumps;

struct MeshRegistration {
  Jumps jumps = Jumps::stretch;  ///< or `cut`, of triangles whose depths differ by more than `jump_ratio`
  double jump_ratio = 1.1;       ///< of the farthest to the nearest depth of a triangle; only of `cut`
  /// Paper 000: how far the outermost depths are extended beyond the depth camera's picture, in its pixels,
  /// so that a colour camera that sees more finds something there; 0: not at all.
  int border_extrusion_px = 0;
  int threads = 0;  ///< 0: one for each core
};

/// Throws InputError naming `where`: a jump ratio that is not above 1, an extrusion outside 0 to 16384.
void require_valid(const MeshRegistration& mesh, const std::string& where);

/// Registration by a mesh (paper 000, section 2.2.2): the depth camera's pixels are the corners of
/// triangles, two for each square of four neighbours, none of which touches a hole; the colour camera looks
/// at them. Every pixel of the colour camera has the depth of the nearest triangle that its centre's ray
/// meets, computed for that ray alone (`ray_grid.h`): without a raster's coordinates, a lens that bends
/// straight edges or a depth buffer's steps. On planes it is exact.
///
/// Of a square with three depths one triangle is left; of a whole one the diagonal joins the corners whose
/// depths are nearer to each other. What lies between two depths of a jump is a sheet or cut; there alone,
/// and where the colour camera sees what the depth camera does not, the result is wrong.
///
/// Extrusion: the outermost depth of each row and column is repeated along its row or column up to
/// `border_extrusion_px` beyond the picture; also from a depth that lies within as many pixels of the edge,
/// because cameras leave bands of holes there. What is extruded is marked, and is seen only where nothing
/// measured is.
///
/// `invented` as in `register_by_points`: a triangle with one invented corner is invented. The same bytes for
/// any number of threads. Throws InputError as both `require_valid`.
[[nodiscard]] RegisteredFrame register_by_mesh(const sensors::DepthFrame& measured,
                                               const Eigen::Isometry3d& colour_from_depth,
                                               const sensors::PinholeCamera& colour,
                                               const MeshRegistration& mesh = {},
                                               std::span<const std::uint8_t> invented = {});

}  // namespace seamline::registration
