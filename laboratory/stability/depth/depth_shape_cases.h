#pragma once
#include "laboratory/stability/common/stability_case.h"
#include "laboratory/stability/depth/depth_maps.h"

namespace seamline::stability {

/// A sphere of constant distance: largest relative error of the distances that rays find.
[[nodiscard]] Finding try_constant_sphere(double distance_m, const MeshOptions& options,
                                          const MeshRule& rule = build_depth_mesh);

/// Blocks of 1 m and of 1e6 m side by side: the adaptive mesh's largest error over all rays of the dense
/// sphere; NaN when a ray is lost.
[[nodiscard]] Finding try_jumps();

/// Rays at and around a pole of a room: largest relative error of the ceiling's (floor's) distance; NaN when
/// one meets nothing.
[[nodiscard]] Finding try_pole(bool zenith);

/// The room's panorama turned by every number of texels: the full mesh must be the same one, turned. Largest
/// relative difference of its vertices; NaN when its triangles differ.
[[nodiscard]] Finding try_seam_full();
/// The same of the adaptive mesh: its largest error against the panorama that was not turned; NaN when a ray
/// is lost.
[[nodiscard]] Finding try_seam_adaptive(double tolerance);

/// Jumps from 1 to 10 m and a hole: rays from the centre by the table of directions against Embree's search.
/// Counts rays that disagree.
[[nodiscard]] Finding try_direction_table();

}  // namespace seamline::stability
