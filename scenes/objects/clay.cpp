#include "scenes/objects/clay.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/arithmetic/shortest_turn.h"

namespace seamline::scenes {
namespace {

using Box = Eigen::AlignedBox3d;
using Vector3d = Eigen::Vector3d;

/// The box of a box after a rotation about `centre`.
Box turned_box(const Vector3d& centre, const Vector3d& half, const Eigen::Quaterniond& turn) {
  const Vector3d reach = turn.toRotationMatrix().cwiseAbs() * half;
  return {centre - reach, centre + reach};
}

}  // namespace

Stroke lump(const Vector3d& centre_m, const Vector3d& half_axes_m, double blend_m,
            const Eigen::Quaterniond& turn) {
  const Eigen::Matrix3d to_local = turn.toRotationMatrix().transpose();
  const Eigen::Array3d inverse = half_axes_m.array().inverse();
  const double smallest = half_axes_m.minCoeff();
  const auto distance = [=](const Vector3d& point) {
    const Eigen::Array3d scaled = (to_local * (point - centre_m)).array() * inverse;
    const double k0 = scaled.matrix().norm();
    if (k0 < 1e-6) return -smallest;
    const double k1 = (scaled * inverse).matrix().norm();
    return k0 * (k0 - 1.0) / k1;
  };
  return {.distance = distance, .bounds = turned_box(centre_m, half_axes_m, turn), .blend_m = blend_m};
}

Stroke drum(const Vector3d& base_m, double radius_m, double height_m, double edge_m, double blend_m) {
  const Vector3d half(radius_m, height_m / 2, radius_m);
  const Vector3d centre = base_m + Vector3d(0, height_m / 2, 0);
  const auto distance = [=](const Vector3d& point) {
    const Vector3d p = point - centre;
    const double side = std::hypot(p.x(), p.z()) - radius_m + edge_m;
    const double end = std::abs(p.y()) - height_m / 2 + edge_m;
    return std::hypot(std::max(side, 0.0), std::max(end, 0.0)) + std::min(std::max(side, end), 0.0) - edge_m;
  };
  return {.distance = distance, .bounds = Box(centre - half, centre + half), .blend_m = blend_m};
}

Stroke block(const Vector3d& centre_m, const Vector3d& half_size_m, double edge_m, double blend_m,
             const Eigen::Quaterniond& turn) {
  const Eigen::Matrix3d to_local = turn.toRotationMatrix().transpose();
  const auto distance = [=](const Vector3d& point) {
    const Vector3d q = (to_local * (point - centre_m)).cwiseAbs() - half_size_m + Vector3d::Constant(edge_m);
    return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0) - edge_m;
  };
  return {.distance = distance, .bounds = turned_box(centre_m, half_size_m, turn), .blend_m = blend_m};
}

Stroke skin(const Vector3d& a_m, const Vector3d& b_m, const Vector3d& c_m, double half_thickness_m,
            double blend_m) {
  const Vector3d ab = b_m - a_m;
  const Vector3d bc = c_m - b_m;
  const Vector3d ca = a_m - c_m;
  const Vector3d normal = ab.cross(bc).normalized();
  const auto edge2 = [](const Vector3d& offset, const Vector3d& edge) {
    return (offset - std::clamp(offset.dot(edge) / edge.squaredNorm(), 0.0, 1.0) * edge).squaredNorm();
  };
  const auto distance = [=](const Vector3d& point) {
    const Vector3d pa = point - a_m;
    const Vector3d pb = point - b_m;
    const Vector3d pc = point - c_m;
    const bool over =
        normal.dot(ab.cross(pa)) >= 0 && normal.dot(bc.cross(pb)) >= 0 && normal.dot(ca.cross(pc)) >= 0;
    if (over) return std::abs(normal.dot(pa)) - half_thickness_m;
    return std::sqrt(std::min({edge2(pa, ab), edge2(pb, bc), edge2(pc, ca)})) - half_thickness_m;
  };
  Box box;
  for (const Vector3d& corner : {a_m, b_m, c_m}) {
    box.extend(corner + Vector3d::Constant(half_thickness_m));
    box.extend(corner - Vector3d::Constant(half_thickness_m));
  }
  return {.distance = distance, .bounds = box, .blend_m = blend_m};
}

Stroke carved(Stroke stroke) {
  stroke.carves = true;
  return stroke;
}

Stroke mirrored(const Stroke& stroke, int axis) {
  const auto flip = [axis](Vector3d point) {
    point[axis] = -point[axis];
    return point;
  };
  Stroke image = stroke;
  image.distance = [flip, original = stroke.distance](const Vector3d& point) {
    return original(flip(point));
  };
  image.bounds = Box();
  image.bounds.extend(flip(stroke.bounds.min()));
  image.bounds.extend(flip(stroke.bounds.max()));
  return image;
}

void add_pair(Sculpture& sculpture, const Stroke& stroke, int axis) {
  sculpture.strokes.push_back(stroke);
  sculpture.strokes.push_back(mirrored(stroke, axis));
}

double scales(const Vector3d& point_m, double size_m, double depth_m) {
  const double per_m = std::numbers::pi / size_m;
  const Vector3d& p = point_m;
  const double a = per_m * (p.y() + 0.35 * p.x() + 0.012 * std::sin(23 * p.z()));
  const double b = per_m * (p.x() - 0.35 * p.y() + 0.55 * p.z() + 0.012 * std::sin(29 * p.y()));
  const double gap = 1 - std::abs(std::sin(a) * std::sin(b));
  return depth_m * gap * gap;
}

Eigen::Quaterniond upright_to(const Vector3d& direction) {
  return shortest_turn(Vector3d::UnitY(), direction.normalized());
}

}  // namespace seamline::scenes
