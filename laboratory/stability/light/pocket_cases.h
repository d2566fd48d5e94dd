#pragma once
#include "laboratory/stability/common/small_render.h"
#include "laboratory/stability/common/stability_case.h"

namespace seamline::stability {

/// A well behind bars: sheets of a coarse depth map run from every bar to the wall behind, so that the local
/// scene gets next to no light there; the object hangs before it. Artifacts whose light the depth mesh
/// decides, both isolations. Counts pixels that are not a number, negative, or brighter than 4 times the
/// photograph's brightest.
[[nodiscard]] Finding try_sealed_pocket(int threads, const ComposeRule& rule = compose_as_product);

/// A sheet of depth mesh runs closely before the object's face: the face, asked from the mesh's own surface,
/// must be lit. `from_mesh` false asks from the face itself, as a guess would.
[[nodiscard]] Finding try_face_behind_sheet(bool from_mesh = true);

}  // namespace seamline::stability
