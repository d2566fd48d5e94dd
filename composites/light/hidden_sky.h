#pragma once
#include <memory>

#include "raytracer/light/environment_map.h"
#include "raytracer/material/direction_map.h"
#include "raytracer/tracing/geometry.h"

namespace seamline::renderer {

/// The sky behind the surfaces that a panorama shows, W/m2/sr: in a room, what other places see through a
/// window in directions in which the camera sees a wall. Nobody knows it; it is filled in from the sky that
/// the panorama shows, the nearer the more (a pyramid of means). `local`: the local scene, whose holes are
/// sky. Null where it has no holes.
[[nodiscard]] std::shared_ptr<const DirectionMap<Rgb>> fill_hidden_sky(const Geometry& local,
                                                                       const EnvironmentMap& panorama,
                                                                       int threads);

}  // namespace seamline::renderer
