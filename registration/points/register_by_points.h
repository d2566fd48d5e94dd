#pragma once
#include "registration/frame/registered_frame.h"

namespace seamline::registration {

/// Registration point by point (paper 001, Eqs. 2 to 4; 002, section 4): every measured pixel becomes a point
/// of the depth camera's frame, in the frame's own convention and with skew and lens, which 001's Eq. 2
/// leaves out; the rigid transformation brings it into the colour camera's frame; the camera projects it.
///
///     x_D = d m (planar) or d m / |m| (radial), with m the pixel's direction, z = 1
///     x_C = R x_D + t          u = project(x_C)          depth = z of x_C
///
/// Of several points that land in one pixel the nearest wins. Pixels that no point lands in stay holes, so a
/// colour camera of more pixels than the depth camera gets a sieve, and its holes let the background through:
/// 002 fills it by nearest neighbours (`sensors::fill_with_nearest`), 000 takes the mesh instead.
///
/// A pixel's depth is that of a point which projects into it, not of the ray of its centre: on a surface of
/// slope dz/du, dz/dv (metres a pixel) it is wrong by at most half of |dz/du| + |dz/dv|.
///
/// `invented` is the mask of what a repair had invented (empty: nothing); the result says which pixels it
/// decided. Amplitudes and confidences are not carried over. The same bytes for any number of threads (0: one
/// for each core). Throws InputError as `require_valid`.
[[nodiscard]] RegisteredFrame register_by_points(const sensors::DepthFrame& measured,
                                                 const Eigen::Isometry3d& colour_from_depth,
                                                 const sensors::PinholeCamera& colour,
                                                 std::span<const std::uint8_t> invented = {},
                                                 int threads = 0);

}  // namespace seamline::registration
