#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "raytracer/common/sampler.h"
#include "raytracer/light/light.h"
#include "raytracer/tracing/ray.h"
#include "raytracer/tracing/surface_point.h"

namespace seamline::renderer {

/// Light that is to arrive at a surface, in the pixel that shows it.
struct AskedLight {
  std::size_t pixel = 0;
  Ray ray;
  /// Where nothing is in the way; and, of rays that look for what emits, what they weigh it by.
  Rgb radiance = Rgb::Zero();
};

/// Questions of one row of pixels, answered together.
struct RowQuestions {
  std::vector<AskedLight> past_everything;  ///< whether anything is in the way
  struct Found {
    AskedLight asked;
    std::function<Rgb(const SurfacePoint& hit)> emission;
  };
  std::vector<Found> emission_questions;  ///< what is met
};

using Strategy = std::function<void(const SurfacePoint& point, const Sampler& sampler, std::size_t pixel,
                                    RowQuestions& questions)>;
struct NamedStrategy {
  std::string light, name;
  Strategy ask;
};

/// Lights of a scene, each of one kind alone.
struct LightsApart {
  std::optional<Light> map, sky, emitters, lamps, suns;
};

[[nodiscard]] LightsApart lights_apart(const Light& light);

/// Every way to sample each kind of light; the last one of a kind is the renderer's own. They refer to
/// `lights`.
[[nodiscard]] std::vector<NamedStrategy> strategies_of(const LightsApart& lights, bool glossy);

}  // namespace seamline::renderer
