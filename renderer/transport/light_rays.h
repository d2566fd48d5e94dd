#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/transport/transport.h"

namespace seamline::renderer {

/// Rays that ask whether light from outside reaches points, each past two geometries: the virtual object and
/// the real world, which may be asked from different places. Asked many at once, in packets.
class LightRays {
 public:
  /// Light that arrives where nothing is in the way.
  struct Arriving {
    std::size_t index;  ///< whatever the caller counts
    Rgb radiance;
    float past_object = 1.0F;  ///< the share that a shadow map lets past the object; of rays 1
  };

  /// From `point` past the object and from `real.start` past the real world; nothing arrives from below that
  /// start's horizon.
  void add(const SurfacePoint& point, const RealQuestion& real, const Eigen::Vector3f& direction, float far_m,
           const Arriving& light);
  void drop_blocked_by_object(const Geometry& object, Coherence coherence, RayCounts* counts) {
    drop_blocked(object, past_object_, coherence, counts);
  }
  void drop_blocked_by_real(const Geometry& real, Coherence coherence, RayCounts* counts) {
    drop_blocked(real, past_real_, coherence, counts);
  }
  /// What is left, in the order it was added in.
  [[nodiscard]] std::span<const Arriving> arriving() const { return arriving_; }
  [[nodiscard]] bool empty() const { return arriving_.empty(); }
  void clear() { resize(0); }

 private:
  void drop_blocked(const Geometry& geometry, const std::vector<Ray>& asked, Coherence coherence,
                    RayCounts* counts);
  void resize(std::size_t size);

  std::vector<Ray> past_object_, past_real_;
  std::vector<Arriving> arriving_;
  std::vector<std::uint8_t> blocked_;
};

}  // namespace seamline::renderer
