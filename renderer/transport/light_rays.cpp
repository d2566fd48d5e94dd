#include "renderer/transport/light_rays.h"

#include "raytracer/tracing/surface_point.h"

namespace seamline::renderer {

void LightRays::add(const SurfacePoint& point, const RealQuestion& real, const Eigen::Vector3f& direction,
                    float far_m, const Arriving& light) {
  if (!above_horizon(*real.start, direction)) return;
  past_object_.push_back(leaving_ray(point, direction, far_m));
  past_real_.push_back(leaving_ray(*real.start, direction, far_m));
  arriving_.push_back(light);
}

void LightRays::drop_blocked(const Geometry& geometry, const std::vector<Ray>& asked, Coherence coherence,
                             RayCounts* counts) {
  blocked_.resize(asked.size());
  geometry.occluded(asked, blocked_, coherence, counts);
  std::size_t left = 0;
  for (std::size_t i = 0; i < blocked_.size(); ++i) {
    if (blocked_[i] != 0) continue;
    past_object_[left] = past_object_[i], past_real_[left] = past_real_[i], arriving_[left] = arriving_[i];
    ++left;
  }
  resize(left);
}

void LightRays::resize(std::size_t size) {
  past_object_.resize(size);
  past_real_.resize(size);
  arriving_.resize(size);
}

}  // namespace seamline::renderer
