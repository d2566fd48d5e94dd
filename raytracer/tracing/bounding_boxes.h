#pragma once
#include <algorithm>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "raytracer/tracing/ray.h"

namespace seamline::renderer {

struct SurfaceMesh;

/// Boxes around the objects of a geometry, to tell most rays that miss them all without asking Embree: an
/// object fills a small part of what a ray of the scene can meet.
class BoundingBoxes {
 public:
  BoundingBoxes() = default;
  /// A box for each object index of the meshes. None at all when the origin, where the camera is, lies in
  /// one: what surrounds the camera is met by most rays.
  explicit BoundingBoxes(std::span<const std::shared_ptr<const SurfaceMesh>> meshes);

  /// False only when the ray meets nothing; true when it may, and always where there are no boxes.
  [[nodiscard]] bool may_meet(const Ray& ray) const {
    if (boxes_.empty()) return true;
    const Eigen::Array3f inverse = ray.direction.array().inverse();
    for (const Box& box : boxes_)
      if (crosses(box, ray, inverse)) return true;
    return false;
  }
  /// Whether any of them may.
  [[nodiscard]] bool may_meet(std::span<const Ray> rays) const {
    return boxes_.empty() ||
           std::any_of(rays.begin(), rays.end(), [&](const Ray& ray) { return may_meet(ray); });
  }

 private:
  struct Box {
    Eigen::Array3f low_m = Eigen::Array3f::Constant(std::numeric_limits<float>::infinity());
    Eigen::Array3f high_m = Eigen::Array3f::Constant(-std::numeric_limits<float>::infinity());
  };
  /// The part of the ray between each pair of planes. A ray inside a face, where 0 times infinity is not a
  /// number, may be taken for a miss: the margin keeps the object away from the faces.
  static bool crosses(const Box& box, const Ray& ray, const Eigen::Array3f& inverse) {
    float from_m = 0.0F, to_m = ray.far_m;
    for (int axis = 0; axis < 3; ++axis) {
      const float a = (box.low_m[axis] - ray.origin_m[axis]) * inverse[axis];
      const float b = (box.high_m[axis] - ray.origin_m[axis]) * inverse[axis];
      const float enter_m = a < b ? a : b, leave_m = a < b ? b : a;
      if (enter_m > from_m) from_m = enter_m;
      if (leave_m < to_m) to_m = leave_m;
    }
    return !(from_m > to_m);
  }

  std::vector<Box> boxes_;
};

}  // namespace seamline::renderer
