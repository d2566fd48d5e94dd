#pragma once
#include <cstdint>
#include <vector>

#include "raytracer/scene/truth_scene.h"
#include "stimuli/definition/study_definition.h"

namespace seamline::renderer {

/// Pixels whose centre shows background or an object.
struct VisiblePixels {
  std::int64_t count = 0;
  double sum_x_px = 0;  ///< of their columns
};
/// Of the background (0) and each object, from 1 to `objects`.
[[nodiscard]] std::vector<VisiblePixels> visible_pixels(const Camera& camera, const Geometry& everything,
                                                        std::size_t objects);

/// Throws InputError when one of the scene's objects covers no pixel of the picture, or when participants who
/// count them from the left (other than three) would count them in another order than the study file has.
void require_visible_objects(const StudyDefinition& study, const TruthScene& scene);

/// Throws InputError when late depth would be of another place than the photograph, because the file's camera
/// moves.
void require_same_camera(const StudyDefinition& study, const TruthScene& now, const TruthScene& then);

/// Throws InputError when a study asks what is mirrored in an object that mirrors nothing.
void require_mirrors(const StudyDefinition& study, const TruthScene& scene);

}  // namespace seamline::renderer
