#pragma once
#include <span>

#include "renderer/realtime/realtime_world.h"
#include "renderer/transport/answers.h"
#include "renderer/transport/object_light.h"
#include "renderer/transport/uncovered_light.h"

namespace seamline::renderer {

/// Direct light as methods of real time find it, with the questions of the same points that are traced
/// otherwise. Where the depth mesh answers questions 1 and 2 its maps do: the object's map at the receiver,
/// the local scene's map at the mesh's own point; what the truth answers is traced. Lamps with a map are
/// asked one by one. Sky, and what emits, are traced. `object` is asked where there is no map of it.
///
/// With occlusion fields all light of a receiver past the real world, however it comes, is multiplied with
/// what the object's field leaves of it; on the object light is <l, t> of its own transfer and the local
/// scene's field, diffuse, and no ray is traced.
///
/// With a dark layer, `without_object` is 1 and `with_object` 1 - opacity s, s being the share of the lights'
/// irradiance, as it is on surfaces that face them, that the object keeps from a receiver; what the real
/// world shades is asked only of the truth.
void realtime_on_uncovered(std::span<const UncoveredPoint> points, const Geometry& object,
                           const RealtimeWorld& world, const Answers& answers, std::span<RadiancePair> pairs,
                           LightRays& rays, RayCounts* counts = nullptr);

/// The same on the virtual object, past the depth mesh and itself (question 3).
void realtime_on_object(std::span<const ObjectPoint> points, const Geometry& object,
                        const RealtimeWorld& world, std::span<Rgb> direct, LightRays& rays,
                        RayCounts* counts = nullptr);

}  // namespace seamline::renderer
