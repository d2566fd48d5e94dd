#pragma once
#include "renderer/common/sampler.h"
#include "renderer/light/light.h"
#include "renderer/tracing/geometry.h"

namespace seamline::renderer {

/// Radiance leaving a point, by how the light came to it.
struct Split {
  Rgb direct = Rgb::Zero();  ///< from sun and sky, and the point's own emission
  Rgb bounce = Rgb::Zero();  ///< from other surfaces: what may be filtered

  [[nodiscard]] Rgb total() const { return direct + bounce; }
  Split& operator+=(const Split& other) {
    direct += other.direct;
    bounce += other.bounce;
    return *this;
  }
  Split& operator-=(const Split& other) {
    direct -= other.direct;
    bounce -= other.bounce;
    return *this;
  }
  friend Split operator*(float factor, const Split& light) {
    return {factor * light.direct, factor * light.bounce};
  }
};

/// The same without and with the virtual object, from one coupled computation on the same path: they differ
/// only by what the object does, so their ratio has far less noise than that of two renderings
/// (documentation/ design.md, section 2).
struct RadiancePair {
  Split without_object;
  Split with_object;
};

/// A point from which real geometry is asked. For a point of the object that lies behind the depth mesh on
/// its view ray, this is the depth mesh's own point, else the object's (documentation/design.md,
/// section 1).
struct RealQuestion {
  const Geometry* geometry;
  const SurfacePoint* start;
};

/// Radiance that a point of the real world sends to the camera, without and with the object. `object` may be
/// null: then both are the same. One sample; `sampler` fixes every random number.
[[nodiscard]] RadiancePair leaving_pair(const Geometry& real, const Geometry* object,
                                        const SurfacePoint& point, const Light& light, const Sampler& sampler,
                                        RayCounts* counts = nullptr);

/// Radiance that a point of the virtual object sends to the camera. `lit_past` answers whether sun and sky
/// reach it past real things (question 3), `bounced_by` where bounce light comes from (question 5);
/// without a geometry there the bounce part is not computed.
[[nodiscard]] Split leaving_object(const RealQuestion& lit_past, const RealQuestion& bounced_by,
                                   const Geometry& object, const SurfacePoint& point, const Light& light,
                                   const Sampler& sampler, RayCounts* counts = nullptr);

}  // namespace seamline::renderer
