#include "analysis/detection/difference_measure.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace seamline::analysis {

std::string title(DifferenceMeasure measure) {
  if (const std::optional<double> exponent = exponent_of(measure))
    return fmt::format("FLIP pooled with exponent {:g}", *exponent);
  if (measure == DifferenceMeasure::mean_flip) return "mean FLIP";
  if (measure == DifferenceMeasure::largest_flip) return "largest FLIP";
  return "root mean square";
}

std::optional<double> exponent_of(DifferenceMeasure measure) {
  const std::size_t place = static_cast<std::size_t>(measure);
  if (place < compared_exponents.size()) return compared_exponents[place];
  return std::nullopt;
}

MeasuredDifference measure_difference(const Image& flip, double pixels_per_degree, double root_mean_square) {
  std::array<double, compared_exponents.size()> sums = {};
  double sum = 0, largest = 0;
  for (const float value : flip.values) {
    if (!(value > 0)) continue;
    sum += double{value};
    largest = std::max(largest, double{value});
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += std::pow(double{value}, compared_exponents[i]);
  }
  MeasuredDifference measured = {};
  for (std::size_t i = 0; i < sums.size(); ++i)
    measured[i] = std::pow(sums[i] / (pixels_per_degree * pixels_per_degree), 1 / compared_exponents[i]);
  measured[static_cast<std::size_t>(DifferenceMeasure::mean_flip)] = sum / flip.values.size();
  measured[static_cast<std::size_t>(DifferenceMeasure::largest_flip)] = largest;
  measured[static_cast<std::size_t>(DifferenceMeasure::root_mean_square)] = root_mean_square;
  return measured;
}

}  // namespace seamline::analysis
