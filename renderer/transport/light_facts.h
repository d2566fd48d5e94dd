#pragma once
#include <optional>

#include "raytracer/scene/truth_scene.h"
#include "renderer/transport/omissions.h"

namespace seamline::renderer {

/// What decides which light of a scene can matter.
struct LightFacts {
  double brightest_albedo = 0;    ///< of background, objects and depth mesh, the largest channel
  double brightest_radiance = 0;  ///< sum of the suns' irradiance / pi, and the sky (of a map, all of it over
                                  ///< pi), the largest channel
  bool emits = false;             ///< some surface emits
  bool is_glossy = false;         ///< some surface has a specular layer
  bool sky_is_dark = false;
  bool sky_is_mapped = false;
  int bounces = 0;  ///< that the study asks for
  int suns = 0;
  int lamps = 0;
  std::size_t emitting_triangles = 0;  ///< of the background
};
/// Whether nothing bounds how bright a bounce is: near lamps and what emits, and in what mirrors.
[[nodiscard]] inline bool is_unbounded(const LightFacts& facts) {
  return facts.emits || facts.lamps > 0 || facts.is_glossy;
}
[[nodiscard]] LightFacts light_facts(const TruthScene& scene);

/// How many bounces matter. Light of bounce k is at most a^(k+1) times the brightest radiance, a the
/// brightest albedo; the display curve is steepest in the dark, 12.92 * 2^exposure; a composite is made of
/// three such lights (background, with, without). The bounces that together stay under a tenth of the error
/// asked (of 1/255 when none is) are left out.
struct BounceLimit {
  int bounces = 0;
  double change = 0;  ///< at most, display units
};
[[nodiscard]] BounceLimit needed_bounces(const LightFacts& facts, double exposure_ev,
                                         std::optional<double> error);

}  // namespace seamline::renderer
