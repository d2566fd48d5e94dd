#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "raytracer/tracing/bounding_boxes.h"
#include "raytracer/tracing/geometry.h"
#include "raytracer/tracing/mesh.h"

namespace seamline::renderer {

/// A search tree of Embree. Several geometries may ask the same one.
class SearchTree {
 public:
  /// Of meshes of scene files. Copies them, but for those with holes, which have to outlive it.
  SearchTree(std::span<const std::shared_ptr<const SurfaceMesh>> meshes, Edges edges,
             TreeQuality quality = TreeQuality::for_light);
  /// Of a local scene.
  SearchTree(const std::vector<Eigen::Vector3f>& positions_m, const std::vector<Triangle>& triangles,
             TreeQuality quality);
  SearchTree(const std::vector<Eigen::Vector3f>& positions_m,
             const std::vector<std::array<std::uint32_t, 4>>& quads, TreeQuality quality);
  ~SearchTree();
  SearchTree(const SearchTree&) = delete;
  SearchTree& operator=(const SearchTree&) = delete;

  /// Embree's scene.
  [[nodiscard]] void* scene() const { return scene_; }
  /// Around what it holds of meshes of scene files.
  [[nodiscard]] const BoundingBoxes& boxes() const { return boxes_; }

 private:
  void* scene_;
  BoundingBoxes boxes_;
};

}  // namespace seamline::renderer
