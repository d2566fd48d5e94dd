#pragma once
#include <span>

#include "raytracer/material/mask.h"
#include "renderer/transport/light_rays.h"
#include "renderer/transport/transport.h"

namespace seamline::renderer {

/// A sample's point off the virtual object: which surface receives light (question 1), from which the virtual
/// object is seen, and of which geometry it is asked, at that geometry's own point, whether sun and sky reach
/// it (question 2).
struct UncoveredPoint {
  const SurfacePoint* receiver = nullptr;
  RealQuestion lit = {nullptr, nullptr};  ///< one geometry for all points
  /// The truth's point, whose material the receiver has and whose emission and bounce light join it.
  const SurfacePoint* shaded_as = nullptr;
  Sampler sampler;
  /// Where the photograph shows it, for mattes of the photograph's shape.
  Eigen::Array2f in_photograph = Eigen::Array2f::Zero();
};

/// Sun and sky on many such points at once: their rays to the sun go together, those to the sky in packets of
/// their own. The sun is in `direct`, with what the points emit; the sky, which is smooth and may be
/// filtered, in `bounce`. `pairs` is as long as `points`. What `rays` holds is forgotten:
/// a caller who asks often keeps it for its memory. With a matte, that says how much of each sun does not
/// arrive past the real world; sky and lamps ask its geometry.
void direct_on_uncovered(std::span<const UncoveredPoint> points, const Geometry& object, const Light& light,
                         std::span<RadiancePair> pairs, LightRays& rays, RayCounts* counts = nullptr,
                         const ShadowMatte* matte = nullptr);

/// The suns alone, each as far as the matte lets it through and the object does not block it; added to the
/// direct light of `pairs`.
void add_suns_by_matte(std::span<const UncoveredPoint> points, const Geometry& object, const Light& light,
                       const ShadowMatte& matte, std::span<RadiancePair> pairs, LightRays& rays,
                       RayCounts* counts = nullptr);

}  // namespace seamline::renderer
