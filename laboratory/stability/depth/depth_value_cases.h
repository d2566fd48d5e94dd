#pragma once
#include "laboratory/stability/common/namespaces.h"
#include "laboratory/stability/common/stability_case.h"
#include "laboratory/stability/depth/depth_maps.h"
#include "renderer/depth/depth_mesh.h"

namespace seamline::stability {

/// A sphere of 2 m with 4 x 4 texels of another value, through an EXR file and both densities. Counts
/// vertices that are not at 2 m, rays into the patch that hit something, and texels that were not counted as
/// cleaned
/// (`counted` says whether they are to be).
[[nodiscard]] Finding try_bad_texels(float value, bool counted, const MeshRule& rule = build_depth_mesh);

/// Nothing but sky: the mesh is empty, rays meet nothing, and a picture of an object before that sky is the
/// reference. Counts what is otherwise.
[[nodiscard]] Finding try_all_sky(int threads);

/// One texel of 64 x 32 is measured: the mesh is at its distance, inside it, and rays elsewhere meet nothing.
/// Counts what is otherwise.
[[nodiscard]] Finding try_one_texel(const MeshRule& rule = build_depth_mesh);

}  // namespace seamline::stability
