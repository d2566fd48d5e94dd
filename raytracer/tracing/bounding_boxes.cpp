#include "raytracer/tracing/bounding_boxes.h"

#include <map>

#include "raytracer/tracing/geometry.h"

namespace seamline::renderer {

BoundingBoxes::BoundingBoxes(std::span<const std::shared_ptr<const SurfaceMesh>> meshes) {
  std::map<int, Box> of_object;
  for (const auto& mesh : meshes)
    for (const Eigen::Vector3f& position_m : mesh->positions_m) {
      Box& box = of_object.try_emplace(mesh->object_index).first->second;
      box.low_m = box.low_m.min(position_m.array());
      box.high_m = box.high_m.max(position_m.array());
    }
  for (auto& [object, box] : of_object) {
    // Wider than the rounding of a slab test, whose operands are as large as the coordinates.
    const float margin_m = 1e-4F * box.low_m.abs().max(box.high_m.abs()).maxCoeff();
    box.low_m -= margin_m;
    box.high_m += margin_m;
    if ((box.low_m <= 0.0F).all() && (box.high_m >= 0.0F).all()) {
      boxes_.clear();
      return;
    }
    boxes_.push_back(box);
  }
}

}  // namespace seamline::renderer
