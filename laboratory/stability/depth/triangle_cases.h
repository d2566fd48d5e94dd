#pragma once
#include "laboratory/stability/common/stability_case.h"

namespace seamline::stability {

/// A scene's picture must not change when triangles are added that have no area: three equal corners, three
/// corners in a line. Counts pixels that do.
[[nodiscard]] Finding try_zero_area(int threads);
/// The same for 2,000 needles, 10 m long and `width_m` wide, before everything. The error is the difference
/// over the picture's noise; a pixel that is not a number fails.
[[nodiscard]] Finding try_needles(float width_m, int threads);
/// Shading normals that are zero or no numbers: the picture must be that with geometric normals.
[[nodiscard]] Finding try_broken_normals(int threads);
/// So many triangles in one place: rays must hit them where they are. Throws what the product throws.
[[nodiscard]] Finding try_coincident(int triangles);

}  // namespace seamline::stability
