// Strokes along curves: limbs, blades, spikes and crests.
#include "scenes/objects/clay.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace seamline::scenes {
namespace {

using Box = Eigen::AlignedBox3d;
using Vector3d = Eigen::Vector3d;

/// A round cone's two balls and what its distance needs of them.
struct RoundCone {
  Vector3d from = Vector3d::Zero();
  Vector3d along = Vector3d::Zero();
  double radius = 0;
  double radius_step = 0;
  double inverse_length2 = 0;
};

RoundCone round_cone(const Knot& a, const Knot& b) {
  const Vector3d along = b.position_m - a.position_m;
  return {.from = a.position_m,
          .along = along,
          .radius = a.radius_m,
          .radius_step = b.radius_m - a.radius_m,
          .inverse_length2 = 1.0 / std::max(along.squaredNorm(), 1e-12)};
}

/// Distance to the balls that interpolate the two ends at the foot of the perpendicular: exact for slender
/// cones.
double distance_to(const RoundCone& cone, const Vector3d& point) {
  const Vector3d offset = point - cone.from;
  const double t = std::clamp(offset.dot(cone.along) * cone.inverse_length2, 0.0, 1.0);
  return (offset - t * cone.along).norm() - (cone.radius + t * cone.radius_step);
}

Box bounds_of(const std::vector<Knot>& curve) {
  Box box;
  for (const Knot& knot : curve) {
    box.extend(knot.position_m + Vector3d::Constant(knot.radius_m));
    box.extend(knot.position_m - Vector3d::Constant(knot.radius_m));
  }
  return box;
}

/// Neighbouring cones and a ball around them, to pass over those that cannot be nearest.
struct ConeGroup {
  std::vector<RoundCone> cones;
  Vector3d centre = Vector3d::Zero();
  double radius = 0;
};

Distance limb_distance(const std::vector<Knot>& curve) {
  constexpr std::size_t group_size = 6;
  std::vector<ConeGroup> groups;
  for (std::size_t first = 0; first + 1 < curve.size(); first += group_size) {
    const std::size_t last = std::min(first + group_size, curve.size() - 1);
    ConeGroup group;
    for (std::size_t i = first; i < last; ++i) group.cones.push_back(round_cone(curve[i], curve[i + 1]));
    group.centre = (curve[first].position_m + curve[last].position_m) / 2;
    for (std::size_t i = first; i <= last; ++i)
      group.radius = std::max(group.radius, (curve[i].position_m - group.centre).norm() + curve[i].radius_m);
    groups.push_back(group);
  }
  return [groups](const Vector3d& point) {
    double nearest = std::numeric_limits<double>::max();
    for (const ConeGroup& group : groups) {
      const double reach = nearest + group.radius;
      if (reach <= 0 || (point - group.centre).squaredNorm() >= reach * reach) continue;
      for (const RoundCone& cone : group.cones) nearest = std::min(nearest, distance_to(cone, point));
    }
    return nearest;
  };
}

}  // namespace

std::vector<Knot> smooth_curve(const std::vector<Knot>& knots, int steps) {
  std::vector<Knot> curve;
  const auto last = knots.size() - 1;
  for (std::size_t i = 0; i < last; ++i) {
    const Knot& b = knots[i];
    const Knot& c = knots[i + 1];
    const Knot& a = i > 0 ? knots[i - 1] : b;
    const Knot& d = i + 2 <= last ? knots[i + 2] : c;
    for (int step = 0; step < steps; ++step) {
      const double t = static_cast<double>(step) / steps;
      const auto blend = [t](const auto& p, const auto& q, const auto& r, const auto& s) {
        return (q + 0.5 * t * ((r - p) + t * ((2 * p - 5 * q + 4 * r - s) + t * (3 * (q - r) + s - p))))
            .eval();
      };
      using Scalar = Eigen::Matrix<double, 1, 1>;
      const double radius =
          blend(Scalar(a.radius_m), Scalar(b.radius_m), Scalar(c.radius_m), Scalar(d.radius_m))[0];
      curve.push_back({blend(a.position_m, b.position_m, c.position_m, d.position_m), std::max(radius, 0.0)});
    }
  }
  curve.push_back(knots.back());
  return curve;
}

Stroke limb(const std::vector<Knot>& knots, double blend_m, int steps) {
  const std::vector<Knot> curve = smooth_curve(knots, steps);
  return {.distance = limb_distance(curve), .bounds = bounds_of(curve), .blend_m = blend_m};
}

Stroke ringed_limb(const std::vector<Knot>& knots, int rings, double depth_m, double blend_m) {
  constexpr int steps_a_ring = 6;
  const int spans = static_cast<int>(knots.size()) - 1;
  std::vector<Knot> curve = smooth_curve(knots, std::max(2, rings * steps_a_ring / spans));
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double along = static_cast<double>(i) / static_cast<double>(curve.size() - 1) * rings;
    const double phase = along - std::floor(along);
    const double thin = curve[i].radius_m > 2 * depth_m ? 1.0 : curve[i].radius_m / (2 * depth_m);
    curve[i].radius_m -= thin * depth_m * phase * phase;
  }
  return {.distance = limb_distance(curve), .bounds = bounds_of(curve), .blend_m = blend_m};
}

Stroke blade(const std::vector<Knot>& knots, const Vector3d& across, double flatness, double blend_m) {
  const Vector3d normal = across.normalized();
  const auto stretched = [normal, flatness](const Vector3d& p) -> Vector3d {
    return p + (flatness - 1) * normal.dot(p) * normal;
  };
  std::vector<Knot> curve = smooth_curve(knots, 5);
  const Box box = bounds_of(curve);
  for (Knot& knot : curve) knot.position_m = stretched(knot.position_m);
  const Distance round = limb_distance(curve);
  // Divided by the stretch it never overestimates, so a joint stays within its width.
  const auto distance = [round, stretched, flatness](const Vector3d& point) {
    return round(stretched(point)) / flatness;
  };
  return {.distance = distance, .bounds = box, .blend_m = blend_m};
}

Stroke spike(const Vector3d& base_m, const Vector3d& tip_m, double radius_m, double blend_m) {
  return limb({{base_m, radius_m}, {tip_m, 0.12 * radius_m}}, blend_m, 1);
}

void add_crest(Sculpture& sculpture, const Crest& crest) {
  const std::vector<Knot> foot = smooth_curve(crest.knots, 12);
  std::vector<Knot> rises;
  for (const Vector3d& rise : crest.rise_m) rises.push_back({rise, 0.0});
  const std::vector<Knot> rise = smooth_curve(rises, 12);
  for (int i = 0; i < crest.count; ++i) {
    const auto at = static_cast<std::size_t>(i) * (foot.size() - 1) /
                    static_cast<std::size_t>(std::max(crest.count - 1, 1));
    const Knot& base = foot[at];
    sculpture.strokes.push_back(
        spike(base.position_m, base.position_m + rise[at].position_m, base.radius_m, crest.blend_m));
  }
}

}  // namespace seamline::scenes
