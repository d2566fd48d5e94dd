#pragma once
#include <Eigen/Core>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "raytracer/tracing/bounding_boxes.h"
#include "raytracer/tracing/direction_table.h"
#include "raytracer/tracing/mesh.h"
#include "raytracer/tracing/ray.h"
#include "raytracer/tracing/surface_point.h"
#include "support/arithmetic/colour.h"

namespace seamline::renderer {

/// How rays that are asked for in one call lie to each other. Measured against one ray at a time: packets
/// that stay together are 2 to 4 times as fast, scattered ones 1.1 (nearest) to 1.6 times (occluded);
/// scattered rays asked as if they were together 0.5 times.
enum class Coherence {
  together,  ///< samples of one pixel, neighbouring pixels or texels, their sun rays
  scattered  ///< bounces
};

/// As many rays as passes ask in one call: two packets.
inline constexpr std::size_t rays_a_call = 16;

/// Whether a ray may slip between two triangles that share an edge.
enum class Edges {
  tight,  ///< never: what a depth map captures, and the reference estimator
  loose   ///< about once in 200,000 rays that meet a mesh, for rays a third faster
};

/// What a search tree is good for.
enum class TreeQuality {
  for_light,    ///< fast rays from everywhere
  for_few_rays  ///< built in a third of the time
};

/// How the local scene answers rays from the photograph's position.
enum class CentreRays {
  by_table,  ///< by the table of directions, if each has at most one triangle: it was captured from there
  by_tree    ///< as any other rays
};

/// Something rays can be asked about: the truth, a virtual object alone, or the local scene. Safe to ask from
/// many threads. Every question adds its rays to `counts->traced`; without `counts` nobody counts them.
class Geometry {
 public:
  /// Meshes of scene files.
  explicit Geometry(std::span<const std::shared_ptr<const SurfaceMesh>> meshes, Edges edges = Edges::tight);
  /// The local scene: geometric normals, one albedo, loose edges.
  Geometry(const DepthMesh& mesh, const Rgb& albedo, TreeQuality quality = TreeQuality::for_light,
           CentreRays centre = CentreRays::by_table);
  /// Gives a local scene another albedo in each direction from the origin. Before anybody asks rays.
  void paint(std::shared_ptr<const AlbedoMap> albedo);
  ~Geometry();
  Geometry(Geometry&&) noexcept;
  Geometry& operator=(Geometry&&) = delete;

  /// The nearest surface along a ray.
  [[nodiscard]] std::optional<SurfacePoint> nearest(const Ray& ray, RayCounts* counts = nullptr) const;
  /// Whether anything lies on the ray before its end.
  [[nodiscard]] bool occluded(const Ray& ray, RayCounts* counts = nullptr) const;
  /// The same for many rays, which are traced in packets. `hits`, `blocked` and `distance_m` are as long as
  /// `rays`.
  void nearest(std::span<const Ray> rays, std::span<std::optional<SurfacePoint>> hits,
               Coherence coherence = Coherence::together, RayCounts* counts = nullptr) const;
  void occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked,
                Coherence coherence = Coherence::together, RayCounts* counts = nullptr) const;
  /// Only how far each ray gets, for rays that lie together; infinity where it meets nothing.
  void distances(std::span<const Ray> rays, std::span<float> distance_m, RayCounts* counts = nullptr) const;
  /// The nearest surfaces along rays that all start at the origin, which is the panorama's centre: the hits
  /// of `nearest`, but in the local scene without search (a ray within rounding of an edge may get either
  /// neighbour).
  void nearest_from_centre(std::span<const Ray> rays, std::span<std::optional<SurfacePoint>> hits,
                           RayCounts* counts = nullptr) const;
  [[nodiscard]] std::span<const std::shared_ptr<const SurfaceMesh>> meshes() const { return meshes_; }
  /// Of the meshes it looks into itself and of the table of directions: what Embree's count leaves out.
  [[nodiscard]] std::int64_t own_memory_bytes() const;
  /// Whether any mesh emits light.
  [[nodiscard]] bool emits() const { return emits_; }
  /// Whether any mesh has a specular layer.
  [[nodiscard]] bool is_glossy() const { return glossy_; }

 private:
  void* scene_ = nullptr;
  std::vector<SurfaceTable> surfaces_;  ///< of each mesh
  std::vector<std::shared_ptr<const SurfaceMesh>> meshes_;
  BoundingBoxes boxes_;                         ///< of virtual objects without the scene around them
  std::optional<DirectionTable> directions_;    ///< of the local scene's one mesh
  std::shared_ptr<const SurfaceMesh> painted_;  ///< what the local scene's one surface is made of, if painted
  bool emits_ = false, glossy_ = false;
};

}  // namespace seamline::renderer
