#pragma once
#include <string>
#include <vector>

#include "laboratory/convergence/convergence_subject.h"

namespace seamline::renderer {

/// The noise that one way of sampling one kind of light leaves, and what it costs.
struct LightRow {
  std::string light;     ///< "environment map", "sky", "emitting surfaces" or "lamps": it alone shines
  std::string strategy;  ///< how its directions are chosen
  int rays = 1;          ///< times that every sample chooses
  int spp = 0;           ///< samples, and camera rays, a pixel
  double seconds = 0;    ///< processor time over all threads, of `spp` samples of every pixel
  std::int64_t traced = 0;
  double error = 0;  ///< root mean square over the pixels that show a surface, over their mean radiance
};

struct LightResult {
  std::vector<LightRow> rows;
  /// Mean radiance by each strategy over that of the reference, -1: of as many samples as any has.
  struct Agreement {
    std::string light, strategy;
    double excess = 0, standard_error = 0;
  };
  std::vector<Agreement> agreements;
  int reference_spp = 0;
};

/// Light that reaches the truth's first surfaces straight from each kind of light that the subject's scene
/// has (suns, which one ray finds, are none), by every strategy there is for it:
/// - the environment map by importance, by the directions of surfaces (visible normals where they are glossy,
///   cosine elsewhere), by the cosine everywhere, and by map and surface together under the power heuristic,
///   as both estimators have it;
/// - a sky of one radiance by the directions of surfaces, and by the cosine;
/// - emitting surfaces by area and luminance, by the directions of surfaces, and by both;
/// - lamps without size: one, chosen by what it sends to the point, one chosen evenly, and every one.
/// Each with 1, 2 and 4 rays a sample, and 1, 4, 16 and 64 samples a pixel. The reference is by the last
/// strategy of each, with other points and `reference_spp` samples. Throws InputError when the scene has no
/// such light.
[[nodiscard]] LightResult measure_light(const ConvergenceSubject& subject);

}  // namespace seamline::renderer
