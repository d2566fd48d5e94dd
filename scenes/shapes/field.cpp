#include "scenes/shapes/field.h"

#include <algorithm>
#include <cmath>

namespace seamline::scenes {

double smooth_min(double a, double b, double blend_m) {
  if (blend_m <= 0) return std::min(a, b);
  const double overlap = std::max(blend_m - std::abs(a - b), 0.0) / blend_m;
  return std::min(a, b) - overlap * overlap * blend_m * 0.25;
}

double LocalField::operator()(const Eigen::Vector3d& point_m) const {
  double distance = 1e3;
  for (const Stroke* stroke : strokes) {
    const double piece = stroke->distance(point_m);
    distance = stroke->carves ? -smooth_min(-distance, piece, stroke->blend_m)
                              : smooth_min(distance, piece, stroke->blend_m);
  }
  return relief && *relief ? distance + (*relief)(point_m) : distance;
}

LocalField near_box(const Sculpture& sculpture, const Eigen::AlignedBox3d& box, double margin_m) {
  LocalField local{.strokes = {}, .relief = &sculpture.relief};
  for (const Stroke& stroke : sculpture.strokes) {
    const double reach = stroke.blend_m + sculpture.relief_m + margin_m;
    if (box.squaredExteriorDistance(stroke.bounds) <= reach * reach) local.strokes.push_back(&stroke);
  }
  return local;
}

}  // namespace seamline::scenes
