#pragma once
#include <span>
#include <string_view>

#include "support/files/image.h"

namespace seamline::analysis {

/// What a test pattern's luminance follows; x to the right, y down, from the middle, in degrees.
enum class PatternKind {
  gabor,         ///< cos(2 pi f y), turned by `angle_deg`, times a Gaussian
  compound,      ///< mean of the cosines of f and of f times `other`, times a Gaussian
  gaussian,      ///< a Gaussian alone
  edge,          ///< -1 above, 1 below, times a Gaussian
  line,          ///< one row of pixels, times a Gaussian
  dipole,        ///< a bright and a dark row with one between them, times a Gaussian
  row_of_five,   ///< five Gabors side by side, 5 standard deviations apart; `other` -1: signs alternate
  noise,         ///< random squares of 2 x 2 pixels, -1 or 1, times a Gaussian
  plaid,         ///< mean of two cosines at right angles, the first turned by `angle_deg`, times a Gaussian
  disk,          ///< 1 within the radius `sigma_x_deg`
  bessel,        ///< J0(2 pi f r), less its mean, times a Gaussian, largest 1
  checkerboard,  ///< squares whose fundamentals have f along both diagonals' halves, times a Gaussian
};

/// A pattern on a uniform field whose detection threshold somebody measured.
struct DetectionPattern {
  int number = 0;  ///< in its source
  std::string_view name;
  PatternKind kind = PatternKind::gabor;
  double frequency_cpd = 0;  ///< cycles per degree
  double sigma_x_deg = 0, sigma_y_deg = 0;
  double angle_deg = 0, other = 0;
  double threshold_db = 0;  ///< -20 log10 of the contrast at the people's mean threshold
  double people_sd_db = 0;  ///< standard deviation between people; 0: the source does not say
  double mean_luminance_cdm2 = 0;
  double pixels_per_degree = 0;
  int side_px = 0;  ///< of the square picture
};

/// One published body of thresholds.
struct DetectionThresholds {
  std::string_view name, source, people;  ///< people: who, and at which share of right answers
  double seen_share = 0;                  ///< share of trials seen at the threshold, after guessing
  std::span<const DetectionPattern> patterns;
};

/// ModelFest, without its photograph: 42 patterns of 256 x 256 pixels at 120 a degree, 30 cd/m2, 16 people.
[[nodiscard]] const DetectionThresholds& modelfest_thresholds();

/// Gabors of three sizes at 2, 20 and 150 cd/m2, 0.125 to 16 cycles per degree: the contrast sensitivity that
/// HDR-VDP-2 was made with.
[[nodiscard]] const DetectionThresholds& hdr_vdp_thresholds();

/// Grey discs of three sizes at 2, 20 and 200 cd/m2: patterns whose difference lies at an edge, as a seam's.
[[nodiscard]] const DetectionThresholds& disc_thresholds();

/// The pattern as contrast, luminance / mean - 1 at contrast 1: one channel, -1 to 1.
[[nodiscard]] Image pattern_contrast(const DetectionPattern& pattern);

/// The pattern at a contrast as a linear grey picture whose mean is half of display white.
[[nodiscard]] Image pattern_picture(const Image& pattern_contrast, double contrast);

}  // namespace seamline::analysis
