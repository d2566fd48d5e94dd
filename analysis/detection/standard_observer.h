#pragma once
#include "support/files/image.h"

namespace seamline::analysis {

/// Contrast sensitivity along x or y at a frequency in cycles per degree, as the standard observer of Watson
/// and Ahumada has it ("A standard model for foveal detection of spatial contrast", Journal of Vision 5(9),
/// 2005, doi:10.1167/5.9.6):
///
///     S(f) = 373.08 (sech((f / 4.1726)^0.7786) - 0.8493 sech(f / 1.3625))
[[nodiscard]] double standard_contrast_sensitivity(double frequency_cpd);

/// -20 log10 of the contrast at which the standard observer sees a pattern that is given at contrast 1
/// (luminance / mean - 1, one channel, square, its side a power of two). The pattern is filtered by S and by
/// the oblique effect, 1 - (1 - exp(-(f - 3.4815) / 13.5715)) sin^2(2 theta) above 3.4815 cycles per degree,
/// multiplied by a Gaussian of 0.6273 degrees, and pooled with the exponent 2.4081 over square degrees. It
/// was fitted to ModelFest by its authors and has no free number here.
[[nodiscard]] double standard_observer_threshold_db(const Image& pattern_contrast, double pixels_per_degree);

}  // namespace seamline::analysis
