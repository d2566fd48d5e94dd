#include "study/visit/display_facts.h"

#include <cmath>
#include <numbers>

namespace seamline::study {

double pixels_per_degree_of(double mm_per_px, double viewing_distance_mm) {
  return 2 * viewing_distance_mm * std::tan(std::numbers::pi / 360) / mm_per_px;
}

}  // namespace seamline::study
