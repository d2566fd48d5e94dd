#pragma once
#include <array>
#include <memory>
#include <span>

#include "raytracer/tracing/geometry.h"

namespace seamline::renderer {

/// Embree as one would call it with nothing around it: the same triangles, flags and build quality as
/// Geometry, rays copied into packets and traced, distances copied out.
class BareScene {
 public:
  BareScene(std::span<const std::shared_ptr<const SurfaceMesh>> parts, Edges edges);
  ~BareScene();
  BareScene(const BareScene&) = delete;
  BareScene& operator=(const BareScene&) = delete;

  /// Rays in a call of Embree: rtcIntersect1, 4, 8, 16.
  static constexpr std::array<int, 4> packet_sizes = {1, 4, 8, 16};

  /// The distance to the nearest hit of each ray, or its own end.
  void nearest(int packet_size, Coherence coherence, std::span<const Ray> rays,
               std::span<float> distance_m) const;
  /// -infinity where something lies on the ray, else its own end.
  void occluded(int packet_size, Coherence coherence, std::span<const Ray> rays,
                std::span<float> distance_m) const;

 private:
  void* scene_;
};

}  // namespace seamline::renderer
