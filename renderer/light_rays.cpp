#include "renderer/light_rays.h"

namespace seamline {

void LightRays::drop_blocked(const Geometry& geometry, const std::vector<Ray>& asked, Coherence coherence) {
  blocked_.resize(asked.size());
  geometry.occluded(asked, blocked_, coherence);
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

}  // namespace seamline
