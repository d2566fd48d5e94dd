#pragma once
#include <functional>
#include <utility>
#include <vector>

#include "scenes/shapes/mesh.h"

namespace seamline::scenes {

/// A cross-section of a hull, at right angles to x and centred on z = 0: a rectangle with round corners.
struct HullSection {
  double x_m = 0;
  double half_width_m = 0;
  double low_m = 0, high_m = 0;
};

/// Sections on the Catmull-Rom curve through `keys`, `steps` a span, ends included.
[[nodiscard]] std::vector<HullSection> smooth_sections(const std::vector<HullSection>& keys, int steps);

/// The closed surface through sections of growing x. Smooth along and around; its ends are flat.
[[nodiscard]] TriangleMesh hull(const std::vector<HullSection>& sections);

/// The same in two: the patches between sections that a predicate wants, and all else. It is asked with the x
/// of a patch's middle and how far around it lies: 0 to the side of z, growing upwards to pi / 2 at the top,
/// below 0 in the lower half; the same on both sides.
[[nodiscard]] std::pair<TriangleMesh, TriangleMesh> parted_hull(
    const std::vector<HullSection>& sections,
    const std::function<bool(double x_m, double around_rad)>& wanted);

}  // namespace seamline::scenes
