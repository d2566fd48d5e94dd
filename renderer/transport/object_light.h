#pragma once
#include <span>

#include "renderer/transport/light_rays.h"
#include "renderer/transport/transport.h"

namespace seamline::renderer {

/// A sample's point on the virtual object, and where the real world is asked whether it is lit.
struct ObjectPoint {
  const SurfacePoint* point = nullptr;
  RealQuestion lit_past = {nullptr, nullptr};  ///< one geometry for all points
  Sampler sampler;
};

/// The direct part of `leaving_object` (what is mirrored is none of it), of many points at once: their rays
/// to the sun go together, those to the sky in packets of their own. `direct` is as long as `points`. What
/// `rays` holds is forgotten: a caller who asks often keeps it for its memory.
void direct_on_object(std::span<const ObjectPoint> points, const Geometry& object, const Light& light,
                      std::span<Rgb> direct, LightRays& rays, RayCounts* counts = nullptr);

}  // namespace seamline::renderer
