#pragma once
#include <optional>

#include "raytracer/common/sampler.h"
#include "raytracer/light/light.h"
#include "raytracer/tracing/geometry.h"

namespace seamline::renderer {

/// Radiance leaving a point, by how the light came to it.
struct Split {
  Rgb direct = Rgb::Zero();  ///< from sun and sky, and the point's own emission
  Rgb bounce = Rgb::Zero();  ///< from other surfaces: what may be filtered
  /// Off the specular layer, from other surfaces, from the environment and from what emits: what is seen in
  /// the surface as in a mirror. (Suns and lamps without size have highlights, which are direct.)
  Rgb mirrored = Rgb::Zero();

  [[nodiscard]] Rgb total() const { return direct + bounce + mirrored; }
  Split& operator+=(const Split& other) {
    direct += other.direct;
    bounce += other.bounce;
    mirrored += other.mirrored;
    return *this;
  }
  Split& operator-=(const Split& other) {
    direct -= other.direct;
    bounce -= other.bounce;
    mirrored -= other.mirrored;
    return *this;
  }
  friend Split operator*(float factor, const Split& light) {
    return {factor * light.direct, factor * light.bounce, factor * light.mirrored};
  }
};

/// The same without and with the virtual object, from one coupled computation on the same path: they differ
/// only by what the object does, so their ratio has far less noise than that of two renderings
/// (documentation/developers/design.md, section 2).
struct RadiancePair {
  Split without_object;
  Split with_object;
};

/// A point from which real geometry is asked.
struct RealQuestion {
  const Geometry* geometry;
  const SurfacePoint* start;
};

/// What the depth mesh is asked about a point of the object: from there, but from the mesh's own point on its
/// view ray where that is nearer, or the object would be sealed in (documentation/developers/design.md,
/// section 1).
[[nodiscard]] inline RealQuestion asked_of_mesh(const Geometry* mesh,
                                                const std::optional<SurfacePoint>& on_mesh,
                                                const SurfacePoint& object) {
  return {mesh, on_mesh && on_mesh->distance_m < object.distance_m ? &*on_mesh : &object};
}

/// Radiance that a point of the real world sends to the camera, without and with the object. `object` may be
/// null: then both are the same. One sample; `sampler` fixes every random number.
[[nodiscard]] RadiancePair radiance_with_and_without(const Geometry& real, const Geometry* object,
                                                     const SurfacePoint& point, const Light& light,
                                                     const Sampler& sampler, RayCounts* counts = nullptr);

/// What the object changes of the radiance that a surface of `Light::photographed` sends, which a path met at
/// the end of its vertex number `vertex`: what it sends follows what it receives, times its albedo. One
/// sample.
[[nodiscard]] Rgb change_of_sent(const Geometry& real, const Geometry& object, const SurfacePoint& from,
                                 const Light& light, const Sampler& sampler, int vertex,
                                 RayCounts* counts = nullptr);

/// Who answers for the light of a point of the virtual object.
struct ObjectQuestions {
  RealQuestion lit_past;  ///< 3: do sun, sky and lamps reach it past real things
  RealQuestion bounced;   ///< 5: where bounce light comes from; without a geometry that part is not computed
  RealQuestion mirrored;  ///< 6: what is mirrored in it; likewise, and asked of glossy points only

  /// All of one geometry, from the same point.
  [[nodiscard]] static ObjectQuestions all_of(const RealQuestion& real) { return {real, real, real}; }
};

/// Radiance that a point of the virtual object sends to the camera.
[[nodiscard]] Split leaving_object(const ObjectQuestions& ask, const Geometry& object,
                                   const SurfacePoint& point, const Light& light, const Sampler& sampler,
                                   RayCounts* counts = nullptr);

}  // namespace seamline::renderer
