#pragma once
#include <optional>

#include "renderer/scene/truth_scene.h"
#include "renderer/transport/omissions.h"

namespace seamline::renderer {

/// What decides which light of a scene can matter.
struct LightFacts {
  double brightest_albedo = 0;    ///< of background, objects and depth mesh, the largest channel
  double brightest_radiance = 0;  ///< sum of the suns' irradiance / pi, and the sky, the largest channel
  bool emits = false;             ///< then nothing bounds how bright a bounce is
  bool sky_is_dark = false;
  int bounces = 0;  ///< that the study asks for
  int suns = 0;
};
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
