#pragma once
#include <memory>
#include <optional>

#include "raytracer/light/light.h"
#include "raytracer/tracing/geometry.h"

namespace seamline::renderer {

/// What the panorama asks of the surfaces of a photographed local scene.
struct SentLight {
  double most_albedo = 0;      ///< the largest that is implied, of what is no light source
  double share_above_one = 0;  ///< of the local scene's solid angle, where more than 1.1 is implied
};

/// Columns of the map of implied albedo, twice its rows: 256, or 128 beside a picture's error that is asked
/// to be no less than 0.02, where a quarter of the rays is enough.
[[nodiscard]] int implied_albedo_columns(const std::optional<double>& error);

/// Makes the light that photographed surfaces send follow what they receive. The albedo that the panorama
/// implies is a = pi B / E in each texel of a map of `columns` x `columns` / 2 directions: B is the
/// panorama's radiance there, E the irradiance of the local scene under `light` without objects. `local` is
/// painted with it (at most 1), so that `change_of_sent` knows it. Where more than 1 is implied, surfaces
/// send what albedo 1 would
/// (`light.environment` is replaced), but light sources keep what the panorama shows: in a panorama of codes
/// what is at least 0.9 of `white`, in others what implies more than 2. Before anybody asks `local` rays;
/// sets `light.photographed`. The same for any number of threads.
[[nodiscard]] SentLight follow_received_light(const std::shared_ptr<Geometry>& local, Light& light,
                                              const std::optional<float>& white, int columns, int threads);

}  // namespace seamline::renderer
