#pragma once
#include "support/files/image.h"

namespace seamline::inline stimuli {

// LDR-FLIP, the difference that people see when they flip between two pictures (Andersson, Nilsson,
// Akenine-Möller, Oskarsson, Åström and Fairchild 2020, "FLIP: A Difference Evaluator for Alternating
// Images", HPG 2020). documentation/explanation/image_observer.md has the equations.

/// What FLIP needs to know of one picture: made once for a reference and compared with many.
struct FlipPicture {
  Image lab;       ///< 3 channels: Hunt-adjusted L*a*b* after the contrast sensitivity filters
  Image features;  ///< 2 channels: strength of edges and of points of the unfiltered lightness, 0..sqrt(2)
};

/// `srgb` has 1 or 3 channels of sRGB codes; `pixels_per_degree` of visual angle, above 0.
[[nodiscard]] FlipPicture flip_picture(const ByteImage& srgb, double pixels_per_degree);

/// The same of a linear picture (1: display white) that is not rounded to codes. Thresholds of detection lie
/// under one code.
[[nodiscard]] FlipPicture flip_picture_of_linear(const Image& linear, double pixels_per_degree);

/// FLIP at every pixel, one channel, 0 (no visible difference) to 1. Symmetric. The sizes must agree.
[[nodiscard]] Image flip_difference(const FlipPicture& reference, const FlipPicture& test);
[[nodiscard]] Image flip_difference(const ByteImage& reference, const ByteImage& test,
                                    double pixels_per_degree);

/// Pixels per degree at the middle of a screen (small angles):
/// distance * width_px / width_m * pi / 180.
[[nodiscard]] double screen_pixels_per_degree(double distance_m, int screen_width_px, double screen_width_m);

}  // namespace seamline::inline stimuli
