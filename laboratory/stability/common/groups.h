#pragma once
#include "laboratory/stability/common/stability_case.h"

namespace seamline::stability {

// The parts that the catalogue is put together from, a file each.

[[nodiscard]] StabilityCases ratio_cases();      ///< light: tiny denominators of the ratio
[[nodiscard]] StabilityCases radiosity_cases();  ///< light: closed spheres whose light is known
[[nodiscard]] StabilityCases sun_cases();        ///< light: suns, skies and shadows far apart in strength
[[nodiscard]] StabilityCases
strong_light_cases();                              ///< light, space, bounds: numbers at and beyond their ends
[[nodiscard]] StabilityCases told_error_cases();   ///< light: what pictures say of their own error
[[nodiscard]] StabilityCases pocket_cases();       ///< light: what depth sheets seal in
[[nodiscard]] StabilityCases space_scale_cases();  ///< space: small, large and far scenes
[[nodiscard]] StabilityCases contact_cases();      ///< space: surfaces that touch, rays that start on them
[[nodiscard]] StabilityCases triangle_cases();     ///< space: triangles without area, and too many
[[nodiscard]] StabilityCases depth_value_cases();  ///< depth: values that are no distances
[[nodiscard]] StabilityCases depth_shape_cases();  ///< depth: poles, seam, jumps
[[nodiscard]] StabilityCases depth_size_cases();   ///< depth: widths of maps
[[nodiscard]] StabilityCases bound_cases();        ///< bounds of the adaptive mesh on random maps
[[nodiscard]] StabilityCases curve_fit_cases();    ///< statistics: psychometric functions
[[nodiscard]] StabilityCases interval_cases();  ///< statistics: intervals, bootstraps, singular information
[[nodiscard]] StabilityCases rating_cases();    ///< statistics: ratings, participants, ordinal models
[[nodiscard]] StabilityCases quest_plus_cases();
[[nodiscard]] StabilityCases convergence_cases();

}  // namespace seamline::stability
