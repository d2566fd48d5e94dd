#pragma once
#include "laboratory/stability/common/small_render.h"
#include "laboratory/stability/common/stability_case.h"

namespace seamline::stability {

/// A plane under a sun `irradiance` times as strong as the sky's radiance of 1: the light of a sunlit point
/// against the sum of both, or the light of a point behind a wall against the sky's alone.
[[nodiscard]] Finding try_strong_sun(float irradiance_w_m2, bool in_shadow);

/// A sun without a sky: the object's shadow must be black in the reference and in a composite through a
/// coarse depth map, and every pixel a number from 0 to what the photograph can become.
[[nodiscard]] Finding try_black_shadow(int threads, const ComposeRule& rule = compose_as_product);

/// Artifact none under a sun 1e8 times stronger than the sky, in a scene with bounces: the composite must be
/// the reference.
[[nodiscard]] Finding try_strong_sun_composite(int threads);

/// A sun `elevation_deg` above a plane in `cells` x cells squares, the plane itself turned by `turn_deg`:
/// light against albedo E sin(elevation) / pi at many points.
[[nodiscard]] Finding try_grazing_sun(double elevation_deg, double turn_deg, int cells);

}  // namespace seamline::stability
