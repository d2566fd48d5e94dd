#pragma once
#include <array>
#include <optional>
#include <string>

#include "stimuli/pictures/flip.h"

namespace seamline::analysis {

/// Exponents of pooling that are compared; 3 is the one that predictions use (`pooling_exponent`).
inline constexpr std::array<double, 6> compared_exponents = {1, 2, 3, 4, 6, 8};

/// One number for the difference of two pictures: FLIP pooled with an exponent, in square degrees, or one of
/// the simple ones.
enum class DifferenceMeasure {
  pooled_1,
  pooled_2,
  pooled_3,
  pooled_4,
  pooled_6,
  pooled_8,
  mean_flip,
  largest_flip,
  root_mean_square  ///< of what the display shows, 0 to 1, sRGB codes by 255
};
inline constexpr std::size_t difference_measure_count = 9;
using MeasuredDifference = std::array<double, difference_measure_count>;

/// "FLIP pooled with exponent 3", "mean FLIP", ...
[[nodiscard]] std::string title(DifferenceMeasure measure);

/// The exponent of a pooled measure; none for the others.
[[nodiscard]] std::optional<double> exponent_of(DifferenceMeasure measure);

[[nodiscard]] inline DifferenceMeasure difference_measure(std::size_t place) {
  return static_cast<DifferenceMeasure>(place);
}

[[nodiscard]] inline double value_of(const MeasuredDifference& measured, DifferenceMeasure measure) {
  return measured[static_cast<std::size_t>(measure)];
}

/// All measures of a pair of which the root mean square difference is known.
[[nodiscard]] MeasuredDifference measure_difference(const Image& flip, double pixels_per_degree,
                                                    double root_mean_square);

}  // namespace seamline::analysis
